// SPDX-License-Identifier: Apache-2.0
// Declares a component in control cycles as a transition system over the events of L(G) (docs/conformance.md). It is
// NF_c(M) for a RoboChart component, or S(M) for a RoboSim component. Logs, monitors, test suites and claims about
// cycles use it without knowing which of the two it is.
#pragma once

#include <string>

#include "checker/lts/transition_system.hpp"

namespace robochart::conformance {

class CycleSystem : public lts::TransitionSystem {
public:
    /// Returns whether a cycle may begin in the state: nothing has been read or written yet.
    [[nodiscard]] virtual bool begins_cycle(lts::StateView state) const = 0;
    /// Returns the text that M prints for its state; "" after termination.
    [[nodiscard]] virtual std::string describe_model(lts::StateView state) const = 0;
};

}  // namespace robochart::conformance
