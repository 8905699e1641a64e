// SPDX-License-Identifier: Apache-2.0
// Numbers the states and events of a component by the structure of its graph. The names of states and events have no
// effect, so equal numbers propose a mapping between two components. Colour refinement (Weisfeiler and Leman, 1968)
// orders the events. A search from the initial state, which takes events in this order, numbers the states.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/component.hpp"

namespace robochart::machine {

/// A canonical numbering of a component. If two components can be mapped to each other, their hashes are equal.
/// Components with equal hashes may still be different.
struct ComponentShape {
    std::vector<Local> state;           ///< by number: the state; the last entry is off
    std::vector<std::uint32_t> number;  ///< by state: its number; the last entry is for off
    std::vector<std::uint32_t> event;   ///< by rank: the index in the alphabet
    std::uint64_t hash = 0;
};

/// Computes the numbering. Events that are mapped to each other must have equal values of `role`, which is indexed like
/// the alphabet. Events that the graph does not distinguish have the order of `names`. Returns empty vectors if some
/// state is not reachable from the first state. Polls the budget.
[[nodiscard]] ComponentShape shape_of(const Component& component, const std::vector<std::uint64_t>& role,
                                      const lts::EventTable& names, diagnostics::Pollable& budget);

}  // namespace robochart::machine
