// SPDX-License-Identifier: Apache-2.0
// The lens above an assertion: which command it runs, and which verdict it shows until when.
"use strict";

const assert = require("node:assert");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { checkAssertion, verdictOf } = require("../../client/check");
const { loadExtension, uriOf } = require("./stand_ins");

const report = (...answers) => ({ assertions: answers.map((answer) => ({ answer, title: `A1 ${answer}` })) });

/** A program that writes its arguments to a file beside it, and `stdout` and `stderr`. */
function standIn(stdout, stderr = "", exitCode = 0) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), "robochart-check-"));
    const program = path.join(folder, "program");
    const text = [
        `#!${process.execPath}`,
        `require("node:fs").writeFileSync(${JSON.stringify(path.join(folder, "words"))}, JSON.stringify(process.argv.slice(2)));`,
        `process.stdout.write(${JSON.stringify(stdout)});`,
        `process.stderr.write(${JSON.stringify(stderr)});`,
        `process.exitCode = ${exitCode};`,
    ];
    fs.writeFileSync(program, text.join("\n"), { mode: 0o755 });
    return { program, words: () => JSON.parse(fs.readFileSync(path.join(folder, "words"), "utf8")) };
}

test("an assertion is as good as the worst of its checks", () => {
    assert.strictEqual(verdictOf(report("holds", "holds")), "holds");
    assert.strictEqual(verdictOf(report("holds", "inconclusive")), "inconclusive");
    assert.strictEqual(verdictOf(report("fails", "holds")), "fails");
    assert.strictEqual(verdictOf(report("holds", "something new")), "something new");
    assert.strictEqual(verdictOf(report()), undefined);
});

test("the program is run without a shell, and its report is read", async () => {
    const failing = report("holds", "fails");
    failing.assertions[1].counterexample = { text: "  t0: i -> S1\n" };
    const { program, words } = standIn(JSON.stringify(failing), "", 1);
    const name = "A; touch x $(y)";
    const found = await checkAssertion(program, "/p/a b.assertions", name);
    assert.deepStrictEqual(words(), ["check", "/p/a b.assertions", "--assertion", name, "--format", "json"]);
    assert.strictEqual(found.verdict, "fails");
    assert.deepStrictEqual(found.lines, ["holds: A1 holds", "fails: A1 fails", "  t0: i -> S1"]);
    assert.deepStrictEqual(found.failures, [{ line: 1, text: "A1 fails fails", steps: [] }]);
});

test("without a report the reason is shown, and nothing holds", async () => {
    const finding = { severity: "error", file: "a.rct", line: 3, message: "lost" };
    const refused = standIn("", JSON.stringify({ diagnostics: [finding] }), 2);
    assert.deepStrictEqual(await checkAssertion(refused.program, "a", "A"), {
        verdict: "error",
        lines: ["a.rct:3: lost"],
        failures: [],
    });
    const broken = standIn("not a report", "it broke", 70);
    assert.deepStrictEqual((await checkAssertion(broken.program, "a", "A")).lines, ["it broke"]);
    const missing = await checkAssertion("/nowhere/program", "a", "A");
    assert.strictEqual(missing.verdict, "error");
    assert.match(missing.lines[0], /ENOENT/);
});

const uri = "file:///p/a.assertions";

async function withServer(answer, counterexample) {
    const written = report(answer);
    if (counterexample !== undefined) Object.assign(written.assertions[0], counterexample);
    const { program } = standIn(JSON.stringify(written));
    const extension = loadExtension({ "robochart.server.path": program });
    await extension.activate({ subscriptions: [], extensionUri: uriOf("file:///extension") });
    const titles = async (...names) => {
        const served = names.map((name) => ({
            command: { title: "check", command: "robochart.check", arguments: [uri, name] },
        }));
        const lenses = await extension.handlers.middleware.provideCodeLenses({}, {}, async () => served);
        return lenses.map((lens) => lens.command.title);
    };
    return { ...extension, titles, check: extension.handlers["robochart.check"] };
}

test("the verdict stands in the lens of its assertion until a text changes", async () => {
    const { handlers, titles, check, log } = await withServer("holds");
    assert.deepStrictEqual(handlers.options, { commands: ["robochart.check", "robochart.draw", "robochart.step"] });
    assert.deepStrictEqual(await titles("A1", "A2"), ["check", "check"]);
    assert.strictEqual(await check(uri, "A1"), "holds");
    assert.deepStrictEqual(await titles("A1", "A2"), ["holds (check again)", "check"]);
    assert.ok(log.findIndex(([kind]) => kind === "save") < log.findIndex(([kind]) => kind === "refresh"));
    assert.ok(!log.some(([kind]) => kind === "show"));
    handlers.text({ document: { languageId: "markdown" } });
    assert.deepStrictEqual(await titles("A1"), ["holds (check again)"]);
    handlers.text({ document: { languageId: "robochart" } });
    assert.deepStrictEqual(await titles("A1"), ["check"]);
});

