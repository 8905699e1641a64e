// SPDX-License-Identifier: Apache-2.0
// Writes JSON values as text, and diagnostics as JSON for programs.
#include "base/diagnostics/json.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/diagnostics/fixes.hpp"
#include "base/diagnostics/json_values.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::diagnostics {

namespace {

std::string_view severity_name(Severity severity) {
    switch (severity) {
        case Severity::note:
            return "note";
        case Severity::warning:
            return "warning";
        case Severity::error:
            return "error";
    }
    return "error";
}

/// Adds the place of a span, unless the place is unknown.
void add_place(Json& json, const SourceManager& sources, Span span) {
    if (!span.is_known()) return;
    const Position begin = sources.position(span.source, span.begin);
    const Position end = sources.position(span.source, span.end);
    json["file"] = sources.path(span.source);
    json["line"] = begin.line;
    json["column"] = begin.column;
    json["endLine"] = end.line;
    json["endColumn"] = end.column;
}

Json note_json(const SourceManager& sources, const Note& note) {
    Json json{{"message", note.message}};
    add_place(json, sources, note.span);
    return json;
}

Json fix_json(const SourceManager& sources, const FixIt& fix) {
    Json json{{"title", fix.title}, {"replacement", fix.replacement}, {"certain", is_certain(fix)}};
    add_place(json, sources, fix.span);
    return json;
}

Json diagnostic_json(const SourceManager& sources, const Diagnostic& diagnostic) {
    Json json{{"code", diagnostic.rule->code},
              {"severity", severity_name(diagnostic.rule->severity)},
              {"message", diagnostic.message()}};
    add_place(json, sources, diagnostic.span);
    json["notes"] = json_array(diagnostic.notes, [&](const Note& note) { return note_json(sources, note); });
    json["fixes"] = json_array(diagnostic.fixes, [&](const FixIt& fix) { return fix_json(sources, fix); });
    return json;
}

}  // namespace

std::string json_text(const Json& value, int indent) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json json_number(double value) {
    if (!std::isfinite(value)) return nullptr;
    return Json::parse(fmt::format("{:.6g}", value));
}

double round_to_places(double value, int places) {
    const double unit = std::pow(10.0, places);
    return std::round(value * unit) / unit;
}

std::string render_json(const SourceManager& sources, const Diagnostics& diagnostics, std::string_view limit) {
    Json json{{"schema", "robochart-verify/diagnostics/1"},
              {"errors", diagnostics.error_count()},
              {"warnings", diagnostics.warning_count()},
              {"dropped", diagnostics.dropped_count()}};
    if (!limit.empty()) json["limit"] = limit;
    json["diagnostics"] = json_array(diagnostics.sorted_findings(),
                                     [&](const Diagnostic& finding) { return diagnostic_json(sources, finding); });
    return json_text(json) + "\n";
}

}  // namespace robochart::diagnostics
