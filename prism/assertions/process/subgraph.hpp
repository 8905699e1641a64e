// SPDX-License-Identifier: Apache-2.0
// Checks that a process with a restricted scheduler is part of the process with all schedulers.
#pragma once

#include "base/diagnostics/pollable.hpp"
#include "prism/assertions/process/decision_process.hpp"

namespace robochart::probability {

/// Returns true if `fewer` is a subgraph of `all`. Both must be made from one exploration. Each state of `fewer`, the
/// initial one first, must be a state of `all` with the same origin, and a deadlock in both or in neither. Each choice
/// of `fewer` must be a choice of the same state in `all`: its action, its distribution and whether time passes must be
/// equal. Then every scheduler of `fewer` corresponds to a scheduler of `all`.
[[nodiscard]] bool is_subgraph(const DecisionProcess& fewer, const DecisionProcess& all, diagnostics::Pollable& budget);

}  // namespace robochart::probability
