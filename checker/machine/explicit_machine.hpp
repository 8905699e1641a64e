// The states and edges of a component while it is made, and how they become fewer.
#pragma once

#include <functional>
#include <vector>

#include "checker/machine/component.hpp"

namespace robochart::machine {

struct ExplicitMachine {
    std::vector<std::vector<Component::RawEdge>> rows;  ///< of each state, its edges ordered by event; state 0 is first
    std::vector<TermId> meaning;                        ///< of each state, a term that it stands for
};

/// The quotient by strong bisimilarity, which keeps every model; states not reached are left out. Of a hidden event's
/// names, those of the states that stand for the others are kept. `poll` may throw to stop.
void minimise(ExplicitMachine& machine, const std::function<void()>& poll);

/// The component without the edges by the events, given by their places, that are not `used`.
[[nodiscard]] ExplicitMachine without_unused(const Component& component, const std::vector<bool>& used);

}  // namespace robochart::machine
