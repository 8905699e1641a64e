// SPDX-License-Identifier: Apache-2.0
// Lowers the registers of RoboSim's machines and operations, and the lengths of cycles. Private to semantics/lower*.
#pragma once

#include <string>
#include <vector>

#include "semantics/lower/machines.hpp"

namespace robochart::ir {

/// Adds the variables, events, operations and inputs of both contexts, and their names.
void add_registers(Lowering&, const frontend::Machine&, const std::string& element, Declarations&,
                   std::vector<Input>& inputs);
/// Lowers the length e in `cycle == e`, `{ cycle == e }` or `e`.
[[nodiscard]] ExprPtr lower_cycle_length(Lowering&, const Names&, const frontend::Expr&);
/// Returns the constant cycle_length of a component. Its value is null if the component has no `cycleDef`. `required`
/// is true if the value comes from the enclosing component, if there is one.
[[nodiscard]] Constant cycle_constant(Lowering&, const Names&, const frontend::Context&, bool required);

}  // namespace robochart::ir
