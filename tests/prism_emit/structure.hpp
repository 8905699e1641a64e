// Whether two models of PRISM are equal up to names and order: names are coloured by where they occur, again and again
// (colour refinement), then the declarations and commands are compared as multisets of text with colours for names.
#pragma once

#include <string>
#include <vector>

#include "checker/prism/syntax/syntax.hpp"

namespace robochart::prism_emit::testing {

/// What only one of the models has, in readable form: "- " of the first, "+ " of the second. Before anything else,
/// names are alike if they are equal but for numbers at the ends of words: `Action_20` and `Action_7`. Program points
/// have any values, and their variables any upper bound.
[[nodiscard]] std::vector<std::string> differences(const prism::ModelFile& first, const prism::ModelFile& second);

}  // namespace robochart::prism_emit::testing
