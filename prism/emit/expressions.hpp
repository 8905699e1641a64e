// SPDX-License-Identifier: Apache-2.0
// Converts expressions of the IR to PRISM.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "prism/emit/context.hpp"

namespace robochart::prism_emit {

/// What names mean at the place of an expression.
struct Scope {
    std::function<std::string(ir::VariableId)> variable;  ///< empty if there are no variables
    std::function<std::string(ir::ConstantId)> constant;
    std::string element;                          ///< for findings
    std::string received;                         ///< the variable with the value that a trigger receives
    std::map<std::string, prism::ExprPtr> bound;  ///< parameters of a function
};

/// Translates the expression. The result is meaningless if findings were reported.
[[nodiscard]] prism::ExprPtr translate_expression(Context&, const Scope&, const ir::Expr&);
/// Translates a condition. R15: each comparison with a clock is `true`.
[[nodiscard]] prism::ExprPtr translate_condition(Context&, const Scope&, const ir::Expr&);
/// Translates the value of a variable. The value is a whole number even if the type is real.
[[nodiscard]] prism::ExprPtr whole_value(Context&, const Scope&, const ir::Expr&);

}  // namespace robochart::prism_emit
