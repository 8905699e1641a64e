// The parts of VS Code's interface that the extension uses, as stand-ins that write down what was asked of them.
"use strict";

const Module = require("node:module");

/** Loads the extension with `vscode` and `vscode-languageclient/node` replaced. `settings`: values by name. */
function loadExtension(settings, failure) {
    const log = [];
    const handlers = {};
    const disposable = { dispose: () => {} };
    const vscode = {
        workspace: {
            workspaceFolders: undefined,
            getConfiguration: (section) => ({ get: (name) => settings[`${section}.${name}`] }),
            onDidChangeConfiguration: (handler) => ((handlers.settings = handler), disposable),
            onDidChangeTextDocument: (handler) => ((handlers.text = handler), disposable),
            saveAll: async () => log.push(["save"]),
            textDocuments: [{ uri: "open" }],
        },
        window: {
            createOutputChannel: (name) => ({
                name,
                appendLine: (line) => log.push(["output", line]),
                show: () => log.push(["show"]),
                ...disposable,
            }),
            showErrorMessage: async (message, ...buttons) => (log.push(["error", message]), buttons[0]),
        },
        commands: {
            registerCommand: (name, handler) => ((handlers[name] = handler), disposable),
            executeCommand: async (...words) => log.push(["command", ...words]),
        },
    };
    vscode.Uri = { parse: (uri) => ({ fsPath: new URL(uri).pathname }) };
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
        delete require.cache[require.resolve("../../client/extension")];
        return { ...require("../../client/extension"), log, handlers };
    } finally {
        Module._load = load;
    }
}

module.exports = { loadExtension };
