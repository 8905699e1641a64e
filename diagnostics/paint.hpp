// Colours of texts for people, as escape sequences of terminals. Whether there are any is the caller's decision
// (app/command/output.hpp: color_wanted).
#pragma once

#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// What a part of a text is.
enum class Paint : unsigned char {
    heading,
    name,  ///< of something that the text is about
    note,
    warning,
    error,
    addition,  ///< what a fix would write
    success,   ///< everything as claimed
};

/// The text so that it stands out, or as it is where no colours are wanted.
[[nodiscard]] std::string painted(std::string_view text, Paint paint, bool color);

}  // namespace robochart::diagnostics
