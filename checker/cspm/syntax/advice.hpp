// SPDX-License-Identifier: Apache-2.0
// Gives suggestions for errors in a script. What the parser expected and what it found determine the suggestion
// (parser.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "base/advice/advice.hpp"

namespace robochart::cspm {

/// Returns the table of all suggestions. Expected texts have quotes, as in messages: "'else'".
[[nodiscard]] std::span<const diagnostics::Advice> all_advice();

/// If the text begins with a non-ASCII letter, returns the number of its bytes. Otherwise returns
/// 0.
[[nodiscard]] std::size_t foreign_letter(std::string_view text);
/// Returns the name without the accents of its letters, or "" if some letter has no ASCII form.
[[nodiscard]] std::string in_plain_letters(std::string_view name);
/// Returns the CSPM notation for a symbol from books, such as `->` for an arrow, or "" if the symbol is unknown.
[[nodiscard]] std::string_view written_for(std::string_view symbol);

}  // namespace robochart::cspm
