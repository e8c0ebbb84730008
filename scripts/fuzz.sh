#!/usr/bin/env bash
# Builds the fuzz targets of tests/fuzz and runs them.
#   scripts/fuzz.sh [--seconds S] [--runs N] [--jobs J] [--goal N] [--tally FILE] [TARGET...]
# Every target runs for S seconds (default 20) or N executions, whichever ends first, from the corpus in
# tests/fuzz/corpus/TARGET. New inputs go to build/fuzz/corpus/TARGET, and are read by the next run; what
# breaks a target goes to build/fuzz/artifacts. Ends with executions and findings of each target. Exit
# code 1 if one broke.
# --tally adds what each run did to a table: executions, processor time and findings of each target, over
# all runs so far. --goal (with --tally) runs the targets in turn, again and again, until the table has N
# executions of each; it can be ended at any time and begun again.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=20 runs=-1 jobs=$(nproc) goal=0 tally="" targets=()
usage() {
  echo "usage: scripts/fuzz.sh [--seconds S] [--runs N] [--jobs J] [--goal N] [--tally FILE] [TARGET...]" >&2
  exit 2
}
while [ $# -gt 0 ]; do
  case $1 in
    --seconds | --runs | --jobs | --goal | --tally)
      [ $# -gt 1 ] || usage
      declare "${1#--}=$2"
      shift 2 ;;
    -*) usage ;;
    *) targets+=("$1"); shift ;;
  esac
done
[ "$goal" -eq 0 ] || [ -n "$tally" ] || usage
if [ ${#targets[@]} -eq 0 ]; then
  for source in tests/fuzz/corpus/*/; do targets+=("$(basename "$source")"); done
fi

[ -f build/fuzz/build.ninja ] || cmake --preset fuzz
cmake --build build/fuzz --parallel "$jobs" --target "${targets[@]/#/fuzz_}"

# add_to_tally FILE TARGET EXECUTIONS SECONDS FINDINGS: adds a run to the table of all runs.
add_to_tally() {
  (
    flock 9
    [ -f "$1" ] || echo "target,executions,processor_seconds,findings,first_day,last_day" >"$1"
    awk -F, -v OFS=, -v target="$2" -v n="$3" -v s="$4" -v f="$5" -v day="$(date -u +%F)" '
      $1 == target { $2 += n; $3 += s; $4 += f; $6 = day; known = 1 }
      { print }
      END { if (!known) print target, n, s, f, day, day }' "$1" >"$1.part"
    mv "$1.part" "$1"
  ) 9>build/fuzz/tally.lock
}

# really_hangs TARGET: whether one of the inputs that took 10 s takes 10 s of the processor too. The clock of
# libFuzzer runs on where other programs keep the processor; such inputs are removed.
really_hangs() {
  local input user hangs=1
  for input in "build/fuzz/artifacts/$1"/timeout-*; do
    user=$(TIMEFORMAT=%U; { time "build/fuzz/tests/fuzz/fuzz_$1" -timeout=1000 "$input" >/dev/null 2>&1; } 2>&1)
    if [ "${user%.*}" -ge 10 ]; then hangs=0; else rm "$input"; fi
  done
  return $hangs
}

# one TARGET SECONDS RUNS TALLY: runs a target and prints a line about it.
one() {
  local target=$1 new=build/fuzz/corpus/$1 kept=tests/fuzz/corpus/$1 words=tests/fuzz/$1.dict code=0 options=()
  local log=build/fuzz/$1.log executions processor longest
  mkdir -p "$new" "$kept" "build/fuzz/artifacts/$target"
  [ ! -f "$words" ] || options+=("-dict=$words")
  longest=$(find "$kept" -type f -printf '%s\n' | sort -n | tail -1)
  [ "${longest:-0}" -ge 4096 ] || longest=4096
  # A limit of 10 s an input and of 2 GB tells hangs and hunger for memory. What libFuzzer would print about
  # new functions, and how it weighs inputs, would take up to a third of the time.
  PENDULAR_ATLAS=sim/atlas/atlas.csv ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
    bash -c 'TIMEFORMAT="processor seconds: %U"; time "$@"' run \
    "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="$2" -runs="$3" -timeout=10 -rss_limit_mb=2048 \
    -max_len="$longest" -entropic=0 -detect_leaks=0 -print_funcs=0 -print_final_stats=1 -artifact_prefix="build/fuzz/artifacts/$target/" "${options[@]}" \
    "$new" "$kept" >"$log" 2>&1 || code=$?
  if [ "$code" -eq 70 ] && ! really_hangs "$target"; then code=0; fi
  if [ "$code" -eq 72 ]; then code=0; fi  # ended by Ctrl-C
  executions=$(awk '/number_of_executed_units/ {n = $2} END {print n + 0}' "$log")
  processor=$(awk '/^processor seconds/ {print $3}' "$log")
  [ -z "$4" ] || add_to_tally "$4" "$target" "$executions" "${processor:-0}" $((code != 0))
  printf '%-16s %12s executions, exit code %d%s\n' "$target" "$executions" "$code" \
    "$([ "$code" -eq 0 ] || printf ': see %s' "$log")"
  return "$code"
}
export -f one add_to_tally really_hangs

# below_goal: targets that have fewer executions in the table than the goal.
below_goal() {
  for target in "${targets[@]}"; do
    [ "$(awk -F, -v target="$target" '$1 == target {n = $2} END {print n + 0}' "$tally")" -ge "$goal" ] ||
      echo "$target"
  done
}

failed=0
if [ "$goal" -eq 0 ]; then
  printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c "one {} $seconds $runs '$tally'" || failed=1
else
  while left=$([ -f "$tally" ] && below_goal || printf '%s\n' "${targets[@]}") && [ -n "$left" ]; do
    xargs -P "$jobs" -I{} bash -c "one {} $seconds $runs '$tally'" <<<"$left" || { failed=1; break; }
  done
fi
rm -rf /dev/shm/pendular_fuzz_*
exit $failed
