// SPDX-License-Identifier: Apache-2.0
// Simulates a user of a page in Chromium: `node browser.mjs FILE [dark|noscript]`, with one command per line on
// standard input. `key NAME` presses a key, `click SELECTOR` clicks, `open HASH` changes the address, `back` goes back,
// `scheme dark` and `scheme light` change the preferred colours, `calm` sets the preference for reduced motion, `paper`
// shows the page as printed for a user who prefers dark colours, `print EXPRESSION` writes a value. At the end it
// writes one line "problem: ..." for each problem.
import { readFileSync } from "node:fs";
import { inChromium } from "../../browser/chromium.mjs";

const [page, how] = process.argv.slice(2);
const lines = readFileSync(0, "utf8").split("\n").filter((each) => each !== "");

async function play(tab) {
    const printed = [];
    /** Performs an action that changes the address; resolves when the browser has handled the change. */
    const moved = (action) =>
        tab.evaluated(`new Promise((done) => { addEventListener("hashchange", () => setTimeout(done), { once: true }); ${action} })`);
    const commands = {
        key: (name) => tab.key(name),
        click: (selector) =>
            tab.evaluated(`void document.querySelector(${JSON.stringify(selector)}).dispatchEvent(new MouseEvent("click", { bubbles: true }))`),
        open: (hash) => moved(`location.hash = ${JSON.stringify(hash)};`),
        back: () => moved("history.back();"),
        scheme: (value) => tab.scheme(value),
        calm: () => tab.calm(),
        paper: () => tab.scheme("dark", "print"),
        print: async (expression) => printed.push(JSON.stringify(await tab.evaluated(expression))),
    };
    if (how === "dark") await tab.scheme("dark");
    await tab.open(page, how !== "noscript");
    for (const line of lines) {
        const [word, ...rest] = line.split(" ");
        await commands[word](rest.join(" "));
    }
    return [...printed, ...tab.problems().map((text) => `problem: ${text}`)];
}

for (const line of await inChromium(play)) console.log(line);
