// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "claims/syntax/lexer.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

#include "claims/syntax/rules.hpp"

namespace robochart::claims {
namespace {

/// The symbols, longest first.
constexpr std::array<std::string_view, 20> symbols{"::", "<=", ">=", "==", "!=", "(", ")", "[", "]", ",",
                                                   ":",  ".",  "<",  ">",  "+",  "-", "*", "%", "^", "="};
constexpr std::size_t most_digits = 9;

class Lexer final : public words::Lexer {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics, bool comments)
        : words::Lexer(text, source, diagnostics, comments, symbols, rules::findings) {}

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

    [[nodiscard]] std::string_view meant_by(std::string_view character) const override {
        if (character == "&" || character == "|" || character == "!")
            return "conditions are joined with `and` and `or`, and negated with `not`";
        return character == "#" ? "a comment begins with `//`" : "";
    }
};

}  // namespace

std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics,
                       bool comments) {
    return Lexer(text, source, diagnostics, comments).read_tokens();
}

}  // namespace robochart::claims
