// SPDX-License-Identifier: Apache-2.0
#include "editors/server/protocol/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "base/diagnostics/fixes.hpp"
#include "base/rule_pages/rule_pages.hpp"

namespace robochart::lsp {

namespace {

using diagnostics::Diagnostic;
using diagnostics::Severity;

int severity_number(Severity severity) {
    switch (severity) {
        case Severity::error:
            return 1;
        case Severity::warning:
            return 2;
        case Severity::note:
            break;
    }
    return 3;
}

/// Returns the message of a finding. LSP requires a place for every related message, so notes without a place become
/// part of the message.
std::string message_of(const Diagnostic& finding) {
    std::string text = finding.message();
    for (const diagnostics::Note& note : finding.notes)
        if (!note.span.is_known()) text += "\n" + note.message;
    for (const diagnostics::FixIt& fix : finding.fixes)
        if (!fix.replacement.empty())
            text += "\n" + fix.title + " `" + fix.replacement + (diagnostics::is_certain(fix) ? "`" : "`?");
    return text;
}

constexpr int unnecessary_tag = 1;  // DiagnosticTag.Unnecessary

/// True for warnings about code that could be removed: never reached, taken, used or read, or a duplicate (rules
/// RC-W…).
bool is_unneeded(std::string_view code) {
    constexpr std::array<std::string_view, 5> codes = {"RC-W03", "RC-W04", "RC-W07", "RC-W08", "RC-W14"};
    return std::ranges::find(codes, code) != codes.end();
}

Json related_locations(const Diagnostic& finding, const Locate& locate) {
    Json list = Json::array();
    for (const diagnostics::Note& note : finding.notes) {
        Json place = locate(note.span);
        if (!place.is_null()) list.push_back(Json::object({{"location", std::move(place)}, {"message", note.message}}));
    }
    return list;
}

}  // namespace

Json lsp_diagnostic(const SourceManager& sources, const Diagnostic& finding, Encoding encoding, const Locate& locate) {
    Json result = Json::object({{"range", lsp_range(sources, finding.span, encoding)},
                                {"severity", severity_number(finding.rule->severity)},
                                {"code", finding.rule->code},
                                {"source", "robochart"},
                                {"message", message_of(finding)}});
    Json notes = related_locations(finding, locate);
    if (!notes.empty()) result["relatedInformation"] = std::move(notes);
    if (is_unneeded(finding.rule->code)) result["tags"] = Json::array({unnecessary_tag});
    return result;
}

std::string text_of_findings(const Json& list) {
    return list.empty() ? std::string() : json_text(list);
}

Json publication_message(const std::string& uri, std::optional<std::int64_t> version, Json list) {
    Json params = Json::object({{"uri", uri}, {"diagnostics", std::move(list)}});
    if (version) params["version"] = *version;
    return Json::object(
        {{"jsonrpc", "2.0"}, {"method", "textDocument/publishDiagnostics"}, {"params", std::move(params)}});
}

Json refresh_request(std::int64_t number) {
    return Json::object({{"jsonrpc", "2.0"},
                         {"id", "refresh-diagnostics-" + std::to_string(number)},
                         {"method", "workspace/diagnostic/refresh"}});
}

std::string explain_findings(const std::vector<Diagnostic>& findings, std::uint32_t offset, bool markdown) {
    std::string out;
    std::set<std::string_view> shown;
    for (const Diagnostic& finding : findings) {
        const bool here = finding.span.begin <= offset && offset <= finding.span.end;
        if (!here || !shown.insert(finding.rule->code).second) continue;
        const auto* pattern = markdown ? "{}**{}** {}" : "{}{}: {}";
        out += fmt::format(fmt::runtime(pattern), out.empty() ? "" : "\n\n", finding.rule->code,
                           diagnostics::reason_for(*finding.rule));
    }
    return out;
}

}  // namespace robochart::lsp
