// SPDX-License-Identifier: Apache-2.0
// Writes the control and during threads: entry, exit and transition actions in the order of semantics 3.4. The order
// is: exits (innermost first), the transition's action, the target's entry, the initial transition and the first child,
// and then the target is entered (`entered`).
#pragma once

#include "cpp_emit/machine/order_fault_code.hpp"
#include "cpp_emit/machine/straight_code.hpp"

namespace robochart::cpp_emit {

/// Writes the places of the threads, and the functions for programs that never wait.
class ControlCode : private MachineCodePart {
public:
    ControlCode(MachineContext& context, OrderFaults& faults, ControlSteps& steps)
        : MachineCodePart(context),
          faults_(faults),
          steps_(steps),
          straight_(context, faults, steps),
          order_(context, faults, steps) {}

    /// Writes all functions and places of nodes and transitions.
    void control_places();
    /// Writes the programs of the during actions.
    void during_places();

private:
    void write_choice(ir::NodeId);
    void await_cycle(ProgramWriter&);
    void draw_place(ir::NodeId);
    void enter_place(ir::NodeId);
    void write_exits(ir::NodeId);
    void exit_place(ir::NodeId);
    void write_taking(ir::TransitionId);
    void take_place(ir::TransitionId);
    [[nodiscard]] ir::NodeId shown_while_taking(ir::TransitionId) const;

    OrderFaults& faults_;
    ControlSteps& steps_;
    StraightCode straight_;
    OrderFaultCode order_;
};

}  // namespace robochart::cpp_emit
