// SPDX-License-Identifier: Apache-2.0
// Checks assertions: refinement in traces, failures and failures-divergences, deadlock, divergence, determinism, and
// traces. The definitions follow Roscoe, Understanding Concurrent Systems (2010), chapters 10, 11 and 16, and the FDR
// manual.
#pragma once

#include <optional>
#include <vector>

#include "checker/refine/verdict/findings.hpp"
#include "checker/refine/verdict/verdict.hpp"

namespace robochart::refine {

/// The findings of an earlier search of the same systems. If the pointer is null, no findings are used or stored. If
/// the pointer refers to findings, the check makes no search: it confirms and reports the violation in these findings.
/// If the pointer refers to an empty optional, the optional receives the findings of this search when the search is
/// complete.
using Earlier = std::optional<Findings>*;

/// Checks specification [M= implementation. Both systems must share one EventTable.
[[nodiscard]] Verdict refines(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Model,
                              const Limits&, Earlier earlier = nullptr);
/// Checks :[deadlock free [M]]. If M is `failures`, the check ignores divergence. If M is `failures_divergences`, a
/// divergence violates the assertion. A terminated process counts as deadlocked, as in FDR.
[[nodiscard]] Verdict deadlock_free(lts::TransitionSystem&, Model, const Limits&, Earlier earlier = nullptr);
[[nodiscard]] Verdict divergence_free(lts::TransitionSystem&, const Limits&, Earlier earlier = nullptr);
[[nodiscard]] Verdict deterministic(lts::TransitionSystem&, Model, const Limits&, Earlier earlier = nullptr);
/// Checks :[has trace [M]]: the process can perform these visible events in order. In models other than T the result is
/// inconclusive if the process could also refuse one of the events. In FD the result is also inconclusive if the
/// process could diverge. FDR's manual does not define these results.
[[nodiscard]] Verdict has_trace(lts::TransitionSystem&, const std::vector<process::Event>& trace, Model, const Limits&);

}  // namespace robochart::refine
