// SPDX-License-Identifier: Apache-2.0
// Reads the client's capabilities from `initialize`, and states the server's capabilities.
#include "editors/server/features/capabilities.hpp"

#include <algorithm>

#include "editors/server/features/models.hpp"
#include "editors/server/protocol/uri.hpp"

namespace robochart::lsp {

namespace {

bool lists_word(View items, std::string_view word) {
    return std::ranges::any_of(items.items(), [&](View item) { return item.text() == word; });
}

std::string_view name_of(Encoding encoding) {
    switch (encoding) {
        case Encoding::utf8:
            return "utf-8";
        case Encoding::utf32:
            return "utf-32";
        case Encoding::utf16:
            break;
    }
    return "utf-16";
}

}  // namespace

Json watch_request() {
    const Json watchers = Json::array({Json::object({{"globPattern", "**/*.{rct,assertions,csp,cspm,fdr3,sleec}"}})});
    const Json registration = Json::object({{"id", "files"},
                                            {"method", "workspace/didChangeWatchedFiles"},
                                            {"registerOptions", Json::object({{"watchers", watchers}})}});
    return Json::object({{"jsonrpc", "2.0"},
                         {"id", "register-files"},
                         {"method", "client/registerCapability"},
                         {"params", Json::object({{"registrations", Json::array({registration})}})}});
}

Client client_of(View params) {
    const View capabilities = params["capabilities"];
    const View document = capabilities["textDocument"];
    const View offered = capabilities["general"]["positionEncodings"];
    Client client;
    // Texts are stored in UTF-8, so this encoding is the cheapest.
    if (lists_word(offered, "utf-8"))
        client.encoding = Encoding::utf8;
    else if (!lists_word(offered, "utf-16") && lists_word(offered, "utf-32"))
        client.encoding = Encoding::utf32;
    client.hierarchical_symbols = document["documentSymbol"]["hierarchicalDocumentSymbolSupport"].truth_or();
    client.snippets = document["completion"]["completionItem"]["snippetSupport"].truth_or();
    client.markdown = lists_word(document["hover"]["contentFormat"], "markdown");
    client.pulls_diagnostics = document["diagnostic"].is_object();
    client.refreshes_diagnostics = capabilities["workspace"]["diagnostics"]["refreshSupport"].truth_or();
    client.watches_files = capabilities["workspace"]["didChangeWatchedFiles"]["dynamicRegistration"].truth_or();
    client.versioned_edits = capabilities["workspace"]["workspaceEdit"]["documentChanges"].truth_or();
    client.creates_files = client.versioned_edits &&
                           lists_word(capabilities["workspace"]["workspaceEdit"]["resourceOperations"], "create");
    for (const char* command : {check_command, draw_command, step_command})
        if (lists_word(params["initializationOptions"]["commands"], command)) client.commands.insert(command);
    return client;
}

std::vector<std::string> folders_of(View params) {
    std::vector<std::string> result;
    for (const View folder : params["workspaceFolders"].items())
        if (folder["uri"].is_text()) result.push_back(path_of_uri(folder["uri"].text()));
    if (!result.empty()) return result;
    if (params["rootUri"].is_text()) return {path_of_uri(params["rootUri"].text())};
    if (params["rootPath"].is_text()) return {params["rootPath"].text()};
    return {};
}

Json server_capabilities(const Client& client) {
    constexpr int incremental = 2;
    const Json folders = Json::object({{"supported", true}, {"changeNotifications", true}});
    const Json legend = semantic_legend();
    Json capabilities = Json::object({
        {"positionEncoding", name_of(client.encoding)},
        {"textDocumentSync", Json::object({{"openClose", true}, {"change", incremental}, {"save", false}})},
        {"completionProvider",
         Json::object({{"triggerCharacters", Json::array({":", ".", "#", "!", "?"})}, {"resolveProvider", false}})},
        {"hoverProvider", true},
        {"signatureHelpProvider", Json::object({{"triggerCharacters", Json::array({"(", ","})}})},
        {"declarationProvider", true},
        {"definitionProvider", true},
        {"referencesProvider", true},
        {"documentHighlightProvider", true},
        {"documentSymbolProvider", true},
        {"workspaceSymbolProvider", true},
        {"codeActionProvider", Json::object({{"codeActionKinds", Json::array({"quickfix"})}})},
        {"documentFormattingProvider", true},
        {"renameProvider", Json::object({{"prepareProvider", true}})},
        {"callHierarchyProvider", true},
        {"inlayHintProvider", true},
        {"foldingRangeProvider", true},
        {"selectionRangeProvider", true},
        {"semanticTokensProvider", Json::object({{"legend", legend}, {"full", true}})},
        {"workspace", Json::object({{"workspaceFolders", folders}})},
        {"experimental", Json::object({{"robochart", Json::object({{"diagram", true}, {"diagramChanged", true}})}})},
    });
    if (!client.commands.empty()) capabilities["codeLensProvider"] = Json::object({{"resolveProvider", false}});
    if (client.pulls_diagnostics)
        capabilities["diagnosticProvider"] =
            Json::object({{"interFileDependencies", true}, {"workspaceDiagnostics", false}});
    return Json::object({{"capabilities", std::move(capabilities)},
                         {"serverInfo", Json::object({{"name", "robochart-verify"}, {"version", "0.1.0"}})}});
}

}  // namespace robochart::lsp
