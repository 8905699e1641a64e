// Small changes of texts.
#pragma once

#include <map>
#include <string>
#include <string_view>

namespace robochart::diagnostics {

/// The text with every run of blanks and line ends as one blank, and none at its ends: for titles and excerpts.
[[nodiscard]] std::string on_one_line(std::string_view text);

/// The text with every @KEY@ replaced; what it is replaced by is not looked at again.
[[nodiscard]] std::string filled(const std::string& text, const std::map<std::string, std::string>& keys);

}  // namespace robochart::diagnostics
