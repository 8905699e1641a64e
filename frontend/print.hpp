// Tree parts back as RoboChart text on one line: for dumps, messages and reports.
#pragma once

#include <string>
#include <string_view>

#include "frontend/ast.hpp"

namespace robochart::frontend {

[[nodiscard]] std::string to_text(const TypeExpr& type);
[[nodiscard]] std::string to_text(const Expr& expr);
[[nodiscard]] std::string to_text(const Communication& communication);
[[nodiscard]] std::string to_text(const Stmt& statement);
/// The operator as written, e.g. "/\\".
[[nodiscard]] std::string_view to_text(BinaryOp op);
/// The keyword or words for a kind of declaration, e.g. "stm", "robotic platform".
[[nodiscard]] std::string_view to_text(DeclKind kind);

}  // namespace robochart::frontend
