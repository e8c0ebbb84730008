#!/usr/bin/env bash
# The package of the library in a clean Debian: examples/api is built with what libpendular-dev depends on, a
# compiler and CMake, and calibrates a study.
#   library.sh PACKAGES WORK SOURCE
packages=$(realpath "$1") work=$2 source=$(realpath "$3")
mkdir -p "$work"
. "$(dirname "$0")/clean_debian.sh"
root=$work/library
clean_debian "$release" "$root"
trap 'rm -rf "$root"' EXIT
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
cp -r "$source/examples/api" "$source/examples/hidden-effect" "$root/root"
inside "$root" "
  apt-get update -q
  apt-get install -q -y --no-install-recommends g++ cmake make /packages/pendular_*.deb /packages/libpendular-dev_*.deb" \
  >"$work/install.log" 2>&1 || fail "$(tail "$work/install.log")"
grep -E '^(Need to get|After this operation)' "$work/install.log"
inside "$root" "
  cmake -S api -B build -DCMAKE_BUILD_TYPE=Release >/dev/null
  cmake --build build >/dev/null
  build/calibrate hidden-effect" 2>&1 | tee "$work/told"
grep -q 'friction = 0[.]' "$work/told" || fail "the example says something else"
echo "All right."
