// SPDX-License-Identifier: Apache-2.0
// Checks one assertion with robochart-verify. This file does not use the API of VS Code, so Node can test it alone.
"use strict";

const { execFile } = require("node:child_process");

/** Verdicts from the best to the worst. The worst check determines the verdict of an assertion. */
const answers = ["holds", "value", "not checked", "no check", "inconclusive", "error", "fails"];

/** The worst answer in a report of `check --format json`; undefined if the report contains no answer. */
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

/** The text for a report: each check with its answer and the text of its counterexample. */
function linesOf(report) {
    return (report.assertions ?? []).flatMap((each) => {
        const text = each.counterexample?.text;
        const values = (each.probability?.rows ?? []).map(valueOf);
        return [`${each.answer}: ${each.title}`, ...values, ...(text === undefined ? [] : [text.trimEnd()])];
    });
}

/** "t=3: input obstacle": a step in the form of the list of steps. */
const textOf = (step) => (step.time === undefined ? step.text : `t=${step.time}: ${step.text}`);

/** The steps of a counterexample that have a place in the texts, in order. Lines and columns are counted from 1. */
function stepsOf(counterexample) {
    return (counterexample?.steps ?? [])
        .filter((step) => step.file !== undefined)
        .map(({ file, line, column, endLine, endColumn, ...step }) => ({
            file,
            range: [line, column, endLine, endColumn],
            text: textOf(step),
        }));
}

/** The failures: the line of the assertion, the reason, and the steps of the counterexample. */
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

/** Errors of the model, if the program wrote these instead of a report. */
function errorsOf(report) {
    return (report?.diagnostics ?? [])
        .filter((each) => each.severity === "error")
        .map((each) => `${each.file}:${each.line}: ${each.message}`);
}

/**
 * Runs `PROGRAM check FILE --assertion NAME` without a shell.
 * Returns `{ verdict, lines, failures }`. If there is no verdict, it is "error" and the lines contain the reason.
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
