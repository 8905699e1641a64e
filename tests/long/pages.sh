#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Runs the tests that need a browser and no C++: the preview of editors/vscode with pictures from the real server; the
# pages that --html writes, checked with the rules of axe-core in light and dark colours; and the output of `draw
# --format mermaid`, parsed by Mermaid's own parser. Arguments: the command (default: that of the release build), a folder for
# the output (default: build/pages). Both npm packages are fetched into that folder, without their dependencies, and
# never shipped. Without Chromium, node, npm or a reachable registry it prints the reason and exits with 77 (skipped).
set -euo pipefail
cd "$(dirname "$0")/../.."
verify="$(realpath "${1:-build/release/app/robochart-verify}")"
made="${2:-build/pages}"

cannot_run() {
  echo "pages are not tested: $1" >&2
  exit 77
}

for program in chromium node npm; do
  command -v "$program" >/dev/null || cannot_run "$program is not installed (scripts/setup.sh installs it)"
done

node tests/browser/preview.mjs "$verify" corpus/swarm_taxis/swarm_taxis.rct

# fetch PACKAGE VERSION FILE SHA512: the file of the package, as $made/PACKAGE/package/FILE.
fetch() {
  local folder="$made/$1" archive="$made/$1/$1-$2.tgz"
  mkdir -p "$folder"
  if [ ! -f "$archive" ]; then
    (cd "$folder" && npm pack --silent --fetch-retries=2 --fetch-timeout=60000 "$1@$2" >/dev/null) ||
      cannot_run "the npm registry $(npm config get registry) has not given $1"
  fi
  echo "$4  $archive" | sha512sum --check --quiet || { rm "$archive"; exit 1; }
  tar -C "$folder" -xzf "$archive" "package/$3"
}
fetch axe-core 4.14.1 axe.min.js \
  1477dafa598d8d065f273d6af302aa203c02e83131707b7fa648cd41bd3d6b734f8c22a0dab86ee6a6f64b8afbe804b214d36db85a2826965edfb3a0b9d546b5
fetch mermaid 11.17.2 dist/mermaid.min.js \
  57a2b70bc101744b0f1595d228c25eea9a50384371b87011afd1af1d7e21878ee501b84c443f6a7f8a042bb2e869143150b31af34feab798073bbdda0a578106

pages="$made/pages"
drawn="$made/drawn"
rm -rf "$pages" "$drawn"
mkdir -p "$pages" "$drawn"

# page NAME ARGUMENTS...: generates a page; its claims are expected to fail.
page() {
  local status=0
  "$verify" "${@:2}" --html "$pages/$1.html" >"$pages/$1.txt" 2>&1 || status=$?
  if [ "$status" -gt 1 ] || [ ! -s "$pages/$1.html" ]; then
    echo "robochart-verify ${*:2}: exit code $status" >&2
    cat "$pages/$1.txt" >&2
    exit 1
  fi
}
for study in aggregation swarm_taxis; do
  page "$study" check "corpus/$study" "corpus/false_claims/$study.assertions"
  page "${study}_steps" step "corpus/$study"
done
"$verify" init "$pages/wanderer" --simulation >/dev/null
page core check "$pages/wanderer/wanderer.rct" --core
page simulation simulate "$pages"/wanderer/*.scenario --out "$pages/simulated"
printf 'robochart-trace 1\ncomponent wanderer::Robot\ncycle 1\nrun one\nturn!90 tock\n' >"$pages/bad.trace"
page log conform "$pages/wanderer" --traces "$pages/bad.trace"
printf 'stm S { initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B } transition t2 { from B to A } }\n' >"$pages/loop.rct"
page loop conform "$pages/loop.rct"
printf 'channel a, b\nP = a -> Q [] b -> STOP\nQ = b -> P\n' >"$pages/choice.csp"
page script step "$pages/choice.csp" P
node tests/browser/accessibility.mjs "$made/axe-core/package/axe.min.js" "$pages"/*.html
echo "axe: $(ls "$pages"/*.html | wc -l) pages, nothing serious"

number=0
while IFS= read -r -d '' model; do
  number=$((number + 1))
  "$verify" draw "$model" --format mermaid --out "$drawn/$number" >/dev/null 2>&1 || [ "$?" -le 2 ]
done < <(find corpus tests/frontend/diagrams tests/frontend/fixtures -name '*.rct' -print0 | sort -z)
mapfile -d '' -t files < <(find "$drawn" -type f -print0 | sort -z)
node tests/browser/mermaid.mjs "$made/mermaid/package/dist/mermaid.min.js" "${files[@]}"
echo "Mermaid: ${#files[@]} diagrams, all accepted"
