// SPDX-License-Identifier: Apache-2.0
// Seeds faults in machines: rewrites a machine as a faulty generator would read it. The IR must be able to express the
// fault. For other faults (order of exits, places, dispatch), the emitters call Mutation.
#pragma once

#include "cpp_emit/faults/mutation.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns the machine of a unit with the fault. It has the same variables, clocks, events, nodes and transitions under
/// the same numbers, so the unit's plan is valid for it. Nodes are visited before transitions, both in textual order.
[[nodiscard]] ir::Machine faulty_machine(const ir::System&, const ir::Instantiation&, const Component&, const Unit&,
                                         Mutation&);

}  // namespace robochart::cpp_emit
