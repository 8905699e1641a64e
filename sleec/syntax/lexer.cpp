// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "sleec/syntax/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "sleec/syntax/rules.hpp"

namespace robochart::sleec {
namespace {

using diagnostics::Span;

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// Longest first.
constexpr std::array<std::string_view, 18> symbols{"::", "<=", ">=", "<>", "{", "}", "(", ")", "[",
                                                   "]",  ",",  ":",  "=",  "<", ">", "+", "-", "*"};

constexpr std::array<std::string_view, 26> reserved{
    "def_start",   "def_end",       "rule_start",  "rule_end", "concern_start",
    "concern_end", "purpose_start", "purpose_end", "event",    "measure",
    "constant",    "boolean",       "numeric",     "scale",    "when",
    "then",        "and",           "or",          "not",      "within",
    "otherwise",   "unless",        "true",        "false",    "relation_start",
    "relation_end"};

/// The equivalent of a character of other notations; "" if it is unknown.
std::string_view meant_by(std::string_view character) {
    if (character == "&") return "join conditions with `and`";
    if (character == "|") return "join conditions with `or`";
    if (character == "!") return "`not` negates a condition, and `<>` tests whether two values differ";
    if (character == ";") return "definitions and rules need no terminator";
    if (character == "#" || character == "%") return "a comment begins with `//`";
    return {};
}

class Lexer {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics, bool comments)
        : text_(text), source_(source), diagnostics_(diagnostics), comments_(comments) {}

    std::vector<Token> read_tokens() {
        while (at_ < text_.size()) {
            diagnostics_.poll();
            next();
        }
        push_token(Tok::end, at_);
        return std::move(tokens_);
    }

private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    [[nodiscard]] Span span_from(std::size_t begin) const {
        return {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    }
    void push_token(Tok kind, std::size_t begin) {
        tokens_.push_back({kind, span_from(begin), text_.substr(begin, at_ - begin)});
    }

    void next() {
        const char c = peek();
        if (c == '\n' || c == ' ' || c == '\t' || c == '\r' || c == '\f') {
            ++at_;
        } else if (c == '/' && (peek(1) == '/' || peek(1) == '*')) {
            read_comment();
        } else if (is_letter(c)) {
            const std::size_t begin = at_;
            while (is_letter(peek()) || is_digit(peek())) ++at_;
            push_token(Tok::word, begin);
        } else if (is_digit(c)) {
            read_number();
        } else {
            read_symbol();
        }
    }

    void read_comment() {
        const std::size_t begin = at_;
        if (peek(1) == '/') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else {
            const std::size_t end = text_.find("*/", at_ + 2);
            at_ = end == std::string_view::npos ? text_.size() : end + 2;
            if (end == std::string_view::npos)
                diagnostics_.report(rules::open_comment, {source_, static_cast<std::uint32_t>(begin),
                                                          static_cast<std::uint32_t>(begin) + 2});
        }
        if (comments_) push_token(Tok::comment, begin);
    }

    void read_number() {
        constexpr std::size_t most_digits = 9;
        const std::size_t begin = at_;
        while (is_digit(peek())) ++at_;
        std::string_view digits = text_.substr(begin, at_ - begin);
        while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
        if (digits.size() > most_digits && digits != "1000000000") {
            const std::string shown(digits.substr(0, 20));
            diagnostics_.report(rules::big_number, span_from(begin), {shown + (digits.size() > 20 ? "..." : "")});
        }
        push_token(Tok::number, begin);
    }

    void read_symbol() {
        const std::size_t begin = at_;
        const std::string_view rest = text_.substr(at_);
        const auto* found = std::ranges::find_if(symbols, [&](auto s) { return rest.starts_with(s); });
        if (found != symbols.end()) {
            at_ += found->size();
            return push_token(Tok::symbol, begin);
        }
        do ++at_;
        while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xc0U) == 0x80U);
        const std::string shown =
            diagnostics::escape_for_display(diagnostics::ForeignText(text_.substr(begin, at_ - begin)));
        auto& finding = diagnostics_.report(rules::bad_character, span_from(begin), {fmt::format("'{}'", shown)});
        if (const std::string_view advice = meant_by(shown); !advice.empty())
            finding.notes.push_back({{}, std::string(advice)});
        if ((shown == "&" || shown == "|") && peek() == shown.front()) ++at_;
    }

    std::string_view text_;
    diagnostics::SourceId source_;
    diagnostics::Diagnostics& diagnostics_;
    bool comments_;
    std::size_t at_ = 0;
    std::vector<Token> tokens_;
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
                                        "assume", "after", "at", "least", "map", "to"})
        result.push_back(word);
    return result;
}

}  // namespace robochart::sleec
