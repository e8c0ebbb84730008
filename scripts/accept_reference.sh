#!/usr/bin/env bash
# Writes the generated pages of docs/reference anew: commands, effects and terms. Look at the
# difference before you commit it.
set -euo pipefail
cd "$(dirname "$0")/.."
PENDULAR_ACCEPT_GOLDEN=1 build/release/tests/app_tests --gtest_filter="ReferencePages.*"
git --no-pager diff --stat -- docs/reference
