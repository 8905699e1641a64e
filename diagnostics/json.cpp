// Diagnostics as JSON for programs, and the escaping of strings.
#include "diagnostics/json.hpp"

#include <fmt/format.h>

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

/// `"file":…,"line":…` of a span; nothing for a place that is not known.
std::string place_members(const SourceManager& sources, Span span) {
    if (!span.known()) return {};
    const Position begin = sources.position(span.source, span.begin);
    const Position end = sources.position(span.source, span.end);
    return fmt::format(R"(,"file":{},"line":{},"column":{},"endLine":{},"endColumn":{})",
                       json_string(sources.path(span.source)), begin.line, begin.column, end.line, end.column);
}

template <class Items, class Write>
std::string json_array(const Items& items, Write write) {
    std::string out = "[";
    for (const auto& item : items) {
        if (out.size() > 1) out += ",";
        out += write(item);
    }
    return out + "]";
}

std::string json_diagnostic(const SourceManager& sources, const Diagnostic& diagnostic) {
    const auto note = [&](const Note& n) {
        return fmt::format(R"({{"message":{}{}}})", json_string(n.message), place_members(sources, n.span));
    };
    const auto fix = [&](const FixIt& f) {
        return fmt::format(R"({{"title":{},"replacement":{},"certain":{}{}}})", json_string(f.title),
                           json_string(f.replacement), is_certain(f), place_members(sources, f.span));
    };
    return fmt::format(R"({{"code":{},"severity":"{}","message":{}{},"notes":{},"fixes":{}}})",
                       json_string(diagnostic.rule->code), severity_name(diagnostic.rule->severity),
                       json_string(diagnostic.message()), place_members(sources, diagnostic.span),
                       json_array(diagnostic.notes, note), json_array(diagnostic.fixes, fix));
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

std::string render_json(const SourceManager& sources, const Diagnostics& diagnostics, std::string_view limit) {
    const auto items =
        json_array(diagnostics.sorted(), [&](const Diagnostic& d) { return json_diagnostic(sources, d); });
    return fmt::format(
        R"({{"schema":"robochart-verify/diagnostics/1","errors":{},"warnings":{},"dropped":{},{}"diagnostics":{}}})"
        "\n",
        diagnostics.errors(), diagnostics.warnings(), diagnostics.dropped(),
        limit.empty() ? "" : fmt::format(R"("limit":{},)", json_string(limit)), items);
}

}  // namespace robochart::diagnostics
