// SPDX-License-Identifier: Apache-2.0
// Shows the diagram next to the text, in a page that follows the cursor in the editors of models. The server draws the
// diagram.
"use strict";

const crypto = require("node:crypto");
const vscode = require("vscode");
const { elementAt, pageOf } = require("./diagram");

const viewType = "robochart.preview";
const request = "robochart/diagram";
const notification = "robochart/diagramChanged";

/** The pause in ms after which the server gets a request while the user types or moves the cursor. */
const rest = 120;

/** Codes of errors after which another request follows anyway: cancelled, or changed in the meantime. */
const passing = [-32800, -32801];

const isModel = (document) => document?.languageId === "robochart";

const isDark = (theme) =>
    theme?.kind === vscode.ColorThemeKind.Dark || theme?.kind === vscode.ColorThemeKind.HighContrast;

/** Compares in one form, because a URI can be written in several ways. */
const sameUri = (a, b) => vscode.Uri.parse(a).toString() === vscode.Uri.parse(b).toString();

class Preview {
    /** `ask(method, parameters)` sends a request to the server; undefined while there is no server. */
    constructor(ask, extensionUri) {
        this.ask = ask;
        this.extensionUri = extensionUri;
        this.panel = undefined;
        /** The place of the cursor: `{ uri, position, column }`. */
        this.place = undefined;
        /** The last answer, and everything else that the page shows. */
        this.answer = undefined;
        this.asked = 0;
        this.timer = undefined;
        this.listeners = [
            vscode.window.onDidChangeActiveTextEditor((editor) => this.follow(editor)),
            vscode.window.onDidChangeTextEditorSelection((event) => this.follow(event.textEditor)),
            vscode.window.onDidChangeActiveColorTheme(() => this.later()),
            vscode.window.registerWebviewPanelSerializer(viewType, {
                deserializeWebviewPanel: async (panel, state) => this.restore(panel, state),
            }),
        ];
    }

    dispose() {
        clearTimeout(this.timer);
        this.panel?.dispose();
        for (const each of this.listeners) each.dispose();
    }

    /** Shows the diagram for the text in the active editor. */
    open() {
        const editor = vscode.window.activeTextEditor;
        if (isModel(editor?.document)) this.remember(editor);
        return this.openPanel();
    }

    /** Shows the diagram of one component, until the cursor moves. */
    draw(uri, component) {
        this.place = { uri };
        this.answer = { component };
        return this.openPanel();
    }

    openPanel() {
        if (this.panel !== undefined) {
            this.panel.reveal(undefined, true);
        } else {
            const column = { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true };
            this.adopt(vscode.window.createWebviewPanel(viewType, "Diagram", column, this.options()));
        }
        return this.refresh();
    }

    /** Restores the page after a restart of the editor; `state` is the stored state of the page. */
    restore(panel, state) {
        if (typeof state?.uri === "string") {
            this.place ??= { uri: state.uri };
            this.answer ??= { component: typeof state.component === "string" ? state.component : undefined };
        }
        this.panel?.dispose();
        panel.webview.options = this.options();
        this.adopt(panel);
        return this.refresh();
    }

    options() {
        return { enableScripts: true, localResourceRoots: [this.folder()] };
    }

    folder() {
        return vscode.Uri.joinPath(this.extensionUri, "client", "page");
    }

    adopt(panel) {
        this.panel = panel;
        panel.onDidDispose(() => {
            if (this.panel === panel) this.panel = undefined;
        });
        panel.onDidChangeViewState(() => this.later());
        panel.webview.onDidReceiveMessage((message) => this.hear(message));
        const file = (name) => panel.webview.asWebviewUri(vscode.Uri.joinPath(this.folder(), name)).toString();
        const nonce = crypto.randomBytes(16).toString("hex");
        // Set only once, because setting it reloads the page and loses zoom and scroll position.
        panel.webview.html = pageOf({
            nonce,
            source: panel.webview.cspSource,
            script: file("page.js"),
            style: file("page.css"),
        });
    }

