// Seeded faults in machines: the machine that a faulty generator would have read, as far as the IR can express what it
// does wrong. What goes wrong below the IR (order of exits, places, dispatch) is asked of Mutation by the emitters.
#pragma once

#include "cpp_emit/faults/mutation.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// The machine of a unit with the fault: the same variables, clocks, events, nodes and transitions under the same
/// numbers, so that the unit's plan is one of it too. Nodes go before transitions, in each the textual order.
[[nodiscard]] ir::Machine faulty_machine(const ir::System&, const ir::Instantiation&, const Component&, const Unit&,
                                         Mutation&);

}  // namespace robochart::cpp_emit
