// SPDX-License-Identifier: Apache-2.0
// Numbers the states and events of a component by the structure of its graph. Their names have no effect, so the
// numbers propose a mapping between two components. Colour refinement (Weisfeiler and Leman, 1968) orders the events. A
// search from the initial state numbers the states; it takes events in this order.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/machine/component.hpp"

namespace robochart::machine {

/// A canonical numbering of a component. No mapping exists between components with different hashes. Between components
/// with equal hashes, one may exist.
struct ComponentShape {
    std::vector<Local> state;           ///< by number: the state; one more at the end: off
    std::vector<std::uint32_t> number;  ///< by state: its number; one more at the end: off
    std::vector<std::uint32_t> event;   ///< by rank: the index in the alphabet
    std::uint64_t hash = 0;
};

/// Computes the numbering. Events that are mapped to each other must have equal values of `role`, which is indexed like
/// the alphabet. If the graph does not distinguish two events, they have the order of `names`. Returns empty vectors if
/// some state is not reachable from the first state. Polls the budget.
[[nodiscard]] ComponentShape shape_of(const Component& component, const std::vector<std::uint64_t>& role,
                                      const lts::EventTable& names, diagnostics::Pollable& budget);

}  // namespace robochart::machine
