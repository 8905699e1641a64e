// SPDX-License-Identifier: Apache-2.0
// Steps through every counterexample of a page by keyboard: `node tour.mjs PAGE JSON`. JSON is the output of `--format
// json` for the same run. Each step must highlight exactly the states that are active in its data, and the browser must
// report no problem. The script prints the size of the page, its loading time (and the CPU time of its main thread,
// which other programs do not affect), and the time per step. It prints faults and exits with 1 if there are any.
import assert from "node:assert";
import { readFileSync, statSync } from "node:fs";
import { inChromium } from "./chromium.mjs";

const [page, json] = process.argv.slice(2);
const report = JSON.parse(readFileSync(json, "utf8"));

/**
 * An expression that takes the next steps, at most 50. For each step its value contains the sentence of the status line,
 * the name and the filled states of each machine, and the milliseconds.
 */
const walked = (id, first) => `(() => {
    const claim = document.getElementById(${JSON.stringify(id)});
    const press = (key) => document.body.dispatchEvent(new KeyboardEvent("keydown", { key, bubbles: true }));
    const figures = Array.from(claim.querySelectorAll("figure[data-machine]"));
    const machines = figures.filter((figure) => figure.querySelector(".values"));
    const filled = (machine) => figures.filter((figure) => figure.dataset.machine === machine).flatMap((figure) =>
        Array.from(figure.querySelectorAll(".on > title"), (title) => title.textContent.trim().split(" ").at(-1)));
    const look = (ms) => ({ ms, status: claim.querySelector(".status").textContent, figures: machines.map((figure) => [
        figure.querySelector("figcaption").textContent, filled(figure.dataset.machine),
    ]) });
    const steps = [];
    if (${first}) {
        claim.querySelector("button[data-to=first]").click();
        steps.push(look(0));
    }
    const rows = Array.from(claim.querySelectorAll("tr.step"));
    const here = rows.findIndex((row) => row.hasAttribute("aria-current"));
    for (let left = Math.min(50, rows.length - 1 - here); left > 0; --left) {
        const begin = performance.now();
        press("ArrowRight");
        claim.getBoundingClientRect();
        steps.push(look(performance.now() - begin));
    }
    return steps;
})()`;

const nameOf = (element) => element.slice(element.lastIndexOf(":") + 1);

function expected(machines, figures) {
    return figures.map(([caption]) => [
        caption,
        (machines.find(({ component }) => component === caption)?.active ?? []).map(nameOf),
    ]);
}

await inChromium(async (tab) => {
    await tab.ask("Performance.enable", { timeDomain: "threadTicks" });
    const worked = async () =>
        1000 * (await tab.ask("Performance.getMetrics")).metrics.find(({ name }) => name === "TaskDuration").value;
    const before = await worked();
    const begin = performance.now();
    await tab.open(page);
    const loaded = performance.now() - begin;
    const cpu = (await worked()) - before;
    let steps = 0;
    let longest = 0;
    for (const [i, { counterexample }] of report.assertions.entries()) {
        if (counterexample === undefined) continue;
        const shown = await tab.evaluated(walked(`a${i}`, true));
        for (let more = shown; more.length > 0; shown.push(...more)) more = await tab.evaluated(walked(`a${i}`, false));
        assert.strictEqual(shown.length, counterexample.steps.length + 1, `a${i}`);
        for (const [n, { status, figures, ms }] of shown.entries()) {
            assert.ok(status.startsWith(`step ${n} of `), status);
            const machines = n === 0 ? counterexample.initial : counterexample.steps[n - 1].machines;
            const drawn = figures.map(([caption, states]) => [caption, states.toSorted()]);
            const wanted = expected(machines, figures).map(([caption, states]) => [caption, states.toSorted()]);
            assert.deepStrictEqual(drawn, wanted, `a${i}, ${status}`);
            longest = Math.max(longest, ms);
        }
        steps += counterexample.steps.length;
    }
    assert.deepStrictEqual(tab.problems(), []);
    const size = Math.round(statSync(page).size / 1000);
    console.log(`${size} kB, loaded in ${Math.round(loaded)} ms (CPU: ${Math.round(cpu)} ms); ${steps} steps fill the states of their data, each in at most ${Math.round(longest)} ms`);
});
