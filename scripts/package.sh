#!/usr/bin/env bash
# Makes the packages of Debian (pendular, libpendular-dev, python3-pendular, pendular-doc) and the archive that
# runs without being installed, from a build of its own, and has lintian look at them.
#   scripts/package.sh [FOLDER]     default: build/packages
# PENDULAR_CONTACT, "NAME <ADDRESS>", or else DEBFULLNAME and DEBEMAIL, as for other tools of Debian, name the
# maintainer in the packages; without them, it is the developers, without an address that can be written to.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(realpath -m "${1:-build/packages}")

if [ -d .git ] || [ -f .git ]; then
  SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
fi
# Of an archive of the sources without history: the time of its files.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(stat -c %Y CMakeLists.txt)}
contact=${PENDULAR_CONTACT:-${DEBEMAIL:+${DEBFULLNAME:-The Pendular developers} <$DEBEMAIL>}}
# -U: the contact of an earlier call does not stay.
cmake --preset package -UPENDULAR_CONTACT ${contact:+"-DPENDULAR_CONTACT=$contact"}
cmake --build --preset package --parallel "$(nproc)"

rm -rf "$folder" && mkdir -p "$folder"
(cd build/package && cpack -G DEB -B "$folder")
rm -rf "$folder/_CPack_Packages"
bash packaging/make_archive.sh build/package "$folder"

# Errors and warnings without an explained exception in packaging/lintian-overrides end this script.
lintian --allow-root --fail-on error,warning "$folder"/*.deb
ls -l "$folder"
