// SPDX-License-Identifier: Apache-2.0
// Suggestions for errors in a script, selected by what was expected and what was found (parser.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/advice/advice.hpp"

namespace robochart::cspm {

/// Returns all rows of the table. Expected texts are quoted as in messages: "'else'".
[[nodiscard]] std::span<const diagnostics::Advice> all_advice();

/// The number of bytes of the non-ASCII letter at the beginning of the text; 0 if there is none.
[[nodiscard]] std::size_t foreign_letter(std::string_view text);
/// The name without the accents of its letters; "" if some letter has no ASCII form.
[[nodiscard]] std::string in_plain_letters(std::string_view name);
/// The CSPM notation for a symbol from books, such as `->` for an arrow; "" if the symbol is unknown.
[[nodiscard]] std::string_view written_for(std::string_view symbol);

}  // namespace robochart::cspm
