// SPDX-License-Identifier: Apache-2.0
// See positions.hpp. A byte that is not UTF-8 counts as one unit, because editors show one replacement character for
// it.
#include "editors/server/protocol/positions.hpp"

#include <algorithm>

#include "base/diagnostics/utf8.hpp"

namespace robochart::lsp {

namespace {

/// The number of code units of a well-formed sequence, or of an invalid byte, of this length.
std::size_t code_units(std::size_t bytes, Encoding encoding) {
    if (encoding == Encoding::utf8) return bytes;
    return encoding == Encoding::utf16 && bytes == 4 ? 2 : 1;
}

std::size_t character_length(std::string_view text) {
    return std::max<std::size_t>(1, diagnostics::utf8_length(text));
}

/// The number of code units of the characters that end at or before `end`.
std::size_t count(std::string_view line, std::size_t end, Encoding encoding) {
    std::size_t total = 0;
    for (std::size_t at = 0; at < line.size();) {
        const std::size_t bytes = character_length(line.substr(at));
        at += bytes;
        if (at > end) break;
        total += code_units(bytes, encoding);
    }
    return total;
}

/// The number of bytes before a column; a column inside a character is its beginning.
std::size_t bytes_before(std::string_view line, std::int64_t column, Encoding encoding) {
    std::size_t at = 0;
    std::int64_t counted = 0;
    while (at < line.size()) {
        const std::size_t bytes = character_length(line.substr(at));
        counted += static_cast<std::int64_t>(code_units(bytes, encoding));
        if (counted > column) break;
        at += bytes;
    }
    return at;
}

}  // namespace

Json lsp_position(const SourceManager& sources, SourceId id, std::uint32_t offset, Encoding encoding) {
    const std::uint32_t line = sources.position(id, offset).line;
    const std::string_view content = sources.line_text(id, line);
    const auto begin = static_cast<std::size_t>(content.data() - sources.source_text(id).data());
    const std::size_t column = count(content, std::max<std::size_t>(offset, begin) - begin, encoding);
    return Json::object({{"line", line - 1}, {"character", column}});
}

Json lsp_range(const SourceManager& sources, Span span, Encoding encoding) {
    return Json::object({{"start", lsp_position(sources, span.source, span.begin, encoding)},
                         {"end", lsp_position(sources, span.source, span.end, encoding)}});
}

std::uint32_t offset_of(const SourceManager& sources, SourceId id, View position, Encoding encoding) {
    const std::string_view text = sources.source_text(id);
    const std::int64_t line = position["line"].number_or();
    if (line < 0) return 0;
    if (line >= sources.position(id, static_cast<std::uint32_t>(text.size())).line)
        return static_cast<std::uint32_t>(text.size());
    const std::string_view content = sources.line_text(id, static_cast<std::uint32_t>(line) + 1);
    const auto begin = static_cast<std::size_t>(content.data() - text.data());
    return static_cast<std::uint32_t>(begin + bytes_before(content, position["character"].number_or(), encoding));
}

Span span_of(const SourceManager& sources, SourceId id, View range, Encoding encoding) {
    const std::uint32_t a = offset_of(sources, id, range["start"], encoding);
    const std::uint32_t b = offset_of(sources, id, range["end"], encoding);
    return {id, std::min(a, b), std::max(a, b)};
}

}  // namespace robochart::lsp
