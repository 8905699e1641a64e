// SPDX-License-Identifier: Apache-2.0
// Decides where the order of actions is faulty when states are left and entered. The IR cannot express these faults. In
// production all answers are false.
#pragma once

#include "cpp_emit/machine/machine_context.hpp"

namespace robochart::cpp_emit {

/// Decides whether a node or transition has the fault. The answer for an element is always the same.
class OrderFaults : private MachineCodePart {
public:
    explicit OrderFaults(MachineContext& context) : MachineCodePart(context) {}

    /// Returns whether a composite state has Fault::entry_inner_first. Its initial node must lead unconditionally to a
    /// child.
    [[nodiscard]] bool enters_child_first(ir::NodeId);
    /// Returns the child that is entered first; invalid if there is none.
    [[nodiscard]] ir::NodeId sole_first_child(ir::NodeId) const;
    /// Returns whether a state has Fault::exit_outer_first: the composite's exit action runs before those of its inner
    /// states.
    [[nodiscard]] bool exits_first(ir::NodeId);
    /// Returns whether a transition has Fault::action_before_exit.
    [[nodiscard]] bool acts_first(const ir::Transition&);
    /// Returns whether a transition has Fault::action_after_entry.
    [[nodiscard]] bool acts_late(const ir::Transition&);
    /// Returns whether a state has Fault::composite_resumed: the composite state continues in its last inner state.
    [[nodiscard]] bool resumes_composite(ir::NodeId composite);
    /// Returns whether a state has Fault::children_not_exited.
    [[nodiscard]] bool skips_children(ir::NodeId left);
};

}  // namespace robochart::cpp_emit
