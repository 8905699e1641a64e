// A numbering of a component's states and events that depends on its graph, not on how states and events are called: a
// proposal how two components can be mapped to each other. Colour refinement (Weisfeiler and Leman, 1968) orders
// events; a search from the initial state in that order numbers the states.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "checker/machine/component.hpp"

namespace robochart::machine {

/// The numbering. Components with different hashes cannot be mapped to each other; those with equal ones perhaps.
struct ComponentShape {
    std::vector<Local> state;           ///< by number; one more at the end: off
    std::vector<std::uint32_t> number;  ///< by state; one more at the end: off
    std::vector<std::uint32_t> event;   ///< by rank, the place in the alphabet
    std::uint64_t hash = 0;
};

/// `role`: by place in the alphabet, a number that has to be equal for events that are mapped to each other. Events
/// that the graph does not tell apart are in the order of `names`. Empty vectors where not every state can be reached
/// from the first. `poll` may throw to stop.
[[nodiscard]] ComponentShape shape_of(const Component& component, const std::vector<std::uint64_t>& role,
                                      const lts::EventTable& names, const std::function<void()>& poll);

}  // namespace robochart::machine
