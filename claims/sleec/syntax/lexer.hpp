// SPDX-License-Identifier: Apache-2.0
// Converts SLEEC text to tokens. All words are tokens of one kind; the parser decides which are reserved.
#pragma once

#include <string_view>
#include <vector>

#include "base/words/words.hpp"

namespace robochart::sleec {

using words::Tok;
using words::Token;

/// Returns all tokens of a text, on request including comments; the last is `end`. Reports and skips invalid pieces.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&,
                                     bool comments = false);

/// True for a keyword of both dialects, which cannot be a name.
[[nodiscard]] bool is_reserved(std::string_view word);

/// Returns all words with a meaning in a dialect or an extension. Words that are not reserved may also be names.
[[nodiscard]] std::vector<std::string_view> language_words();

}  // namespace robochart::sleec
