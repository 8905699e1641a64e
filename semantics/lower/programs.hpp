// SPDX-License-Identifier: Apache-2.0
// Lowers statements and communications. Private to semantics/lower*.
#pragma once

#include "semantics/lower/expressions.hpp"

namespace robochart::ir {

/// Lowers one action. Statements are numbered from Machine::points on, each before the statements inside it. `element`
/// is the node or transition that has the action.
[[nodiscard]] StmtPtr lower_action(Lowering&, const Names&, const frontend::Stmt&, const std::string& element);
/// Lowers a trigger without its predicate, which becomes part of the guard.
[[nodiscard]] Communication lower_trigger(Lowering&, const Names&, const frontend::Communication&);
/// Lowers the duration of a wait or deadline, in whole time units.
[[nodiscard]] ExprPtr lower_duration(Lowering&, const Names&, const frontend::Expr&);

}  // namespace robochart::ir
