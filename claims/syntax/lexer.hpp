// SPDX-License-Identifier: Apache-2.0
// Converts the text of a claims file to tokens. All words are tokens of one kind. The parser decides from the context
// which words are keywords.
#pragma once

#include <string_view>
#include <vector>

#include "base/words/words.hpp"

namespace robochart::claims {

using words::Tok;
using words::Token;

/// Returns all tokens of a text, on request including comments; the last is `end`. Reports and skips invalid pieces.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&,
                                     bool comments = false);

}  // namespace robochart::claims
