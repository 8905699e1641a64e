// SPDX-License-Identifier: Apache-2.0
// Colours texts for people by terminal escape sequences. The caller decides whether to use colours
// (app/command/output.hpp: color_wanted).
#pragma once

#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// What a piece of printed text is. Each kind has its own colour.
enum class Paint : unsigned char {
    heading,
    name,  ///< what the text is about
    note,
    warning,
    error,
    addition,  ///< text that a fix would insert
    success,   ///< all claims are true
};

/// Returns the text in the colour of its kind. Without `color`, the text is unchanged.
[[nodiscard]] std::string paint_text(std::string_view text, Paint paint, bool color);

}  // namespace robochart::diagnostics
