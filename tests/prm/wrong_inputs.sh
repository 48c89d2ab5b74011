#!/usr/bin/env bash
# Wrong inputs: each must end with code 1 and a message that names the entry, or
# what was found.
#   wrong_inputs.sh CONTACT_SCENE RUBBER_FIT DUMMY_ON_HOOD FOLDER_OF_PRM WORK
set -uo pipefail
scene=$1 fit=$2 dummy=$3 prm=$4 work=$5
rm -rf "$work"
mkdir -p "$work"
punch="$prm/tutorial/punch_2d.prm"
ring="$prm/rubber_fit.prm"
count=0
failed=0

# refuse 'WORDS' DRIVER ARGUMENTS...: WORDS, separated by |, must all be said
refuse() {
  local words=$1 code=0 message
  shift
  count=$((count + 1))
  message=$("$@" --output "$work/out" 2>&1 > /dev/null) || code=$?
  local ok=1
  [ "$code" = 1 ] || ok=0
  local IFS='|'
  for word in $words; do
    grep -qF -- "$word" <<< "$message" || ok=0
  done
  grep -qE "Stacktrace|TimerOutput|terminate" <<< "$message" && ok=0
  if [ "$ok" = 0 ]; then
    failed=$((failed + 1))
    echo "FAILED (code $code, expected '$words'): $*"
    echo "$message" | head -8
  fi
}

b="Bodies/block" p="Bodies/punch" c="Contact/punch on block"
set_punch() {
  local words=$1
  shift
  local arguments=()
  for setting in "$@"; do arguments+=(--set "$setting"); done
  refuse "$words" "$scene" "$punch" "${arguments[@]}"
}

# a mesh file that is none
echo "not a mesh" > "$work/bad.msh"

echo "*KEYWORD" > "$work/model.k"

refuse "cannot be opened|nothing.prm" "$scene" "$work/nothing.prm"
refuse "Driver|rubber_fit|contact_scene" "$scene" "$ring"
refuse "--sett" "$scene" "$punch" --sett x=1
refuse "No parameter file" "$scene"
set_punch "Stifness scale" "$c/Stifness scale=1"
set_punch "SFS|Stiffness scale|LS-DYNA" "$c/SFS=1"
set_punch "model.k|LS-DYNA|gmsh" "$b/Mesh/Type=file" "$b/Mesh/File=$work/model.k"
set_punch "Secondary|Primary|single surface" "$c/Primary=block: boundary 3" "$c/Secondary=block: boundary 3"
set_punch "Friction coefficient" "$c/Friction=0.2"
set_punch "side|Boundary conditions/Names" "Boundary conditions/side/x=0"
refuse "is a folder" "$scene" "$work"
set_punch "Contacts" "Contacts/Interfaces=a"
set_punch "Stiffness scale|-1" "$c/Stiffness scale=-1"
set_punch "Degree|7" "$c/Degree=7"
set_punch "Kind|glued" "$c/Kind=glued"
set_punch "Integration|lines" "$c/Integration=lines"
set_punch "Characteristic length|long|shortest edge" "$c/Characteristic length=long"
set_punch "Removal time|remove over time" "$c/Initial penetration=remove over time"
set_punch "MPAR2|remove over time deep" "$c/Initial penetration=remove over time deep" "$c/Removal time=1"
set_punch "Initial pressure|ignore" "$c/Initial pressure=3"
set_punch "Largest penetration|shortest edge" "$c/Characteristic length=shortest edge" "$c/Largest penetration=0.1"
set_punch "Secondary|blok|block" "$c/Secondary=blok"
set_punch "Secondary|empty" "$c/Secondary="
set_punch "Primary|boundary" "$c/Primary=punch: side 3"
set_punch "punch on block|empty|secondary" "$c/Secondary=block: boundary 9"
set_punch "Young's modulus|-5" "$b/Material/Young's modulus=-5"
set_punch "Young's modulus|positive" "$b/Material/Young's modulus=0"
set_punch "Poisson's ratio|0.5" "$b/Material/Poisson's ratio=0.5"
set_punch "C10|Mooney-Rivlin" "$b/Material/C10=1"
set_punch "Mean dilatation|automatic" "$b/Mean dilatation=yes"
set_punch "Upper corner|Lower corner" "$b/Mesh/Upper corner=0, 1"
set_punch "Cells|expected 2" "$b/Mesh/Cells=3"
set_punch "Cells|0" "$b/Mesh/Cells=3, 0"
set_punch "File|missing.msh|cannot be opened" "$b/Mesh/Type=file" "$b/Mesh/File=missing.msh"
set_punch "File|empty" "$b/Mesh/Type=file"
set_punch "cylinder|Dimension" "$b/Mesh/Type=cylinder"
set_punch "Boundary ids|8|base" "Boundary conditions/base/Boundary ids=8"
set_punch "Body|blokc" "Boundary conditions/base/Body=blokc"
set_punch "x|0*" "Boundary conditions/base/x=0*"
set_punch "Type|Pressure" "Boundary conditions/base/Type=pressure"
set_punch "base|top|x|2" "Boundary conditions/top/Body=block" "Boundary conditions/top/Boundary ids=2, 3"
set_punch "z|Dimension" "Boundary conditions/base/z=0"
set_punch "First step|Largest step" "Steps/Largest step=0.01"
set_punch "Names|block|twice" "Bodies/Names=block, punch, block"
set_punch "Bodies|empty" "Bodies/Names="
set_punch "Section/Entry=value" "Steps"
set_punch "Friction coefficient|tied" "$c/Kind=tied" "$c/Friction coefficient=0.3"
set_punch "Friction coefficient|-0.1" "$c/Friction coefficient=-0.1"
set_punch "Friction decay|Dynamic friction coefficient" "$c/Friction coefficient=0.3" "$c/Dynamic friction coefficient=0.1"
set_punch "Friction function|0.3*q" "$c/Friction function=0.3*q"
set_punch "Friction function|Friction coefficient" "$c/Friction function=0.3" "$c/Friction coefficient=0.3"
set_punch "Elastic slip|friction" "$c/Elastic slip=1e-3"
set_punch "Tie tolerance|tied" "$c/Tie tolerance=1"
set_punch "Normal strength|NFLS|tiebreak" "$c/Kind=tiebreak"
set_punch "ERATEN|ERATES" "$c/Kind=tiebreak" "$c/Tiebreak=cohesive" "$c/Normal strength=1" "$c/Shear strength=1"
set_punch "fracture energy|CN" "$c/Kind=tiebreak" "$c/Tiebreak=cohesive" "$c/Normal strength=100" "$c/Shear strength=100" "$c/Normal fracture energy=1e-6" "$c/Shear fracture energy=1e-6"
set_punch "punch on block|nothing is tied|Tie tolerance" "$c/Kind=tied" "$c/Secondary=block: boundary 2"
set_punch "Penetration tolerance|Uzawa" "$c/Augmentation=Uzawa"
set_punch "Primary|single surface" "$c/Kind=automatic single surface"
set_punch "Tool normals|forming" "$c/Tool normals=turn"
set_punch "Density|dynamic" "Dynamics/Type=dynamic"
set_punch "Initial velocity|static" "$b/Initial velocity=1; 0"
set_punch "Mass damping|static" "Dynamics/Mass damping=1"
set_punch "energy-momentum|static" "Dynamics/Method=energy-momentum"
set_punch "Spectral radius|0.8|1" "Dynamics/Type=dynamic" "Dynamics/Method=energy-momentum"
set_punch "energy-momentum|generalised-alpha|block" "Dynamics/Type=dynamic" "Dynamics/Method=energy-momentum" "Dynamics/Spectral radius=1" "$b/Material/Density=1" "$p/Material/Density=1"
set_punch "Map|components|2" "$b/Mesh/Map=x"
set_punch "Map|inside out" "$b/Mesh/Map=-x; y"

