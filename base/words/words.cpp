// SPDX-License-Identifier: Apache-2.0
// Divides texts of claims and of SLEEC into tokens.
#include "base/words/words.hpp"

#include <fmt/format.h>

#include <utility>

#include "base/diagnostics/escape.hpp"

namespace robochart::words {

std::vector<Token> Lexer::read_tokens() {
    while (!at_end()) {
        diagnostics_.poll();
        next();
    }
    push_token(Tok::end, at_);
    return std::move(tokens_);
}

void Lexer::next() {
    const char c = peek();
    if (c == '\n' || c == ' ' || c == '\t' || c == '\r' || c == '\f') {
        ++at_;
    } else if (c == '/' && (peek(1) == '/' || peek(1) == '*')) {
        read_comment();
    } else if (diagnostics::begins_name(c)) {
        const std::size_t begin = at_;
        skip_name();
        push_token(Tok::word, begin);
    } else if (diagnostics::is_digit(c)) {
        read_number();
    } else {
        read_symbol();
    }
}

void Lexer::read_comment() {
    const std::size_t begin = at_;
    if (accept("/*")) {
        const diagnostics::Span opening = span_from(begin);
        if (!skip_past("*/")) diagnostics_.report(findings_.open_comment, opening);
    } else {
        at_ = line_end();
    }
    if (comments_) push_token(Tok::comment, begin);
}

void Lexer::read_symbol() {
    const std::size_t begin = at_;
    if (accept_first(symbols_) != nullptr) return push_token(Tok::symbol, begin);
    skip_character();
    const std::string shown = diagnostics::escape_for_display(text_from(begin));
    auto& finding = diagnostics_.report(findings_.bad_character, span_from(begin), {fmt::format("'{}'", shown)});
    if (const std::string_view advice = meant_by(shown); !advice.empty())
        finding.notes.push_back({{}, std::string(advice)});
    if ((shown == "&" || shown == "|") && peek() == shown.front()) ++at_;
}

}  // namespace robochart::words
