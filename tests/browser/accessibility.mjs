// SPDX-License-Identifier: Apache-2.0
// Checks pages with the rules of axe-core: `node accessibility.mjs AXE PAGE...`. AXE is the file axe.min.js of this npm
// package. Each page is checked in light and in dark colours. The script prints one line for each violation of level
// serious or critical, and for each message of the browser. Exit code 1 if there are any.
import { readFileSync } from "node:fs";
import { basename } from "node:path";
import { inChromium } from "./chromium.mjs";

const [axe, ...pages] = process.argv.slice(2);

const judged = `axe.run(document, { resultTypes: ["violations"] }).then(({ violations, passes }) => ({ passes: passes.length,
    found: violations.filter(({ impact }) => impact === "serious" || impact === "critical").flatMap(({ id, impact, nodes }) =>
        nodes.map(({ target, failureSummary }) => [impact, id, target.join(" "), failureSummary].join(" | "))) }))`;

async function judge(tab, page, scheme) {
    await tab.scheme(scheme);
    await tab.open(page);
    await tab.evaluated(readFileSync(axe, "utf8"));
    const { found, passes } = await tab.evaluated(judged);
    if (passes === 0) throw new Error(`${page}: axe has looked at nothing`);
    return found.map((text) => `${basename(page)} (${scheme}): ${text.replaceAll("\n", " ")}`);
}

const found = await inChromium(async (tab) => {
    const lines = [];
    for (const page of pages) for (const scheme of ["light", "dark"]) lines.push(...(await judge(tab, page, scheme)));
    return [...lines, ...tab.problems()];
});
for (const line of found) console.log(line);
process.exitCode = found.length > 0 ? 1 : 0;
