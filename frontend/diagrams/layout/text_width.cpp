// SPDX-License-Identifier: Apache-2.0
// See text_width.hpp.
#include "frontend/diagrams/layout/text_width.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "base/diagnostics/utf8.hpp"
#include "frontend/diagrams/layout/font_tables.hpp"

namespace robochart::diagrams::layout {
namespace {

constexpr std::string_view ellipsis = "\xE2\x80\xA6";

/// The first character of a nonempty text, and its length in bytes.
struct Character {
    std::uint32_t code = 0;
    std::size_t bytes = 1;
};
Character first_character(std::string_view text) {
    const std::size_t length = diagnostics::utf8_length(text);
    const auto lead = static_cast<unsigned char>(text[0]);
    if (length <= 1) return {length == 1 ? lead : 0U, 1};
    std::uint32_t code = lead & (0xFFU >> (length + 1));
    for (std::size_t i = 1; i < length; ++i) code = (code << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
    return {code, length};
}

double width_of(std::uint32_t code, bool bold) {
    for (const WidthRange& range : width_ranges())
        if (code >= range.first && code <= range.last)
            return (bold ? range.bold : range.regular)[code - range.first] / units_of_em;
    return 1;
}

std::size_t columns_of(std::string_view text) {
    std::size_t count = 0;
    for (; !text.empty(); text.remove_prefix(first_character(text).bytes)) ++count;
    return count;
}

/// Returns the number of bytes of the first `columns` characters.
std::size_t bytes_of(std::string_view text, std::size_t columns) {
    std::size_t bytes = 0;
    for (; columns > 0 && bytes < text.size(); --columns) bytes += first_character(text.substr(bytes)).bytes;
    return bytes;
}

/// Returns the position at which to break a line that must end within `columns` characters. This is after the last
/// blank or, if there is none, after a punctuation sign in the second half. Without such a sign, the line is broken
/// after `columns` characters.
std::size_t line_end(std::string_view text, std::size_t columns) {
    const std::size_t most = bytes_of(text, columns);
    if (most >= text.size()) return text.size();
    const std::size_t blank = text.substr(0, most + 1).rfind(' ');
    if (blank != std::string_view::npos && blank > 0) return blank;
    const std::size_t sign = text.substr(0, most).find_last_of("!?.,;:_=()[]/|");
    return sign != std::string_view::npos && sign + 1 > most / 2 ? sign + 1 : most;
}

void without_blanks(std::string_view& text) {
    const std::size_t begin = text.find_first_not_of(' ');
    text.remove_prefix(begin == std::string_view::npos ? text.size() : begin);
}

void break_piece(std::string_view piece, std::size_t columns, std::vector<std::string>& lines) {
    for (without_blanks(piece); !piece.empty(); without_blanks(piece)) {
        const std::size_t end = line_end(piece, columns);
        lines.emplace_back(piece.substr(0, end));
        piece.remove_prefix(end);
    }
}

}  // namespace

double text_width(std::string_view text, double font_size, bool bold) {
    double ems = 0;
    while (!text.empty()) {
        const Character character = first_character(text);
        ems += width_of(character.code, bold);
        text.remove_prefix(character.bytes);
    }
    return ems * font_size * font_slack;
}

std::string elide_text(std::string_view text, std::size_t columns) {
    const std::size_t bytes = bytes_of(text, columns);
    if (bytes >= text.size()) return std::string(text);
    return std::string(text.substr(0, bytes_of(text, columns - 1))) + std::string(ellipsis);
}

Lines break_lines(const std::vector<std::string>& pieces, const LineLimits& limits) {
    Lines result;
    std::string line;
    const auto finish = [&] { break_piece(std::exchange(line, ""), limits.columns, result.lines); };
    for (const std::string& piece : pieces) {
        if (!line.empty() && columns_of(line) + columns_of(piece) > limits.columns) finish();
        line += piece;
    }
    finish();
    result.elided = result.lines.size() > limits.lines;
    if (result.elided) {
        result.lines.resize(limits.lines);
        std::string& last = result.lines.back();
        last.resize(bytes_of(last, limits.columns - 2));
        while (last.ends_with(' ')) last.pop_back();
        last += " " + std::string(ellipsis);
    }
    return result;
}

}  // namespace robochart::diagrams::layout
