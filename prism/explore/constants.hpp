// SPDX-License-Identifier: Apache-2.0
// Evaluates constants that the model defines or the caller gives.
#pragma once

#include <vector>

#include "prism/explore/evaluation.hpp"

namespace robochart::prism {

/// Adds the values of the constants to `known`. `given` contains values, by name, for constants without a definition;
/// an int is converted to a double if necessary. Throws EvaluationError if a constant has no value, unless `optional`
/// is set.
void evaluate_constants(const std::vector<Constant>& constants, const Values& given, Values& known,
                        bool optional = false);

}  // namespace robochart::prism
