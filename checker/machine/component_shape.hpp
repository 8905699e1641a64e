// SPDX-License-Identifier: Apache-2.0
// Numbers the states and events of a component by the structure of its graph, independently of their names. The
// numbering proposes a mapping between two components. Colour refinement (Weisfeiler and Leman, 1968) orders the
// events. A search from the initial state that takes events in this order numbers the states.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/component.hpp"

namespace robochart::machine {

/// A canonical numbering of a component. If two components have different hashes, neither can be mapped to the other.
/// If the hashes are equal, a mapping may exist.
struct ComponentShape {
    std::vector<Local> state;           ///< by number: the state; one more at the end: off
    std::vector<std::uint32_t> number;  ///< by state: its number; one more at the end: off
    std::vector<std::uint32_t> event;   ///< by rank: the index in the alphabet
    std::uint64_t hash = 0;
};

/// Computes the numbering. `role`: for each index in the alphabet, a number that must be equal for events that are
/// mapped to each other. Events that the graph does not distinguish are in the order of `names`. Returns empty vectors
/// if some state is not reachable from the first state. Polls the budget.
[[nodiscard]] ComponentShape shape_of(const Component& component, const std::vector<std::uint64_t>& role,
                                      const lts::EventTable& names, diagnostics::Pollable& budget);

}  // namespace robochart::machine
