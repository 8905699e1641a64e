// SPDX-License-Identifier: Apache-2.0
// Writes the IR as text.
#pragma once

#include <string>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns the IR as text, for `--print ir`. Equal systems give equal texts. Each declaration is on one line, and
/// programs are indented.
[[nodiscard]] std::string dump_text(const System&);
/// Returns an expression on one line, with all parentheses. Variables and other elements have their names in the
/// machine. The machine may be null.
[[nodiscard]] std::string dump_text(const System&, const Machine*, const Expr&);
/// Returns the operator as `dump_text` writes it, such as "<=". If the form has no operator, returns a word, such as
/// "seq".
[[nodiscard]] const char* operator_text(ExprKind);

}  // namespace robochart::ir
