// SPDX-License-Identifier: Apache-2.0
// See format_gaps.hpp. Writes the text between two tokens: a gap, and the comments in it. A comment after a token stays
// on the token's line. A comment at the beginning of a line stays at the beginning of a line, with the indentation of
// the next token.
#include <algorithm>
#include <array>

#include "frontend/format/format_gaps.hpp"

namespace robochart::frontend {

namespace {

bool keeps_empty_lines(Gap gap) {
    return gap == Gap::open || gap == Gap::first || gap == Gap::member || gap == Gap::block || gap == Gap::start;
}

bool ends_line(Gap gap) {
    return gap == Gap::first || gap == Gap::member || gap == Gap::block || gap == Gap::start;
}

template <std::size_t n>
bool is_among(std::string_view word, const std::array<std::string_view, n>& words) {
    return std::ranges::find(words, word) != words.end();
}

std::string_view without_trailing_blanks(std::string_view line) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\t')) line.remove_suffix(1);
    return line;
}

/// Removes the first line from a text and returns it without its line end.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = std::min(text.size(), text.find_first_of("\r\n"));
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(end);
    if (!text.empty()) text.remove_prefix(text.substr(0, 2) == "\r\n" ? 2 : 1);
    return without_trailing_blanks(line);
}

}  // namespace

Doc WordLayout::format_separator(Gap gap, std::size_t lines) {
    switch (gap) {
        case Gap::blank:
            return doc_.blank();
        case Gap::soft:
            return may_touch() ? doc_.soft() : doc_.line();
        case Gap::line:
        case Gap::open:
            return doc_.line();
        case Gap::first:
            return doc_.hard();
        case Gap::member:
            return lines > 1 ? doc_.empty_line() : doc_.hard();
        case Gap::block:
            return doc_.empty_line();
        case Gap::none:
            return may_touch() ? 0 : doc_.blank();
        case Gap::done:
        case Gap::start:
            break;
    }
    return 0;
}

Doc WordLayout::format_gap(Gap gap) {
    if (gap == Gap::done) return 0;
    if (!has_comment()) return format_separator(gap, lines_before());
    const std::vector<Piece> found = take_comments();
    const bool joins = gap == Gap::none || gap == Gap::soft || gap == Gap::blank;
    const auto on_line = [&](const Piece& p) { return !p.to_line_end && (p.lines == 0 || (p.is_token && joins)); };
    const bool one_line = gap != Gap::start && std::ranges::all_of(found, on_line);
    if (one_line) return inline_comments(gap, found);
    const auto stays = [&](const Piece& p) { return p.lines == 0 && !p.is_token && gap != Gap::start; };
    const auto moved = std::ranges::find_if_not(found, stays);
    const auto count = static_cast<std::size_t>(moved - found.begin());
    return doc_.cat(format_trailing(found, count), own_lines(gap, found, count));
}

/// Formats `a /* c */ b`. A comment within a line belongs to the token after it.
Doc WordLayout::inline_comments(Gap gap, const std::vector<Piece>& pieces) {
    constexpr std::array<std::string_view, 7> openers = {"(", "[", "{", "(|", "[|", "Set(", "Seq("};
    constexpr std::array<std::string_view, 9> closers = {")", "]", "}", "|)", "|]", ",", ";", ".", "::"};
    const bool opened = last_token() && is_among(last_token()->text, openers);
    Doc result = gap == Gap::soft && opened ? doc_.soft() : format_separator(gap, 0);
    if (gap == Gap::none && !opened) result = doc_.blank();
    if (gap == Gap::none && opened) result = 0;
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        result = cat({result, i > 0 ? doc_.blank() : 0, format_comment(pieces[i])});
    return is_among(peek().text, closers) ? result : doc_.cat(result, doc_.blank());
}

/// Formats comments that stay on the line of the token before them.
Doc WordLayout::format_trailing(const std::vector<Piece>& pieces, std::size_t count) {
    Doc result = 0;
    for (std::size_t i = 0; i < count; ++i) result = cat({result, doc_.blank(), format_comment(pieces[i])});
    return result;
}

