// SPDX-License-Identifier: Apache-2.0
// Converts PRISM text to tokens. All words are tokens of the same kind; the parser checks whether a word is reserved.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::prism {

enum class Tok : std::uint8_t { end, word, integer, real, quoted, symbol };

struct Token {
    Tok kind = Tok::end;
    diagnostics::Span span;
    std::string_view text;     ///< the covered text; for a quoted name, the text inside the quotes
    bool line_begins = false;  ///< true for the first token of its line
};

/// Returns all tokens of a text; the last one is `end`. Malformed tokens are reported and skipped.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&);

/// Returns whether the word is reserved and cannot be a name.
[[nodiscard]] bool is_reserved(std::string_view word);

}  // namespace robochart::prism
