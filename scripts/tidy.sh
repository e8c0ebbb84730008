#!/usr/bin/env bash
# Runs clang-tidy with the checks of .clang-tidy.
#   scripts/tidy.sh            source files that the last commit or the working copy changed
#   scripts/tidy.sh --all      all source files of the program; 11 s of the processor for each
#   scripts/tidy.sh --input    source files that read what others wrote: files, studies, stores
#   scripts/tidy.sh FILE...    these files
# Fails if a check finds an error (WarningsAsErrors there).
set -euo pipefail
cd "$(dirname "$0")/.."

folders=(data sim calib analysis workflow reports app)
case ${1:-} in
  --input) mapfile -t files < <(git ls-files -- data/{files,quantities,study}/'*.cpp' sim/runs/store/'*.cpp') ;;
  --all) mapfile -t files < <(git ls-files -- "${folders[@]/%//*.cpp}") ;;
  "") mapfile -t files < <(git diff --name-only --diff-filter=d HEAD~1 -- "${folders[@]/%//*.cpp}") ;;
  -*) echo "usage: scripts/tidy.sh [--all | --input | FILE...]" >&2; exit 2 ;;
  *) files=("$@") ;;
esac
[ ${#files[@]} -gt 0 ] || { echo "No source file to check."; exit 0; }
# The preset dev compiles each file by itself; only its list of commands is needed.
[ -f build/dev/compile_commands.json ] || cmake --preset dev >/dev/null
printf '%s\0' "${files[@]}" | xargs -0 -n 1 -P "$(nproc)" clang-tidy -p build/dev --quiet --extra-arg=-Wno-unknown-warning-option 2>/dev/null
