// SPDX-License-Identifier: Apache-2.0
// Gives suggestions for errors in a script. A suggestion is selected by what the parser expected and what it found
// (parser.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/advice/advice.hpp"

namespace robochart::cspm {

/// Returns all rows of the table of suggestions. Expected texts are quoted as in messages: "'else'".
[[nodiscard]] std::span<const diagnostics::Advice> all_advice();

/// Returns the number of bytes of the non-ASCII letter at the beginning of the text, or 0 if it begins with another
/// character.
[[nodiscard]] std::size_t foreign_letter(std::string_view text);
/// Returns the name without the accents of its letters, or "" if some letter has no ASCII form.
[[nodiscard]] std::string in_plain_letters(std::string_view name);
/// Returns the CSPM notation for a symbol from books, such as `->` for an arrow, or "" if the symbol is unknown.
[[nodiscard]] std::string_view written_for(std::string_view symbol);

}  // namespace robochart::cspm
