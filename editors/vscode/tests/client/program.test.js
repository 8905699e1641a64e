// SPDX-License-Identifier: Apache-2.0
// The program for each value of the setting robochart.server.path.
"use strict";

const assert = require("node:assert");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { findProgram } = require("../../client/program");

const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robochart-"));
test.after(() => fs.rmSync(folder, { recursive: true }));

function write(name, mode) {
    const file = path.join(folder, name);
    fs.mkdirSync(path.dirname(file), { recursive: true });
    fs.writeFileSync(file, "#!/bin/sh\n", { mode });
    return file;
}
const program = write("bin/robochart-verify", 0o755);
const text = write("docs/robochart-verify", 0o644);

test("a bare name is looked up in PATH, in its order, empty parts left out", () => {
    const PATH = ["", path.dirname(text), path.join(folder, "none"), path.dirname(program)].join(path.delimiter);
    assert.deepStrictEqual(findProgram("robochart-verify", undefined, { PATH }), { program });
});

test("a name that is nowhere is a problem that names it", () => {
    assert.match(findProgram("robochart-verify", folder, { PATH: path.join(folder, "none") }).problem, /no program robochart-verify in PATH/);
    assert.match(findProgram("robochart-verify", folder, {}).problem, /PATH/);
});

test("paths: absolute, from the open folder, from home", () => {
    assert.deepStrictEqual(findProgram(program, undefined, {}), { program });
    assert.deepStrictEqual(findProgram("bin/robochart-verify", folder, {}), { program });
    assert.deepStrictEqual(findProgram("./bin/robochart-verify", folder, {}), { program });
    assert.deepStrictEqual(findProgram("~/bin/robochart-verify", "/", { HOME: folder }), { program });
    assert.deepStrictEqual(findProgram(`  ${program}\n`, undefined, {}), { program });
});

test("a program that cannot be run is distinguished from one that does not exist", () => {
    assert.match(findProgram(text, undefined, {}).problem, /is not a program that can be run/);
    assert.match(findProgram(path.dirname(program), undefined, {}).problem, /is not a program that can be run/);
    assert.match(findProgram(path.join(folder, "x"), undefined, {}).problem, /x, which does not exist/);
});

test("an empty setting is a problem, not the folder", () => {
    assert.match(findProgram("  ", folder, {}).problem, /is empty/);
});

test("the default name means the program that came with the extension, another name does not", () => {
    const bundled = write("extension/server/robochart-verify", 0o755);
    const extension = path.dirname(path.dirname(bundled));
    const PATH = path.dirname(program);
    assert.deepStrictEqual(findProgram("robochart-verify", folder, { PATH }, extension), { program: bundled });
    assert.deepStrictEqual(findProgram(program, folder, { PATH }, extension), { program });
    assert.deepStrictEqual(findProgram("robochart-verify", folder, { PATH }, folder), { program });
});
