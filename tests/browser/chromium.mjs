// SPDX-License-Identifier: Apache-2.0
// A page in headless Chromium, controlled over its debugging pipe (Chrome DevTools Protocol). If the browser does not
// start, ends or does not answer, this says nothing about the page: the script is repeated from the start in a new
// browser.
import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";

const attempts = 3;
/** Milliseconds that a browser may take for one answer: on a busy machine it takes some seconds to start. */
const patience = 60_000;

/** The browser failed, not the page. */
class BrowserFailed extends Error {}

class Browser {
    #profile = mkdtempSync(join(tmpdir(), "robochart-browser-"));
    #process;
    #answers = new Map();
    #read = "";
    #last = 0;
    events = [];

    constructor() {
        this.#process = spawn(
            "chromium",
            [
                "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--remote-debugging-pipe",
                `--user-data-dir=${this.#profile}`,
                // Without this option the browser silently drops keys before the first frame, which comes late on a
                // busy machine.
                "--allow-pre-commit-input",
                "--disable-background-timer-throttling", "--disable-backgrounding-occluded-windows",
                "--disable-renderer-backgrounding", "--no-first-run", "--disable-extensions", "--disable-background-networking",
            ],
            { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"], detached: true },
        );
        this.#process.once("error", () => this.#fail("Chromium cannot be started"));
        this.#process.once("exit", () => this.#fail("Chromium has ended"));
        this.#process.stdio[3].on("error", () => this.#fail("Chromium has ended"));
        this.#process.stdio[4].on("data", (text) => this.#take(text));
    }

    #take(text) {
        this.#read += text;
        for (let end = this.#read.indexOf("\0"); end >= 0; end = this.#read.indexOf("\0")) {
            const message = JSON.parse(this.#read.slice(0, end));
            this.#read = this.#read.slice(end + 1);
            this.#answers.get(message.id)?.answered(message);
            if (message.method === "Inspector.targetCrashed") this.#fail("the page has crashed");
            if (message.method !== undefined) this.events.push(message);
        }
    }

    #fail(why) {
        for (const { failed } of this.#answers.values()) failed(new BrowserFailed(why));
    }

    ask(method, params, sessionId) {
        const id = ++this.#last;
        return new Promise((answered, failed) => {
            const timer = setTimeout(() => failed(new BrowserFailed(`${method}: no answer`)), patience);
            const done = (then) => (value) => {
                clearTimeout(timer);
                this.#answers.delete(id);
                then(value);
            };
            this.#answers.set(id, {
                answered: done(({ result, error }) =>
                    error ? failed(new Error(`${method}: ${error.message}`)) : answered(result)),
                failed: done(failed),
            });
            this.#process.stdio[3].write(JSON.stringify({ id, method, params, sessionId }) + "\0");
        });
    }

    async end() {
        if (this.#process.pid !== undefined && this.#process.exitCode === null && this.#process.signalCode === null) {
            const ended = new Promise((done) => this.#process.once("exit", done));
            process.kill(-this.#process.pid, "SIGKILL");
            await ended;
        }
        // Other processes of the browser may live a little longer and write into the profile.
        for (let left = 50; left > 0 && !removed(this.#profile); --left) await new Promise((done) => setTimeout(done, 100));
    }
}

function removed(folder) {
    try {
        rmSync(folder, { recursive: true, force: true });
        return true;
    } catch {
        return false;
    }
}

/** The only tab of a browser. */
class Tab {
    #browser;
    #session;
    #opened = [];

    constructor(browser) {
        this.#browser = browser;
    }

    async begin() {
        const { targetId } = await this.ask("Target.createTarget", { url: "about:blank" });
        this.#session = (await this.ask("Target.attachToTarget", { targetId, flatten: true })).sessionId;
        for (const domain of ["Page", "Runtime", "Log", "Network", "Inspector"]) await this.ask(`${domain}.enable`);
        await this.ask("Emulation.setFocusEmulationEnabled", { enabled: true });
    }

    ask(method, params = {}) {
        return this.#browser.ask(method, params, this.#session);
    }

    /** The value of an expression in the page; if the value is a promise, its result. */
    async evaluated(expression) {
        const { result, exceptionDetails } = await this.ask("Runtime.evaluate", {
            expression, awaitPromise: true, returnByValue: true,
        });
        if (exceptionDetails) throw new Error(`${expression.slice(0, 200)}: ${exceptionDetails.exception?.description}`);
        return result.value;
    }

    /** Opens a file, with or without scripts; `loads`: the files that the page may load. */
    async open(file, scripted = true, loads = []) {
        const url = pathToFileURL(resolve(file)).href;
        this.#opened.push(url, ...loads.map((each) => pathToFileURL(resolve(each)).href));
        await this.ask("Emulation.setScriptExecutionDisabled", { value: !scripted });
        const before = this.#browser.events.length;
        await this.ask("Page.navigate", { url });
        const loaded = () => this.#browser.events.slice(before).some(({ method }) => method === "Page.loadEventFired");
        for (const end = Date.now() + patience; !loaded(); await new Promise((done) => setTimeout(done, 10)))
            if (Date.now() > end) throw new BrowserFailed(`${url}: not loaded`);
        if (scripted) await this.evaluated("new Promise((done) => requestAnimationFrame(() => setTimeout(done)))");
    }

    async key(key) {
        const text = key.length === 1 ? key : undefined;
        await this.ask("Input.dispatchKeyEvent", { type: "keyDown", key, text });
        await this.ask("Input.dispatchKeyEvent", { type: "keyUp", key });
    }

    /** Sets the preferred colours, `dark` or `light`; `media`: "print" displays the page as printed. */
    scheme(value, media = "") {
        return this.ask("Emulation.setEmulatedMedia", { media, features: [{ name: "prefers-color-scheme", value }] });
    }

    /** Sets the preference for reduced motion. */
    calm() {
        return this.ask("Emulation.setEmulatedMedia", { features: [{ name: "prefers-reduced-motion", value: "reduce" }] });
    }

    /** The problems: console messages, exceptions, violations of the policy, and requests other than for the opened files. */
    problems() {
        return this.#browser.events.map((event) => this.#problem(event)).filter((text) => text !== undefined);
    }

    #problem({ method, params }) {
        if (method === "Runtime.consoleAPICalled") return `console: ${JSON.stringify(params.args)}`;
        if (method === "Runtime.exceptionThrown") return `exception: ${params.exceptionDetails.exception?.description}`;
        if (method === "Log.entryAdded") return `log: ${params.entry.text}`;
        if (method === "Network.requestWillBeSent" && !this.#opened.includes(params.request.url.replace(/#.*/, "")))
            return `request: ${params.request.url}`;
        return undefined;
    }
}

/** Calls `play` with the tab of a new browser, and again with another browser if the first one fails; returns its result. */
export async function inChromium(play) {
    for (let attempt = 1; ; ++attempt) {
        const browser = new Browser();
        try {
            const tab = new Tab(browser);
            await tab.begin();
            return await play(tab);
        } catch (error) {
            if (!(error instanceof BrowserFailed) || attempt === attempts) throw error;
            console.error(`attempt ${attempt}: ${error.message}`);
        } finally {
            await browser.end();
        }
    }
}
