// What a scheduler of fewer ways can do is part of what all can do.
#pragma once

#include <functional>

#include "probability/process/decision_process.hpp"

namespace robochart::probability {

/// Whether each state of `fewer`, the initial one first, is a state of `all` (states are the same whose origins are),
/// is a deadlock in both or in neither, and has only choices that it has there: the same action, time that passes or
/// does not, and the same distribution. Both are made from one exploration. Then whatever a scheduler of `fewer` does,
/// one of `all` does.
[[nodiscard]] bool is_subgraph(const DecisionProcess& fewer, const DecisionProcess& all,
                               const std::function<void()>& poll);

}  // namespace robochart::probability
