#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Prepares a release: checks that the versions agree, runs all tests, builds and tests the packages, and prints the
# command that sets the tag. Changes nothing in the repository. `scripts/release.sh --check` only compares the versions.
set -euo pipefail
cd "$(dirname "$0")/.."

stop() {
  echo "$1" >&2
  exit 1
}

version="$(sed -n 's/^project(robochart-verify VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)"
[ -n "$version" ] || stop "CMakeLists.txt has no version"
grep -qx "version: $version" CITATION.cff || stop "CITATION.cff does not have version $version"
grep -q "^## $version\b" CHANGELOG.md || stop "CHANGELOG.md has no heading '## $version'"
[ "${1:-}" != --check ] || exit 0
[ "$#" -eq 0 ] || stop "usage: scripts/release.sh [--check]"

[ -z "$(git status --porcelain)" ] || stop "commit or remove the changes first: git status"
git rev-parse -q --verify "refs/tags/v$version" >/dev/null && stop "the tag v$version exists"

scripts/test.sh
scripts/package.sh
program="$(build/package/app/robochart-verify version --format json)"
grep -qF "\"commit\": \"$(git rev-parse HEAD)\"" <<<"$program" && grep -qF '"modified": false' <<<"$program" ||
  stop "the packaged program was not built from this commit: $program"
(cd build/package/packages && sha256sum ./*.deb ./*.tar.gz | tee SHA256SUMS)
echo "To release: git tag -a v$version -m 'robochart-verify $version' && git push origin v$version"
