// SPDX-License-Identifier: Apache-2.0
// Every word that a grammar lists is coloured when it occurs alone, so no rule hides another.
"use strict";

const assert = require("node:assert");
const fs = require("node:fs");
const path = require("node:path");
const test = require("node:test");
const oniguruma = require("vscode-oniguruma");
const textmate = require("vscode-textmate");

const root = path.join(__dirname, "../..");
const grammars = new Map(
    require("../../package.json").contributes.grammars.map(({ scopeName, path: file }) => [
        scopeName,
        fs.readFileSync(path.join(root, file), "utf8"),
    ]),
);

function createRegistry() {
    const wasm = fs.readFileSync(require.resolve("vscode-oniguruma/release/onig.wasm"));
    return new textmate.Registry({
        onigLib: oniguruma.loadWASM(wasm).then(() => ({
            createOnigScanner: (patterns) => new oniguruma.OnigScanner(patterns),
            createOnigString: (text) => new oniguruma.OnigString(text),
        })),
        loadGrammar: async (scope) => textmate.parseRawGrammar(grammars.get(scope), "grammar.json"),
    });
}
const registry = createRegistry();

/** Words that are coloured only next to others: types after `:`, and the models of `[FD=`. */
const beside = /^(support\.type\.primitive|keyword\.operator\.refinement)/;

/** The words in the lists `(?:a|b|c)` of rules with a name. */
function listedWords(node, found = new Set()) {
    if (node === null || typeof node !== "object") return found;
    const list = typeof node.name === "string" && !beside.test(node.name) && /\(\?:([\w|-]+)\)(?!.*\(\?:)/.exec(node.match ?? "");
    if (list) list[1].split("|").forEach((word) => found.add(word));
    Object.values(node).forEach((child) => listedWords(child, found));
    return found;
}

for (const [scope, text] of grammars) {
    test(`${scope}: each word alone, and as part of a longer name`, async () => {
        const grammar = await registry.loadGrammar(scope);
        const innermost = (line, at) =>
            grammar.tokenizeLine(line, textmate.INITIAL).tokens.find((token) => token.endIndex > at).scopes.at(-1);
        const coloured = /^(keyword|storage|support|constant\.language|variable\.language)/;
        const words = [...listedWords(JSON.parse(text))].filter((word) => /\w{2}/.test(word));
        assert.ok(words.length > 5, `${words.length} words`);
        for (const word of words) {
            assert.match(innermost(`  ${word}  `, 2), coloured, word);
            assert.doesNotMatch(innermost(`  ${word}_x  `, 2), coloured, `${word}_x`);
            assert.doesNotMatch(innermost(`  x_${word}  `, 2), coloured, `x_${word}`);
        }
    });
}
