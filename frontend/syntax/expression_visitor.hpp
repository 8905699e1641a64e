// SPDX-License-Identifier: Apache-2.0
// Visits all parts of statements and expressions. The recursion is bounded, because the parser limits nesting.
#pragma once

#include <functional>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Calls `visit` for the expression and everything below it, outermost first.
void walk_tree(const Expr& expr, const std::function<void(const Expr&)>& visit);
/// Calls `visit` for the direct parts of an expression.
void for_children(const Expr& expr, const std::function<void(const Expr&)>& visit);
/// Calls `visit` for the statement and every statement inside it.
void walk_tree(const Stmt& statement, const std::function<void(const Stmt&)>& visit);
/// Calls `visit` for the expressions of a statement, without those of the statements inside it.
void for_expressions(const Stmt& statement, const std::function<void(const Expr&)>& visit);
/// Calls `visit` for every container of a machine: first the machine, then composite states from the outermost to the
/// innermost, in textual order.
void walk_tree(const NodeContainer& top, const std::function<void(const NodeContainer&)>& visit);
/// Calls `visit` for every action of the states and transitions of a machine.
void for_actions(const NodeContainer& top, const std::function<void(const Stmt&)>& visit);
/// Calls `visit` for every transition of a machine.
void for_transitions(const NodeContainer& top, const std::function<void(const Transition&)>& visit);
/// Calls `visit` for every state of a machine, without its initial and final nodes and junctions.
void for_states(const NodeContainer& top, const std::function<void(const State&)>& visit);

}  // namespace robochart::frontend