# rigid bodies: the punch of a scene of its own
wall="$prm/verification/impact_bar.prm"
w="Rigid bodies/wall"
set_wall() {
  local words=$1
  shift
  local arguments=()
  for setting in "$@"; do arguments+=(--set "$setting"); done
  refuse "$words" "$scene" "$wall" "${arguments[@]}"
}
set_wall "Type|cylinder|Dimension" "$w/Type=cylinder"
set_wall "Sizes|box" "$w/Type=box"
set_wall "Formula|formula" "$w/Type=formula"
set_wall "wall|x^|formula" "$w/Type=formula" "$w/Formula=x^"
set_wall "File|none.stl|cannot be opened" "$w/Type=mesh" "$w/File=$work/none.stl"
set_wall "File|bad.msh|surface mesh" "$w/Type=mesh" "$w/File=$work/bad.msh"
set_wall "Position|2" "$w/Position=1,2,3"
set_wall "Axis|direction" "$w/Axis=0, 0"
set_wall "Move z|Dimension" "$w/Move z=t"
set_wall "Smooth|mesh" "$w/Smooth=yes"
set_wall "Force x|Free motions" "$w/Force x=1"
set_wall "Free motions|dynamic" "$w/Free motions=x"
set_wall "smooth surface|primary" "Contact/end/Secondary=wall" "Contact/end/Primary=bar"
set_wall "only primary|wall" "Contact/end/Primary=wall; bar"
set_wall "bar|different names" "Rigid bodies/Names=wall, bar"
refuse "Outer radius|Inner radius" "$fit" "$ring" --set "Rubber/Outer radius=10"
refuse "MPAR2|Deepest initial penetration|1.5" "$fit" "$ring" --set "Contact/Deepest initial penetration=1.0"
refuse "Hardness|120" "$fit" "$ring" --set "Rubber/Hardness=120"
refuse "checkpoint|no such file" "$scene" "$punch" --restart "$work/no_run"

