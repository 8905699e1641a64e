// Statistical model checking: a property answered by random paths, without exploring the state space.
#pragma once

#include "checker/prism/checks/checked.hpp"
#include "checker/prism/explore/instance.hpp"
#include "checker/prism/result.hpp"
#include "checker/prism/sampling/method.hpp"

namespace robochart::prism {

/// Answers P [ path ] or R [ F, C<=k, I=k ] over a dtmc with one initial state; `constants` are those of the
/// properties. The result has an Estimate: a number is the mean of the samples and no enclosure, and a bound counts as
/// decided where every interval of the estimate is on one side of it. Unknown, with the reason, where the method or the
/// paths do not decide. Same seed, same result, for any number of threads. Throws EvaluationError, LimitReached.
[[nodiscard]] Result simulate(const Instance& instance, const CheckedProperties& properties, std::size_t property,
                              const Values& constants, const SamplingOptions& options,
                              diagnostics::Diagnostics& diagnostics);

}  // namespace robochart::prism
