// What a mistake in a script probably means: by what was expected and what was found (parser.hpp).
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "diagnostics/advice/advice.hpp"

namespace robochart::cspm {

/// All rows; what is expected is as the messages say it: "'else'".
[[nodiscard]] std::span<const diagnostics::Advice> all_advice();

/// The bytes of the letter beyond ASCII that the text begins with; 0 if it begins with none.
[[nodiscard]] std::size_t foreign_letter(std::string_view text);
/// The name without the accents of its letters; "" where one has no plain letter.
[[nodiscard]] std::string in_plain_letters(std::string_view name);
/// What CSPM writes for a symbol of books, such as `->` for an arrow; "" if none is known.
[[nodiscard]] std::string_view written_for(std::string_view symbol);

}  // namespace robochart::cspm
