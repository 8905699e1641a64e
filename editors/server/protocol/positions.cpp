// SPDX-License-Identifier: Apache-2.0
// See positions.hpp. A byte that is not UTF-8 is one unit, because editors show one replacement character for it.
#include "editors/server/protocol/positions.hpp"

#include <algorithm>
#include <iterator>

#include "base/diagnostics/utf8.hpp"

namespace robochart::lsp {

namespace {

/// Returns the number of code units of a well-formed sequence of this length, or of an invalid byte.
std::size_t code_units(std::size_t bytes, Encoding encoding) {
    if (encoding == Encoding::utf8) return bytes;
    return encoding == Encoding::utf16 && bytes == 4 ? 2 : 1;
}

std::size_t character_length(std::string_view text) {
    return std::max<std::size_t>(1, diagnostics::utf8_length(text));
}

/// Returns the number of code units of the characters that end at or before `end`.
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

/// Returns the number of bytes before a column. A column inside a character means the beginning of this character.
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

PositionTable::PositionTable(const SourceManager& sources, SourceId source, Encoding encoding)
    : sources_(sources), source_(source), encoding_(encoding), text_(sources.source_text(source)) {
    constexpr std::uint32_t spacing = 1024;
    for (std::uint32_t number = 1;; ++number) {
        const std::string_view line = sources.line_text(source, number);
        if (line.data() == nullptr) break;  // the line number is after the last line
        const auto begin = static_cast<std::uint32_t>(line.data() - text_.data());
        lines_.push_back({begin, begin + static_cast<std::uint32_t>(line.size())});
    }
    Mark here;
    marks_.push_back(here);
    while (here.offset < text_.size()) {
        const std::size_t bytes = character_length(text_.substr(here.offset));
        here.offset += static_cast<std::uint32_t>(bytes);
        here.units += static_cast<std::uint32_t>(code_units(bytes, encoding));
        if (here.offset - marks_.back().offset >= spacing) marks_.push_back(here);
    }
}

/// Returns the number of code units of the characters in the text that end at or before an offset.
std::uint32_t PositionTable::units_before(std::uint32_t offset) const {
    const auto after = std::ranges::upper_bound(marks_, offset, {}, &Mark::offset);
    const Mark& mark = *std::prev(after);
    bytes_read_ += offset - mark.offset;
    const std::string_view rest = text_.substr(mark.offset);
    return mark.units + static_cast<std::uint32_t>(count(rest, offset - mark.offset, encoding_));
}

std::uint32_t PositionTable::line(std::uint32_t offset) const {
    const auto after = std::ranges::upper_bound(lines_, offset, {}, &Line::begin);
    return static_cast<std::uint32_t>(after - lines_.begin()) - 1;
}

Json PositionTable::lsp_position(std::uint32_t offset) const {
    const std::uint32_t number = line(offset);
    const Line& whole = lines_[number];
    const std::uint32_t column = units_before(std::min(offset, whole.end)) - units_before(whole.begin);
    return Json::object({{"line", number}, {"character", column}});
}

Json PositionTable::lsp_range(Span span) const {
    if (span.source != source_) return lsp::lsp_range(sources_, span, encoding_);
    return Json::object({{"start", lsp_position(span.begin)}, {"end", lsp_position(span.end)}});
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
