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

/// Translates the expression. If there are findings, the result has no meaning.
[[nodiscard]] prism::ExprPtr translate_expression(Context&, const Scope&, const ir::Expr&);
/// Translates a condition. R15: each comparison with a clock is `true`.
[[nodiscard]] prism::ExprPtr translate_condition(Context&, const Scope&, const ir::Expr&);
/// Translates the value of a variable, which is a whole number even for type real.
[[nodiscard]] prism::ExprPtr whole_value(Context&, const Scope&, const ir::Expr&);

}  // namespace robochart::prism_emit
