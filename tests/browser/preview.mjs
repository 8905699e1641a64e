// SPDX-License-Identifier: Apache-2.0
// The page of the VS Code preview in Chromium, with pictures from the real server: `node preview.mjs PROGRAM MODEL`.
// The API of VS Code (acquireVsCodeApi and messages) is simulated. The script checks that zoom and scroll position
// survive an edit; that the last picture stays while the text is broken, with a message; that a click on an element
// leads to the line with its name, and the cursor there to the element; and that the page loads nothing else. It prints
// faults and exits with 1 if there are any.
import assert from "node:assert";
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { inChromium } from "./chromium.mjs";

const [program, model] = process.argv.slice(2);
const client = fileURLToPath(new URL("../../editors/vscode/client/", import.meta.url));
const { elementAt, pageOf } = createRequire(import.meta.url)(join(client, "diagram.js"));

/** A client of the language server, which sends the messages of an editor. */
class Server {
    #process = spawn(program, ["lsp"], { stdio: ["pipe", "pipe", "ignore"] });
    #read = Buffer.alloc(0);
    #answers = new Map();
    #last = 0;

    constructor() {
        this.#process.stdout.on("data", (data) => {
            this.#read = Buffer.concat([this.#read, data]);
            for (let end = this.#read.indexOf("\r\n\r\n"); end >= 0; end = this.#read.indexOf("\r\n\r\n")) {
                const length = Number(/Content-Length: (\d+)/.exec(this.#read.toString("latin1", 0, end))[1]);
                if (this.#read.length < end + 4 + length) return;
                const message = JSON.parse(this.#read.toString("utf8", end + 4, end + 4 + length));
                this.#read = this.#read.subarray(end + 4 + length);
                this.#answers.get(message.id)?.(message);
            }
        });
    }

    #send(message) {
        const text = JSON.stringify({ jsonrpc: "2.0", ...message });
        this.#process.stdin.write(`Content-Length: ${Buffer.byteLength(text)}\r\n\r\n${text}`);
    }

    tell(method, params) {
        this.#send({ method, params });
    }

    async ask(method, params) {
        const id = ++this.#last;
        const answer = await new Promise((answered) => {
            this.#answers.set(id, answered);
            this.#send({ id, method, params });
        });
        if (answer.error) throw new Error(`${method}: ${answer.error.message}`);
        return answer.result;
    }

    end() {
        this.#process.kill();
    }
}

const folder = mkdtempSync(join(tmpdir(), "robochart-preview-"));
const page = join(folder, "page.html");
const parts = ["page.js", "page.css"].map((name) => join(client, "page", name));
const [script, style] = parts.map((path) => pathToFileURL(path).href);
const standIn = `<script nonce="N">
window.heard = [];
window.acquireVsCodeApi = () => ({ getState: () => undefined, setState: () => {}, postMessage: (message) => heard.push(message) });
</script>
</head>`;
writeFileSync(page, pageOf({ nonce: "N", source: "file:", script, style }).replace("</head>", standIn));

const uri = pathToFileURL(resolve(model)).href;
const original = readFileSync(model, "utf8");

async function play(tab, server) {
    let version = 0;
    const draw = (component) => server.ask("robochart/diagram", { textDocument: { uri }, component, theme: "light" });
    const edited = (text) =>
        server.tell("textDocument/didChange", { textDocument: { uri, version: ++version }, contentChanges: [{ text }] });
    const show = async (picture) =>
        tab.evaluated(`new Promise((done) => {
            addEventListener("message", () => setTimeout(done), { once: true });
            postMessage(${JSON.stringify({ type: "picture", uri, ...picture })}, "*");
        })`);
    const view = () =>
        tab.evaluated(`(() => { const view = document.getElementById("view"); const svg = view.querySelector("svg");
            return { zoom: document.getElementById("zoom").textContent, left: view.scrollLeft, top: view.scrollTop,
                     stale: view.classList.contains("stale"), note: document.getElementById("note").textContent,
                     width: svg.getBoundingClientRect().width, text: svg.textContent }; })()`);

    await server.ask("initialize", { processId: null, rootUri: null, capabilities: {} });
    server.tell("initialized", {});
    server.tell("textDocument/didOpen", { textDocument: { uri, languageId: "robochart", version, text: original } });
    const symbols = await server.ask("textDocument/documentSymbol", { textDocument: { uri } });
    const components = [];
    const collect = (list) => {
        for (const each of list) {
            components.push(each.name);
            collect(each.children ?? []);
        }
    };
    collect(symbols);

    await tab.open(page, true, parts);
    assert.deepStrictEqual(await tab.evaluated("heard"), [{ type: "ready" }]);

    // Zoom and scroll position after an edit, and after text that is broken for a while.
    const { index: begin, 1: machine } = /^\s*stm (\w+)/m.exec(original);
    await show(await draw(machine));
    for (let i = 0; i < 6; ++i) await tab.evaluated("void document.getElementById('larger').click()");
    await tab.evaluated("void document.getElementById('view').scrollTo(40, 30)");
    const before = await view();
    assert.notStrictEqual(before.zoom, "100 %");
    assert.deepStrictEqual([before.left, before.top, before.stale], [40, 30, false]);
    const state = /^\s*state (\w+)/m.exec(original.slice(begin))[1];
    const renamed = original.replaceAll(new RegExp(`\\b${state}\\b`, "g"), `${state}Renamed`);
    edited(renamed);
    await show(await draw(machine));
    const after = await view();
    assert.ok(after.text.includes(`${state}Renamed`));
    assert.deepStrictEqual([after.zoom, after.left, after.top, after.stale], [before.zoom, 40, 30, false]);
    edited(renamed.replace(`state ${state}Renamed`, `state { ${state}Renamed`));
    await show(await draw(machine));
    const broken = await view();
    assert.ok(broken.text.includes(`${state}Renamed`), "the last good picture");
    assert.deepStrictEqual([broken.zoom, broken.left, broken.top, broken.stale], [before.zoom, 40, 30, true]);
    assert.match(broken.note, /mistakes of syntax/);
    edited(original);

    // From each element to the text and back.
    const lines = original.split("\n");
    let elements = 0;
    for (const component of new Set(components)) {
        const answer = await draw(component);
        if (answer === null) continue;
        assert.strictEqual(answer.stale, false);
        await show(answer);
        const ids = await tab.evaluated(`Array.from(document.querySelectorAll("#view [data-element]"), (each) => {
            heard.length = 0;
            each.dispatchEvent(new MouseEvent("click", { bubbles: true }));
            return [each.dataset.element, heard.map((message) => message.type + " " + message.id)];
        })`);
        for (const [id, heard] of ids) {
            assert.deepStrictEqual(heard, [`reveal ${id}`]);
            const element = answer.elements.find((each) => each.id === id);
            assert.ok(element, `${component}: ${id} has a place`);
            const { start, end } = element.selectionRange;
            if (start.line === end.line && element.name !== "")
                assert.ok(lines[start.line].slice(start.character, end.character).includes(element.name), `${element.kind} ${element.name}`);
            const found = elementAt(answer.elements, start);
            assert.ok(found, `the element at ${element.kind} ${element.name}`);
            await tab.evaluated(`new Promise((done) => {
                addEventListener("message", () => setTimeout(done), { once: true });
                postMessage({ type: "highlight", id: ${JSON.stringify(found.id)} }, "*");
            })`);
            const marked = await tab.evaluated("Array.from(document.querySelectorAll('.current'), (each) => each.dataset.element)");
            assert.ok(marked.length > 0 || !ids.some(([other]) => other === found.id));
            assert.ok(marked.every((each) => each === found.id));
            ++elements;
        }
    }
    assert.ok(elements > 20, `${elements} elements`);
    assert.deepStrictEqual(tab.problems(), []);
    return elements;
}

try {
    const elements = await inChromium(async (tab) => {
        const server = new Server();
        try {
            return await play(tab, server);
        } finally {
            server.end();
        }
    });
    console.log(`${elements} elements lead to the text and back`);
} finally {
    rmSync(folder, { recursive: true });
}
