// SLEEC text to tokens. Words are tokens of one kind: whether one is reserved, the parser asks.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace robochart::sleec {

enum class Tok : std::uint8_t { end, word, number, symbol, comment };

struct Token {
    Tok kind = Tok::end;
    diagnostics::Span span;
    std::string_view text;
};

/// All tokens of a text, comments among them where they are asked for; the last is `end`. Broken pieces are reported
/// and left out.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&,
                                     bool comments = false);

/// A word of both dialects, which names nothing.
[[nodiscard]] bool is_reserved(std::string_view word);

/// All words that mean something in a dialect or an extension; those that are not reserved may be names too.
[[nodiscard]] std::vector<std::string_view> language_words();

}  // namespace robochart::sleec
