// SPDX-License-Identifier: Apache-2.0
// Writes the choice of transitions: active states from the inside out, and in each state the textual order. Triggers
// are examined before they are consumed, and guards see the incoming value (semantics 3.4 "Guards").
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes the functions that start a transition.
class TransitionCode : private MachineCodePart {
public:
    TransitionCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context), faults_(faults), steps_(steps) {}

    /// Writes a function for each state that can be left, and the function that calls them from the inside out.
    void transition_functions();

private:
    void pick_function();
    [[nodiscard]] std::vector<std::string> attempt_calls(ir::NodeId leaf) const;
    void from_function(ir::NodeId);
    bool try_transition(const ir::Transition&);
    void reset_too_soon(const ir::Transition&);
    bool try_trigger(const ir::Transition&, ir::TransitionId);
    void begin_transition(const ir::Transition&, ir::TransitionId);
    void write_departure(ir::NodeId source, ir::TransitionId);

    OrderFaults& faults_;
    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
