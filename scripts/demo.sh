#!/usr/bin/env bash
# From nothing to a calibrated friction with its figures: installs what is missing, builds, calibrates
# the published measurement of dry polystyrene beads, and predicts the wet range. The first figure
# rests on the simulations that come with the program; new ones confirm it. Takes about four minutes
# on two cores, most of it the build.
set -euo pipefail
cd "$(dirname "$0")/.."

bash scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target pendular

study=examples/polystyrene
verdict=$(mktemp)
trap 'rm -f "$verdict"' EXIT
store=$study/out/runs.sqlite figures=$study/out/figures

build/release/pendular calibrate "$study" --fidelity quick --store "$store" --no-confirm --quiet >"$verdict"
build/release/pendular compare "$study" --fidelity quick --quiet >/dev/null
head -n 1 "$verdict"
echo "Figure: $figures/calibration.png. New simulations now check this fit, in about half a minute."
echo

build/release/pendular calibrate "$study" --fidelity quick --store "$store" | tee "$verdict"
build/release/pendular compare "$study" --fidelity quick

echo
echo "Results: $study/out/fit.json, $study/out/compare.json; every run: $store"
echo "Figures: $figures/calibration.png and others (SVG, PDF, CSV beside them)"
head -n 1 "$verdict"
