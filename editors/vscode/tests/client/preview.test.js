// SPDX-License-Identifier: Apache-2.0
// The preview: its requests to the server, its messages to the page, and the effect of a click on the page.
"use strict";

const assert = require("node:assert");
const test = require("node:test");
const { elementAt, pageOf } = require("../../client/diagram");
const { documentAt, loadExtension, uriOf } = require("./stand_ins");

const uri = "file:///p/a.rct";
const rangeOf = (line, from, to, last = line) => ({ start: { line, character: from }, end: { line: last, character: to } });
const elements = [
    { id: "e1", kind: "state machine", name: "S", uri, range: rangeOf(0, 0, 1, 9), selectionRange: rangeOf(0, 4, 5) },
    { id: "e2", kind: "state", name: "A", uri, range: rangeOf(2, 0, 11), selectionRange: rangeOf(2, 6, 7) },
    { id: "e3", kind: "event", name: "e", uri: "file:///p/b.rct", range: rangeOf(2, 0, 9), selectionRange: rangeOf(2, 6, 7) },
];
const answer = { version: 1, component: "p::S", svg: "<svg/>", elements, stale: false };

const soon = () => new Promise((resolve) => setTimeout(resolve, 200));

const editorAt = (line, document = documentAt(uri)) => ({
    document,
    viewColumn: 1,
    selection: { active: { line, character: 8 } },
});

/** An extension with an open preview; `log` is empty. */
async function opened(reply = answer) {
    const extension = loadExtension({ "robochart.server.path": process.execPath });
    const context = { subscriptions: [], extensionUri: uriOf("file:///extension") };
    await extension.activate(context);
    extension.handlers.answer = () => reply;
    extension.vscode.window.activeTextEditor = editorAt(2);
    await extension.handlers["robochart.preview"]();
    const [panel] = extension.handlers.panels;
    const first = extension.log.splice(0);
    return { ...extension, panel, first, context };
}

const of = (log, kind) => log.filter(([each]) => each === kind).map(([, ...words]) => words);

test("the smallest element around a place, the later of two that are alike", () => {
    assert.strictEqual(elementAt(elements.slice(0, 2), { line: 2, character: 11 }).id, "e2");
    assert.strictEqual(elementAt(elements.slice(0, 2), { line: 3, character: 0 }).id, "e1");
    assert.strictEqual(elementAt(elements, { line: 10, character: 0 }), undefined);
    assert.strictEqual(elementAt([elements[0], { ...elements[0], id: "e9" }], { line: 1, character: 0 }).id, "e9");
});

test("the page allows its own script and styles alone, and what is put into it is escaped", () => {
    const page = pageOf({ nonce: "N", source: "https://x", script: 'a"><b', style: "c" });
    assert.match(page, /content="default-src 'none'; script-src 'nonce-N'; style-src https:\/\/x 'nonce-N'"/);
    assert.match(page, /<script nonce="N" src="a&quot;>&lt;b">/);
    assert.doesNotMatch(page, / on[a-z]+=| style=/);
});

test("opens beside, keeps the focus, and asks for the component at the cursor", async () => {
    const { first, panel } = await opened();
    assert.deepStrictEqual(of(first, "panel"), [["robochart.preview", { viewColumn: -2, preserveFocus: true }]]);
    const parameters = { textDocument: { uri }, theme: "light", position: { line: 2, character: 8 } };
    assert.deepStrictEqual(of(first, "request"), [["robochart/diagram", parameters]]);
    const { svg, version, component } = answer;
    const picture = { type: "picture", svg, stale: false, version, component, uri, id: "e2" };
    assert.deepStrictEqual(of(first, "post"), [[picture]]);
    assert.strictEqual(panel.title, "Diagram p::S");
    assert.strictEqual(panel.webview.options.enableScripts, true);
    assert.deepStrictEqual(panel.webview.options.localResourceRoots.map(String), ["file:///extension/client/page"]);
});

test("opened twice there is one panel, and its page is set once", async () => {
    const { handlers, panel, log } = await opened();
    await handlers["robochart.preview"]();
    assert.strictEqual(handlers.panels.length, 1);
    assert.strictEqual(of(log, "reveal panel").length, 1);
    handlers.selection({ textEditor: editorAt(5) });
    await soon();
    assert.strictEqual(panel.webview.pages, 1);
});

test("each page has a nonce of its own", async () => {
    const nonce = async () => /nonce="(\w{32})"/.exec((await opened()).panel.webview.page)[1];
    assert.notStrictEqual(await nonce(), await nonce());
});

test("the cursor's element is highlighted at once; the server is asked when the cursor rests", async () => {
    const { handlers, log } = await opened();
    for (const line of [5, 6, 7]) handlers.selection({ textEditor: editorAt(line) });
    assert.deepStrictEqual(of(log, "post"), [5, 6, 7].map(() => [{ type: "highlight", id: "e1" }]));
    assert.deepStrictEqual(of(log, "request"), []);
    await soon();
    assert.strictEqual(of(log, "request").length, 1);
    assert.deepStrictEqual(of(log, "request")[0][1].position, { line: 7, character: 8 });
    assert.strictEqual(of(log, "request")[0][1].component, "p::S");
});

test("editors of other languages are not followed", async () => {
    const { handlers, log } = await opened();
    handlers.editor(editorAt(0, documentAt("file:///p/x.txt", "plaintext")));
    handlers.editor(undefined);
    await soon();
    assert.deepStrictEqual(log, []);
});

