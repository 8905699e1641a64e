// Diagnostics as JSON for programs, and the escaping of strings.
#include "diagnostics/json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "diagnostics/control.hpp"
#include "diagnostics/fixes.hpp"
#include "diagnostics/render.hpp"
#include "diagnostics/utf8.hpp"

namespace robochart::diagnostics {

std::size_t utf8_length(std::string_view text) {
    if (text.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80U) return 1;
    // Unicode 15, table 3-7: lengths and the narrowed range of the second byte.
    const std::size_t length = byte(0) >= 0xC2U && byte(0) <= 0xDFU   ? 2
                               : (byte(0) & 0xF0U) == 0xE0U           ? 3
                               : byte(0) >= 0xF0U && byte(0) <= 0xF4U ? 4
                                                                      : 0;
    if (length == 0 || text.size() < length) return 0;
    const unsigned low = byte(0) == 0xE0U ? 0xA0U : byte(0) == 0xF0U ? 0x90U : 0x80U;
    const unsigned high = byte(0) == 0xEDU ? 0x9FU : byte(0) == 0xF4U ? 0x8FU : 0xBFU;
    if (byte(1) < low || byte(1) > high) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if ((byte(i) & 0xC0U) != 0x80U) return 0;
    return length;
}

namespace {

std::string escaped(char c) {
    if (c == '"' || c == '\\') return {'\\', c};
    if (const auto letter = letter_of_control(c)) return {'\\', *letter};
    return is_control(c) ? fmt::format("\\u{:04x}", static_cast<unsigned>(c)) : std::string{c};
}

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

/// Adds the place of a span; nothing for a place that is not known.
void add_place(Json& json, const SourceManager& sources, Span span) {
    if (!span.known()) return;
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
    Json& notes = json["notes"] = Json::array();
    for (const Note& note : diagnostic.notes) notes.push_back(note_json(sources, note));
    Json& fixes = json["fixes"] = Json::array();
    for (const FixIt& fix : diagnostic.fixes) fixes.push_back(fix_json(sources, fix));
    return json;
}

}  // namespace

std::string json_string(std::string_view text) {
    std::string out = "\"";
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) out += replacement_character;
        if (length == 1) out += escaped(text.front());
        if (length > 1) out += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return out + "\"";
}

std::string json_text(const Json& value, int indent) {
    return value.dump(indent, ' ', false, Json::error_handler_t::replace);
}

double rounded(double value, int places) {
    const double unit = std::pow(10.0, places);
    return std::round(value * unit) / unit;
}

std::string render_json(const SourceManager& sources, const Diagnostics& diagnostics, std::string_view limit) {
    Json json{{"schema", "robochart-verify/diagnostics/1"},
              {"errors", diagnostics.errors()},
              {"warnings", diagnostics.warnings()},
              {"dropped", diagnostics.dropped()}};
    if (!limit.empty()) json["limit"] = limit;
    Json& list = json["diagnostics"] = Json::array();
    for (const Diagnostic& each : diagnostics.sorted()) list.push_back(diagnostic_json(sources, each));
    return json_text(json) + "\n";
}

}  // namespace robochart::diagnostics
