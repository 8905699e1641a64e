// SPDX-License-Identifier: Apache-2.0
// Represents a component during its construction by states and edges. Contains the functions that make it smaller.
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
/// states. The name of a hidden event is that in the representative of the merged states. Polls the budget.
void minimise(ExplicitMachine& machine, diagnostics::Pollable& budget);

/// Returns the component without the edges whose events are not used. `used` contains, for each index in the alphabet,
/// whether the event is used.
[[nodiscard]] ExplicitMachine without_unused(const Component& component, const std::vector<bool>& used);

}  // namespace robochart::machine
