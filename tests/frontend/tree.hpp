// The shape of a syntax tree as nested brackets, `(kind part …)`: independent of the printer, so that precedence and
// every field show in tests.
#pragma once

#include <string>

#include "frontend/syntax/ast.hpp"

namespace robochart::frontend::testing {

/// `_` stands for a part that is absent.
[[nodiscard]] std::string tree(const Expr& expr);
[[nodiscard]] std::string tree(const TypeExpr& type);
[[nodiscard]] std::string tree(const Stmt& statement);
[[nodiscard]] std::string tree(const Communication& communication);

}  // namespace robochart::frontend::testing
