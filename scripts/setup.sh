#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs the Debian packages that are missing. `scripts/setup.sh build` installs what a build needs; `quick` also what
# `scripts/test.sh --quick` needs, `package` also what the packages need, `benchmarks` also what the benchmarks need.
# Without an argument the script installs what a build and all tests need. Can be run again. Asks for sudo only if a package is missing.
set -euo pipefail

packages=(
  g++ cmake ninja-build ccache mold
  libfmt-dev libcli11-dev nlohmann-json3-dev libeigen3-dev libboost-graph-dev libsodium-dev libexpat1-dev
  libzstd-dev liblz4-dev  # compressed chunks of MCAP files; everything else is built without them
  libz3-dev  # classes of data for conditions that are not linear; everything else is built without it
  openmpi-bin libopenmpi-dev  # robochart-verify-mpi; everything else is built without them
)
case "${1:-tests}" in
  build) ;;
  quick) packages+=(clang-format libgtest-dev libgmock-dev) ;;
  package) packages+=(ocaml) ;;
  benchmarks) packages+=(libbenchmark-dev libenki-dev ocaml) ;;
  tests)
    packages+=(
      clang clang-format libclang-rt-14-dev
      libgtest-dev libgmock-dev librapidcheck-dev libbenchmark-dev libenki-dev pybind11-dev python3-dev
      ocaml  # robochart-certify: 110 MB to fetch, 440 MB on disk; Coq, for its proofs, is three times as large and optional
      librsvg2-bin graphviz pngcheck poppler-utils  # these programs read the pictures that the tests draw
    )
    # For the tests of editors/vscode. A Node.js from another source is used if present, because it conflicts with
    # Debian's.
    command -v npm >/dev/null || packages+=(nodejs npm)
    if [ -n "${CI:-}" ]; then
      packages+=(gcc-arm-none-eabi libstdc++-arm-none-eabi-dev libnewlib-dev)  # the embedded profile; headers only, because nothing is linked
    else
      packages+=(chromium)  # pages in a browser: 126 MB to fetch, 420 MB on disk, three minutes of tests
    fi
    ;;
  *)
    echo "usage: scripts/setup.sh [build|quick|package|benchmarks|tests]" >&2
    exit 2
    ;;
esac

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
