// Words of RoboChart and assertion text, after Xtext's common terminals (ID, INT, STRING, comments) and
// RoboChart.xtext.
#pragma once

#include <cstdint>
#include <deque>
#include <span>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::frontend {

enum class TokenKind : std::uint8_t {
    end,         ///< after the last word
    identifier,  ///< a name, or a word that only some places reserve
    keyword,     ///< a reserved word of RoboChart
    integer,
    real,
    string,    ///< with its quotes
    symbol,    ///< operator or bracket, longest match; `Set(` and `Seq(` count as such
    csp_code,  ///< `csp-begin … csp-end`, whole (assertion files)
};

/// One word. `text` views the source; escaped names (`^end`) come without their `^`.
struct Token {
    TokenKind kind = TokenKind::end;
    bool escaped = false;  ///< written with `^`
    bool first_on_line = false;
    std::string_view text;
    diagnostics::Span span;

    [[nodiscard]] bool is(std::string_view word) const {
        return (kind == TokenKind::keyword || kind == TokenKind::symbol) && text == word;
    }
};

/// A text in words; the last token is `end`. Comments keep their places so that a formatter can put them back.
struct TokenStream {
    std::deque<Token> tokens;  ///< a deque: a long text needs no second copy while it grows
    std::vector<diagnostics::Span> comments;
};

/// Splits a text into words. What is no word becomes a diagnostic and is skipped.
[[nodiscard]] TokenStream tokenize(const diagnostics::SourceManager&, diagnostics::SourceId, bool is_assertions,
                                   diagnostics::Diagnostics&);

/// Is this one of RoboChart's reserved words?
[[nodiscard]] bool is_reserved(std::string_view word);
/// The reserved words, sorted.
[[nodiscard]] const std::vector<std::string_view>& reserved_words();
/// The operators and brackets, longest first; the last few are words of the PRISM parts of assertion files alone.
[[nodiscard]] std::span<const std::string_view> symbol_words();

/// A piece of source text made fit for a message: on one line, at most 40 characters.
[[nodiscard]] std::string shorten(std::string_view text);

}  // namespace robochart::frontend
