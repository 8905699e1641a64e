// SPDX-License-Identifier: Apache-2.0
// Asks robochart-verify about one assertion. Knows nothing of VS Code, so that plain Node tests it.
"use strict";

const { execFile } = require("node:child_process");

/** From the best to the worst: an assertion is as good as the worst of its checks. */
const answers = ["holds", "value", "not checked", "no check", "inconclusive", "error", "fails"];

/** The worst answer of a report of `check --format json`; undefined if it answers nothing. */
function verdictOf(report) {
    const found = (report.assertions ?? []).map((each) => each.answer);
    if (found.length === 0) return undefined;
    const rank = (answer) => (answers.includes(answer) ? answers.indexOf(answer) : answers.length);
    return found.reduce((worst, answer) => (rank(answer) > rank(worst) ? answer : worst));
}

/** "  k=5: 0.25", "  k=5: from 0 to 0.25": a row of a probabilistic assertion. */
function valueOf(row) {
    const constants = Object.entries(row.constants ?? {}).map(([name, value]) => `${name}=${value}`);
    const value = row.least ? `from ${row.least.value} to ${row.greatest.value}` : (row.value ?? row.answer);
    return `  ${constants.join(", ")}${constants.length > 0 ? ": " : ""}${value}`;
}

/** What is shown of a report: each check with its answer, and the text of its counterexample. */
function linesOf(report) {
    return (report.assertions ?? []).flatMap((each) => {
        const text = each.counterexample?.text;
        const values = (each.probability?.rows ?? []).map(valueOf);
        return [`${each.answer}: ${each.title}`, ...values, ...(text === undefined ? [] : [text.trimEnd()])];
    });
}

/** "t=3: input obstacle": a step as the list of steps has it. */
const textOf = (step) => (step.time === undefined ? step.text : `t=${step.time}: ${step.text}`);

/** The steps of a counterexample that are somewhere in the texts, in order; lines and columns count from 1. */
function stepsOf(counterexample) {
    return (counterexample?.steps ?? [])
        .filter((step) => step.file !== undefined)
        .map(({ file, line, column, endLine, endColumn, ...step }) => ({
            file,
            range: [line, column, endLine, endColumn],
            text: textOf(step),
        }));
}

/** What fails: the line of the assertion, why, and the steps that show it. */
function failuresOf(report) {
    return (report.assertions ?? [])
        .filter((each) => each.answer === "fails")
        .map((each) => ({
            line: Number(/:(\d+)$/.exec(each.place ?? "")?.[1] ?? 1),
            text: [`${each.title} fails`, each.counterexample?.end?.why].filter((part) => part).join(": "),
            steps: stepsOf(each.counterexample),
        }));
}

function parsed(text) {
    try {
        return JSON.parse(text);
    } catch {
        return undefined;
    }
}

/** Errors of the model, if that is what was written instead of a report. */
function errorsOf(report) {
    return (report?.diagnostics ?? [])
        .filter((each) => each.severity === "error")
        .map((each) => `${each.file}:${each.line}: ${each.message}`);
}

/**
 * Runs `PROGRAM check FILE --assertion NAME`; no shell is involved.
 * Gives `{ verdict, lines, failures }`; the verdict is "error" where there is none, and the lines say why.
 */
function checkAssertion(program, file, name) {
    const words = ["check", file, "--assertion", name, "--format", "json"];
    return new Promise((resolve) => {
        execFile(program, words, { maxBuffer: 64 * 1024 * 1024 }, (failure, stdout, stderr) => {
            const report = parsed(stdout);
            const verdict = report && verdictOf(report);
            if (verdict !== undefined) return resolve({ verdict, lines: linesOf(report), failures: failuresOf(report) });
            const errors = [...errorsOf(report), ...errorsOf(parsed(stderr))];
            const why = errors.length > 0 ? errors : [(stderr || failure?.message || "no answer").trim()];
            return resolve({ verdict: "error", lines: why, failures: [] });
        });
    });
}

module.exports = { checkAssertion, verdictOf };
