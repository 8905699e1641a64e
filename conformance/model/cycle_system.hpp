// SPDX-License-Identifier: Apache-2.0
// A component in control cycles as a transition system over the events of L(G) (docs/conformance.md): NF_c(M) of a
// RoboChart component, or S(M) of a RoboSim component. Logs, monitors, test suites and claims about cycles use it
// without knowing which of the two it is.
#pragma once

#include <string>

#include "checker/lts/transition_system.hpp"

namespace robochart::conformance {

class CycleSystem : public lts::TransitionSystem {
public:
    /// Whether a cycle may begin in the state: nothing has been read or written yet.
    [[nodiscard]] virtual bool begins_cycle(lts::StateView state) const = 0;
    /// The text that M prints for its state; "" after termination.
    [[nodiscard]] virtual std::string describe_model(lts::StateView state) const = 0;
};

}  // namespace robochart::conformance
