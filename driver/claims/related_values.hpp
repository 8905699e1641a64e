// SPDX-License-Identifier: Apache-2.0
// Shows the values of related variables in runs of a class model (docs/data.md, "Relations of variables").
#pragma once

#include <vector>

#include "counterexample/run.hpp"
#include "semantics/data/class_model.hpp"

namespace robochart::driver {

/// Replaces classes of terms by values. In the class model, an input of a related variable has the new class of the
/// term, such as "d - l = 1". This function computes the input from the values of the other variables. From the first
/// step with an unknown value on, the function does not change classes. A value is unknown if the variable that stores
/// the input is not known, if no decimal solves the equation, or if the machine changes the variables without an input.
/// The function does not change the classes in alternatives to a step.
void show_related_values(runs::Run& run, const std::vector<ir::RelatedVariables>& related);

}  // namespace robochart::driver
