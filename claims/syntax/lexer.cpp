// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "claims/syntax/lexer.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/word_lexer.hpp"
#include "claims/syntax/rules.hpp"

namespace robochart::claims {
namespace {

/// Longest first.
constexpr std::array<std::string_view, 20> symbols{"::", "<=", ">=", "==", "!=", "(", ")", "[", "]", ",",
                                                   ":",  ".",  "<",  ">",  "+",  "-", "*", "%", "^", "="};
constexpr std::size_t most_digits = 9;

class Lexer final : public diagnostics::WordLexer<Token> {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics, bool comments)
        : WordLexer(text, source, diagnostics, comments, rules::open_comment) {}

private:
    void read_number() override {
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
            diagnostics().report(rules::bad_number, span_from(begin), {std::string(text_from(begin).substr(0, 30))});
        push_token(Tok::number, begin);
    }

    void read_symbol() override {
        const std::size_t begin = at_;
        if (accept_first(symbols) != nullptr) return push_token(Tok::symbol, begin);
        skip_character();
        const std::string shown = diagnostics::escape_for_display(text_from(begin));
        auto& finding = diagnostics().report(rules::bad_character, span_from(begin), {fmt::format("'{}'", shown)});
        if (shown == "&" || shown == "|" || shown == "!")
            finding.notes.push_back({{}, "conditions are joined with `and` and `or`, and negated with `not`"});
        if (shown == "#") finding.notes.push_back({{}, "a comment begins with `//`"});
    }
};

}  // namespace

std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics,
                       bool comments) {
    return Lexer(text, source, diagnostics, comments).read_tokens();
}

}  // namespace robochart::claims