test("a verdict about a text that changed meanwhile is not shown in the lens", async () => {
    const { handlers, titles, check } = await withServer("holds");
    const running = check(uri, "A1");
    await new Promise(setImmediate);
    handlers.text({ document: { languageId: "robochart" } });
    await running;
    assert.deepStrictEqual(await titles("A1"), ["check"]);
});

test("what does not hold is shown with its text", async () => {
    const { check, log } = await withServer("fails");
    assert.strictEqual(await check(uri, "A1"), "fails");
    assert.ok(log.some(([kind, text]) => kind === "output" && text === "fails: A1 fails"));
    assert.ok(log.some(([kind]) => kind === "show"));
});

const failing = {
    title: "A1 [timed] S is never B",
    place: "/p/a.assertions:7",
    counterexample: {
        end: { why: "the state has been reached" },
        steps: [
            { n: 1, time: 0, text: "t0: i -> A", file: "/p/m.rct", line: 4, column: 3, endLine: 4, endColumn: 20 },
            { n: 2, time: 0, text: "2 time units pass" },
            { n: 3, time: 2, text: "entered B", file: "/p/n.rct", line: 2, column: 1, endLine: 3, endColumn: 2 },
        ],
    },
};

test("a failure is a problem at its assertion, with the steps as related places, until a text changes", async () => {
    const { handlers, check } = await withServer("fails", failing);
    await check(uri, "A1");
    const [problem, ...more] = handlers.problems.get(uri);
    assert.deepStrictEqual(more, []);
    assert.strictEqual(problem.message, "A1 [timed] S is never B fails: the state has been reached");
    assert.deepStrictEqual(problem.range.numbers.slice(0, 3), [6, 0, 6]);
    const related = problem.relatedInformation.map(({ location, message }) => [
        message,
        location.uri.fsPath,
        location.range.numbers,
    ]);
    assert.deepStrictEqual(related, [
        ["t=0: t0: i -> A", "/p/m.rct", [3, 2, 3, 19]],
        ["t=2: entered B", "/p/n.rct", [1, 0, 2, 1]],
    ]);
    await check(uri, "A1");
    assert.strictEqual(handlers.problems.get(uri).length, 1, "instead of the one before");
    await check(uri, "A2");
    assert.strictEqual(handlers.problems.get(uri).length, 2, "beside those of other assertions");
    handlers.text({ document: { languageId: "robochart" } });
    assert.strictEqual(handlers.problems.size, 0);
});

test("the steps are a list that leads through the texts", async () => {
    const { handlers, check, titles, log } = await withServer("fails", failing);
    await check(uri, "A1");
    assert.deepStrictEqual(await titles("A1", "A2"), ["fails (check again)", "steps", "check"]);
    const list = handlers["robochart.steps"](uri, "A1");
    assert.deepStrictEqual(
        list.items.map(({ label, description }) => [label, description]),
        [
            ["A1 [timed] S is never B fails: the state has been reached", undefined],
            ["1  t=0: t0: i -> A", "m.rct:4"],
            ["2  t=2: entered B", "n.rct:2"],
        ],
    );
    const shown = () => log.filter(([kind]) => kind === "shown").map(([, at, how]) => [at, how.selection.numbers, how.preserveFocus]);
    list.go(list.items[0]);
    await list.go(list.items[2]);
    assert.deepStrictEqual(shown(), [["file:///p/n.rct", [1, 0, 2, 1], true]]);
    list.accept();
    await new Promise(setImmediate);
    assert.deepStrictEqual(shown().at(-1), ["file:///p/n.rct", [1, 0, 2, 1], false]);
    assert.ok(log.some(([kind]) => kind === "dispose list"));
});

test("step opens a terminal with the program, without a shell", async () => {
    const { handlers, log } = await withServer("holds");
    await handlers["robochart.step"]("file:///p/a%20b.rct", "p::S; x");
    const [, options] = log.find(([kind]) => kind === "terminal");
    assert.deepStrictEqual(options.shellArgs, ["step", "/p/a%20b.rct", "p::S; x"]);
    assert.match(options.shellPath, /program$/);
    assert.ok(log.findIndex(([kind]) => kind === "save") < log.findIndex(([kind]) => kind === "terminal"));
    assert.deepStrictEqual(log.at(-1), ["show terminal"]);
});

test("draw asks for the component of its lens", async () => {
    const { handlers, log } = await withServer("holds");
    handlers.answer = ({ component }) => ({ component, svg: "<svg/>", elements: [], stale: false, version: 1 });
    await handlers["robochart.draw"]("file:///p/m.rct", "p::S");
    const [, method, parameters] = log.find(([kind]) => kind === "request");
    assert.strictEqual(method, "robochart/diagram");
    assert.strictEqual(parameters.component, "p::S");
    assert.strictEqual(parameters.position, undefined);
    assert.strictEqual(handlers.panels[0].title, "Diagram p::S");
});
