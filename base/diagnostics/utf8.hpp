// SPDX-License-Identifier: Apache-2.0
// Decodes text that should be UTF-8 but may contain any bytes.
#pragma once

#include <cstddef>
#include <string_view>

namespace robochart::diagnostics {

/// Returns the length in bytes of the well-formed UTF-8 sequence at the beginning of `text`, or 0 if there is none.
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// The mark that editors write before a text to mark it as UTF-8. It belongs to the file, not to the text.
inline constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// Returns true for a byte of a UTF-8 sequence after its first byte.
[[nodiscard]] constexpr bool is_continuation(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

/// Returns the beginning of a text: at most this many bytes, without a part of a character at its end.
[[nodiscard]] constexpr std::string_view beginning_of(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && is_continuation(text[most])) --most;
    return text.substr(0, most);
}

/// The character that is shown in place of a byte that is not UTF-8 (U+FFFD).
inline constexpr std::string_view replacement_character = "\xEF\xBF\xBD";

}  // namespace robochart::diagnostics
