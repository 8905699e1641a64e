// SPDX-License-Identifier: Apache-2.0
// Finds the variables whose lists have no bound in the model. An assignment may lengthen such a list each time it is
// executed, or the list is the result of a function of the platform. For such lists, generated code has the usual
// capacity (list_capacities.hpp).
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// An assignment after which the lists of a variable may be longer than any bound.
struct ListGrowth {
    ir::VariableId variable;
    diagnostics::Span span;  ///< place of the assigned value
    std::string reason;      ///< for messages: "this assignment may make the list longer each time"
};

/// Returns the assignments of a machine that let a list grow, in textual order. An assignment lengthens a list if it
/// joins lists and one of them may come from the assigned variable, directly or through other variables of the machine.
[[nodiscard]] std::vector<ListGrowth> growing_lists(const ir::System&, const ir::Machine&);

}  // namespace robochart::cpp_emit
