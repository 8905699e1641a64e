// SPDX-License-Identifier: Apache-2.0
// Checks that a process with a restricted scheduler is part of the process with all schedulers.
#pragma once

#include <functional>

#include "prism/assertions/process/decision_process.hpp"

namespace robochart::probability {

/// True if each state of `fewer`, the initial one first, is a state of `all` (with the same origin), is a deadlock in
/// both or in neither, and has only choices of that state: the same action, time passing or not, and distribution. Both
/// must be made from one exploration. Then every scheduler of `fewer` corresponds to a scheduler of `all`.
[[nodiscard]] bool is_subgraph(const DecisionProcess& fewer, const DecisionProcess& all,
                               const std::function<void()>& poll);

}  // namespace robochart::probability
