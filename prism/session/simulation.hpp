// SPDX-License-Identifier: Apache-2.0
// Implements statistical model checking: evaluates a property on random paths, without exploring the state space.
#pragma once

#include "prism/checks/checked.hpp"
#include "prism/explore/instance.hpp"
#include "prism/sampling/method.hpp"
#include "prism/session/result.hpp"

namespace robochart::prism {

/// Evaluates P [ path ] or R [ F, C<=k, I=k ] over a dtmc with one initial state. `constants` contains the values of
/// the properties' constants. The result contains an Estimate. A number is the mean of the samples and not an
/// enclosure. A bound is decided if every interval of the estimate is on one side of it. If the method or the paths do
/// not decide the property, the result is unknown and contains the reason. The same seed gives the same result for any
/// number of threads. Throws EvaluationError, LimitReached.
[[nodiscard]] Result simulate(const Instance& instance, const CheckedProperties& properties, std::size_t property,
                              const Values& constants, const SamplingOptions& options,
                              diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
