// SPDX-License-Identifier: Apache-2.0
// Makes the page around a diagram, and finds the element at a place. This file does not use the API of VS Code, so Node
// can test it alone.
"use strict";

const compare = (a, b) => a.line - b.line || a.character - b.character;

const holds = ({ start, end }, position) => compare(start, position) <= 0 && compare(position, end) <= 0;

/** Whether the range `b` contains the range `a`. */
const within = (a, b) => compare(b.start, a.start) <= 0 && compare(a.end, b.end) <= 0;

/** The element with the smallest range around a position; undefined if there is none. */
function elementAt(elements, position) {
    let best;
    for (const each of elements)
        if (holds(each.range, position) && (best === undefined || within(each.range, best.range))) best = each;
    return best;
}

const escaped = (text) => text.replaceAll("&", "&amp;").replaceAll('"', "&quot;").replaceAll("<", "&lt;");

/** The page. Its policy allows only its own script and files, because names in the picture come from the model. */
function pageOf({ nonce, source, script, style }) {
    const policy = `default-src 'none'; script-src 'nonce-${nonce}'; style-src ${source} 'nonce-${nonce}'`;
    return `<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="UTF-8">
<meta http-equiv="Content-Security-Policy" content="${escaped(policy)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<link rel="stylesheet" href="${escaped(style)}">
<title>Diagram</title>
</head>
<body>
<div id="tools">
<button id="smaller" type="button" title="Zoom out" aria-label="Zoom out">−</button>
<button id="whole" type="button" title="Zoom to 100 %"><span id="zoom">100 %</span></button>
<button id="larger" type="button" title="Zoom in" aria-label="Zoom in">+</button>
<button id="fit" type="button" title="Fit into the window">fit</button>
<span id="note" role="status"></span>
</div>
<div id="view"></div>
<script nonce="${nonce}" src="${escaped(script)}"></script>
</body>
</html>
`;
}

module.exports = { elementAt, pageOf };
