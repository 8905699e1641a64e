// The lens above an assertion: what is run, what is shown, and for how long.
"use strict";

const assert = require("node:assert");
const fs = require("node:fs");
const os = require("node:os");
const path = require("node:path");
const test = require("node:test");
const { checkAssertion, verdictOf } = require("../../client/check");
const { loadExtension } = require("./stand_ins");

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
    failing.assertions[1].counterexample = { story: "  t0: i -> S1\n" };
    const { program, words } = standIn(JSON.stringify(failing), "", 1);
    const name = "A; touch x $(y)";
    const found = await checkAssertion(program, "/p/a b.assertions", name);
    assert.deepStrictEqual(words(), ["check", "/p/a b.assertions", "--assertion", name, "--format", "json"]);
    assert.deepStrictEqual(found, { verdict: "fails", lines: ["holds: A1 holds", "fails: A1 fails", "  t0: i -> S1"] });
});

test("without a report the reason is shown, and nothing holds", async () => {
    const finding = { severity: "error", file: "a.rct", line: 3, message: "lost" };
    const refused = standIn("", JSON.stringify({ diagnostics: [finding] }), 2);
    assert.deepStrictEqual(await checkAssertion(refused.program, "a", "A"), { verdict: "error", lines: ["a.rct:3: lost"] });
    const broken = standIn("not a report", "it broke", 70);
    assert.deepStrictEqual(await checkAssertion(broken.program, "a", "A"), { verdict: "error", lines: ["it broke"] });
    const missing = await checkAssertion("/nowhere/program", "a", "A");
    assert.strictEqual(missing.verdict, "error");
    assert.match(missing.lines[0], /ENOENT/);
});

const uri = "file:///p/a.assertions";

async function withServer(answer) {
    const { program } = standIn(JSON.stringify(report(answer)));
    const extension = loadExtension({ "robochart.server.path": program });
    await extension.activate({ subscriptions: [] });
    const titles = async (...names) => {
        const served = names.map((name) => ({ command: { title: "check", arguments: [uri, name] } }));
        const lenses = await extension.handlers.middleware.provideCodeLenses({}, {}, async () => served);
        return lenses.map((lens) => lens.command.title);
    };
    return { ...extension, titles, check: extension.handlers["robochart.check"] };
}

test("the verdict stands in the lens of its assertion until a text changes", async () => {
    const { handlers, titles, check, log } = await withServer("holds");
    assert.deepStrictEqual(handlers.options, { commands: ["robochart.check"] });
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
