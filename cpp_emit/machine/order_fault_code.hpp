// The code of seeded faults of order, where programs may wait.
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes what a fault of OrderFaults puts at another place.
class OrderFaultCode : private MachineCodePart {
public:
    OrderFaultCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context), faults_(faults), steps_(steps) {}

    /// The entry of a composite and its first child, the child before.
    void enter_child_first(ProgramWriter&, ir::NodeId);
    /// In the exit place of a state: the exit actions of the composites around it that come too soon.
    void exit_outer_before(ProgramWriter&, ir::NodeId);
    /// In the exit place of a state: the actions of the transitions out of it that come too soon.
    void act_before(ProgramWriter&, ir::NodeId);
    /// A transition's action behind the entry of its target.
    void act_late(ProgramWriter&, const ir::Transition&, const std::string& label);

private:
    OrderFaults& faults_;
    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
