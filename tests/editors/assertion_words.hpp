// The words of assertions, which the language reserves only where they stand.
#pragma once

#include <set>
#include <string>

namespace robochart::editors {

/// The words that the parser of assertions asks for: those of its string literals that are words.
[[nodiscard]] std::set<std::string> assertion_words();

}  // namespace robochart::editors
