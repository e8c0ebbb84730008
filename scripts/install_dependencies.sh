#!/usr/bin/env bash
# Installs everything Pendular needs to build, test and draw on Debian 12, as root or through sudo.
set -euo pipefail

packages=(
  # build
  g++ cmake ninja-build ccache
  # libraries
  libceres-dev libeigen3-dev libboost-dev libboost-program-options-dev libboost-iostreams-dev
  libboost-filesystem-dev libboost-system-dev libicu-dev libudunits2-dev libtomlplusplus-dev
  nlohmann-json3-dev libcereal-dev libfmt-dev libgnuplot-iostream-dev
  libkainjow-mustache-dev libzip-dev libpugixml-dev libsqlite3-dev libsqlitecpp-dev zlib1g-dev libopenmpi-dev openmpi-bin libmuparser-dev
  libcpp-httplib-dev libmimalloc-dev pkg-config
  # the Python module, its tests and notebooks
  pybind11-dev python3-dev python3-numpy python3-pip python3-venv python3-setuptools python3-wheel python3-pytest
  python3-pandas python3-matplotlib python3-xarray python3-scipy python3-emcee python3-lmfit python3-iminuit python3-tqdm python3-nbclient
  python3-ipykernel mypy
  # figures
  gnuplot-nox fonts-dejavu-core
  # tests, benchmarks, style
  libgtest-dev libgmock-dev libvalijson-dev libbenchmark-dev librapidcheck-dev clang clang-format clang-tidy libclang-rt-14-dev libomp-14-dev doxygen codespell
  sqlite3 python3 locales chromium
  # tests of manual pages and completion, the manual as a site
  groff-base mandoc zsh fish mkdocs python3-pymdownx libjs-katex
  # packages, and a clean Debian to try them in
  dpkg-dev file lintian debootstrap xz-utils fonts-katex libjs-lunr sphinx-rtd-theme-common
)

# Node drives the browser of the tests; any version from 18 on will do.
command -v npm >/dev/null || packages+=(nodejs npm)

missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
browser=$(dirname "${BASH_SOURCE[0]}")/../tests/browser
# Without it, the tests of the page are left out.
install_driver() {
  [ -d "$browser/node_modules/playwright-core" ] || npm --prefix "$browser" ci --no-audit --no-fund --silent ||
    echo "npm cannot install what drives the browser: the tests of the page will be left out." >&2
}
if [ ${#missing[@]} -eq 0 ]; then
  echo "All packages are installed."
  install_driver
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "Run this as root, or install sudo; missing: ${missing[*]}" >&2; exit 1; }
  as_root=(sudo)
fi
echo "Installing ${missing[*]}"
"${as_root[@]}" apt-get update -q
"${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
install_driver
