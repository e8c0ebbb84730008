#!/usr/bin/env bash
# Says which C++ files differ from a commit in more than comments and texts.
#   scripts/same_code.sh [COMMIT] [FOLDER...]     default: HEAD and all folders
# A change of words alone leaves this silent, exit code 0. Contents of string literals are not compared, and neither are
# their number where adjacent ones are joined; -s compares them too.
set -euo pipefail
cd "$(git rev-parse --show-toplevel)"
strings=false
if [ "${1:-}" = -s ]; then strings=true; shift; fi
commit=${1:-HEAD}
[ $# -gt 0 ] && shift

# Tokens of a file: no comments, no white space; texts emptied and joined unless they are compared.
tokens() {
  local text
  text=$(g++ -fpreprocessed -dD -E -P -x c++ - 2>/dev/null | tr -d '[:space:]')
  $strings || text=$(sed -E 's/"([^"\\]|\\.)*"/""/g; s/(""){2,}/""/g' <<<"$text")
  printf '%s' "$text"
}

changed=0
while read -r file; do
  [ -f "$file" ] || continue
  if [ "$(git show "$commit:$file" 2>/dev/null | tokens)" != "$(tokens <"$file")" ]; then
    echo "$file"
    changed=1
  fi
done < <(git diff --name-only "$commit" -- "${@:-.}" | grep -E '\.(h|cpp)$')
exit $changed
