// SPDX-License-Identifier: Apache-2.0
// The code of seeded faults of order, if programs may wait.
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes what a fault of OrderFaults moves to another place.
class OrderFaultCode : private MachineCodePart {
public:
    OrderFaultCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context), faults_(faults), steps_(steps) {}

    /// The entry of a composite and of its first child, the child first.
    void enter_child_first(ProgramWriter&, ir::NodeId);
    /// In the exit place of a state: the exit actions of its parents that run too early.
    void exit_outer_before(ProgramWriter&, ir::NodeId);
    /// In the exit place of a state: the actions of its outgoing transitions that run too early.
    void act_before(ProgramWriter&, ir::NodeId);
    /// A transition's action after the entry of its target.
    void act_late(ProgramWriter&, const ir::Transition&, const std::string& label);

private:
    OrderFaults& faults_;
    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
