// SPDX-License-Identifier: Apache-2.0
// Shows the shape of a syntax tree as nested brackets, `(kind part …)`. It is independent of the printer, so tests show
// precedence and every field.
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend::testing {

/// Returns the tree, with `_` for an absent part.
[[nodiscard]] std::string tree(const Expr& expr);
[[nodiscard]] std::string tree(const TypeExpr& type);
[[nodiscard]] std::string tree(const Stmt& statement);
[[nodiscard]] std::string tree(const Communication& communication);

}  // namespace robochart::frontend::testing
