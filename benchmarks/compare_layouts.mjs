// SPDX-License-Identifier: Apache-2.0
// Compares crossings in our diagrams with those in ELK's layered layout of the same boxes and labels: `node
// compare_layouts.mjs ELK < PICTURES`. ELK is the file elk.bundled.js of the npm package elkjs; PICTURES is the output
// of `benchmark_diagrams --pictures`. ELK lays out each level alone, as we do, downwards and to the right, with and
// without the order of the text. The layout with the fewest crossings is compared. One function counts the crossings in
// both diagrams. Exits with 1 if our diagrams have more crossings.
import { createRequire } from "node:module";
import { readFileSync } from "node:fs";

const ELK = createRequire(import.meta.url)(process.argv[2]);
const elk = new ELK();

/** The number of points at which a horizontal and a vertical segment cross; their ends do not count. */
function crossings(lines) {
    const across = [];
    const down = [];
    lines.forEach((points, line) => {
        for (let i = 0; i + 1 < points.length; ++i) {
            const [a, b] = [points[i], points[i + 1]];
            const level = Math.abs(a.y - b.y) < Math.abs(a.x - b.x);
            (level ? across : down).push({
                line, x: Math.min(a.x, b.x), right: Math.max(a.x, b.x), y: Math.min(a.y, b.y), bottom: Math.max(a.y, b.y),
            });
        }
    });
    const near = 0.5;
    let count = 0;
    for (const a of across)
        for (const b of down)
            if (a.line !== b.line && a.x + near < b.x && b.x < a.right - near && b.y + near < a.y && a.y < b.bottom - near)
                ++count;
    return count;
}

const length = (lines) =>
    lines.reduce(
        (sum, points) =>
            sum + points.slice(1).reduce((part, p, i) => part + Math.abs(p.x - points[i].x) + Math.abs(p.y - points[i].y), 0),
        0,
    );

/** The box at an end of a line; for a square of an event, the box on whose border it is. */
const boxOf = (picture, end) => (picture.boxes[end].eventOf < 0 ? end : picture.boxes[end].eventOf);

/** The lines of a picture, by the box that contains them. */
function levelsOf(picture) {
    const levels = new Map();
    for (const line of picture.lines) {
        const [from, to] = [boxOf(picture, line.from), boxOf(picture, line.to)];
        const outer = picture.boxes[to].parent === from ? from : picture.boxes[from].parent === to ? to : picture.boxes[from].parent;
        if (!levels.has(outer)) levels.set(outer, []);
        levels.get(outer).push(line);
    }
    return levels;
}

function graphOf(picture, outer, lines, options) {
    const name = (box) => `b${box}`;
    const portsOf = (box) =>
        picture.boxes.flatMap((each, i) => (each.eventOf === box ? [{ id: name(i), width: each.width, height: each.height }] : []));
    const children = picture.boxes.flatMap((each, i) =>
        each.parent === outer && each.eventOf < 0
            ? [{ id: name(i), width: each.width, height: each.height, ports: portsOf(i), layoutOptions: { "elk.portConstraints": "FREE" } }]
            : [],
    );
    const edges = lines.map((line, i) => ({
        id: `e${i}`,
        sources: [name(line.from)],
        targets: [name(line.to)],
        labels: line.label.width > 0 ? [{ id: `l${i}`, text: "label", width: line.label.width, height: line.label.height }] : [],
    }));
    const level = { id: name(outer), children, edges, ports: portsOf(outer), layoutOptions: options };
    return { id: "root", children: [level], layoutOptions: { "elk.algorithm": "layered" } };
}

async function elkLines(graph) {
    const level = (await elk.layout(graph)).children[0];
    return level.edges.map(({ sections }) => sections.flatMap((s) => [s.startPoint, ...(s.bendPoints ?? []), s.endPoint]));
}

const ways = ["DOWN", "RIGHT"].flatMap((direction) =>
    ["NODES_AND_EDGES", "NONE"].map((order) => ({
        "elk.algorithm": "layered",
        "elk.direction": direction,
        "elk.edgeRouting": "ORTHOGONAL",
        "elk.edgeLabels.placement": "CENTER",
        "elk.layered.considerModelOrder.strategy": order,
    })),
);

/** The layout with the fewest crossings (and then the shortest lines): its number of crossings, and its length. */
async function elkBest(picture, outer, lines) {
    let best = { crossings: Infinity, length: Infinity };
    for (const options of ways) {
        const drawn = await elkLines(graphOf(picture, outer, lines, options));
        const way = { crossings: crossings(drawn), length: length(drawn) };
        if (way.crossings < best.crossings || (way.crossings === best.crossings && way.length < best.length)) best = way;
    }
    return best;
}

const total = { diagrams: 0, levels: 0, lines: 0, ours: 0, theirs: 0, length: 0, elkLength: 0 };
const more = [];
let fewer = 0;
for (const text of readFileSync(0, "utf8").split("\n").filter((each) => each !== "")) {
    const picture = JSON.parse(text);
    let [ours, theirs] = [0, 0];
    for (const [outer, lines] of levelsOf(picture)) {
        const drawn = lines.map((line) => line.points);
        const elkWay = await elkBest(picture, outer, lines);
        ours += crossings(drawn);
        theirs += elkWay.crossings;
        total.length += length(drawn);
        total.elkLength += elkWay.length;
        total.lines += lines.length;
        ++total.levels;
    }
    ++total.diagrams;
    total.ours += ours;
    total.theirs += theirs;
    if (ours < theirs) ++fewer;
    if (ours > theirs) more.push(`${picture.name} (${picture.file}): ${ours}, ELK ${theirs}`);
}
const pixels = (sum) => `${Math.round(sum / 1000)} kpx`;
console.log(`${total.diagrams} diagrams, ${total.levels} levels with ${total.lines} lines`);
console.log(`crossings: ${total.ours}, ELK ${total.theirs}`);
console.log(`length of all lines: ${pixels(total.length)}, ELK ${pixels(total.elkLength)}`);
console.log(`diagrams with fewer crossings than ELK: ${fewer}, with more: ${more.length}`);
for (const each of more) console.log(`  ${each}`);
process.exitCode = total.ours > total.theirs ? 1 : 0;
