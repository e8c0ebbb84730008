#!/usr/bin/env bash
# Replaces scripts, styles and fonts in pages that mkdocs wrote by links to the same files of other
# packages of Debian, which pendular-doc depends on (cmake/packages.cmake).
#   link_shared_files.sh ROOT     ROOT/usr/share/doc/... are the files of the package
set -euo pipefail
root=$1 pages=/usr/share/doc/pendular-doc/html
declare -A owned
shared=(/usr/share/javascript /usr/share/sphinx_rtd_theme /usr/share/fonts /usr/share/fonts-font-awesome)
while read -r sum file; do owned[$sum]=$file; done < <(
  find "${shared[@]}" -type f \( -name '*.js' -o -name '*.css' -o -path '*font*' \) -exec md5sum {} + 2>/dev/null)
find "$root$pages" -type f \( -name '*.js' -o -name '*.css' -o -path '*/fonts/*' \) -exec md5sum {} + |
  while read -r sum file; do
    there=${owned[$sum]:-}
    [ -z "$there" ] || ln -sf "$(realpath -m -s --relative-to="$(dirname "${file#"$root"}")" "$there")" "$file"
  done
rm -f "$root$pages"/sitemap.xml "$root$pages"/sitemap.xml.gz  # for servers; with the time of the build
