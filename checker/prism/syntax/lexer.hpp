// PRISM text to tokens. Words are tokens of one kind: whether one is reserved, the parser asks.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"

namespace robochart::prism {

enum class Tok : std::uint8_t { end, word, integer, real, quoted, symbol };

struct Token {
    Tok kind = Tok::end;
    diagnostics::Span span;
    std::string_view text;     ///< the text covered; of a quoted name, what stands between the quotes
    bool line_begins = false;  ///< the first token of its line
};

/// All tokens of a text; the last is `end`. Broken pieces are reported and left out.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&);

/// A word of the language, which names nothing.
[[nodiscard]] bool is_reserved(std::string_view word);

}  // namespace robochart::prism
