// SPDX-License-Identifier: Apache-2.0
// Offers the fixes of rules as quick fixes.
#include <fmt/format.h>

#include <limits>

#include "base/diagnostics/fixes.hpp"
#include "editors/server/features/models.hpp"
#include "editors/server/protocol/uri.hpp"
#include "frontend/project/move_claims.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::lsp {

namespace {

using diagnostics::Diagnostic;
using diagnostics::FixIt;

bool spans_overlap(Span a, Span b) {
    return a.source == b.source && a.begin <= b.end && b.begin <= a.end;
}

std::string title_of(const FixIt& fix, std::string_view replaced) {
    if (replaced.empty()) return fmt::format("Insert `{}`", fix.replacement);
    if (fix.replacement.empty()) return fmt::format("Remove `{}`", replaced);
    return fmt::format("Change `{}` to `{}`", replaced, fix.replacement);
}

/// Returns the editor's diagnostic to which the fix belongs, so that the editor can show both together.
Json matching_diagnostic(View context, const Diagnostic& finding, const Json& place) {
    for (const View shown : context["diagnostics"].items())
        if (shown["code"].text() == finding.rule->code && shown["range"].json() == place)
            return Json::array({shown.json()});
    return {};
}

Json code_action(const Session& session, const Target& target, const Diagnostic& finding, const FixIt& fix,
                 View context) {
    const SourceManager& sources = target.project.sources();
    const Encoding encoding = session.client.encoding;
    const std::string_view replaced =
        sources.source_text(fix.span.source).substr(fix.span.begin, fix.span.end - fix.span.begin);
    const Json edit = Json::object({{"range", lsp_range(sources, fix.span, encoding)}, {"newText", fix.replacement}});
    const Document* edited = target.project.find(fix.span.source);
    Json changes;
    changes[edited != nullptr ? edited->uri : target.document.uri] = Json::array({edit});
    Json result = Json::object({{"title", title_of(fix, replaced)},
                                {"kind", "quickfix"},
                                {"isPreferred", &fix == &finding.fixes.front() && diagnostics::is_certain(fix)},
                                {"edit", Json::object({{"changes", std::move(changes)}})}});
    Json shown = matching_diagnostic(context, finding, lsp_range(sources, finding.span, encoding));
    if (!shown.is_null()) result["diagnostics"] = std::move(shown);
    return result;
}

/// Moves all claims of an assertion file to the end of the claims file in the same folder.
Json move_of_claims(const Session& session, const Target& target, const Diagnostic& finding, View context) {
    const auto moved = frontend::move_claims(target.project.tree_of(target.document), target.project.sources());
    if (!moved) return {};
    const SourceManager& sources = target.project.sources();
    const Encoding encoding = session.client.encoding;
    const auto versioned = [](const std::string& uri, Json version, Json edits) {
        return Json::object({{"textDocument", Json::object({{"uri", uri}, {"version", std::move(version)}})},
                             {"edits", std::move(edits)}});
    };
    // A position after the last line is the end of the text.
    const Json end = Json::object({{"line", std::numeric_limits<std::int32_t>::max()}, {"character", 0}});
    const Json added =
        Json::object({{"range", Json::object({{"start", end}, {"end", end}})}, {"newText", moved->text}});
    Json removals = Json::array();
    for (const Span span : moved->removals)
        removals.push_back(Json::object({{"range", lsp_range(sources, span, encoding)}, {"newText", ""}}));
    const std::string uri = uri_of_path(moved->path);
    const Json create =
        Json::object({{"kind", "create"}, {"uri", uri}, {"options", Json::object({{"ignoreIfExists", true}})}});
    const Json version = target.document.version ? Json(*target.document.version) : Json();
    const Json changes = Json::array({create, versioned(uri, Json(), Json::array({added})),
                                      versioned(target.document.uri, version, std::move(removals))});
    Json result =
        Json::object({{"title", fmt::format("Move the claims to {}", moved->path.substr(moved->path.rfind('/') + 1))},
                      {"kind", "quickfix"},
                      {"isPreferred", true},
                      {"edit", Json::object({{"documentChanges", changes}})}});
    Json shown = matching_diagnostic(context, finding, lsp_range(sources, finding.span, encoding));
    if (!shown.is_null()) result["diagnostics"] = std::move(shown);
    return result;
}

}  // namespace

Json Models::code_actions(const Request& request) {
    const Target target = target_of(request);
    const Span requested =
        span_of(target.project.sources(), target.document.source, request.params["range"], session_.client.encoding);
    const View only = request.params["context"]["only"];
    Json list = Json::array();
    for (const View kind : only.items())
        if (kind.text() != "quickfix" && !kind.text().empty() && only.items().size() == 1) return list;
    for (const Diagnostic& finding : findings_about(target)) {
        if (!spans_overlap(finding.span, requested)) continue;
        if (finding.rule == &frontend::syntax::claim_in_assertions && session_.client.creates_files)
            list.push_back(move_of_claims(session_, target, finding, request.params["context"]));
        for (const FixIt& fix : finding.fixes)
            if (fix.span.is_known())
                list.push_back(code_action(session_, target, finding, fix, request.params["context"]));
    }
    return list;
}

}  // namespace robochart::lsp
