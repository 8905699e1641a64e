// SPDX-License-Identifier: Apache-2.0
// Stubs for the parts of VS Code's API that the extension uses. They record the calls.
"use strict";

const Module = require("node:module");

function uriOf(text) {
    const { pathname } = new URL(text);
    return { fsPath: pathname, toString: () => text.replace("%3A", ":") };
}

/** A document whose ranges are all valid. */
function documentAt(uri, languageId = "robochart") {
    return { uri: uriOf(uri), languageId, validateRange: (range) => range };
}

/** A panel that records its messages. `hear` simulates a message from its page. */
function standInPanel(log, options) {
    const listeners = {};
    const listen = (name) => (handler) => ((listeners[name] = handler), { dispose: () => {} });
    const webview = {
        options,
        cspSource: "https://files.example",
        pages: 0,
        asWebviewUri: (uri) => uriOf(uri.toString().replace("file://", "https://files.example")),
        postMessage: async (message) => log.push(["post", message]),
        onDidReceiveMessage: listen("message"),
        set html(text) {
            this.pages += 1;
            this.page = text;
        },
    };
    return {
        webview,
        visible: true,
        title: "",
        reveal: (...words) => log.push(["reveal panel", ...words]),
        dispose: () => listeners.dispose?.(),
        onDidDispose: listen("dispose"),
        onDidChangeViewState: listen("state"),
        hear: (message) => listeners.message(message),
        shown: () => listeners.state(),
    };
}

/** Loads the extension with `vscode` and `vscode-languageclient/node` replaced. `settings`: values by name. */
function loadExtension(settings, failure) {
    const log = [];
    const handlers = { panels: [], notifications: {}, answer: undefined };
    const disposable = { dispose: () => {} };
    const vscode = {
        workspace: {
            workspaceFolders: undefined,
            getConfiguration: (section) => ({ get: (name) => settings[`${section}.${name}`] }),
            onDidChangeConfiguration: (handler) => ((handlers.settings = handler), disposable),
            onDidChangeTextDocument: (handler) => ((handlers.text = handler), disposable),
            saveAll: async () => log.push(["save"]),
            textDocuments: [{ uri: "open" }],
            asRelativePath: (file) => file.replace("/p/", ""),
            openTextDocument: async (uri) => documentAt(uri.toString()),
        },
        window: {
            createOutputChannel: (name) => ({
                name,
                appendLine: (line) => log.push(["output", line]),
                show: () => log.push(["show"]),
                ...disposable,
            }),
            activeColorTheme: { kind: 1 },
            activeTextEditor: undefined,
            visibleTextEditors: [],
            onDidChangeActiveTextEditor: (handler) => ((handlers.editor = handler), disposable),
            onDidChangeTextEditorSelection: (handler) => ((handlers.selection = handler), disposable),
            onDidChangeActiveColorTheme: (handler) => ((handlers.theme = handler), disposable),
            registerWebviewPanelSerializer: (type, serializer) => ((handlers[type + " serializer"] = serializer), disposable),
            createWebviewPanel: (type, title, column, options) => {
                log.push(["panel", type, column]);
                const panel = standInPanel(log, options);
                handlers.panels.push(panel);
                return panel;
            },
            showTextDocument: async (document, options) => {
                log.push(["shown", document.uri.toString(), options]);
                return { revealRange: (range) => log.push(["revealed", range]) };
            },
            createTerminal: (options) => (log.push(["terminal", options]), { show: () => log.push(["show terminal"]) }),
            createQuickPick: () => {
                const listeners = {};
                const listen = (name) => (handler) => ((listeners[name] = handler), disposable);
                return {
                    activeItems: [],
                    onDidChangeActive: listen("active"),
                    onDidAccept: listen("accept"),
                    onDidHide: listen("hide"),
                    go(item) {
                        this.activeItems = [item];
                        return listeners.active([item]);
                    },
                    accept: () => listeners.accept(),
                    show: () => log.push(["show list"]),
                    hide: () => listeners.hide(),
                    dispose: () => log.push(["dispose list"]),
                };
            },
            showErrorMessage: async (message, ...buttons) => (log.push(["error", message]), buttons[0]),
        },
        commands: {
            registerCommand: (name, handler) => ((handlers[name] = handler), disposable),
            executeCommand: async (...words) => log.push(["command", ...words]),
        },
    };
    vscode.languages = {
        createDiagnosticCollection: (name) => {
            const problems = new Map();
            handlers.problems = problems;
            return {
                name,
                get: (uri) => problems.get(uri.toString()),
                set: (uri, list) => problems.set(uri.toString(), list),
                clear: () => problems.clear(),
                ...disposable,
            };
        },
    };
    const record = (...names) =>
        class {
            constructor(...values) {
                names.forEach((name, index) => (this[name] = values[index]));
            }
        };
    vscode.Diagnostic = record("range", "message", "severity");
    vscode.DiagnosticRelatedInformation = record("location", "message");
    vscode.Location = record("uri", "range");
    vscode.CodeLens = record("range", "command");
    vscode.DiagnosticSeverity = { Error: 0 };
    vscode.QuickPickItemKind = { Separator: -1 };
    vscode.Uri = {
        parse: uriOf,
        file: (path) => uriOf(`file://${path}`),
        joinPath: (uri, ...names) => uriOf([uri.toString(), ...names].join("/")),
    };
    vscode.ViewColumn = { Beside: -2, One: 1 };
    vscode.ColorThemeKind = { Light: 1, Dark: 2, HighContrast: 3, HighContrastLight: 4 };
    vscode.TextEditorRevealType = { InCenterIfOutsideViewport: 2 };
    vscode.Range = class {
        constructor(...numbers) {
            this.numbers = numbers;
        }
    };
    class LanguageClient {
        constructor(id, name, server, options) {
            Object.assign(this, { server, options });
            handlers.middleware = options.middleware;
            handlers.options = options.initializationOptions;
            handlers.documents = options.documentSelector;
        }
        getFeature(method) {
            const fire = () => log.push(["refresh", method]);
            return { getProvider: () => ({ onDidChangeCodeLensEmitter: { fire } }) };
        }
        onNotification(method, handler) {
            handlers.notifications[method] = handler;
        }
        async sendRequest(method, parameters) {
            log.push(["request", method, parameters]);
            return handlers.answer(parameters);
        }
        async start() {
            if (failure !== undefined) throw new Error(failure);
            log.push(["start", this.server.command, ...this.server.args]);
        }
        async stop() {
            log.push(["stop"]);
        }
    }
    const stand = { vscode, "vscode-languageclient/node": { LanguageClient } };
    const load = Module._load;
    Module._load = (request, ...rest) => stand[request] ?? load(request, ...rest);
    try {
        for (const name of ["extension", "preview", "steps"]) delete require.cache[require.resolve(`../../client/${name}`)];
        return { ...require("../../client/extension"), log, handlers, vscode };
    } finally {
        Module._load = load;
    }
}

module.exports = { loadExtension, documentAt, uriOf };
