// SPDX-License-Identifier: Apache-2.0
// Contains what the languages of claims (claims/syntax) and of SLEEC (claims/sleec/syntax) share: tokens and their
// lexer. All words are tokens of one kind; a parser decides which of them are keywords.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/scanner.hpp"

namespace robochart::words {

enum class Tok : std::uint8_t { end, word, number, symbol, comment };

struct Token {
    Tok kind = Tok::end;
    diagnostics::Span span;
    std::string_view text;
};

/// A name with its place. It may be qualified: "Patrol", "warehouse::Patrol".
struct Name {
    std::string text;
    diagnostics::Span span;
};

/// The findings of a language about its text.
struct Findings {
    const diagnostics::Rule& unexpected_token;  ///< arguments: what was expected, what was found
    const diagnostics::Rule& bad_character;     ///< argument: the character
    const diagnostics::Rule& open_comment;
    const diagnostics::Rule& too_deep;  ///< argument: the limit
};

/// The base class of lexers. Comments begin with `//` or are inside `/*` and `*/`.
class Lexer : protected diagnostics::Scanner {
public:
    /// `symbols`: the longest first. `comments`: whether comments are tokens.
    Lexer(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics& diagnostics, bool comments,
          std::span<const std::string_view> symbols, const Findings& findings)
        : Scanner(text, source),
          diagnostics_(diagnostics),
          comments_(comments),
          symbols_(symbols),
          findings_(findings) {}
    Lexer(const Lexer&) = delete;
    Lexer& operator=(const Lexer&) = delete;
    virtual ~Lexer() = default;

    /// Returns the tokens of the text; the last one is an `end`. Invalid characters are reported and skipped.
    std::vector<Token> read_tokens();

protected:
    /// Reads a number. Its first digit is the next character.
    virtual void read_number() = 0;
    /// Returns the equivalent of a character of other notations, or "" if it is unknown.
    [[nodiscard]] virtual std::string_view meant_by(std::string_view character) const = 0;

    void push_token(Tok kind, std::size_t begin) { tokens_.push_back({kind, span_from(begin), text_from(begin)}); }
    [[nodiscard]] diagnostics::Diagnostics& diagnostics() { return diagnostics_; }

private:
    void next();
    void read_comment();
    void read_symbol();

    diagnostics::Diagnostics& diagnostics_;
    bool comments_;
    std::span<const std::string_view> symbols_;
    const Findings& findings_;
    std::vector<Token> tokens_;
};

}  // namespace robochart::words
