// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "prism/syntax/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "prism/syntax/rules.hpp"

namespace robochart::prism {
namespace {

using diagnostics::Span;

bool is_letter(char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool is_digit(char c) {
    return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

/// The longest symbols come first. `<-`, `||` and `|[` are read as two tokens each, because `x<-1` is a comparison. The
/// last symbols belong to unsupported constructs, which the parser reports.
constexpr std::array<std::string_view, 34> symbols{"<=>", "..", "->", "=>", "<=", ">=", "!=", ";", ":", ",", "(", ")",
                                                   "[",   "]",  "{",  "}",  "=",  "<",  ">",  "+", "-", "*", "/", "^",
                                                   "&",   "|",  "!",  "?",  "'",  ".",  "@",  "$", "%", "~"};

class Lexer {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics)
        : text_(text), source_(source), diagnostics_(diagnostics) {}

    std::vector<Token> read_tokens() {
        while (at_ < text_.size()) {
            diagnostics_.poll();
            read_token();
        }
        push_token(Tok::end, at_, "");
        return std::move(tokens_);
    }

private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    [[nodiscard]] Span span(std::size_t begin) const {
        return {source_, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(at_)};
    }
    void push_token(Tok kind, std::size_t begin, std::string_view text) {
        tokens_.push_back({kind, span(begin), text, std::exchange(line_begins_, false)});
    }
    void push_token(Tok kind, std::size_t begin) { push_token(kind, begin, text_.substr(begin, at_ - begin)); }

    void read_token() {
        const char c = peek();
        if (c == '\n') {
            line_begins_ = true;
            ++at_;
        } else if (c == ' ' || c == '\t' || c == '\r' || c == '\f') {
            ++at_;
        } else if (c == '/' && peek(1) == '/') {
            at_ = std::min(text_.find('\n', at_), text_.size());
        } else if (is_letter(c)) {
            read_word();
        } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
            read_number();
        } else if (c == '"') {
            read_quoted();
        } else {
            read_symbol();
        }
    }

    void read_word() {
        const std::size_t begin = at_;
        while (is_letter(peek()) || is_digit(peek())) ++at_;
        push_token(Tok::word, begin);
    }

    /// `0` or digits without a leading zero are integers; `01` is a decimal number, as in PRISM. Digits before `..` are
    /// an integer.
    void read_number() {
        const std::size_t begin = at_;
        while (is_digit(peek())) ++at_;
        bool real = at_ - begin > 1 && text_[begin] == '0';
        if (peek() == '.' && is_digit(peek(1))) {
            real = true;
            ++at_;
            while (is_digit(peek())) ++at_;
        }
        const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 2 : 1;
        if ((peek() == 'e' || peek() == 'E') && is_digit(peek(sign))) {
            real = true;
            at_ += sign;
            const std::size_t exponent = at_;
            while (is_digit(peek())) ++at_;
            if (at_ - exponent > 3) too_large(begin);
        }
        if (at_ - begin > 400) too_large(begin);
        push_token(real ? Tok::real : Tok::integer, begin);
    }
    void too_large(std::size_t begin) {
        std::string shown(text_.substr(begin, std::min<std::size_t>(at_ - begin, 20)));
        diagnostics_.report(rules::big_number, span(begin), {shown + (at_ - begin > 20 ? "..." : "")});
    }

    void read_quoted() {
        const std::size_t begin = at_++;
        const std::size_t end = text_.find_first_of("\"\n", at_);
        if (end == std::string_view::npos || text_[end] == '\n') {
            at_ = std::min(end, text_.size());
            diagnostics_.report(rules::open_label, span(begin));
            return;
        }
        const std::string_view name = text_.substr(at_, end - at_);
        at_ = end + 1;
        push_token(Tok::quoted, begin, name);
    }

    void read_symbol() {
        const std::size_t begin = at_;
        const std::string_view rest = text_.substr(at_);
        const auto* found = std::ranges::find_if(symbols, [&](auto s) { return rest.starts_with(s); });
        if (found != symbols.end()) {
            at_ += found->size();
            return push_token(Tok::symbol, begin);
        }
        if (peek() == '#') return skip_preprocessor_text();
        do ++at_;
        while (at_ < text_.size() && (static_cast<unsigned char>(text_[at_]) & 0xc0U) == 0x80U);
        const std::string shown =
            diagnostics::escape_for_display(diagnostics::ForeignText(text_.substr(begin, at_ - begin)));
        diagnostics_.report(rules::bad_character, span(begin), {fmt::format("'{}'", shown)});
    }

    /// Skips `#...#`, which is text for the preprocessor of PRISM, or for a tool that fills holes.
    void skip_preprocessor_text() {
        const std::size_t begin = at_++;
        at_ = std::min(text_.find_first_of("#\n", at_), text_.size());
        if (at_ < text_.size() && text_[at_] == '#') ++at_;
        diagnostics_.report(rules::not_supported, span(begin), {"text for a preprocessor (#...#)"});
    }

    std::string_view text_;
    diagnostics::SourceId source_;
    diagnostics::Diagnostics& diagnostics_;
    std::size_t at_ = 0;
    bool line_begins_ = true;
    std::vector<Token> tokens_;
};

constexpr std::array<std::string_view, 64> reserved{"A",
                                                    "bool",
                                                    "clock",
                                                    "const",
                                                    "ctmc",
                                                    "C",
                                                    "double",
                                                    "dtmc",
                                                    "E",
                                                    "endinit",
                                                    "endinvariant",
                                                    "endmodule",
                                                    "endobservables",
                                                    "endrewards",
                                                    "endsystem",
                                                    "false",
                                                    "filter",
                                                    "formula",
                                                    "func",
                                                    "F",
                                                    "global",
                                                    "G",
                                                    "init",
                                                    "I",
                                                    "int",
                                                    "invariant",
                                                    "label",
                                                    "max",
                                                    "min",
                                                    "mdp",
                                                    "module",
                                                    "nondeterministic",
                                                    "observable",
                                                    "observables",
                                                    "P",
                                                    "pomdp",
                                                    "popta",
                                                    "prob",
                                                    "probabilistic",
                                                    "pta",
                                                    "rate",
                                                    "R",
                                                    "rewards",
                                                    "S",
                                                    "stochastic",
                                                    "system",
                                                    "true",
                                                    "U",
                                                    "W",
                                                    "X",
                                                    "Pmin",
                                                    "Pmax",
                                                    "Rmin",
                                                    "Rmax",
                                                    "Pminmin",
                                                    "Pminmax",
                                                    "Pmaxmin",
                                                    "Pmaxmax",
                                                    "Rminmin",
                                                    "Rminmax",
                                                    "Rmaxmin",
                                                    "Rmaxmax",
                                                    "minmax",
                                                    "maxmin"};

}  // namespace

std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics) {
    return Lexer(text, source, diagnostics).read_tokens();
}

bool is_reserved(std::string_view word) {
    return std::ranges::find(reserved, word) != reserved.end();
}

}  // namespace robochart::prism
