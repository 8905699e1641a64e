// SPDX-License-Identifier: Apache-2.0
// The entry point of the extension: starts `robochart-verify lsp`, which communicates over stdio, and stops it.
"use strict";

const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");
const { checkAssertion } = require("./check");
const { Lenses } = require("./lenses");
const preview = require("./preview");
const { findProgram } = require("./program");
const { Steps } = require("./steps");

/** The texts on which verdicts depend. */
const models = [
    { scheme: "file", language: "robochart" },
    { scheme: "file", language: "robochart-assertions" },
    { scheme: "file", language: "robosim" },
    { scheme: "file", language: "robosim-assertions" },
];

/** The texts that the server handles. */
const documentSelector = [
    ...models,
    { scheme: "file", language: "cspm" },
    { scheme: "file", language: "sleec" },
    { scheme: "file", language: "robochart-claims" },
];

/** The commands of the server's lenses. The server offers only the lenses whose commands are listed at the start. */
const checkCommand = "robochart.check";
const drawCommand = "robochart.draw";
const stepCommand = "robochart.step";
/** The command of the extension's lens for an assertion that fails. */
const stepsCommand = "robochart.steps";

let client;
let output;
let lenses;
let steps;
let diagrams;

/** The current start or stop. Starts and stops never overlap. */
let queue = Promise.resolve();

async function sayNotFound(problem) {
    const settingsButton = "Open settings";
    const choice = await vscode.window.showErrorMessage(
        `RoboChart: robochart-verify was not found, so there are colours and snippets only. ${problem} ` +
            "Install it, or set robochart.server.path; then run “RoboChart: Restart the language server”.",
        settingsButton,
    );
    if (choice === settingsButton)
        await vscode.commands.executeCommand("workbench.action.openSettings", "robochart.server.path");
}

function openFolder() {
    return vscode.workspace.workspaceFolders?.[0]?.uri.fsPath;
}

function program() {
    return findProgram(vscode.workspace.getConfiguration("robochart").get("server.path"), openFolder());
}

/** Makes VS Code request the lenses again. */
function refreshLenses() {
    const feature = client?.getFeature("textDocument/codeLens");
    for (const document of vscode.workspace.textDocuments)
        feature?.getProvider(document)?.onDidChangeCodeLensEmitter.fire();
}

/** Checks one assertion. The program reads the files on disk, so texts are saved first. */
async function check(uri, name) {
    const found = program();
    if (found.problem !== undefined) return void sayNotFound(found.problem);
    await vscode.workspace.saveAll(false);
    const file = vscode.Uri.parse(uri).fsPath;
    const edition = lenses.edition;
    lenses.set(uri, name, "checking …");
    refreshLenses();
    const { verdict, lines, failures } = await checkAssertion(found.program, file, name);
    if (edition === lenses.edition) {
        lenses.set(uri, name, verdict, failures);
        steps.report(uri, name, failures);
    }
    refreshLenses();
    output.appendLine(`check ${file} --assertion ${name}`);
    for (const line of lines) output.appendLine(line);
    if (verdict !== "holds") output.show(true);
    return verdict;
}

/** Steps through a component in a terminal, without a shell. */
async function step(uri, name) {
    const found = program();
    if (found.problem !== undefined) return void sayNotFound(found.problem);
    await vscode.workspace.saveAll(false);
    const shellArgs = ["step", vscode.Uri.parse(uri).fsPath, name];
    const terminal = vscode.window.createTerminal({ name: `step ${name}`, shellPath: found.program, shellArgs });
    terminal.show();
}

function textChanged(event) {
    if (!models.some((each) => each.language === event.document.languageId)) return;
    lenses.forget();
    steps.forget();
}

async function start() {
    const folder = openFolder();
    const found = program();
    if (found.problem !== undefined) {
        output.appendLine(found.problem);
        // There is no `await`, because the message stays open until the user answers.
        void sayNotFound(found.problem);
        return;
    }
    const server = { command: found.program, args: ["lsp"], options: { cwd: folder } };
    const started = new LanguageClient("robochart", "RoboChart", server, {
        documentSelector,
        outputChannel: output,
        initializationOptions: { commands: [checkCommand, drawCommand, stepCommand] },
        middleware: {
            provideCodeLenses: async (document, token, next) =>
                lenses.titled(await next(document, token), checkCommand, stepsCommand),
        },
    });
    try {
        started.onNotification(preview.notification, (parameters) => diagrams.changed(parameters));
        await started.start();
        client = started;
        void diagrams.refresh();
    } catch (error) {
        const reason = error instanceof Error ? error.message : String(error);
        output.appendLine(`${found.program} lsp: ${reason}`);
        void vscode.window.showErrorMessage(`RoboChart: ${found.program} lsp could not be started: ${reason}`);
    }
}

async function stop() {
    const running = client;
    client = undefined;
    try {
        await running?.stop();
    } catch (error) {
        // A server that has already ended cannot receive a request to stop.
        output.appendLine(`stop: ${error instanceof Error ? error.message : String(error)}`);
    }
}

function enqueue(...steps) {
    for (const step of steps) queue = queue.then(step);
    return queue;
}

/** The language client itself handles changes of `robochart.trace.server`. */
function settingsChanged(event) {
    if (event.affectsConfiguration("robochart.server.path")) return enqueue(stop, start);
    return undefined;
}

function activate(context) {
    output = vscode.window.createOutputChannel("RoboChart");
    lenses = new Lenses((range, command) => new vscode.CodeLens(range, command));
    steps = new Steps();
    diagrams = new preview.Preview(async (...words) => client?.sendRequest(...words), context.extensionUri);
    context.subscriptions.push(
        output,
        steps,
        diagrams,
        vscode.commands.registerCommand("robochart.preview", () => diagrams.open()),
        vscode.commands.registerCommand(checkCommand, check),
        vscode.commands.registerCommand(drawCommand, (uri, name) => diagrams.draw(uri, name)),
        vscode.commands.registerCommand(stepCommand, step),
        vscode.commands.registerCommand(stepsCommand, (uri, name) => steps.list(lenses.failures(uri, name))),
        vscode.workspace.onDidChangeTextDocument(textChanged),
        vscode.commands.registerCommand("robochart.restartServer", () => enqueue(stop, start)),
        vscode.workspace.onDidChangeConfiguration(settingsChanged),
    );
    return enqueue(start);
}

function deactivate() {
    return enqueue(stop);
}

module.exports = { activate, deactivate };
