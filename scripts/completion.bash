# Completion for bash: source scripts/completion.bash
# Completes the drivers' options, parameter files, and after --set the entries that
# the driver knows (of contact_scene with its names in the place of NAME).

# Paths of all entries in a driver's annotated defaults, one in a line.
_mortar_contact_entries() {
  "$1" --print-parameters 2> /dev/null | awk '
    $1 == "subsection" { sub(/^[ \t]*subsection[ \t]+/, ""); path[++depth] = $0 }
    $1 == "end" { --depth }
    $1 == "set" {
      sub(/^[ \t]*set[ \t]+/, ""); sub(/[ \t]*=.*/, "")
      text = ""
      for (i = 1; i <= depth; ++i) text = text path[i] "/"
      print text $0 "="
    }'
}

_mortar_contact() {
  local driver=$1 word=$2 before=$3
  COMPREPLY=()
  case "$before" in
    --set)
      local entry
      while IFS= read -r entry; do
        [[ ${entry,,} == "${word,,}"* ]] && COMPREPLY+=("\"$entry\"")
      done < <(_mortar_contact_entries "$driver")
      compopt -o nospace 2> /dev/null
      return
      ;;
    --output | --restart)
      mapfile -t COMPREPLY < <(compgen -d -- "$word")
      return
      ;;
  esac
  case "$word" in
    -*)
      mapfile -t COMPREPLY < <(compgen -W "--set --output --restart --check --pictures --quiet \
        --print-parameters --help --version" -- "$word")
      ;;
    *)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.@(prm|json)' -- "$word"; compgen -d -S / -- "$word")
      compopt -o nospace 2> /dev/null
      ;;
  esac
}

shopt -s extglob
complete -F _mortar_contact contact_scene dummy_on_hood immersed_leaflets rubber_fit \
  shell_leaflet
