#!/usr/bin/env bash
# Installs what is missing, builds, and runs the tests.
#   scripts/test.sh        everything that is decided in seconds
#   scripts/test.sh --all  simulations and physics too, and unit and law tests again under the
#                          sanitizers, and clang-tidy on what reads input; never those of ctest
#                          label "long", which take hours
# Ends with what took how long.
set -euo pipefail
cd "$(dirname "$0")/.."

case ${1:-} in
  "" | --all) ;;
  *) echo "usage: scripts/test.sh [--all]" >&2; exit 2 ;;
esac
jobs=$(nproc)
times=""

# part NAME COMMAND...: runs a command and notes how long it took.
part() {
  local name=$1 begin=$SECONDS
  shift
  "$@"
  times+=$(printf '%6d s  %s' $((SECONDS - begin)) "$name")$'\n'
}

part "install packages" bash scripts/install_dependencies.sh
part "configure" cmake --preset release
part "build" cmake --build --preset release --parallel "$jobs"
part "unit, law and certified tests" ctest --preset quick --parallel "$jobs"
if [ "${1:-}" = --all ]; then
  part "simulations and physics" ctest --preset slow --parallel "$jobs"
  part "configure with sanitizers" cmake --preset asan
  part "build with sanitizers" cmake --build --preset asan --parallel "$jobs" --target \
    data_tests sim_tests calib_tests analysis_tests workflow_tests reports_tests app_tests laws_tests \
    properties_tests fuzz_corpus pendular
  part "tests under sanitizers" ctest --preset asan --parallel "$jobs"
  part "static checks of what reads input" bash scripts/tidy.sh --input
fi
printf '\nAll passed. What took how long:\n%s%6d s  in all\n' "$times" "$SECONDS"
