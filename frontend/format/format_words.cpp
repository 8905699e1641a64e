// SPDX-License-Identifier: Apache-2.0
// See format_words.hpp.
#include "frontend/format/format_words.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "base/diagnostics/scanner.hpp"

namespace robochart::frontend {

namespace {

bool is_line_break(char c) {
    return c == '\n' || c == '\r';
}

}  // namespace

TokenReader::TokenReader(std::string_view text, const TokenStream& stream) : text_(text), stream_(stream) {}

Token TokenReader::peek(std::size_t ahead) const {
    return stream_.tokens[std::min(at_ + ahead, stream_.tokens.size() - 1)];
}

bool TokenReader::at_word(std::string_view word, std::size_t ahead) const {
    const Token& token = peek(ahead);
    const bool word_like = token.kind == TokenKind::identifier || token.kind == TokenKind::keyword;
    return word_like && !token.escaped && token.text == word;
}

bool TokenReader::at_closing() const {
    constexpr std::array<std::string_view, 6> closing = {")", "]", "}", "|)", "|]", ">"};
    return at_end() || std::ranges::any_of(closing, [&](std::string_view word) { return at(word); });
}

bool TokenReader::may_touch() const {
    constexpr std::array<std::string_view, 17> joined = {
        "<->", "::", "->", "<{", "=>", "==", "!=", ">=", "<=", "\\/", "/\\", "(|", "|)", "[|", "|]", "//", "/*"};
    if (at_ == 0 || at_end()) return true;
    const Token& before = stream_.tokens[at_ - 1];
    const std::string_view left = source_text(before.span);
    const std::string_view right = source_text(peek().span);
    if (diagnostics::continues_name(right.front()) && (diagnostics::continues_name(left.back()) || left == "^"))
        return false;
    if ((left == "Set" || left == "Seq") && right.front() == '(') return false;
    if (before.kind != TokenKind::symbol || peek().kind != TokenKind::symbol) return true;
    const std::string both = std::string(left) + std::string(right);
    return std::ranges::none_of(
        joined, [&](std::string_view word) { return word.size() > left.size() && both.starts_with(word); });
}

std::string_view TokenReader::take_token() {
    const Token& token = peek();
    previous_end_ = token.span.end;
    if (!at_end()) ++at_;
    return source_text(token.span);
}

// ---------------------------------------------------------------- comments and text

bool TokenReader::has_comment() const {
    return comment_ < stream_.comments.size() && stream_.comments[comment_].begin < peek().span.begin;
}

std::vector<Piece> TokenReader::take_comments() {
    std::vector<Piece> result;
    std::size_t end = previous_end_;
    const auto add = [&](diagnostics::Span span, bool is_token) {
        const bool to_line_end = !is_token && text_[span.begin + 1] == '/';
        result.push_back({span, line_ends(end, span.begin), to_line_end, is_token});
        end = span.end;
    };
    const auto& comments = stream_.comments;
    for (; comment_ < comments.size() && comments[comment_].begin < peek().span.begin; ++comment_)
        add(comments[comment_], false);
    add(peek().span, true);
    return result;
}

void TokenReader::skip_comments(std::size_t offset) {
    while (comment_ < stream_.comments.size() && stream_.comments[comment_].begin < offset) ++comment_;
}

std::string_view TokenReader::source_text(diagnostics::Span span) const {
    return text_.substr(span.begin, span.end - span.begin);
}

/// Returns the number of line ends between two offsets, at most 2.
std::size_t TokenReader::line_ends(std::size_t begin, std::size_t end) const {
    std::size_t count = 0;
    for (std::size_t at = begin; at < end && count < 2; ++at) {
        if (!is_line_break(text_[at])) continue;
        if (text_.substr(at, 2) == "\r\n") ++at;
        ++count;
    }
    return count;
}

std::optional<std::string_view> TokenReader::margin_before(std::size_t offset) const {
    std::size_t begin = offset;
    while (begin > 0 && (text_[begin - 1] == ' ' || text_[begin - 1] == '\t')) --begin;
    if (begin > 0 && !is_line_break(text_[begin - 1])) return std::nullopt;
    return text_.substr(begin, offset - begin);
}

}  // namespace robochart::frontend
