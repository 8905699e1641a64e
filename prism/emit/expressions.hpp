// SPDX-License-Identifier: Apache-2.0
// Converts expressions of the IR to PRISM.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "prism/emit/context.hpp"

namespace robochart::prism_emit {

/// The meaning of the names at the place of an expression.
struct Scope {
    std::function<std::string(ir::VariableId)> variable;  ///< none: no variables
    std::function<std::string(ir::ConstantId)> constant;
    std::string element;                          ///< for findings
    std::string received;                         ///< the variable with the value that a trigger receives
    std::map<std::string, prism::ExprPtr> bound;  ///< parameters of a function
};

/// The expression. If there are findings, the result is some expression.
[[nodiscard]] prism::ExprPtr expression(Context&, const Scope&, const ir::Expr&);
/// A condition. R15: each comparison with a clock is `true`.
[[nodiscard]] prism::ExprPtr condition(Context&, const Scope&, const ir::Expr&);
/// The value of a variable: a whole number, also for type real.
[[nodiscard]] prism::ExprPtr whole_value(Context&, const Scope&, const ir::Expr&);

}  // namespace robochart::prism_emit
