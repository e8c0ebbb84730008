#!/usr/bin/env bash
# Builds the tests with the thread sanitizer and runs those in which several threads share something:
# refits side by side, readers of units and of the emulator, the store, ensembles of runs, the server, threads of Python.
# Takes about half an hour on two cores the first time. Exit code 1 if the sanitizer reports a race.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset tsan
cmake --build --preset tsan --parallel "$(nproc)"
ctest --preset tsan
