// SPDX-License-Identifier: Apache-2.0
// Finds the cause of an evaluation error in the finite instantiation.
#pragma once

#include <string>

#include "app/command/pipeline.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"

namespace robochart::app {

/// A text to append to the error, with a remedy: "; type Twist has about 2e+15 values: ...". "" if the cause is
/// unknown.
[[nodiscard]] std::string cause_of(const Project&, const cspm::EvaluationError&);

}  // namespace robochart::app
