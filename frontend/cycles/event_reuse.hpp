// SPDX-License-Identifier: Apache-2.0
// Finds inputs that a machine could take twice in one cycle. A register keeps its content for a whole cycle, but a
// simulation of RoboChart takes it at most once (docs/conformance.md, A1).
#pragma once

#include <set>
#include <string>

#include "frontend/cycles/usage.hpp"

namespace robochart::frontend {

/// True if every run of the action ends a cycle: it waits for at least one time unit.
[[nodiscard]] bool surely_waits(const Stmt& action, const Callers& callers);

/// Returns the inputs for which the machine and its operations must record that they were taken. May also return inputs
/// that are never taken twice.
[[nodiscard]] std::set<std::string> reusable_inputs(const Callers& callers);

}  // namespace robochart::frontend
