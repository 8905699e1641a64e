#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Tests the VS Code extension: a copy of editors/vscode with its npm packages, then `npm test`. Argument: the folder for
# the copy (default: build/vscode). Without node, npm or a reachable registry it prints the reason and exits with 77
# (skipped), or with 1 in CI (if CI is set).
set -euo pipefail
cd "$(dirname "$0")/../.."
copy="${1:-build/vscode}"

cannot_run() {
  echo "editors/vscode is not tested: $1" >&2
  if [ -n "${CI:-}" ]; then
    exit 1
  fi
  exit 77
}

for program in node npm; do
  command -v "$program" >/dev/null || cannot_run "$program is not installed (scripts/setup.sh installs it)"
done

mkdir -p "$copy"
rm -rf "$copy"/{client,snippets,syntaxes,tests}
tar -C editors/vscode --exclude=node_modules -c . | tar -C "$copy" -x
cd "$copy"
if ! npm ci --no-audit --no-fund --fetch-retries=2 --fetch-timeout=60000; then
  registry="$(npm config get registry)"
  if ! npm ping --fetch-retries=0 >/dev/null 2>&1; then
    cannot_run "the npm registry $registry does not answer"
  fi
  echo "editors/vscode: npm ci failed although $registry answers" >&2
  exit 1
fi
npm test
