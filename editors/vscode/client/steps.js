// SPDX-License-Identifier: Apache-2.0
// Shows counterexamples in the texts. A failure is a problem at its assertion, and the related places of the problem
// are the steps of the run. The steps are also shown as a list that leads through the texts.
"use strict";

const vscode = require("vscode");

/** The number of steps that a problem lists. For longer runs these are the last steps. */
const mostRelated = 200;

const rangeOf = ([line, column, endLine, endColumn]) =>
    new vscode.Range(line - 1, column - 1, endLine - 1, endColumn - 1);

class Steps {
    constructor() {
        this.problems = vscode.languages.createDiagnosticCollection("robochart check");
    }

    dispose() {
        this.problems.dispose();
    }

    /** Removes the failures, because any change of a text may change them. */
    forget() {
        this.problems.clear();
    }

    /** Replaces the failures of one assertion. */
    report(uri, name, failures) {
        const file = vscode.Uri.parse(uri);
        const others = (this.problems.get(file) ?? []).filter((each) => each.code !== name);
        this.problems.set(file, [...others, ...failures.map((each) => this.problem(name, each))]);
    }

    problem(name, { line, text, steps }) {
        const whole = new vscode.Range(line - 1, 0, line - 1, Number.MAX_SAFE_INTEGER);
        const problem = new vscode.Diagnostic(whole, text, vscode.DiagnosticSeverity.Error);
        problem.source = "robochart check";
        problem.code = name;
        problem.relatedInformation = steps.slice(-mostRelated).map((step) => {
            const place = new vscode.Location(vscode.Uri.file(step.file), rangeOf(step.range));
            return new vscode.DiagnosticRelatedInformation(place, step.text);
        });
        return problem;
    }

    /** Lists the steps. Choosing a step in the list selects its place in the text. */
    list(failures) {
        const list = vscode.window.createQuickPick();
        list.placeholder = "Steps of the counterexample: go through them with the arrow keys";
        list.matchOnDescription = true;
        list.items = failures.flatMap(({ text, steps }) => [
            { label: text, kind: vscode.QuickPickItemKind.Separator },
            ...steps.map((step, index) => ({
                label: `${index + 1}  ${step.text}`,
                description: `${vscode.workspace.asRelativePath(step.file)}:${step.range[0]}`,
                step,
            })),
        ]);
        list.onDidChangeActive(([item]) => item?.step && this.select(item.step, true));
        list.onDidAccept(() => {
            const [item] = list.activeItems;
            list.hide();
            if (item?.step) void this.select(item.step, false);
        });
        list.onDidHide(() => list.dispose());
        list.show();
        return list;
    }

    async select({ file, range }, preserveFocus) {
        const document = await vscode.workspace.openTextDocument(vscode.Uri.file(file));
        const selection = document.validateRange(rangeOf(range));
        await vscode.window.showTextDocument(document, { selection, preserveFocus, preview: true });
    }
}

module.exports = { Steps };
