// SPDX-License-Identifier: Apache-2.0
// The words of assertions, which are reserved only in some positions.
#pragma once

#include <set>
#include <string>

namespace robochart::editors {

/// The words that the parser of assertions compares with: those of its string literals that are words.
[[nodiscard]] std::set<std::string> assertion_words();

}  // namespace robochart::editors
