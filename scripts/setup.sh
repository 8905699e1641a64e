#!/usr/bin/env bash
# Installs the Debian packages that the project needs and that are missing. Can be run again; asks for sudo only if
# something is missing and we are not root.
set -euo pipefail

packages=(
  g++ clang clang-format cmake ninja-build ccache mold
  libfmt-dev libcli11-dev nlohmann-json3-dev libeigen3-dev libboost-graph-dev
  libsodium-dev libexpat1-dev libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libclang-rt-14-dev libenki-dev librsvg2-bin graphviz
  openmpi-bin libopenmpi-dev  # robochart-verify-mpi; without them all else is built
  pngcheck poppler-utils  # tests have pictures read by them
)
# For the tests of editors/vscode. A Node.js from elsewhere serves as well, and conflicts with Debian's.
command -v npm >/dev/null || packages+=(nodejs npm)
# For the tests of pages in a browser: 126 MB to fetch, 420 MB on disk, half a minute. Not in continuous integration, whose
# run has no three minutes to spare for them on two cores; there they are skipped.
[ -n "${CI:-}" ] || packages+=(chromium)
# The embedded profile is compiled in continuous integration: 0.4 GB to fetch, 2.5 GB on disk.
[ -z "${CI:-}" ] || packages+=(gcc-arm-none-eabi libstdc++-arm-none-eabi-newlib)

missing=()
for package in "${packages[@]}"; do
  if ! dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'install ok installed'; then
    missing+=("$package")
  fi
done
if [ "${#missing[@]}" -eq 0 ]; then
  exit 0
fi

echo "installing: ${missing[*]}"
as_root=()
if [ "$(id -u)" -ne 0 ]; then
  as_root=(sudo)
fi
export DEBIAN_FRONTEND=noninteractive
"${as_root[@]}" apt-get update -q
"${as_root[@]}" apt-get install -y -q --no-install-recommends "${missing[@]}"
