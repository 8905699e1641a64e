// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "claims/syntax/lexer.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/scanner.hpp"
#include "claims/syntax/rules.hpp"

namespace robochart::claims {
namespace {

/// Longest first.
constexpr std::array<std::string_view, 20> symbols{"::", "<=", ">=", "==", "!=", "(", ")", "[", "]", ",",
                                                   ":",  ".",  "<",  ">",  "+",  "-", "*", "%", "^", "="};
constexpr std::size_t most_digits = 9;

class Lexer : diagnostics::Scanner {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics, bool comments)
        : Scanner(text, source), diagnostics_(diagnostics), comments_(comments) {}

    std::vector<Token> read_tokens() {
        while (!at_end()) {
            diagnostics_.poll();
            next();
        }
        push_token(Tok::end, at_);
        return std::move(tokens_);
    }

private:
    void push_token(Tok kind, std::size_t begin) { tokens_.push_back({kind, span_from(begin), text_from(begin)}); }

    void next() {
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

    void read_comment() {
        const std::size_t begin = at_;
        if (accept("/*")) {
            const diagnostics::Span opening = span_from(begin);
            if (!skip_past("*/")) diagnostics_.report(rules::open_comment, opening);
        } else {
            at_ = line_end();
        }
        if (comments_) push_token(Tok::comment, begin);
    }

    void read_number() {
        const std::size_t begin = at_;
        skip_digits();
        bool too_long = at_ - begin > most_digits;
        if (peek() == '.' && diagnostics::is_digit(peek(1))) {
            ++at_;
            const std::size_t point = at_;
            skip_digits();
            too_long = too_long || at_ - point > most_digits;
        }
        if (too_long)
            diagnostics_.report(rules::bad_number, span_from(begin), {std::string(text_from(begin).substr(0, 30))});
        push_token(Tok::number, begin);
    }

    void read_symbol() {
        const std::size_t begin = at_;
        if (accept_first(symbols) != nullptr) return push_token(Tok::symbol, begin);
        skip_character();
        const std::string shown = diagnostics::escape_for_display(text_from(begin));
        auto& finding = diagnostics_.report(rules::bad_character, span_from(begin), {fmt::format("'{}'", shown)});
        if (shown == "&" || shown == "|" || shown == "!")
            finding.notes.push_back({{}, "conditions are joined with `and` and `or`, and negated with `not`"});
        if (shown == "#") finding.notes.push_back({{}, "a comment begins with `//`"});
    }

    diagnostics::Diagnostics& diagnostics_;
    bool comments_;
    std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics,
                       bool comments) {
    return Lexer(text, source, diagnostics, comments).read_tokens();
}

}  // namespace robochart::claims
