// Walking over text that should be UTF-8 but may hold anything.
#pragma once

#include <cstddef>
#include <string_view>

namespace robochart::diagnostics {

/// Length in bytes of the well-formed UTF-8 sequence at the front of `text`; 0 if there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// What editors put in front of a text to say that it is UTF-8. It belongs to the file, not to the text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// A byte inside a UTF-8 sequence, behind its first.
[[nodiscard]] inline bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// What is shown in place of a byte that is not UTF-8 (U+FFFD).
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

}  // namespace robochart::diagnostics
