// SPDX-License-Identifier: Apache-2.0
// Prints expressions, types and statements for dump.hpp (private to this component).
#pragma once

#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

[[nodiscard]] std::string type_text(const System&, TypeId);
[[nodiscard]] std::string expression_text(const System&, const Machine*, const Expr&);
/// Returns the expression as " WORD text", or "" if it is null.
[[nodiscard]] std::string clause_text(const System&, const Machine*, const char* word, const ExprPtr&);
[[nodiscard]] std::string communication_text(const System&, const Machine&, const Communication&);
/// Returns one line per statement, "point: text". Inner statements are indented further.
[[nodiscard]] std::string program_text(const System&, const Machine&, const Stmt&, std::size_t indent);

}  // namespace robochart::ir
