#!/usr/bin/env bash
# Accepts what the program says now: rewrites tests/golden. Look at the difference before you commit it.
#   scripts/accept_golden.sh terminal/NAME    # a transcript, tests/golden/terminal/NAME.txt
#   scripts/accept_golden.sh FOLDER/NAME      # of the tests that tests/golden/FOLDER/NAME.txt names
#   scripts/accept_golden.sh FOLDER           # of all tests in tests/FOLDER, new ones too
#   scripts/accept_golden.sh                  # everything
set -euo pipefail
cd "$(dirname "$0")/.."
export PENDULAR_ACCEPT_GOLDEN=1

accept() {
    local folder=${1%%/*} file=tests/golden/$1.txt filter='*'
    if [[ $folder == terminal ]]; then
        local name=${1#terminal} && name=${name//-/_}
        folder=app filter="*Transcripts.*$name"
    elif [[ -f $file ]]; then
        filter=$(sed -n 's/^== \([^ ]*\).*/\1/p' "$file" | paste -sd:) && rm "$file"
    elif [[ $1 == */* ]]; then
        echo "$file does not exist; new ones are written with all of the folder $folder" >&2
        return 2
    else
        [[ -x build/release/tests/${folder}_tests ]] || { echo "build ${folder}_tests first" >&2; return 2; }
        rm -rf "tests/golden/$folder"
    fi
    "build/release/tests/${folder}_tests" --gtest_brief=1 --gtest_filter="$filter"
}

if [[ $# -gt 0 ]]; then
    accept "$1"
else
    for folder in $(ls tests/golden); do accept "$folder"; done
fi
git --no-pager diff --stat -- tests/golden