/// Formats the comments from the first one that begins a line up to the next token.
Doc WordLayout::own_lines(Gap gap, const std::vector<Piece>& pieces, std::size_t trailing) {
    const Piece& head = pieces[trailing];
    const bool forced = !head.is_token || (trailing > 0 && pieces[trailing - 1].to_line_end);
    const bool any_empty_line = std::any_of(pieces.begin() + static_cast<std::ptrdiff_t>(trailing), pieces.end(),
                                            [](const Piece& p) { return p.lines > 1; });
    Doc result = format_separator(gap == Gap::block && any_empty_line ? Gap::member : gap, head.lines);
    if (gap == Gap::start)
        result = 0;
    else if (forced && !ends_line(gap))
        result = doc_.hard();
    for (std::size_t i = trailing; !pieces[i].is_token; ++i)
        result = cat({result, format_comment(pieces[i]), gap_after_comment(gap, pieces[i], pieces[i + 1])});
    return result;
}

/// Returns the gap between a comment that begins a line and the next piece.
Doc WordLayout::gap_after_comment(Gap gap, const Piece& before, const Piece& piece) {
    if (!before.to_line_end && piece.lines == 0) return doc_.blank();
    return keeps_empty_lines(gap) && piece.lines > 1 ? doc_.empty_line() : doc_.hard();
}

Doc WordLayout::closing_comments() {
    std::vector<Piece> found = take_comments();
    found.pop_back();
    Doc result = 0;
    const bool opened = !last_token() || last_token()->is_word("{");
    for (std::size_t i = 0; i < found.size(); ++i) {
        const bool behind = found[i].lines == 0 && (i == 0 || !found[i - 1].to_line_end);
        const bool empty_line = found[i].lines > 1 && !(i == 0 && opened);
        Doc before = 0;
        if (behind)
            before = doc_.blank();
        else
            before = empty_line ? doc_.empty_line() : doc_.hard();
        result = cat({result, i == 0 && !last_token() ? 0 : before, format_comment(found[i])});
        read_to(found[i].span.end);
    }
    return result;
}

// ---------------------------------------------------------------- the text of a comment

/// Formats a line of a block comment after its first line. If `moved` is true, the line is indented with the first
/// line. Otherwise it is unchanged.
Doc WordLayout::comment_line(std::string_view line, std::size_t margin, bool moved) {
    if (!moved) return doc_.cat(doc_.raw(), doc_.comment_text(line));
    line.remove_prefix(std::min(line.size(), margin));
    return doc_.cat(doc_.hard(), doc_.comment_text(line));
}

/// Formats a comment. The other lines of a block comment move with its first line if they were indented at least as
/// far.
Doc WordLayout::format_comment(const Piece& piece) {
    std::string_view rest = source_text(piece.span);
    const std::string_view first = take_line(rest);
    if (piece.to_line_end) return doc_.line_comment(first);
    const auto indentation = margin_before(piece.span.begin);
    bool moved = indentation.has_value();
    for (std::string_view lines = rest; moved && !lines.empty();) {
        const std::string_view line = take_line(lines);
        moved = line.empty() || line.starts_with(*indentation);
    }
    Doc result = doc_.comment_text(first);
    while (!rest.empty()) {
        const std::string_view line = take_line(rest);
        result = doc_.cat(result, comment_line(line, indentation ? indentation->size() : 0, moved));
    }
    return result;
}

// ---------------------------------------------------------------- words

Doc WordLayout::format_token(Gap gap) {
    const Doc before = this->format_gap(gap);
    return doc_.cat(before, advance());
}

Doc WordLayout::format_words(Gap gap, std::size_t count) {
    Doc result = format_token(gap);
    while (--count > 0) result = doc_.cat(result, format_token(Gap::blank));
    return result;
}

Doc WordLayout::format_names(Gap gap) {
    Doc result = format_token(gap);
    while (at("::") && !peek(1).is_word("*")) result = cat({result, format_token(Gap::none), format_token(Gap::none)});
    return result;
}

Doc WordLayout::format_phrase(Gap gap) {
    const Doc word = format_token(gap);
    return doc_.cat(word, format_names(Gap::blank));
}

Doc WordLayout::format_import(Gap gap) {
    const Doc result = format_phrase(gap);
    return at("::") ? cat({result, format_token(Gap::none), format_token(Gap::none)}) : result;
}

std::string WordLayout::run(std::string_view line_end) {
    Printer printer(doc_, line_end);
    Gap gap = Gap::start;
    while (!at_end()) {
        printer.print(format_member(gap));
        doc_.clear();
        gap = Gap::member;
    }
    printer.print(cat({closing_comments(), is_untouched() ? 0 : doc_.hard()}));
    return printer.take_text();
}

}  // namespace robochart::frontend
