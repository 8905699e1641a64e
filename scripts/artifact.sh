#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prints every table of docs/benchmarks.md that the repository alone can measure, next to the table of the document. Installs
# missing packages, and builds in release form. Options: --only TEXT (sections whose
# heading contains it), --quick (no models of more than a million states).
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/setup.sh benchmarks
cmake --preset release -DROBOCHART_BENCHMARKS=ON -DROBOCHART_WITH_ENKI=ON >/dev/null
targets=(controllers checker prism markov frontend lsp simulation)
cmake --build --preset release --target robochart-verify "${targets[@]/#/benchmark_}"
exec python3 benchmarks/artifact.py "$@"
