// What in the finite instantiation is behind an error of evaluation.
#pragma once

#include <string>

#include "app/command/pipeline.hpp"
#include "checker/cspm/eval/evaluation_error.hpp"

namespace robochart::app {

/// Behind the error, what to do about it: "; type Twist has about 2e+15 values: ...". "" where it is not known.
[[nodiscard]] std::string cause_of(const Project&, const cspm::EvaluationError&);

}  // namespace robochart::app
