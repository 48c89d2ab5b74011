#!/usr/bin/env bash
# Run the cases of doc/gallery.md and make their pictures anew (some minutes):
#   scripts/gallery.sh
set -euo pipefail
source "$(dirname "$0")/prepare.sh"
install_missing $build_packages $picture_packages
cd "$root"
pictures=doc/pictures
mkdir -p "$pictures"

# show FILE.prm DRIVER'S-PICTURE NAME: run, make pictures, keep one, small
show() {
  scripts/run.sh "$1" --output "output/gallery/$3" --quiet
  /usr/bin/python3 scripts/shrink.py "output/gallery/$3/$2" "$pictures/$3.png"
}
show prm/rubber_fit.prm pressure.png rubber_fit
show prm/dummy_on_hood.prm hood.png hood
show prm/shell_leaflet.prm valve.png valve
show prm/immersed_leaflets.prm flow.png flow
show prm/tutorial/07_self_contact.prm run.png tube
show prm/tutorial/08_your_own_mesh.prm run.png hook
/usr/bin/python3 scripts/plot_run.py output/gallery/hook --time 0.6
/usr/bin/python3 scripts/shrink.py output/gallery/hook/run.png $pictures/hook.png
show prm/verification/ironing.prm run.png ironing
show prm/verification/hemisphere.prm run.png hemisphere
for more in rubber_fit/section rubber_fit/overlap hood/force valve/valve_history \
  flow/flow_history; do
  /usr/bin/python3 scripts/shrink.py "output/gallery/$more.png" \
    "$pictures/$(basename "$more").png"
done
