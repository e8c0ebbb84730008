#!/usr/bin/env bash
# Sends hostile and broken studies to the program and checks what it answers.
#   attacks.sh PROGRAM [--table FILE] [KIND]
# KIND: text, numbers, paths, stores, files, work; all without it. --table: writes a row per attack
# (name, exit code, seconds, what was wrong or "ok", answer), for docs/hostile-input.md. Exit code 1 if an answer is wrong.
#
# The files of this folder hold the attacks, each one a call
#   attack NAME CODE TEXT <<'E' ... E
# The commands run in an empty folder. The last `run` must end with the exit code CODE ('2|1': either),
# and TEXT must be in its output. `fail WHY` marks an attack as failed. A run may take 20 s of the
# processor and 4 GB, and never prints an escape character.
set -u
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$(realpath "$1")
shift
table=/dev/null
if [ "${1:-}" = --table ]; then table=$2; : >"$table"; shift 2; fi
kinds=${1:-text numbers paths stores files work}
failed=0 attacks=0
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export PENDULAR_ATLAS=$here/../../sim/atlas/atlas.csv
export here program

. "$here/support.sh"

attack() {
  local name=$1 code=$2 text=$3 begin seconds got verdict=ok
  attacks=$((attacks + 1))
  rm -rf "${work:?}/box"; mkdir -p "$work/box/here" "$work/box/outside"
  cat >"$work/box/commands"
  begin=$(date +%s%N)
  (cd "$work/box/here" && exec bash -c '. "$here/support.sh"; . ../commands' >/dev/null 2>"$work/box/shell")
  seconds=$(awk -v ns=$(($(date +%s%N) - begin)) 'BEGIN {printf "%.1f", ns / 1e9}')
  got=$(cat "$work/box/code" 2>/dev/null || echo none)
  [[ $got =~ ^($code)$ ]] || verdict="exit code $got, not $code"
  cat "$work/box/err" "$work/box/out" >"$work/box/answer" 2>/dev/null
  [ -z "$text" ] || grep -qaF -- "$text" "$work/box/answer" || verdict="'$text' is not in the answer"
  ! grep -qP '[\x00-\x08\x0b\x0c\x0e-\x1f\x7f]' "$work/box/answer" || verdict="control characters in the answer"
  [ ! -s "$work/box/failed" ] || verdict=$(head -1 "$work/box/failed")
  printf '%s\t%s\t%s\t%s\t%s\n' "$name" "$got" "$seconds" "$verdict" \
    "$(grep -a -v '^[[:space:]]*$' "$work/box/answer" | head -1 | cut -c1-300 | tr -d '\000' | cat -v)" >>"$table"
  if [ "$verdict" != ok ]; then
    failed=$((failed + 1))
    printf 'FAILED %s: %s\n' "$name" "$verdict"
    head -3 "$work/box/answer" "$work/box/shell" | cut -c1-300 | cat -v
  fi
}

for kind in $kinds; do . "$here/$kind.sh"; done
printf '%d of %d attacks failed.\n' "$failed" "$attacks"
[ "$failed" -eq 0 ]
