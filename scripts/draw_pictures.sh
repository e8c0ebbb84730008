#!/usr/bin/env bash
# Draws the pictures of README.md, docs and the site anew, by the program in build/release (or PROGRAM). The picture
# of the page, docs/page.png, is a screenshot; docs/first_measurement.png needs the file that the page names.
#   scripts/draw_pictures.sh [FILE]
#   scripts/draw_pictures.sh --check PROGRAM    says which pictures the program would draw otherwise; changes none
# Exit code 77 of --check: another gnuplot is installed than the one that drew the pictures.
set -euo pipefail
cd "$(dirname "$0")/.."
program=$PWD/build/release/pendular
check=
if [ "${1:-}" = --check ]; then
  check=yes program=$(realpath "$2")
  shift 2
  # Texts and lines differ by single pixels from version to version.
  [ "$(gnuplot --version)" = "gnuplot 5.4 patchlevel 4" ] || exit 77
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PENDULAR_STORE=$work/runs.sqlite
failed=0

# picture DRAWN KEPT: puts a picture in its place, or compares it with the one that is there.
picture() {
  if [ -z "$check" ]; then
    cp "$1" "$2"
  elif ! cmp -s "$1" "$2"; then
    echo "$2 is not what the program draws: look at what scripts/draw_pictures.sh draws, and keep it."
    failed=1
  fi
}
# calibrated NAME: copies an example to work and calibrates it.
calibrated() {
  cp -r "examples/$1" "$work/$1"
  "$program" calibrate "$work/$1" --no-confirm --quiet >"$work/log"
}

calibrated hidden-effect
"$program" diagnose "$work/hidden-effect" --quiet >"$work/log"
for name in diagnosis impact; do
  picture "$work/hidden-effect/out/figures/$name.png" docs/explanation/$name.png
done
"$program" add "$work/hidden-effect" wall-friction --quiet >"$work/log"
picture "$work/hidden-effect/out/figures/change.png" docs/change.png

calibrated wet
"$program" compare "$work/wet" >"$work/log"
picture "$work/wet/out/figures/stress_ratio_wet.png" docs/explanation/model.png

calibrated straight-line
"$program" compare "$work/straight-line" >"$work/log"
picture "$work/straight-line/out/figures/stress_ratio_wet.png" docs/tutorial/straight_line.png

calibrated polystyrene
"$program" compare "$work/polystyrene" >"$work/log"
picture "$work/polystyrene/out/figures/calibration.png" docs/calibration.png

"$program" predict --along reduced-pressure=0.6:30 --friction 0.09 --liquid-content 0.03 \
  --out "$work/curve" >"$work/log"
picture "$work/curve/figures/prediction.png" docs/explanation/emulator.png

if [ $# -gt 0 ]; then
  "$program" import "$1" --study "$work/coated" >"$work/log"
  "$program" calibrate "$work/coated" --no-confirm --quiet >"$work/log"
  "$program" compare "$work/coated" >"$work/log"
  picture "$work/coated/out/figures/calibration.png" docs/first_measurement.png
fi
[ -n "$check" ] || git --no-pager diff --stat -- docs
exit $failed
