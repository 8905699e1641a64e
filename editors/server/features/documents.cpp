// SPDX-License-Identifier: Apache-2.0
// Applies the client's notifications to the workspace.
#include "editors/server/features/documents.hpp"

#include "editors/server/protocol/uri.hpp"

namespace robochart::lsp {

/// Registers for changes of files that are not open.
void did_initialize(Session& session, View) {
    if (!session.client.watches_files) return;
    const Json watchers = Json::array({Json::object({{"globPattern", "**/*.{rct,assertions,csp,cspm,fdr3,sleec}"}})});
    const Json registration = Json::object({{"id", "files"},
                                            {"method", "workspace/didChangeWatchedFiles"},
                                            {"registerOptions", Json::object({{"watchers", watchers}})}});
    session.send(Json::object({{"jsonrpc", "2.0"},
                               {"id", "register-files"},
                               {"method", "client/registerCapability"},
                               {"params", Json::object({{"registrations", Json::array({registration})}})}}));
}

void did_open(Session& session, View params) {
    const View document = params["textDocument"];
    if (!document["uri"].is_text()) return;
    const auto place = session.workspace.open_document(document["uri"].text(), document["text"].text());
    if (document["version"].is_number()) place.document->version = document["version"].number_or();
}

void did_change(Session& session, View params) {
    const Target target = target_of(session, params);
    const SourceManager& sources = target.project.sources();
    for (const View change : params["contentChanges"].items()) {
        if (!change["text"].is_text()) continue;
        std::string text = change["text"].text();
        if (change.has_key("range")) {
            const Span span = span_of(sources, target.document.source, change["range"], session.client.encoding);
            text = std::string(sources.source_text(target.document.source))
                       .replace(span.begin, span.end - span.begin, text);
        }
        target.project.change(target.document, std::move(text));
    }
    const View version = params["textDocument"]["version"];
    if (version.is_number()) target.document.version = version.number_or();
}

void did_close(Session& session, View params) {
    session.workspace.close(params["textDocument"]["uri"].text());
}

/// The server already has the open text, so saving has no effect.
void did_save(Session&, View) {}

void did_change_watched_files(Session& session, View params) {
    for (const View change : params["changes"].items()) session.workspace.refresh_file(change["uri"].text());
}

void did_change_folders(Session& session, View params) {
    for (const View folder : params["event"]["removed"].items())
        session.workspace.remove_folder(path_of_uri(folder["uri"].text()));
    for (const View folder : params["event"]["added"].items())
        session.workspace.add_folder(path_of_uri(folder["uri"].text()));
}

}  // namespace robochart::lsp
