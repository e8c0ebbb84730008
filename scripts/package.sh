#!/usr/bin/env bash
# Makes the packages of Debian (pendular, libpendular-dev, pendular-doc) and the archive that runs without
# being installed, from a build of its own, and has lintian look at them.
#   scripts/package.sh [FOLDER]     default: build/packages
# PENDULAR_CONTACT names the maintainer in the packages, "NAME <ADDRESS>"; default: the author of the commit.
set -euo pipefail
cd "$(dirname "$0")/.."
folder=$(realpath -m "${1:-build/packages}")

if [ -d .git ] || [ -f .git ]; then
  SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
  PENDULAR_CONTACT=${PENDULAR_CONTACT:-$(git log -1 --format='%an <%ae>')}
fi
# Of an archive of the sources without history: the time of its files.
export SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(stat -c %Y CMakeLists.txt)}
cmake --preset package -DPENDULAR_CONTACT="${PENDULAR_CONTACT:-}"
cmake --build --preset package --parallel "$(nproc)"

rm -rf "$folder" && mkdir -p "$folder"
(cd build/package && cpack -G DEB -B "$folder")
rm -rf "$folder/_CPack_Packages"
bash packaging/make_archive.sh build/package "$folder"

# Errors and warnings without an explained exception in packaging/lintian-overrides end this script.
lintian --allow-root --fail-on error,warning "$folder"/*.deb
ls -l "$folder"
