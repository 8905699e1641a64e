// SPDX-License-Identifier: Apache-2.0
// Gives the escapes of ASCII control characters for the languages that the project writes. A character with a letter
// has the same escape in all languages (`\n`). The other characters are written as numbers, in the form of the
// language.
#pragma once

#include <optional>

namespace robochart::diagnostics {

[[nodiscard]] constexpr bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20U || c == 0x7F;
}

/// Returns the letter after the backslash for line ends and tabulators. Returns no value for other characters.
[[nodiscard]] constexpr std::optional<char> letter_of_control(char c) {
    switch (c) {
        case '\n':
            return 'n';
        case '\r':
            return 'r';
        case '\t':
            return 't';
        default:
            return std::nullopt;
    }
}

}  // namespace robochart::diagnostics
