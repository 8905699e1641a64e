// SPDX-License-Identifier: Apache-2.0
// Converts results of the operators over intervals to enclosures.
#pragma once

#include <functional>

#include "prism/markov/operators/operators.hpp"

namespace robochart::markov {

/// Runs the operator with upward rounding. Repeats it with a higher precision if values lose too much precision from
/// one component to the next.
[[nodiscard]] Solution solve_precisely(const Precision& precision,
                                       const std::function<Result<Interval>(const Precision& precision)>& operation);

}  // namespace robochart::markov
