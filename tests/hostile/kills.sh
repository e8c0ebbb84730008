#!/usr/bin/env bash
# Kills the program at random instants while it changes a study, and looks at what is left.
#   kills.sh PROGRAM [KILLS [SEED]]
# The commands are add, drop, calibrate and compare, in turn; every other kill comes while files are
# written. After every kill study.toml must be the
# text before the command or after it, to the byte; every JSON file, CSV file and figure must be whole.
# At the end all commands must work again. Prints how many kills came while the program still ran, and
# how many of these left study.toml as before.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
kills=${2:-100}
RANDOM=${3:-1}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PENDULAR_STORE=$work/store.sqlite PENDULAR_ATLAS=$here/../../sim/atlas/atlas.csv
export PENDULAR_LOCK_SECONDS=5
cp -r "$here/../../examples/dry-recordings" "$work/s"
cd "$work" || exit 1
printf '\n[model]\nbase = "dem"  # a comment of the user\neffects = []   # and another\n' >>s/study.toml

cp s/study.toml without
"$program" calibrate s --no-confirm --quiet >/dev/null || exit 1
begin=$(date +%s%N)
"$program" add s torque-offset --quiet >/dev/null || exit 1
longest=$(( ($(date +%s%N) - begin) / 1000000 ))
cp s/study.toml with
"$program" drop s torque-offset --quiet >/dev/null || exit 1
cmp -s s/study.toml without || { echo "FAILED: add and drop do not restore study.toml"; exit 1; }

milliseconds() { awk -v ms="$1" 'BEGIN {print ms / 1000}'; }
failed=0
wrong() { echo "FAILED after kill $kill of '$command': $*"; failed=$((failed + 1)); }

whole() {
  cmp -s s/study.toml without || cmp -s s/study.toml with || wrong "study.toml is neither before nor after"
  local file
  for file in s/out/*.json; do
    [ ! -e "$file" ] || python3 -m json.tool "$file" >/dev/null 2>&1 || wrong "$file is cut off"
  done
  for file in s/out/figures/*.svg; do
    [ ! -e "$file" ] || tail -c 20 "$file" | grep -q '</svg>' || wrong "$file is cut off"
  done
  for file in s/out/figures/*.png; do
    [ ! -e "$file" ] || tail -c 20 "$file" | grep -qa IEND || wrong "$file is cut off"
  done
  for file in s/out/figures/*.csv s/out/*.csv; do
    [ ! -e "$file" ] || [ -z "$(tail -c 1 "$file")" ] || wrong "$file is cut off"
  done
}

hit=0 before=0
for kill in $(seq "$kills"); do
  case $((kill % 4)) in
    0) command="calibrate s --no-confirm" ;;
    1 | 3) if cmp -s s/study.toml with; then command="drop s torque-offset"; else command="add s torque-offset"; fi ;;
    2) command="compare s" ;;
  esac
  cp s/study.toml was
  # shellcheck disable=SC2086
  "$program" $command --quiet >/dev/null 2>&1 &
  pid=$!
  if [ $((kill % 2)) -eq 0 ]; then
    sleep "$(milliseconds $((RANDOM % (longest + 50))))"  # anywhere
  else
    while kill -0 $pid 2>/dev/null && ! compgen -G 's/*.part' >/dev/null &&
      ! compgen -G 's/out/*.part' >/dev/null; do :; done
    sleep "$(milliseconds $((RANDOM % 40)))"  # while files are written
  fi
  if kill -KILL $pid 2>/dev/null; then hit=$((hit + 1)); cmp -s s/study.toml was && before=$((before + 1)); fi
  wait $pid
  whole
done 2>/dev/null  # where the shell says what was killed

kill=all
for command in "calibrate s --no-confirm" "compare s"; do
  # shellcheck disable=SC2086
  "$program" $command --quiet >/dev/null 2>err || wrong "$(cat err)"
done
cmp -s s/study.toml with && "$program" drop s torque-offset --quiet >/dev/null
cmp -s s/study.toml without || wrong "study.toml is not restored"
printf '%d kills, %d while the program ran, study.toml as before in %d of these; %d temporary files are left; %d failures.\n' \
  "$kills" "$hit" "$before" "$(find s -name '*.part' -o -name '.pendular-*' | wc -l)" "$failed"
[ "$failed" -eq 0 ]
