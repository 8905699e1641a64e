#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The extension parses the program's own report: a failed check at the line of its assertion, and steps at their lines.
# Argument: the program. Exit code 77 (skipped) without node.
set -euo pipefail
program="$(realpath "$1")"
client="$(cd "$(dirname "$0")/../.." && pwd)/editors/vscode/client/check.js"
command -v node >/dev/null || { echo "node is not installed" >&2; exit 77; }
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
printf '%s\n' 'package p' 'stm S { event e' 'initial i' 'state A { }' 'state B { }' \
  'transition t0 { from i to A }' 'transition t1 { from A to B trigger e } }' >"$folder/m.rct"
printf '%s\n' 'package q' 'import p::*' 'untimed assertion X : p::S::B is not reachable in p::S' \
  'untimed assertion Y : p::S is deadlock-free' >"$folder/m.assertions"
XDG_CACHE_HOME="$folder/cache" node - "$client" "$program" "$folder" <<'NODE'
const assert = require("node:assert");
const [client, program, folder] = process.argv.slice(2);
const { checkAssertion } = require(client);
(async () => {
    const { verdict, failures } = await checkAssertion(program, `${folder}/m.assertions`, "X");
    assert.strictEqual(verdict, "fails");
    assert.strictEqual(failures.length, 1);
    const [{ line, text, steps }] = failures;
    assert.strictEqual(line, 3);
    assert.match(text, /^X \[untimed\] .*: the state has been reached$/);
    const places = new Map(steps.map((step) => [step.text, step]));
    const lineOf = (words) => steps.find((step) => step.text.includes(words))?.range[0];
    assert.strictEqual(lineOf("t0: i -> A"), 6, JSON.stringify([...places.keys()]));
    assert.strictEqual(lineOf("entered B"), 5);
    assert.strictEqual(lineOf("input e"), 7);
    assert.ok(steps.every(({ file, range }) => file === `${folder}/m.rct` && range.every((each) => each >= 1)));
    const { failures: others } = await checkAssertion(program, `${folder}/m.assertions`, "Y");
    assert.strictEqual(others[0].line, 4, "B has no way on");
})().catch((error) => {
    console.error(error.message);
    process.exit(1);
});
NODE