# shells
strip="$prm/verification/shell_cantilever.prm" shear="Boundary conditions/shear"
set_strip() {
  local words=$1
  shift
  local arguments=()
  for setting in "$@"; do arguments+=(--set "$setting"); done
  refuse "$words" "$scene" "$strip" "${arguments[@]}"
}
set_strip "Thickness|shell" "Bodies/strip/Thickness=0"
set_strip "Thickness|solid" "Bodies/strip/Type=solid"
set_strip "shell|Degree" "Bodies/strip/Degree=2"
set_strip "strip|Mesh/Type|ball|box" "Bodies/strip/Mesh/Type=ball"
set_strip "Map|2 components|3" "Bodies/strip/Mesh/Map=x; y"
set_strip "strip|0 or 180 degrees" "Bodies/strip/Mesh/Map=x; x; 0"
set_strip "shear|Plane normal" "$shear/Type=symmetry" "$shear/z=free"
set_strip "shear|On surface|pressure" "$shear/Type=pressure" "$shear/z=free" "$shear/Pressure=1"
set_strip "Point|traction" "$shear/Type=symmetry" "$shear/z=free" "$shear/Point=1,0,0"
set_strip "shear|Point|2 numbers" "$shear/Point=1, 0"
set_strip "shear|Boundary ids|7" "$shear/Boundary ids=7"
set_punch "solid|Directors|shell" "Boundary conditions/base/Directors=fixed"
set_punch "Secondary|block|not a shell" "$c/Secondary=block: top"
set_punch "Thickness scale|positive" "$c/Thickness scale=0"
set_strip "Where|0 at all nodes|strip" "Boundary conditions/clamp/Where=x > 1000"
set_strip "Where|no 'Point'" "$shear/Where=x > 9"
set_strip "Law|shell|Mooney-Rivlin" "Bodies/strip/Material/Law=Mooney-Rivlin" "Bodies/strip/Material/C10=1"
set_strip "Yield stress|neo-Hookean" "Bodies/strip/Material/Law=neo-Hookean" "Bodies/strip/Material/Yield stress=1"
set_punch "Yield stress|shell" "$b/Material/Yield stress=1"
set_strip "Hardening modulus|Yield stress" "Bodies/strip/Material/Hardening modulus=1"
set_strip "Saturation stress|Yield stress" "Bodies/strip/Material/Yield stress=2" "Bodies/strip/Material/Saturation stress=1" "Bodies/strip/Material/Saturation exponent=1"
set_strip "Thickness of parts|file" "Bodies/strip/Thickness of parts=rim: 1"
# shells with parts, two squares
cat > "$work/parts.inp" << 'END'
*Node
1, 0, 0, 0
2, 5, 0, 0
3, 10, 0, 0
4, 0, 1, 0
5, 5, 1, 0
6, 10, 1, 0
*Element, type=S4, elset=rim
1, 1, 2, 5, 4
*Element, type=S4, elset=panel
2, 2, 3, 6, 5
END
parts=("Bodies/strip/Mesh/Type=file" "Bodies/strip/Mesh/File=$work/parts.inp"
  "Bodies/strip/Mesh/Map=")
set_strip "Thickness of parts|roof|RIM" "${parts[@]}" "Bodies/strip/Thickness of parts=roof: 1"
set_strip "Thickness|part 2|PANEL" "${parts[@]}" "Bodies/strip/Thickness=0" "Bodies/strip/Thickness of parts=RIM: 1"
set_strip "Map|file" "Bodies/strip/Mesh/Type=file" "Bodies/strip/Mesh/File=$work/parts.inp"
sed 's/S4/C3D8/' "$work/parts.inp" > "$work/solid.inp"
set_strip "solid.inp|line 8|C3D8|S3" "${parts[@]}" "Bodies/strip/Mesh/File=$work/solid.inp"

# the dummy on the hood
set_hood() {
  local words=$1
  shift
  local arguments=()
  for setting in "$@"; do arguments+=(--set "$setting"); done
  refuse "$words" "$dummy" "$prm/dummy_on_hood.prm" "${arguments[@]}"
}
set_hood "Parts|1, 2, 3|semi-axes" "Dummy/Parts=1, 2, 3"
set_hood "Parts|over the hood" "Dummy/Position=5000, 0"
set_hood "Flanges|space for bowls" "Hood/Flange width=500"
set_hood "Panel cells|positive" "Hood/Panel cells=0, 10"
set_hood "Foam thickness|semi-axes" "Dummy/Type=foam" "Dummy/Foam thickness=500"
set_hood "Where|hinges|frame" "Hood/Support size=1"
set_hood "Dummy/Type|wood" "Dummy/Type=wood"

set_punch "File|bad.msh|gmsh" "$b/Mesh/Type=file" "$b/Mesh/File=$work/bad.msh"
# a folder that cannot be made
: > "$work/file"
count=$((count + 1))
message=$("$scene" "$punch" --output "$work/file/below" 2>&1 > /dev/null)
if [ $? != 1 ] || ! grep -q "Output/Directory" <<< "$message"; then
  failed=$((failed + 1))
  echo "FAILED: a folder that cannot be made: $message"
fi

echo "$((count - failed)) of $count wrong inputs were refused in words"
[ "$failed" = 0 ]
