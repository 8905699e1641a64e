// Control characters of ASCII as the languages that are written here spell them: those with a letter of their own alike
// (`\n`), the others by their numbers, each language in its way.
#pragma once

#include <optional>

namespace robochart::diagnostics {

[[nodiscard]] constexpr bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20U || c == 0x7F;
}

/// The letter behind the backslash for line ends and tabulators; nothing for other characters.
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
