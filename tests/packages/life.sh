#!/usr/bin/env bash
# Packages in a clean Debian: installed, run, upgraded from a former version, purged without a trace.
#   life.sh PACKAGES WORK SOURCE
# Prints how long it takes from the package to the figure of scripts/demo.sh, and what is downloaded.
# $PENDULAR_FORMER names the .deb of a former version; without it, the present one gets a lower number.
packages=$(realpath "$1") work=$2 source=$(realpath "$3")
mkdir -p "$work"
. "$(dirname "$0")/clean_debian.sh"
root=$work/life
clean_debian "$release" "$root"
trap 'rm -rf "$root"' EXIT

# Files of the system, but for what apt, dpkg and the loader keep for themselves, and what users own.
files() {
  inside "$root" "find / -xdev \( -path /proc -o -path /root -o -path /tmp -o -path /packages -o -path /var/lib/apt \
    -o -path /var/lib/dpkg -o -path /var/cache -o -path /var/log -o -path /etc/ld.so.cache \) -prune -o -print | sort"
}

# former_package: a package of a version below the present one, with a file that is gone in the present one.
former_package() {
  local tree=$work/former
  rm -rf "$tree" && dpkg-deb -R "$packages"/pendular_*.deb "$tree"
  sed -i 's/^Version: .*/Version: 0.0.1-1/' "$tree/DEBIAN/control"
  echo gone >"$tree/usr/share/pendular/gone-since"
  dpkg-deb --root-owner-group -b "$tree" "$root/packages/former.deb" >/dev/null
  rm -rf "$tree"
}

mkdir "$root/packages" "$root/packages/stores"
cp "$packages"/*.deb "$root/packages"
cp "$source"/tests/data/stores/*.sqlite "$root/packages/stores"
files >"$work/before"

echo "== From the package to the figure of the demo"
begin=$(date +%s.%N)
inside "$root" "apt-get update -q" >"$work/apt.log" || skip "apt cannot reach its repository"
inside "$root" "apt-get install -q -y --no-install-recommends /packages/pendular_*.deb" >"$work/install.log" 2>&1 || fail "$(tail "$work/install.log")"
installed=$(date +%s.%N)
inside "$root" "
  cp -r /usr/share/pendular/examples/polystyrene study
  pendular calibrate study --fidelity quick --no-confirm >answer
  pendular compare study --fidelity quick >/dev/null
  head -n 1 answer" 2>"$work/errors" || fail "$(cat "$work/errors")"
drawn=$(date +%s.%N)
[ "$(head -c 4 "$root/root/study/out/figures/calibration.png" | tail -c 3)" = PNG ] || fail "there is no figure"
grep -E '^(Need to get|After this operation)' "$work/install.log"
awk "BEGIN { printf \"Installed in %.0f s, figure %.1f s later.\n\", $installed - $begin, $drawn - $installed }"

echo "== What else there is"
inside "$root" "
  test -s /usr/share/man/man1/pendular-diagnose.1.gz
  test -s /usr/share/bash-completion/completions/pendular
  test -s /usr/share/applications/pendular.desktop
  pendular --version
  ! pendular --version | grep -v '^Atlas: .* /usr/share/pendular/atlas.csv' | grep /
  pendular diagnose study --fidelity quick | head -n 1
  apt-get install -q -y --no-install-recommends /packages/pendular-doc_*.deb >/dev/null 2>&1
  test -s /usr/share/doc/pendular-doc/html/index.html
  missing=\$(find /usr/share/doc/pendular-doc -xtype l); test -z \"\$missing\" || { echo \"links to nothing: \$missing\"; exit 1; }" ||
  fail "the installed program"

purge_and_compare() {
  purge "$root"
  files >"$work/after"
  # Of other packages: gnuplot and the fonts it needs leave their caches and links.
  diff "$work/before" "$work/after" | sed -n 's/^> /left by dependencies: /p; s/^< /gone: /p' || true
}
echo "== Purged"
purge_and_compare
[ -s "$root/root/study/out/fit.json" ] || fail "purge removed a study"

echo "== Upgraded"
if [ -n "${PENDULAR_FORMER:-}" ]; then cp "$PENDULAR_FORMER" "$root/packages/former.deb"; else former_package; fi
inside "$root" "
  apt-get install -q -y --no-install-recommends /packages/former.deb >/dev/null 2>&1
  pendular --version | head -n 1
  for friction in 0.1 0.2; do
    pendular simulate --beads 100 --stiffness-number 300 --inertial-number 0.05 --strain 1 --friction \$friction --quiet >/dev/null
  done
  pendular runs export /tmp/former.csv --quiet >/dev/null
  apt-get install -q -y --no-install-recommends /packages/pendular_*.deb >/dev/null 2>&1
  pendular --version | head -n 1
  test ! -e /usr/share/pendular/gone-since
  pendular runs export /tmp/present.csv --quiet >/dev/null
  cmp /tmp/former.csv /tmp/present.csv
  for store in /packages/stores/*.sqlite; do pendular runs list --store \$store | head -n 1; done" || fail "the upgrade"
purge_and_compare
[ -s "$root/root/.local/share/pendular/runs.sqlite" ] || fail "purge removed a store"
echo "All right."
