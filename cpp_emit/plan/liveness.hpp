// SPDX-License-Identifier: Apache-2.0
// Finds the variables of machines that no later cycle reads. They are members of Step instead of State. For example, a
// list of hundreds of items that one cycle receives and evaluates is not part of the state. This is the classical
// backward analysis of live variables over the control graph of the machine. A use that the analysis does not recognise
// is taken as a read.
#pragma once

#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Sets StoredVariable::local and Unit::awaited_locals. Considers only variables with lists, because the size of lists
/// has no small bound. The cycles of their machines must end only in states, in junctions, and at places that wait.
/// Precondition: the connections of the component are resolved, and its variables are collected.
void find_local_variables(Component&, const ir::System&);

}  // namespace robochart::cpp_emit
