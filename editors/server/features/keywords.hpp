// SPDX-License-Identifier: Apache-2.0
// Explains the reserved words of the language, for hovers.
#pragma once

#include <string_view>

namespace robochart::lsp {

/// Returns the meaning of a reserved word of RoboChart in one or two sentences, with its timing if relevant; "" for
/// other words.
[[nodiscard]] std::string_view meaning_of_word(std::string_view word);
/// Returns the meaning of a word of assertions (`deadlock-free`, `refines`); "" for other words.
[[nodiscard]] std::string_view meaning_of_assertion_word(std::string_view word);

}  // namespace robochart::lsp
