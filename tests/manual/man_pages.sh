#!/usr/bin/env bash
# Every command has a manual page, which groff and, where it is installed, mandoc find nothing wrong with.
#   man_pages.sh PROGRAM MANUAL
set -euo pipefail
program=$1 pages=$2/man1
command -v groff >/dev/null || { echo "groff is not installed"; exit 77; }
wrong=0
commands=$("$program" --help | sed -n 's/^  \([a-z-]\+\)  *[a-z].*/\1/p' | grep -vx pendular)
[ "$(wc -l <<<"$commands")" -ge 15 ] || { echo "the program lists too few commands"; exit 1; }
for page in pendular $(sed 's/^/pendular-/' <<<"$commands"); do
  file=$pages/$page.1
  [ -s "$file" ] || { echo "$page has no manual page"; wrong=1; continue; }
  complaints=$(groff -man -ww -Tutf8 -z "$file" 2>&1
    if command -v mandoc >/dev/null; then mandoc -Tlint -W warning "$file" 2>&1; fi) || true
  [ -z "$complaints" ] || { echo "$complaints"; wrong=1; }
done
# The text is that of the help.
shown=$(MANWIDTH=100 groff -man -Tascii -P-cbou "$pages/pendular-diagnose.1")
for word in "^NAME" "^EXAMPLES" "suspect-measurement" "pendular diagnose my-study --confirm 5" "--runs-of FILE"; do
  grep -q -e "$word" <<<"$shown" || { echo "'$word' is not in the manual page of diagnose"; wrong=1; }
done
exit $wrong
