// SPDX-License-Identifier: Apache-2.0
// Explores L(G) into a graph, for exports and for comparing two controllers.
#pragma once

#include "checker/lts/graph.hpp"
#include "checker/refine/verdict/check.hpp"
#include "conformance/code/code_system.hpp"

namespace robochart::conformance {

/// Returns the reachable states of the code. Throws process::Interrupted at a limit.
[[nodiscard]] lts::Graph explore_code(CodeSystem& system, const refine::Limits& limits);

}  // namespace robochart::conformance
