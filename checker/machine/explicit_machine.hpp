// SPDX-License-Identifier: Apache-2.0
// The states and edges of a component while it is built, and their reduction.
#pragma once

#include <functional>
#include <vector>

#include "checker/machine/component.hpp"

namespace robochart::machine {

struct ExplicitMachine {
    std::vector<std::vector<Component::RawEdge>> rows;  ///< by state: its edges ordered by event; state 0 is first
    std::vector<TermId> meaning;                        ///< by state: a term that it represents
};

/// The quotient by strong bisimilarity, which preserves every model; unreachable states are left out. The names of
/// hidden events are those of the representatives. `poll` may throw to stop.
void minimise(ExplicitMachine& machine, const std::function<void()>& poll);

/// The component without the edges whose events, given by their indices, are not `used`.
[[nodiscard]] ExplicitMachine without_unused(const Component& component, const std::vector<bool>& used);

}  // namespace robochart::machine
