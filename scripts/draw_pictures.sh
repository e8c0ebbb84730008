#!/usr/bin/env bash
# Draws the pictures of README.md and docs anew, by the program in build/release. The picture of the
# page, docs/page.png, is a screenshot; docs/first_measurement.png needs the file that the page names,
# as the only argument.
set -euo pipefail
cd "$(dirname "$0")/.."
program=$PWD/build/release/pendular
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PENDULAR_STORE=$work/runs.sqlite

# calibrated NAME: copies an example to work and calibrates it.
calibrated() {
  cp -r "examples/$1" "$work/$1"
  "$program" calibrate "$work/$1" --no-confirm --quiet >"$work/log"
}

calibrated hidden-effect
"$program" diagnose "$work/hidden-effect" --quiet >"$work/log"
cp "$work/hidden-effect/out/figures/"{diagnosis,impact}.png docs/explanation
"$program" add "$work/hidden-effect" wall-friction --quiet >"$work/log"
cp "$work/hidden-effect/out/figures/change.png" docs

calibrated wet
"$program" compare "$work/wet" >"$work/log"
cp "$work/wet/out/figures/stress_ratio_wet.png" docs/explanation/model.png

calibrated polystyrene
"$program" compare "$work/polystyrene" >"$work/log"
cp "$work/polystyrene/out/figures/calibration.png" docs/calibration.png

"$program" predict --along reduced-pressure=0.6:30 --friction 0.09 --liquid-content 0.03 \
  --out "$work/curve" >"$work/log"
cp "$work/curve/figures/prediction.png" docs/explanation/emulator.png

if [ $# -gt 0 ]; then
  "$program" import "$1" --study "$work/coated" >"$work/log"
  "$program" calibrate "$work/coated" --no-confirm --quiet >"$work/log"
  "$program" compare "$work/coated" >"$work/log"
  cp "$work/coated/out/figures/calibration.png" docs/first_measurement.png
fi
git --no-pager diff --stat -- docs
