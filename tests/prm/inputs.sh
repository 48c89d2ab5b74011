#!/usr/bin/env bash
# What the programs print can be read again, in both formats, and completed by bash:
#   inputs.sh CONTACT_SCENE RUBBER_FIT SCRIPTS FOLDER
set -euo pipefail
scene=$1 fit=$2 scripts=$3 work=$4
rm -rf "$work"
mkdir -p "$work"
fail() {
  echo "FAILED: $*"
  exit 1
}

# the annotated defaults are a scene that runs
"$scene" --print-parameters > "$work/defaults.prm"
"$scene" "$work/defaults.prm" --quiet --output "$work/defaults"

# what the file changes of them is small, and the same scene
"$scene" "$work/defaults.prm" --print-parameters > "$work/small.prm"
[ "$(wc -l < "$work/small.prm")" -lt 60 ] || fail "--print-parameters FILE is long"
"$scene" "$work/small.prm" --quiet --output "$work/small"
cmp "$work/defaults/history.csv" "$work/small/history.csv"

# so are the parameters in the output
"$scene" "$work/small/parameters.prm" --quiet --output "$work/again"
cmp "$work/defaults/history.csv" "$work/again/history.csv"
"$fit" --print-parameters > "$work/fit.prm"
"$fit" "$work/fit.prm" --check --quiet
"$fit" "$work/fit.prm" --print-parameters > "$work/small_fit.prm"
"$fit" "$work/small_fit.prm" --check --quiet

# the same scene as JSON
cat > "$work/scene.json" << 'END'
{
  "Driver": "contact_scene",
  "Bodies": {
    "Names": "body",
    "body": { "Material": { "Young's modulus": 1000 } }
  },
  "Rigid bodies": { "Names": "rigid body" },
  "Boundary conditions": {
    "Names": "condition",
    "condition": {
      "Body": "body", "Boundary ids": "5", "x": "0", "y": "0", "z": "-0.01*t"
    }
  },
  "Contact": {
    "Interfaces": "interface",
    "interface": { "Secondary": "body: boundary 4", "Primary": "rigid body" }
  },
  "Probes": { "Names": "probe", "probe": { "Body": "body" } }
}
END
"$scene" "$work/scene.json" --quiet --output "$work/json"
cmp "$work/defaults/history.csv" "$work/json/history.csv"
sed 's/"Names": "probe",/"Names": "probe"/' "$work/scene.json" > "$work/comma.json"
message=$("$scene" "$work/comma.json" --quiet 2>&1 > /dev/null) && fail "JSON without a comma"
grep -q "comma.json" <<< "$message" || fail "no file in: $message"
sed "s/Young's modulus/Young's modul/" "$work/scene.json" > "$work/entry.json"
message=$("$scene" "$work/entry.json" --quiet 2>&1 > /dev/null) && fail "unknown entry in JSON"
grep -q "Young's modul" <<< "$message" || fail "no entry in: $message"
sed 's/"Driver"/"Dimension": true, "Driver"/' "$work/scene.json" > "$work/value.json"
message=$("$scene" "$work/value.json" --quiet 2>&1 > /dev/null) && fail "true dimensions"
grep -q "Dimension" <<< "$message" || fail "no entry in: $message"
sed 's/"Names": "body"/"Names": ["body"]/' "$work/scene.json" > "$work/list.json"
"$scene" "$work/list.json" --check --quiet || fail "a list in JSON"

# presets set entries, those of the file win
"$scene" "$work/small.prm" --print-parameters --set Accuracy=exact > "$work/exact.prm"
grep -q "Degree *= 6" "$work/exact.prm" || fail "Accuracy = exact sets no Degree"
"$scene" "$work/small.prm" --print-parameters --set Accuracy=exact \
  --set Contact/interface/Degree=4 > "$work/four.prm"
grep -q "Degree *= 4" "$work/four.prm" || fail "Accuracy overrules an entry"
"$scene" "$work/small.prm" --print-parameters --set Accuracy=exact \
  --set Contact/interface/Degree=5 > "$work/five.prm"
"$scene" "$work/five.prm" --print-parameters | grep -q "Degree *= 5" ||
  fail "a default that is given again is lost"

# features and why they are on
"$scene" "$work/small.prm" --check --set "Contact/interface/Friction coefficient=0.3" \
  > "$work/check.txt"
grep -q "friction (Contact/interface" "$work/check.txt" || fail "friction is not on"
grep -q "^Off.*ties" "$work/check.txt" || fail "ties are not off"

# completion
complete_words() {
  bash -c 'source "$1"; _mortar_contact "$2" "$3" "$4"; printf "%s\n" "${COMPREPLY[@]}"' \
    completion "$scripts/completion.bash" "$scene" "$1" "$2"
}
complete_words "Solver/Newton/Forc" --set | grep -qx '"Solver/Newton/Force tolerance="' ||
  fail "no completion of entries"
complete_words --ch contact_scene | grep -qx -- "--check" || fail "no completion of options"
echo "all inputs read"
