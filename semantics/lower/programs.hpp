// SPDX-License-Identifier: Apache-2.0
// Statements and communications. Private to semantics/lower*.
#pragma once

#include "semantics/lower/expressions.hpp"

namespace robochart::ir {

/// Lowers one action. Statements are numbered from Machine::points; a statement is numbered before those inside it.
/// `element` is the node or transition that has the action.
[[nodiscard]] StmtPtr lower_action(Lowering&, const Names&, const frontend::Stmt&, const std::string& element);
/// A trigger without its predicate (which belongs to the guard).
[[nodiscard]] Communication lower_trigger(Lowering&, const Names&, const frontend::Communication&);
/// A duration in whole time units: wait, deadline.
[[nodiscard]] ExprPtr lower_duration(Lowering&, const Names&, const frontend::Expr&);

}  // namespace robochart::ir
