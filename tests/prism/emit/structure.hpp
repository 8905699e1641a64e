// SPDX-License-Identifier: Apache-2.0
// Compares two PRISM models up to names and order. Colour refinement repeatedly colours names by their occurrences.
// Then the declarations and commands are compared as multisets of texts with colours in place of names.
#pragma once

#include <string>
#include <vector>

#include "prism/syntax/syntax.hpp"

namespace robochart::prism_emit::testing {

/// Returns the items that only one of the models has, in readable form, with "- " for the first and "+ " for the
/// second. Initially two names have the same colour if they differ only in numbers at the ends of words: `Action_20`
/// and `Action_7`. The values of program points, and upper bounds of their variables, are ignored.
[[nodiscard]] std::vector<std::string> find_differences(const prism::ModelFile& first, const prism::ModelFile& second);

}  // namespace robochart::prism_emit::testing
