# shellcheck shell=bash disable=SC2154
# What the benchmarks share, to be sourced. Scripts that use it set: root (of the project), run (a
# folder for what is not kept), pendular (empty: the program of the preset release, built if need be).

say() { echo "$*" >&2; }
fail() {
  say "$(basename "$0" .sh): $*"
  exit 1
}
wrong() {
  say "$(basename "$0" .sh): $* (--help explains)"
  exit 2
}

build_pendular() {
  if [ -z "$pendular" ]; then
    pendular=$root/build/release/pendular
    say "Building $pendular"
    { cmake --preset release && cmake --build --preset release --target pendular; } >"$run/build" 2>&1 || {
      tail -n 20 "$run/build" >&2
      fail "Pendular does not build; see CONTRIBUTING.md"
    }
  fi
  [ -x "$pendular" ] || fail "$pendular is not a program"
}

# run_logged LOG COMMAND...: runs with both streams in a file, which is shown where it fails.
run_logged() {
  local log=$1
  shift
  "$@" >"$log" 2>&1 </dev/null || {
    tail -n 15 "$log" >&2
    fail "this failed: $1"
  }
}

# describe_machine PACKAGE...: machine and versions, as they stand at the head of a result.
describe_machine() {
  echo "machine   $(awk -F': ' '/model name/ { print $2; exit }' /proc/cpuinfo), $(getconf _NPROCESSORS_ONLN) cores, load $(cut -d' ' -f1 /proc/loadavg) at the start"
  echo "system    $(sed -n 's/^PRETTY_NAME="\(.*\)"/\1/p' /etc/os-release), Linux $(uname -r)"
  echo "compiler  $(c++ --version 2>/dev/null | head -n 1)"
  echo "pendular  $("$pendular" --version 2>/dev/null | head -n 1) $(git -C "$root" describe --always --dirty 2>/dev/null)"
  local package
  for package in "$@"; do
    printf '%-9s %s\n' "$package" "$(dpkg-query -W -f='${Version}' "$package")"
  done
}
