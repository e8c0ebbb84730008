#!/usr/bin/env bash
# Writes the documentation as a site: the pages of docs/ and beside it, and a page for each effect that
# the program writes. The target 'site' calls this script.
#   scripts/build_site.sh PROGRAM FOLDER
set -euo pipefail
program=$(realpath "$1") folder=$(realpath -m "$2")
cd "$(dirname "$0")/.."
pages=$folder-effects
rm -rf "$pages"
PENDULAR_ATLAS=sim/atlas/atlas.csv "$program" effects --manual "$pages" --quiet
PENDULAR_EFFECT_PAGES=$pages mkdocs build --strict --clean --site-dir "$folder" 2>&1 | sed -n '/WARNING\|ERROR\|Aborted/p'
rm -rf "$pages"
echo "The documentation is in $folder/index.html."