    remember(editor) {
        const { line, character } = editor.selection.active;
        this.place = { uri: editor.document.uri.toString(), position: { line, character }, column: editor.viewColumn };
    }

    follow(editor) {
        if (this.panel === undefined || !isModel(editor?.document)) return;
        this.remember(editor);
        this.post({ type: "highlight", id: this.current() });
        this.later();
    }

    /** Handles the notification of the server. */
    changed(parameters) {
        if (this.place !== undefined && sameUri(parameters.uri, this.place.uri)) this.later();
    }

    later() {
        clearTimeout(this.timer);
        if (this.panel !== undefined) this.timer = setTimeout(() => this.refresh(), rest);
    }

    async refresh() {
        clearTimeout(this.timer);
        if (this.panel === undefined || this.place === undefined || !this.panel.visible) return;
        const asked = ++this.asked;
        const { uri, position } = this.place;
        const parameters = { textDocument: { uri }, theme: isDark(vscode.window.activeColorTheme) ? "dark" : "light" };
        if (position !== undefined) parameters.position = position;
        if (this.answer?.component !== undefined) parameters.component = this.answer.component;
        try {
            const answer = await this.ask(request, parameters);
            if (asked === this.asked) this.show(answer);
        } catch (error) {
            if (asked === this.asked && !passing.includes(error?.code)) this.say(`There is no diagram: ${error.message}`);
        }
    }

    show(answer) {
        if (answer === undefined) return this.say("The language server is not running.");
        if (answer === null) return this.say("There is nothing to draw here.");
        this.answer = answer;
        if (this.panel === undefined) return undefined;
        this.panel.title = `Diagram ${answer.component}`;
        const { svg, stale, version, component } = answer;
        this.picture = { type: "picture", svg, stale, version, component, uri: this.place.uri, id: this.current() };
        return this.send(this.picture);
    }

    say(note) {
        return this.send({ ...(this.picture ?? { type: "picture" }), stale: true, note });
    }

    /** Sends the state to the page, but only if it has changed. */
    send(message) {
        const text = JSON.stringify(message);
        if (text === this.sent) return;
        this.sent = text;
        this.post(message);
    }

    post(message) {
        void this.panel?.webview.postMessage(message);
    }

    /** The id of the element at the cursor. */
    current() {
        if (this.answer?.elements === undefined || this.answer.stale || this.place?.position === undefined) return undefined;
        const here = this.answer.elements.filter((each) => sameUri(each.uri, this.place.uri));
        return elementAt(here, this.place.position)?.id;
    }

    hear(message) {
        if (message?.type === "ready") {
            // The page was loaded, possibly again after it was hidden.
            if (this.sent !== undefined) this.post(JSON.parse(this.sent));
            return undefined;
        }
        if (message?.type === "reveal") return this.reveal(message.id);
        return undefined;
    }

    /** Selects the name of an element in the text. Accepts only elements that the server has listed. */
    async reveal(id) {
        const element = this.answer?.elements?.find((each) => each.id === id);
        if (element === undefined) return;
        const rangeOf = ({ start, end }) => new vscode.Range(start.line, start.character, end.line, end.character);
        const uri = vscode.Uri.parse(element.uri);
        const shown = vscode.window.visibleTextEditors.find((each) => each.document.uri.toString() === uri.toString());
        const document = await vscode.workspace.openTextDocument(uri);
        const editor = await vscode.window.showTextDocument(document, {
            viewColumn: shown?.viewColumn ?? this.place?.column ?? vscode.ViewColumn.One,
            selection: document.validateRange(rangeOf(element.selectionRange)),
        });
        editor.revealRange(
            document.validateRange(rangeOf(element.range)),
            vscode.TextEditorRevealType.InCenterIfOutsideViewport,
        );
    }
}

module.exports = { Preview, notification };
