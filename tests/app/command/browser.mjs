// Plays somebody at a page in Chromium, over its debugging pipe: `node browser.mjs FILE [dark|noscript]`, a command a line on
// standard input. `key NAME` presses a key, `click SELECTOR` clicks, `open HASH` changes the address, `back` goes back,
// `print EXPRESSION` writes a value. What should not be is written at the end: "problem: ..." for each message of the
// console, exception, violation of the policy, and request but the page itself.
import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

const page = "file://" + resolve(process.argv[2]);
const profile = mkdtempSync(join(tmpdir(), "robochart-browser-"));
const browser = spawn(
    "chromium",
    [
        "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", `--user-data-dir=${profile}`,
        // Without it keys are dropped, without a word, until the first frame is drawn: on a busy machine that is late.
        "--allow-pre-commit-input",
        "--disable-background-timer-throttling", "--disable-backgrounding-occluded-windows",
        "--disable-renderer-backgrounding", "--no-first-run", "--disable-extensions",
    ],
    { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"], detached: true },
);
const [toBrowser, fromBrowser] = [browser.stdio[3], browser.stdio[4]];

const answers = new Map();
const events = [];
let loaded = () => {};
let read = "";
fromBrowser.on("data", (text) => {
    read += text;
    for (let end = read.indexOf("\0"); end >= 0; end = read.indexOf("\0")) {
        const message = JSON.parse(read.slice(0, end));
        read = read.slice(end + 1);
        answers.get(message.id)?.(message);
        if (message.method !== undefined) events.push(message);
        if (message.method === "Page.loadEventFired") loaded();
    }
});

let last = 0;
let session;
function ask(method, params = {}) {
    const id = ++last;
    toBrowser.write(JSON.stringify({ id, method, params, sessionId: session }) + "\0");
    return new Promise((answered, failed) =>
        answers.set(id, ({ result, error }) => (error ? failed(new Error(`${method}: ${error.message}`)) : answered(result))),
    );
}

async function evaluated(expression) {
    const { result, exceptionDetails } = await ask("Runtime.evaluate", { expression, awaitPromise: true, returnByValue: true });
    if (exceptionDetails) throw new Error(`${expression}: ${exceptionDetails.exception?.description}`);
    return result.value;
}

/** After what the browser still does for the change of the address. */
const moved = (action) =>
    evaluated(`new Promise((done) => { addEventListener("hashchange", () => setTimeout(done), { once: true }); ${action} })`);

const commands = {
    key: async (key) => {
        const text = key.length === 1 ? key : undefined;
        await ask("Input.dispatchKeyEvent", { type: "keyDown", key, text });
        await ask("Input.dispatchKeyEvent", { type: "keyUp", key });
    },
    click: (selector) => evaluated(`void document.querySelector(${JSON.stringify(selector)}).click()`),
    open: (hash) => moved(`location.hash = ${JSON.stringify(hash)};`),
    back: () => moved("history.back();"),
    print: async (expression) => console.log(JSON.stringify(await evaluated(expression))),
};

function problem({ method, params }) {
    if (method === "Runtime.consoleAPICalled") return `console: ${JSON.stringify(params.args)}`;
    if (method === "Runtime.exceptionThrown") return `exception: ${params.exceptionDetails.exception?.description}`;
    if (method === "Log.entryAdded") return `log: ${params.entry.text}`;
    if (method === "Network.requestWillBeSent" && params.request.url !== page) return `request: ${params.request.url}`;
    return undefined;
}

try {
    const { targetId } = await ask("Target.createTarget", { url: "about:blank" });
    session = (await ask("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    for (const domain of ["Page", "Runtime", "Log", "Network"]) await ask(`${domain}.enable`);
    const scripted = process.argv[3] !== "noscript";
    if (!scripted) await ask("Emulation.setScriptExecutionDisabled", { value: true });
    if (process.argv[3] === "dark")
        await ask("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: "dark" }] });
    const ready = new Promise((done) => (loaded = done));
    await ask("Page.navigate", { url: page });
    await ready;
    await ask("Emulation.setFocusEmulationEnabled", { enabled: true });
    if (scripted) await evaluated("new Promise((done) => requestAnimationFrame(() => setTimeout(done)))");
    for (const line of readFileSync(0, "utf8").split("\n").filter((each) => each !== "")) {
        const [word, ...rest] = line.split(" ");
        await commands[word](rest.join(" "));
    }
    for (const text of events.map(problem)) if (text !== undefined) console.log(`problem: ${text}`);
} finally {
    // Its other processes outlive it for a moment, and write into the profile.
    const ended = new Promise((done) => browser.once("exit", done));
    process.kill(-browser.pid, "SIGKILL");
    await ended;
    for (let left = 50; left > 0 && !removed(profile); --left) await new Promise((done) => setTimeout(done, 100));
}

function removed(folder) {
    try {
        rmSync(folder, { recursive: true, force: true });
        return true;
    } catch {
        return false;
    }
}