test("a notification about the document asks anew; the same picture is not sent twice", async () => {
    const { handlers, log } = await opened();
    handlers.notifications["robochart/diagramChanged"]({ uri: "file:///p/other.rct", version: 1 });
    await soon();
    assert.deepStrictEqual(of(log, "request"), []);
    handlers.notifications["robochart/diagramChanged"]({ uri, version: 1 });
    await soon();
    assert.strictEqual(of(log, "request").length, 1);
    assert.deepStrictEqual(of(log, "post"), []);
});

test("a stale picture is sent as one, without a highlight", async () => {
    const { handlers, log } = await opened();
    handlers.answer = () => ({ ...answer, stale: true });
    handlers.notifications["robochart/diagramChanged"]({ uri, version: 2 });
    await soon();
    assert.deepStrictEqual(of(log, "post").map(([{ stale, id }]) => [stale, id]), [[true, undefined]]);
});

test("where nothing is to be drawn, or the server refuses, the last picture stays with a note", async () => {
    for (const [reply, note] of [
        [() => null, /nothing to draw/],
        [() => Promise.reject(Object.assign(new Error("too large"), { code: -32803 })), /too large/],
    ]) {
        const { handlers, log } = await opened();
        handlers.answer = reply;
        handlers.theme();
        await soon();
        const [[message]] = of(log, "post");
        assert.strictEqual(message.svg, answer.svg);
        assert.strictEqual(message.stale, true);
        assert.match(message.note, note);
    }
});

test("a request that the server gave up for a newer text says nothing", async () => {
    const { handlers, log } = await opened();
    handlers.answer = () => Promise.reject(Object.assign(new Error("changed"), { code: -32801 }));
    handlers.theme();
    await soon();
    assert.deepStrictEqual(of(log, "post"), []);
});

test("an answer that another has overtaken is dropped", async () => {
    const { handlers, log } = await opened();
    let late;
    handlers.answer = () => new Promise((resolve) => (late = resolve));
    const waiting = handlers["robochart.preview"]();
    handlers.answer = () => ({ ...answer, svg: "<svg>new</svg>" });
    await handlers["robochart.preview"]();
    late({ ...answer, svg: "<svg>old</svg>" });
    await waiting;
    assert.deepStrictEqual(of(log, "post").map(([{ svg }]) => svg), ["<svg>new</svg>"]);
});

test("the theme of the editor is asked for", async () => {
    const { handlers, log, vscode } = await opened();
    for (const kind of [2, 3, 4]) {
        vscode.window.activeColorTheme = { kind };
        handlers.theme();
        await soon();
    }
    assert.deepStrictEqual(of(log, "request").map(([, { theme }]) => theme), ["dark", "dark", "light"]);
});

test("a hidden page is not drawn for; shown again it is, and gets what it lost", async () => {
    const { handlers, log, panel } = await opened();
    panel.visible = false;
    handlers.notifications["robochart/diagramChanged"]({ uri, version: 2 });
    await soon();
    assert.deepStrictEqual(log, []);
    panel.visible = true;
    panel.shown();
    panel.hear({ type: "ready" });
    await soon();
    assert.strictEqual(of(log, "request").length, 1);
    assert.deepStrictEqual(of(log, "post").map(([{ svg }]) => svg), [answer.svg]);
});

test("a click selects the name and reveals the element, in the editor that shows it", async () => {
    const { log, panel, vscode } = await opened();
    vscode.window.visibleTextEditors = [{ document: documentAt("file:///p/b.rct"), viewColumn: 3 }];
    await panel.hear({ type: "reveal", id: "e3" });
    const [[shown, { viewColumn, selection }]] = of(log, "shown");
    assert.deepStrictEqual([shown, viewColumn, selection.numbers], ["file:///p/b.rct", 3, [2, 6, 2, 7]]);
    assert.deepStrictEqual(of(log, "revealed")[0][0].numbers, [2, 0, 2, 9]);
});

test("what the page says is not trusted", async () => {
    const { log, panel } = await opened();
    for (const message of [undefined, null, "x", {}, { type: "reveal" }, { type: "reveal", id: "file:///etc/passwd" }])
        await panel.hear(message);
    assert.deepStrictEqual(log, []);
});

test("after a restart the panel is filled again from what its page kept", async () => {
    const { handlers, log, panel } = await opened();
    panel.dispose();
    const other = loadExtension({ "robochart.server.path": process.execPath });
    other.handlers.answer = () => answer;
    await other.activate({ subscriptions: [], extensionUri: uriOf("file:///extension") });
    const serializer = other.handlers["robochart.preview serializer"];
    other.log.length = 0;
    await serializer.deserializeWebviewPanel(panel, { uri, component: "p::S", zoom: 2 });
    assert.deepStrictEqual(of(other.log, "request"), [["robochart/diagram", { textDocument: { uri }, theme: "light", component: "p::S" }]]);
    assert.strictEqual(panel.webview.pages, 2);
    assert.strictEqual(handlers.panels.length, 1);
    assert.deepStrictEqual(of(log, "post").map(([{ svg }]) => svg), [answer.svg]);
    await serializer.deserializeWebviewPanel(panel, { uri: 7, component: {} });
});

test("without a server the page says so; once there is one it is asked", async () => {
    const extension = loadExtension({ "robochart.server.path": process.execPath });
    extension.handlers.answer = () => answer;
    const started = extension.activate({ subscriptions: [], extensionUri: uriOf("file:///extension") });
    extension.vscode.window.activeTextEditor = editorAt(2);
    await Promise.all([extension.handlers["robochart.preview"](), started]);
    await soon();
    const notes = of(extension.log, "post").map(([{ note }]) => note);
    assert.match(notes[0], /not running/);
    assert.strictEqual(notes.at(-1), undefined);
});
