// Values of constants: of those that the model defines, and of those that it leaves open.
#pragma once

#include <vector>

#include "checker/prism/explore/evaluation.hpp"

namespace robochart::prism {

/// Adds the values of the constants to those known. `given`: of open ones, by name; a value of another type is
/// converted if it is an int for a double. Throws EvaluationError where one has no value, unless they are `optional`.
void evaluate_constants(const std::vector<Constant>& constants, const Values& given, Values& known,
                        bool optional = false);

}  // namespace robochart::prism
