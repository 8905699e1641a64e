// SPDX-License-Identifier: Apache-2.0
// Finds the cause of an evaluation error in the finite instantiation.
#pragma once

#include <string>
#include <string_view>

#include "checker/cspm/eval/evaluation_error.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::driver {

/// Returns a cause and a remedy as text after the error, such as "; type Twist has about 2e+15 values: ...". Returns ""
/// if the cause is unknown.
[[nodiscard]] std::string cause_of(const Project&, const cspm::EvaluationError&);

/// Returns true if an evaluation error occurred because a set has too many elements.
[[nodiscard]] bool is_about_large_set(std::string_view reason);

}  // namespace robochart::driver
