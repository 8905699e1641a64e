// SPDX-License-Identifier: Apache-2.0
// Declares a component in control cycles as a transition system over the events of L(G) (docs/conformance.md). This
// system is NF_c(M) for a RoboChart component and S(M) for a RoboSim component. Logs, monitors, test suites and claims
// about cycles use this interface for both kinds of components.
#pragma once

#include <string>

#include "checker/lts/transition_system.hpp"

namespace robochart::conformance {

class CycleSystem : public lts::TransitionSystem {
public:
    /// Returns whether a cycle may begin in the state, that is, whether nothing has been read or written since the last
    /// cycle.
    [[nodiscard]] virtual bool begins_cycle(lts::StateView state) const = 0;
    /// Returns the text that M prints for its state; "" after termination.
    [[nodiscard]] virtual std::string describe_model(lts::StateView state) const = 0;
};

}  // namespace robochart::conformance
