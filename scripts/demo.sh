#!/usr/bin/env bash
# From nothing to a calibrated friction with its figures: installs what is missing, builds, calibrates
# the published measurement of dry polystyrene beads, confirms it by discrete-element simulation, predicts the wet
# range, and compares. About six minutes on 2 cores once the packages are installed, the build among them.
set -euo pipefail
cd "$(dirname "$0")/.."

bash scripts/install_dependencies.sh
cmake --preset release
cmake --build --preset release --parallel "$(nproc)" --target pendular

study=examples/polystyrene
verdict=$(mktemp)
trap 'rm -f "$verdict"' EXIT
build/release/pendular calibrate "$study" --fidelity quick --store "$study/out/runs.sqlite" | tee "$verdict"
build/release/pendular compare "$study" --fidelity quick

echo
echo "Results: $study/out/fit.json, $study/out/compare.json; every run: $study/out/runs.sqlite"
echo "Figures: $study/out/figures/calibration.png and others (SVG, PDF, CSV beside them)"
head -n 1 "$verdict"
