#!/usr/bin/env bash
# Fails where the words of the project break its rules: docstrings that lean on the one before them,
# names that only this program would use, misspellings, a README that is too long to read, golden texts
# of tests that are gone.
#   tests/check_words.sh ROOT
set -uo pipefail
cd "$1"
broken=0

# Prints the lines found in files of the given kinds and remembers that there were any.
forbid() {
  local why=$1 pattern=$2 hits
  hits=$(find "${folders[@]}" -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.def' \) -print0 |
         xargs -0 grep -nP "$pattern" )
  if [ -n "$hits" ]; then
    printf '%s:\n%s\n' "$why" "$(head -20 <<<"$hits")"
    broken=1
  fi
}

folders=(data sim calib analysis workflow reports app python include bench tests)
forbid "A docstring names what it describes instead of leaning on the one before" \
       '^\s*/// (Of|Those|The same|What|Likewise|Such) '
forbid "A comment calls the paper by its authors, Badetti et al. (2018)" \
       '(//|"|\*).*\b[Tt]he source\x27s\b|^\s*//.*\b(as|in|of|than|where|that) the source\b(?! file)(?!s)'
folders=(data sim calib analysis workflow reports app python include)
for name in learn_scales EmulatorScales untold taught foretold told_so Books open_books Grip Meeting guests Rung \
            rungs Suspect felt absorbed carry_out Supported FormNames Ask Asked Load spin; do
  # "absorbed" remains a key of study.toml and JSON, inside of texts.
  forbid "The project's vocabulary has another name for this" \
         "^(?!\s*//)(?:[^\"/]|\"(?:[^\"\\\\\\\\]|\\\\\\\\.)*\"|/(?!/))*\b$name\b"
done
if find "${folders[@]}" -name 'shown.h' -o -name 'form.h' -o -name 'beads.h' | grep .; then
  echo "The project's vocabulary has another name for these files"
  broken=1
fi

if [ "$(wc -l < README.md)" -gt 120 ]; then
  echo "README.md has more than 120 lines: move what is not the tour to docs/"
  broken=1
fi

# A section of a golden text belongs to a test that there is.
for golden in tests/golden/*/*.txt; do
  folder=$(basename "$(dirname "$golden")") source=$(basename "$golden" .txt).cpp
  [ "$folder" = terminal ] && continue
  sed -n 's/^== \([^ .]*\)\.\([^ ]*\).*/\1 \2/p' "$golden" | sort -u | while read -r suite name; do
    grep -Pzq "\($suite,\s*$name\)" "tests/$folder/$source" || echo "$golden: no test $suite.$name"
  done | grep . && broken=1
done

# Misspelt names that tests give on purpose, the typedef of valijson, and words of exports in other languages are
# no mistakes.
if command -v codespell >/dev/null; then
  find data sim calib analysis workflow reports app python include bench tests docs examples scripts cmake \
       -not -path '*/node_modules/*' -type f \( -name '*.h' -o -name '*.cpp' -o -name '*.md' -o -name '*.sh' -o -name '*.cmake' -o -name '*.toml' -o -path 'python/*.py' \) \
       -print0 | xargs -0 codespell -q 3 -L doesnot,gird,lits,frition,coeficient,desnity,commun,nin,normale,mesure,projet,momento,intervall,als,merrors,tork,stap,ot,modul,fase,amplitud,produkt,serie,groupe,somme,degres,alle,contro,paret,ist,valide \
       README.md ARCHITECTURE.md CONTRIBUTING.md CHANGELOG.md || broken=1
fi
exit $broken
