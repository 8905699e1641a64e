// SPDX-License-Identifier: Apache-2.0
// Contains the states and edges of a component that is being built, and reduces them.
#pragma once

#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/component.hpp"

namespace robochart::machine {

struct ExplicitMachine {
    std::vector<std::vector<Component::RawEdge>> rows;  ///< by state: its edges, ordered by event; state 0 is first
    std::vector<TermId> meaning;                        ///< by state: a term that it represents
};

/// Replaces the machine by its quotient under strong bisimilarity, which preserves every model. Removes unreachable
/// states. Hidden events get the names that they have in the representatives. Polls the budget.
void minimise(ExplicitMachine& machine, diagnostics::Pollable& budget);

/// Returns the component without the edges of events that are not used. `used` has one element for each event, by
/// index.
[[nodiscard]] ExplicitMachine without_unused(const Component& component, const std::vector<bool>& used);

}  // namespace robochart::machine
