// Seeded faults of order, which the IR cannot express: what comes first when states are left and entered. In
// production the answer is always no.
#pragma once

#include "cpp_emit/machine/machine_context.hpp"

namespace robochart::cpp_emit {

/// Whether a node or transition has the fault. The answer for one is the same each time it is asked.
class OrderFaults : private MachineCodePart {
public:
    explicit OrderFaults(MachineContext& context) : MachineCodePart(context) {}

    /// Fault::entry_inner_first at a composite whose initial node leads to a child without more ado.
    [[nodiscard]] bool enters_child_first(ir::NodeId);
    /// That child; invalid if there is none.
    [[nodiscard]] ir::NodeId sole_first_child(ir::NodeId) const;
    /// Fault::exit_outer_first: the composite's exit action has run before those below it.
    [[nodiscard]] bool exits_first(ir::NodeId);
    /// Fault::action_before_exit.
    [[nodiscard]] bool acts_first(const ir::Transition&);
    /// Fault::action_after_entry.
    [[nodiscard]] bool acts_late(const ir::Transition&);
    /// Fault::composite_resumed: the composite continues where it was.
    [[nodiscard]] bool resumes(ir::NodeId composite);
    /// Fault::children_not_exited.
    [[nodiscard]] bool skips_children(ir::NodeId left);
};

}  // namespace robochart::cpp_emit
