#!/usr/bin/env bash
# The archive in a clean Debian 11, whose C library is older than the one that Pendular was linked with:
# unpacked in a folder with spaces, it goes through the tutorial of the README without gnuplot, as a user
# without rights.
#   archive.sh PACKAGES WORK
packages=$(realpath "$1") work=$2
mkdir -p "$work"
. "$(dirname "$0")/clean_debian.sh"
root=$work/archive
clean_debian bullseye "$root"
trap 'rm -rf "$root"' EXIT
home="$root/home/a user"
mkdir -p "$home"
tar -C "$home" -xf "$packages"/pendular-*.tar.xz
chown -R 1000:1000 "$home"

inside "$root" '
  ldd --version | head -n 1
  cat >/tmp/tour <<"TOUR"
    cd "/home/a user"; export HOME="$PWD"
    p=$(echo "$PWD"/pendular-*/bin/pendular)
    cp -r pendular-*/share/pendular/examples/hidden-effect my-study
    run() { echo "\$ pendular $*"; "$p" "$@" 2>/tmp/errors >/tmp/told || { code=$?; cat /tmp/errors; return $code; }; head -n 1 /tmp/told; }
    set -e
    run --version
    run import my-study
    run calibrate my-study --no-confirm
    run diagnose my-study
    run add my-study wall-friction
    run next my-study
    run report my-study
    test -s my-study/out/report.html
    run simulate --beads 100 --stiffness-number 300 --inertial-number 0.05 --strain 1
    run compare my-study
    grep -q "No figures were drawn, since gnuplot is not installed" /tmp/told
    test -s my-study/out/figures/calibration.csv
    # Nothing of the system is loaded.
    lib=$(echo "$PWD"/pendular-*/lib)
    "$lib/loader" --inhibit-cache --library-path "$lib" --list "$lib/pendular" >/tmp/loaded
    test "$(grep -c " => $lib/" /tmp/loaded)" -gt 40
    if grep " => " /tmp/loaded | grep -v " => $lib/"; then echo "is loaded from outside"; exit 1; fi
TOUR
  setpriv --reuid 1000 --regid 1000 --clear-groups sh /tmp/tour' | tee "$work/tour"
grep -q '^Missing: wall-friction' "$work/tour" || fail "the tour went elsewhere"
echo "All right."
