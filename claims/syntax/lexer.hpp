// SPDX-License-Identifier: Apache-2.0
// Converts the text of a claims file to tokens. All words are tokens of one kind; the parser decides which are
// keywords at their place.
#pragma once

#include <string_view>
#include <vector>

#include "base/words/words.hpp"

namespace robochart::claims {

using words::Tok;
using words::Token;

/// All tokens of a text, on request including comments; the last is `end`. Invalid pieces are reported and skipped.
[[nodiscard]] std::vector<Token> lex(std::string_view text, diagnostics::SourceId source, diagnostics::Diagnostics&,
                                     bool comments = false);

}  // namespace robochart::claims
