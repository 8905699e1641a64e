// SPDX-License-Identifier: Apache-2.0
// Prepares an excerpt. Only the bytes around the mark are processed, so that a line of many megabytes is not slow.
#include "base/diagnostics/excerpt.hpp"

#include <algorithm>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/utf8.hpp"

namespace robochart::diagnostics {

namespace {

constexpr std::size_t tab_width = 4;
constexpr std::string_view ellipsis = "...";

/// A cell of the excerpt: its text, and the offset in the line of the byte that it represents.
struct Cell {
    std::string_view text;
    std::size_t offset;
};

void add_cells(std::vector<Cell>& cells, std::string_view rest, std::size_t offset, std::size_t length) {
    const char c = rest.front();
    if (c == '\t') {
        do cells.push_back({" ", offset});
        while (cells.size() % tab_width != 0);
    } else if (length == 0) {
        cells.push_back({replacement_character, offset});
    } else if (static_cast<unsigned char>(c) < 0x20U || c == 0x7F) {
        cells.push_back({" ", offset});
    } else if (const std::string_view character = rest.substr(0, length); escape_for_display(character) != character) {
        cells.push_back({replacement_character, offset});  // it is invisible or changes the direction of writing
    } else {
        cells.push_back({character, offset});
    }
}

std::vector<Cell> split_cells(std::string_view line, std::size_t first, std::size_t last) {
    std::vector<Cell> cells;
    for (std::size_t i = first; i < last;) {
        const std::string_view rest = line.substr(i);
        const std::size_t length = utf8_length(rest);
        add_cells(cells, rest, i, length);
        i += std::max<std::size_t>(length, 1);
    }
    return cells;
}

/// Returns the nearest beginning of a character at or before `offset`.
std::size_t align_to_character(std::string_view line, std::size_t offset) {
    for (std::size_t back = 0; back < 3 && offset > 0 && offset < line.size() && is_continuation(line[offset]); ++back)
        --offset;
    return offset;
}

std::size_t cell_at(const std::vector<Cell>& cells, std::size_t offset) {
    const auto it = std::ranges::find_if(cells, [&](const Cell& c) { return c.offset >= offset; });
    return static_cast<std::size_t>(it - cells.begin());
}

}  // namespace

Excerpt make_excerpt(std::string_view line, std::size_t begin, std::size_t end, std::size_t max_width) {
    begin = std::min(begin, line.size());
    end = std::clamp(end, begin, line.size());
    max_width = std::max<std::size_t>(max_width, 20);
    // A cell represents at most four bytes, so this window is large enough for the width.
    const std::size_t reach = 4 * max_width;
    const std::size_t first = align_to_character(line, begin > reach ? begin - reach : 0);
    const std::size_t last = align_to_character(line, std::min(line.size(), begin + reach));
    std::vector<Cell> cells = split_cells(line, first, last);

    const std::size_t mark = cell_at(cells, begin);
    const std::size_t mark_end = std::max(cell_at(cells, end), mark + 1);
    const bool too_wide = cells.size() > max_width || first > 0 || last < line.size();
    const std::size_t context = max_width / 3;
    const std::size_t from = too_wide && mark > context ? mark - context : 0;
    const std::size_t to = std::min(cells.size(), from + max_width);

    Excerpt excerpt;
    const bool cut_left = from > 0 || first > 0;
    if (cut_left) excerpt.text += ellipsis;
    excerpt.mark_begin = excerpt.text.size() + mark - from;
    for (std::size_t i = from; i < to; ++i) excerpt.text += cells[i].text;
    if (to < cells.size() || last < line.size()) excerpt.text += ellipsis;
    excerpt.mark_width = std::max<std::size_t>(1, std::min(mark_end, std::max(to, mark + 1)) - mark);
    while (!excerpt.text.empty() && excerpt.text.back() == ' ') excerpt.text.pop_back();
    return excerpt;
}

}  // namespace robochart::diagnostics
