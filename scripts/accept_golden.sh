#!/usr/bin/env bash
# Accepts what the program says now: rewrites tests/app/golden. Look at the difference before you
# commit it.
#   scripts/accept_golden.sh [NAME]    # NAME of a file there without .txt, all without
set -euo pipefail
cd "$(dirname "$0")/.."
PENDULAR_ACCEPT_GOLDEN=1 build/release/tests/app_tests --gtest_filter="*Transcripts.*${1:+/${1//-/_}}"
git --no-pager diff --stat -- tests/app/golden
