#!/usr/bin/env bash
# Installs what is missing, builds, and runs all tests but the long ones (ctest label "long"):
# unit and law tests, physics, then unit and law tests again under the sanitizers, but for a dozen
# that simulate for minutes there (named in CMakePresets.json).
set -euo pipefail
cd "$(dirname "$0")/.."

bash scripts/install_dependencies.sh
jobs=$(nproc)

cmake --preset release
cmake --build --preset release --parallel "$jobs"
ctest --preset release --parallel "$jobs"

cmake --preset asan
cmake --build --preset asan --parallel "$jobs" --target unit_tests laws_tests pendular
ctest --preset asan --parallel "$jobs"
