// SPDX-License-Identifier: Apache-2.0
// Values of constants, defined by the model or given by the caller.
#pragma once

#include <vector>

#include "prism/explore/evaluation.hpp"

namespace robochart::prism {

/// Adds the values of the constants to the known values. `given`: values of constants without definition, by name; an
/// int is converted for a double. Throws EvaluationError if a constant has no value, unless `optional` is set.
void evaluate_constants(const std::vector<Constant>& constants, const Values& given, Values& known,
                        bool optional = false);

}  // namespace robochart::prism
