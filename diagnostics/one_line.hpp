// Text of several lines as one, for titles and excerpts.
#pragma once

#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The text with every run of blanks and line ends as one blank, and none at its ends.
[[nodiscard]] std::string on_one_line(std::string_view text);

}  // namespace robochart::diagnostics
