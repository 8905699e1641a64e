// SPDX-License-Identifier: Apache-2.0
// Numbers the states and events of a component by its graph, independently of their names. The numbering proposes a
// mapping between two components. Colour refinement (Weisfeiler and Leman, 1968) orders events; a search from the
// initial state in that order numbers the states.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/component.hpp"

namespace robochart::machine {

/// A canonical numbering of a component. Components with different hashes cannot be mapped to each other; components
/// with equal hashes may be mappable.
struct ComponentShape {
    std::vector<Local> state;           ///< by number; one more at the end: off
    std::vector<std::uint32_t> number;  ///< by state; one more at the end: off
    std::vector<std::uint32_t> event;   ///< by rank: the index in the alphabet
    std::uint64_t hash = 0;
};

/// `role`: for each index in the alphabet, a number that must be equal for events that are mapped to each other. Events
/// that the graph does not distinguish are in the order of `names`. Returns empty vectors if some state is not
/// reachable from the first. Polls the budget.
[[nodiscard]] ComponentShape shape_of(const Component& component, const std::vector<std::uint64_t>& role,
                                      const lts::EventTable& names, diagnostics::Pollable& budget);

}  // namespace robochart::machine
