#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Installs missing packages, builds, and runs all steps on the aggregation case study.
set -euo pipefail
cd "$(dirname "$0")/.."
cat <<'SAY'
This installs the Debian packages that are missing (with sudo unless you are root), builds robochart-verify into
build/release, and runs it on corpus/aggregation; CSP scripts and C++ go to out/. The first build takes about four
minutes on two cores, the run a few seconds.
SAY
scripts/setup.sh build
cmake --preset release -DROBOCHART_TESTS=OFF >/dev/null
cmake --build --preset release --target robochart-verify
exec build/release/app/robochart-verify corpus/aggregation --out out "$@"
