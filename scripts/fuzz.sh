#!/usr/bin/env bash
# Builds the fuzz targets of tests/fuzz and runs them.
#   scripts/fuzz.sh [--seconds S] [--runs N] [--jobs J] [--report FILE] [TARGET...]
# Every target runs for S seconds (default 20) or N executions, whichever ends first, from the corpus in
# tests/fuzz/corpus/TARGET. New inputs go to build/fuzz/corpus/TARGET, and are read by the next run; what
# breaks a target goes to build/fuzz/artifacts. Ends with executions and findings of each target, which
# --report also writes to a file. Exit code 1 if one broke.
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=20 runs=-1 jobs=$(nproc) report=/dev/null targets=()
while [ $# -gt 0 ]; do
  case $1 in
    --seconds) seconds=$2; shift 2 ;;
    --runs) runs=$2; shift 2 ;;
    --jobs) jobs=$2; shift 2 ;;
    --report) report=$2; shift 2 ;;
    -*) echo "usage: scripts/fuzz.sh [--seconds S] [--runs N] [--jobs J] [--report FILE] [TARGET...]" >&2; exit 2 ;;
    *) targets+=("$1"); shift ;;
  esac
done
if [ ${#targets[@]} -eq 0 ]; then
  for source in tests/fuzz/*.cpp; do targets+=("$(basename "$source" .cpp)"); done
fi

[ -f build/fuzz/build.ninja ] || cmake --preset fuzz
cmake --build build/fuzz --parallel "$jobs" --target "${targets[@]/#/fuzz_}"

# one TARGET: runs a target and prints a line about it.
one() {
  local target=$1 new=build/fuzz/corpus/$1 kept=tests/fuzz/corpus/$1 words=tests/fuzz/$1.dict code=0 options=()
  mkdir -p "$new" "$kept" "build/fuzz/artifacts/$target"
  [ ! -f "$words" ] || options+=("-dict=$words")
  # A limit of 10 s an input and of 2 GB tells hangs and hunger for memory.
  PENDULAR_ATLAS=sim/atlas/atlas.csv ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 \
    "build/fuzz/tests/fuzz/fuzz_$target" -max_total_time="$2" -runs="$3" -timeout=10 -rss_limit_mb=2048 \
    -max_len=16384 -print_final_stats=1 -artifact_prefix="build/fuzz/artifacts/$target/" "${options[@]}" \
    "$new" "$kept" >"build/fuzz/$target.log" 2>&1 || code=$?
  printf '%-16s %12s executions, exit code %d%s\n' "$target" \
    "$(awk '/number_of_executed_units/ {n = $2} END {print n + 0}' "build/fuzz/$target.log")" "$code" \
    "$([ "$code" -eq 0 ] || printf ': see build/fuzz/%s.log' "$target")"
  return "$code"
}
export -f one
failed=0
printf '%s\n' "${targets[@]}" | xargs -P "$jobs" -I{} bash -c "one {} $seconds $runs" | tee "$report" || failed=1
rm -rf /dev/shm/pendular_fuzz_*
exit $failed
