#!/usr/bin/env bash
# The package of the module in a clean Debian: without the program and without pandas, the module calibrates a
# study from memory; beside the program, it gives the program's numbers; purged, it leaves nothing, although
# root has imported it.
#   python.sh PACKAGES WORK SOURCE
packages=$(realpath "$1") work=$2 source=$(realpath "$3")
mkdir -p "$work"
. "$(dirname "$0")/clean_debian.sh"
ls "$packages"/python3-pendular_*.deb >/dev/null 2>&1 || fail "there is no package python3-pendular"
root=$work/python
clean_debian "$release" "$root"
trap 'rm -rf "$root"' EXIT
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r "$source/examples/hidden-effect" "$root/root"
cat >"$root/root/alone.py" <<'MODULE'
import pendular

states = pendular.predict([0.09, 0.2], 0.01, store=False)
assert not any(states.why_not), states.why_not
study = pendular.Study(
    grains={"diameter": "500 um", "density": "1050 kg/m^3"}, store=False,
    readings={"normal_stress [kPa]": [0.3, 1, 3], "stress_ratio": [0.282, 0.281, 0.283], "stress_ratio_sd": [0.003] * 3,
              "solid_fraction": [0.613, 0.613, 0.615], "solid_fraction_sd": [0.001] * 3,
              "inertial_number": [0.01] * 3, "liquid_content": [0.0] * 3})
print("The module alone:", study.calibrate())
MODULE
cat >"$root/root/beside.py" <<'MODULE'
import json
import subprocess

import pendular

told = subprocess.run(["pendular", "calibrate", "hidden-effect", "--no-confirm", "--json", "-", "--quiet"],
                      check=True, capture_output=True).stdout
fit = pendular.open("hidden-effect").calibrate()
printed = json.loads(told)
assert printed.pop("format")  # belongs to the file
assert printed == fit.to_dict()
print("Beside the program:", fit.to_dataframe().shape, fit.parameters["friction"])
MODULE

begin=$(date +%s.%N)
inside "$root" "apt-get update -q" >"$work/apt.log" || skip "apt cannot reach its repository"
inside "$root" "apt-get install -q -y --no-install-recommends /packages/python3-pendular_*.deb" >"$work/install.log" 2>&1 || fail "$(tail "$work/install.log")"
grep -E '^(Need to get|After this operation)' "$work/install.log"
awk "BEGIN { printf \"Installed in %.0f s.\\n\", $(date +%s.%N) - $begin }"
inside "$root" "
  ! command -v pendular gnuplot
  python3 alone.py
  apt-get install -q -y --no-install-recommends python3-pandas /packages/pendular_*.deb >/dev/null 2>&1
  python3 beside.py
  ls -d /usr/lib/python3/dist-packages/pendular/__pycache__ >/dev/null" 2>&1 || fail "the module"
purge "$root"
echo "All right."
