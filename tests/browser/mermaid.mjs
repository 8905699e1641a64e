// SPDX-License-Identifier: Apache-2.0
// Parses files with Mermaid's own parser: `node mermaid.mjs MERMAID FILE...`. MERMAID is the file mermaid.min.js of
// this npm package. The script prints one line for each rejected file, and then exits with 1.
import { readFileSync } from "node:fs";
import { inChromium } from "./chromium.mjs";

const [mermaid, ...files] = process.argv.slice(2);

const found = await inChromium(async (tab) => {
    const lines = [];
    await tab.evaluated(readFileSync(mermaid, "utf8"));
    const read = (text) => tab.evaluated(`mermaid.parse(${JSON.stringify(text)}).then(() => "", (error) => String(error.message))`);
    if ((await read("stateDiagram-v2\n  a -->\n")) === "") throw new Error("Mermaid accepts anything");
    for (const file of files) {
        const refused = await read(readFileSync(file, "utf8"));
        if (refused !== "") lines.push(`${file}: ${refused}`);
    }
    return lines;
});
for (const line of found) console.log(line);
process.exitCode = found.length > 0 ? 1 : 0;
