// SPDX-License-Identifier: Apache-2.0
// The extension starts, restarts and stops the server, and reports a failure of these.
"use strict";

const assert = require("node:assert");
const test = require("node:test");
const { loadExtension } = require("./stand_ins");

// Node itself is a program that exists in every test.
const program = process.execPath;

async function activated(settings, failure) {
    const extension = loadExtension(settings, failure);
    const context = { subscriptions: [] };
    await extension.activate(context);
    assert.strictEqual(context.subscriptions.length, 11);
    return extension;
}

test("starts `PROGRAM lsp`", async () => {
    const { log } = await activated({ "robochart.server.path": program });
    assert.deepStrictEqual(log, [["start", program, "lsp"]]);
});

test("the server is asked about models, assertions, scripts and rules on disk", async () => {
    const { handlers } = await activated({ "robochart.server.path": program });
    const languages = handlers.documents.map((each) => `${each.scheme}:${each.language}`);
    const models = ["file:robochart", "file:robochart-assertions", "file:robosim", "file:robosim-assertions"];
    assert.deepStrictEqual(languages, [...models, "file:cspm", "file:sleec", "file:robochart-claims"]);
});

test("a missing program is said once, with the setting and a way to it", async () => {
    const { log } = await activated({ "robochart.server.path": "/nowhere/robochart-verify" });
    await new Promise(setImmediate);
    const messages = log.filter(([kind]) => kind === "error");
    assert.strictEqual(messages.length, 1);
    assert.match(messages[0][1], /robochart-verify was not found.*\/nowhere\/robochart-verify, which does not exist.*robochart\.server\.path/);
    assert.deepStrictEqual(log.at(-1), ["command", "workbench.action.openSettings", "robochart.server.path"]);
    assert.ok(!log.some(([kind]) => kind === "start"));
});

test("a server that does not start is said with its reason", async () => {
    const { log } = await activated({ "robochart.server.path": program }, "exit code 4");
    assert.ok(log.some(([kind, text]) => kind === "error" && text.includes(program) && text.includes("exit code 4")));
});

test("restart stops first, also when asked twice at once", async () => {
    const extension = await activated({ "robochart.server.path": program });
    const restart = extension.handlers["robochart.restartServer"];
    await Promise.all([restart(), restart()]);
    const kinds = extension.log.map(([kind]) => kind);
    assert.deepStrictEqual(kinds, ["start", "stop", "start", "stop", "start"]);
});

test("a changed path restarts, another setting does not", async () => {
    const extension = await activated({ "robochart.server.path": program });
    const change = (name) => extension.handlers.settings({ affectsConfiguration: (each) => each === name });
    await change("editor.fontSize");
    assert.strictEqual(extension.log.length, 1);
    await change("robochart.server.path");
    assert.deepStrictEqual(extension.log.slice(1).map(([kind]) => kind), ["stop", "start"]);
});

test("deactivation stops the server, and nothing if there is none", async () => {
    const extension = await activated({ "robochart.server.path": program });
    await extension.deactivate();
    assert.deepStrictEqual(extension.log.at(-1), ["stop"]);
    await extension.deactivate();
    assert.strictEqual(extension.log.filter(([kind]) => kind === "stop").length, 1);
});
