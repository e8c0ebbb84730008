#!/usr/bin/env bash
# Makes an archive that runs on any Linux of this processor, unpacked anywhere, without root: the program with
# all libraries that it needs, those of C and C++ and their loader included, since a program that was linked
# with the C library of Debian 12 does not start with an older one.
#   make_archive.sh BUILD FOLDER     writes FOLDER/pendular-VERSION-linux-PROCESSOR.tar.xz
set -euo pipefail
here=$(dirname "$(realpath "$0")")
build=$1 folder=$2
version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' "$build/CMakeCache.txt")
name=pendular-$version-linux-$(uname -m)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
root=$work/$name

cmake --install "$build" --component program --prefix "$root" --strip >/dev/null
mkdir "$root/lib"
mv "$root/bin/pendular" "$root/lib/pendular"
install -m 755 "$here/start_archive.sh" "$root/bin/pendular"
install -m 644 "$here/copyright" "$root/COPYRIGHT"
cp -rL /usr/share/xml/udunits "$root/share/udunits"

# The plain BLAS and LAPACK of Debian, whichever others this machine prefers: OpenBLAS alone has 36 MB.
plain=/usr/lib/$(uname -m)-linux-gnu
# Lines of ldd: "NAME => FILE (ADDRESS)" and, for the loader, "FILE (ADDRESS)".
mapfile -t libraries < <(LD_LIBRARY_PATH=$plain/blas:$plain/lapack ldd "$root/lib/pendular" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p; s/^\s*\(\/[^ ]*\) (.*/\1/p')
for library in "${libraries[@]}"; do
  install -m 644 "$library" "$root/lib/"
  case $library in */ld-*) chmod 755 "$root/lib/${library##*/}" && ln -s "${library##*/}" "$root/lib/loader" ;; esac
done

# Licences of the packages that the libraries come from, and where their sources are.
realpath "${libraries[@]}" >"$work/files"
sed -n 's|^/usr/|/|p' "$work/files" >"$work/by_link"  # some packages name files of /usr/lib by the link /lib
mapfile -t owners < <({ xargs dpkg -S <"$work/files" 2>/dev/null; xargs dpkg -S <"$work/by_link" 2>/dev/null; } |
                      cut -d: -f1 | sort -u)
for owner in "${owners[@]}"; do
  mkdir -p "$root/share/licenses/$owner"
  cp -L "/usr/share/doc/$owner/copyright" "$root/share/licenses/$owner/"
  dpkg-query -W -f='${source:Package} ${source:Version}\n' "$owner" | head -1 >"$root/share/licenses/$owner/source-package-of-debian"
done

tar -C "$work" --sort=name --owner=0 --group=0 --numeric-owner --mtime="@${SOURCE_DATE_EPOCH:-0}" \
    -c "$name" | xz -T0 -3 >"$folder/$name.tar.xz"
echo "The archive is $folder/$name.tar.xz."
