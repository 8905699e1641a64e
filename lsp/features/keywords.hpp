// What the reserved words of the language mean, for hovers.
#pragma once

#include <string_view>

namespace robochart::lsp {

/// The meaning of a reserved word of RoboChart in one or two sentences, with time where it matters; "" if it is none.
[[nodiscard]] std::string_view meaning_of_word(std::string_view word);
/// The meaning of a word of assertions (`deadlock-free`, `refines`); "" if it is none.
[[nodiscard]] std::string_view meaning_of_assertion_word(std::string_view word);

}  // namespace robochart::lsp
