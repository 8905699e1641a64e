// SPDX-License-Identifier: Apache-2.0
// Writes the code of seeded faults of order for programs that may wait.
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes the code that a fault of OrderFaults moves to another place.
class OrderFaultCode : private MachineCodePart {
public:
    OrderFaultCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context), faults_(faults), steps_(steps) {}

    /// Writes the code that enters a composite state after its first child.
    void enter_child_first(ProgramWriter&, ir::NodeId);
    /// Writes the exit actions of enclosing states that the fault runs too early: in the exit place of the inner state.
    void exit_outer_before(ProgramWriter&, ir::NodeId);
    /// Writes the actions of a state's outgoing transitions that the fault runs too early: in the exit place of the
    /// state.
    void act_before(ProgramWriter&, ir::NodeId);
    /// Writes a transition's action after the entry of its target.
    void act_late(ProgramWriter&, const ir::Transition&, const std::string& label);

private:
    OrderFaults& faults_;
    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
