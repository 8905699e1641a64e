// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "claims/sleec/syntax/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>

#include "claims/sleec/syntax/rules.hpp"

namespace robochart::sleec {
namespace {

/// The symbols, longest first.
constexpr std::array<std::string_view, 18> symbols{"::", "<=", ">=", "<>", "{", "}", "(", ")", "[",
                                                   "]",  ",",  ":",  "=",  "<", ">", "+", "-", "*"};

constexpr std::array<std::string_view, 26> reserved{
    "def_start",   "def_end",       "rule_start",  "rule_end", "concern_start",
    "concern_end", "purpose_start", "purpose_end", "event",    "measure",
    "constant",    "boolean",       "numeric",     "scale",    "when",
    "then",        "and",           "or",          "not",      "within",
    "otherwise",   "unless",        "true",        "false",    "relation_start",
    "relation_end"};

class Lexer final : public words::Lexer {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics, bool comments)
        : words::Lexer(text, source, diagnostics, comments, symbols, rules::findings) {}

private:
    void read_number() override {
        constexpr std::size_t most_digits = 9;
        const std::size_t begin = at_;
        skip_digits();
        std::string_view digits = text_from(begin);
        while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
        if (digits.size() > most_digits && digits != "1000000000") {
            const std::string shown(digits.substr(0, 20));
            diagnostics().report(rules::big_number, span_from(begin), {shown + (digits.size() > 20 ? "..." : "")});
        }
        push_token(Tok::number, begin);
    }

    [[nodiscard]] std::string_view meant_by(std::string_view character) const override {
        if (character == "&") return "join conditions with `and`";
        if (character == "|") return "join conditions with `or`";
        if (character == "!") return "`not` negates a condition, and `<>` tests whether two values differ";
        if (character == ";") return "definitions and rules need no terminator";
        if (character == "#" || character == "%") return "a comment begins with `//`";
        return {};
    }
};

}  // namespace

std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics,
                       bool comments) {
    return Lexer(text, source, diagnostics, comments).read_tokens();
}

bool is_reserved(std::string_view word) {
    return std::ranges::find(reserved, word) != reserved.end();
}

std::vector<std::string_view> language_words() {
    std::vector<std::string_view> result(reserved.begin(), reserved.end());
    for (const std::string_view word : {"seconds", "minutes", "hours", "days", "eventually", "else", "exists", "while",
                                        "assume", "after", "at", "least", "map", "to", "in"})
        result.push_back(word);
    return result;
}

}  // namespace robochart::sleec
