// Visiting every part of statements and expressions. Depth is bounded by the parser.
#pragma once

#include <functional>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend {

/// Calls `visit` for the expression and everything below it, outermost first.
void walk(const Expr& expr, const std::function<void(const Expr&)>& visit);
/// The direct parts of an expression.
void for_children(const Expr& expr, const std::function<void(const Expr&)>& visit);
/// Calls `visit` for the statement and every statement inside it.
void walk(const Stmt& statement, const std::function<void(const Stmt&)>& visit);
/// The expressions that stand directly in a statement (not in statements inside it).
void for_expressions(const Stmt& statement, const std::function<void(const Expr&)>& visit);
/// Every container of a machine: itself, then composite states outside in, in textual order.
void walk(const NodeContainer& top, const std::function<void(const NodeContainer&)>& visit);
/// Every action statement of a machine: of states and transitions.
void for_actions(const NodeContainer& top, const std::function<void(const Stmt&)>& visit);

}  // namespace robochart::frontend
