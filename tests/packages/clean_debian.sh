# Functions for tests that need a machine on which nothing is installed: a Debian that debootstrap makes in a
# folder, from the repository that apt of this machine is configured with. To be sourced; expects the variable
# `work`, a folder for what is kept between tests. Exit code 77: cannot be had on this machine.
set -euo pipefail

skip() {
  echo "skipped: $*"
  exit 77
}

[ "$(id -u)" = 0 ] || skip "only root can make a clean Debian"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
unshare --mount --pid --fork true 2>/dev/null || skip "unshare is not permitted"
release=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
# 'apt-get indextargets' lists what apt downloads, with the address of the repository.
repository=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' "Codename: $release" | head -n 1)
[ -n "$repository" ] || skip "apt has no repository of '$release'"

# clean_debian SUITE FOLDER: the smallest system, whose packages are those of SUITE.
clean_debian() {
  local suite=$1 folder=$2 kept=$work/$1.tar
  if [ ! -e "$kept" ]; then
    rm -rf "$work/$suite.new"
    debootstrap --variant=minbase "$suite" "$work/$suite.new" "$repository" >"$work/$suite.log" 2>&1 ||
      skip "debootstrap cannot make '$suite': $(tail -n 1 "$work/$suite.log")"
    tar -C "$work/$suite.new" -cf "$kept.part" . && mv "$kept.part" "$kept"
    rm -rf "$work/$suite.new"
  fi
  rm -rf "$folder" && mkdir -p "$folder" && tar -C "$folder" -xf "$kept"
  apt-config dump Acquire | grep -i '::proxy' >"$folder/etc/apt/apt.conf.d/proxy" || true
}

# inside FOLDER COMMANDS: runs commands of a shell in such a system, with its own processes.
inside() {
  unshare --mount --pid --fork --mount-proc="$1/proc" env -i ${http_proxy:+http_proxy="$http_proxy"} \
    PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive chroot "$1" /bin/sh -ec "cd /root; $2"
}

# purge FOLDER: removes all packages of Pendular from such a system, and fails if a file of one is left.
purge() {
  inside "$1" "
    apt-get purge -q -y \$(dpkg-query -W -f '\${Package} ' '*pendular*') && apt-get autoremove -q -y --purge" >"$work/purge.log" 2>&1 || fail "$(tail "$work/purge.log")"
  inside "$1" "find / -xdev \( -path /proc -o -path /root -o -path /packages -o -path /var/log -o -path /var/lib/apt \) -prune \
    -o -iname '*pendular*' -print" >"$work/left"
  [ ! -s "$work/left" ] || fail "purge leaves $(cat "$work/left")"
}

fail() {
  echo "FAILED: $*"
  exit 1
}
