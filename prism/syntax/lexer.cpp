// SPDX-License-Identifier: Apache-2.0
// See lexer.hpp.
#include "prism/syntax/lexer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/scanner.hpp"
#include "prism/syntax/rules.hpp"

namespace robochart::prism {
namespace {

using diagnostics::is_digit;

/// The symbols, longest first. `<-`, `||` and `|[` are read as two tokens each, because `x<-1` is a comparison. The
/// last symbols belong to unsupported constructs, which the parser reports.
constexpr std::array<std::string_view, 34> symbols{"<=>", "..", "->", "=>", "<=", ">=", "!=", ";", ":", ",", "(", ")",
                                                   "[",   "]",  "{",  "}",  "=",  "<",  ">",  "+", "-", "*", "/", "^",
                                                   "&",   "|",  "!",  "?",  "'",  ".",  "@",  "$", "%", "~"};

class Lexer : diagnostics::Scanner {
public:
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics)
        : Scanner(text, source), diagnostics_(diagnostics) {}

    std::vector<Token> read_tokens() {
        while (!at_end()) {
            diagnostics_.poll();
            read_token();
        }
        push_token(Tok::end, at_, "");
        return std::move(tokens_);
    }

private:
    void push_token(Tok kind, std::size_t begin, std::string_view text) {
        tokens_.push_back({kind, span_from(begin), text, std::exchange(line_begins_, false)});
    }
    void push_token(Tok kind, std::size_t begin) { push_token(kind, begin, text_from(begin)); }

    void read_token() {
        const char c = peek();
        if (c == '\n') {
            line_begins_ = true;
            ++at_;
        } else if (c == ' ' || c == '\t' || c == '\r' || c == '\f') {
            ++at_;
        } else if (looking_at("//")) {
            at_ = line_end();
        } else if (diagnostics::begins_name(c)) {
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
        skip_name();
        push_token(Tok::word, begin);
    }

    /// Reads a number. `0` and digits without a leading zero are integers; `01` is a decimal number, as in PRISM.
    /// Digits before `..` are an integer.
    void read_number() {
        const std::size_t begin = at_;
        skip_digits();
        bool real = at_ - begin > 1 && text_[begin] == '0';
        if (peek() == '.' && is_digit(peek(1))) {
            real = true;
            ++at_;
            skip_digits();
        }
        const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 2 : 1;
        if ((peek() == 'e' || peek() == 'E') && is_digit(peek(sign))) {
            real = true;
            at_ += sign;
            const std::size_t exponent = at_;
            skip_digits();
            if (at_ - exponent > 3) too_large(begin);
        }
        if (at_ - begin > 400) too_large(begin);
        push_token(real ? Tok::real : Tok::integer, begin);
    }
    void too_large(std::size_t begin) {
        const std::string shown(text_from(begin).substr(0, 20));
        diagnostics_.report(rules::big_number, span_from(begin), {shown + (at_ - begin > 20 ? "..." : "")});
    }

    void read_quoted() {
        const std::size_t begin = at_++;
        skip_to("\"\n");
        const std::string_view name = text_from(begin + 1);
        if (accept("\""))
            push_token(Tok::quoted, begin, name);
        else
            diagnostics_.report(rules::open_label, span_from(begin));
    }

    void read_symbol() {
        const std::size_t begin = at_;
        if (accept_first(symbols) != nullptr) return push_token(Tok::symbol, begin);
        if (peek() == '#') return skip_preprocessor_text();
        skip_character();
        const std::string shown = diagnostics::escape_for_display(text_from(begin));
        diagnostics_.report(rules::bad_character, span_from(begin), {fmt::format("'{}'", shown)});
    }

    /// Skips `#...#`, which is text for PRISM's preprocessor or for other tools that fill in templates.
    void skip_preprocessor_text() {
        const std::size_t begin = at_++;
        skip_to("#\n");
        accept("#");
        diagnostics_.report(rules::not_supported, span_from(begin), {"text for a preprocessor (#...#)"});
    }

    diagnostics::Diagnostics& diagnostics_;
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
