// SPDX-License-Identifier: Apache-2.0
// Lists the words of assertions, which are reserved only in some positions.
#pragma once

#include <set>
#include <string>

namespace robochart::editors {

/// Returns the words with which the parser of assertions compares: those of its string literals that are words.
[[nodiscard]] std::set<std::string> assertion_words();

}  // namespace robochart::editors
