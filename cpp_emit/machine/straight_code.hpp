// SPDX-License-Identifier: Apache-2.0
// Writes programs that never wait as functions. A transition whose exits, action and entries never wait is one straight
// effect, in the order of semantics 3.4 (exits from the innermost outwards, action, entries).
#pragma once

#include "cpp_emit/machine/control_steps.hpp"

namespace robochart::cpp_emit {

/// Writes the functions one by one.
class StraightCode : private MachineCodePart {
public:
    StraightCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context), faults_(faults), steps_(steps) {}

    /// Writes the function that enters a node.
    void enter_function(ir::NodeId);
    /// Writes the function with the exit action of a state.
    void exit_function(ir::NodeId);
    /// Writes the function with the exits of a composite state, from the innermost active state outwards.
    void leave_function(ir::NodeId);
    /// Writes the function with the action of a transition, followed by the entry of its target.
    void take_function(ir::TransitionId);
    /// Writes the function for an initial node or junction. Returns true if control may have to stay there.
    bool pass_function(ir::NodeId);

private:
    void straight_function(const std::string& name, const diagnostics::ForeignText& comment);

    OrderFaults& faults_;
    ControlSteps& steps_;
};

}  // namespace robochart::cpp_emit
