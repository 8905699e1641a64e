// SPDX-License-Identifier: Apache-2.0
// Colours of texts for people, as terminal escape sequences. The caller decides whether to use them
// (app/command/output.hpp: color_wanted).
#pragma once

#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The role of a part of a text.
enum class Paint : unsigned char {
    heading,
    name,  ///< the subject of the text
    note,
    warning,
    error,
    addition,  ///< text that a fix would insert
    success,   ///< all claims are true
};

/// The text with the colour of its role; unchanged without `color`.
[[nodiscard]] std::string paint_text(std::string_view text, Paint paint, bool color);

}  // namespace robochart::diagnostics
