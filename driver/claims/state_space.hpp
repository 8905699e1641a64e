// SPDX-License-Identifier: Apache-2.0
// Explores all states of a process within the limits of a check.
#pragma once

#include "checker/lts/graph.hpp"
#include "checker/refine/verdict/check.hpp"

namespace robochart::driver {

/// Throws process::Interrupted if a limit is reached; `known` then contains the number of states found so far.
[[nodiscard]] lts::Graph explore_graph(lts::TransitionSystem& system, const refine::Limits& limits, std::size_t& known);

}  // namespace robochart::driver
