// SPDX-License-Identifier: Apache-2.0
// Checks: refinement in traces, failures, failures-divergences; deadlock, divergence, determinism, traces. Roscoe,
// Understanding Concurrent Systems (2010), chapters 10, 11, 16; FDR manual.
#pragma once

#include <optional>
#include <vector>

#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// The findings of an earlier search of the same systems. If there is a value, it replaces the search: its violation is
/// confirmed and reported like that of a search. If there is no value, it receives the findings of this search when the
/// search is complete. Null if neither is wanted.
using Earlier = std::optional<Findings>*;

/// specification [M= implementation. Both systems must share one EventTable.
[[nodiscard]] Verdict refines(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Model,
                              const Limits&, Earlier earlier = nullptr);
/// :[deadlock free [M]]. M is failures (divergence is ignored) or failures_divergences (a divergence violates it). A
/// terminated process counts as deadlocked, as in FDR.
[[nodiscard]] Verdict deadlock_free(lts::TransitionSystem&, Model, const Limits&, Earlier earlier = nullptr);
[[nodiscard]] Verdict divergence_free(lts::TransitionSystem&, const Limits&, Earlier earlier = nullptr);
[[nodiscard]] Verdict deterministic(lts::TransitionSystem&, Model, const Limits&, Earlier earlier = nullptr);
/// :[has trace [M]]: the process can perform these visible events in order. In models other than T the result is
/// inconclusive if the process could also refuse one of them, or in FD diverge, since the manual does not define these
/// cases.
[[nodiscard]] Verdict has_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, Model, const Limits&);

}  // namespace robochart::refine
