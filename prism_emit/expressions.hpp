// Expressions of the IR in PRISM.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "prism_emit/context.hpp"

namespace robochart::prism_emit {

/// What the names of an expression mean where it stands.
struct Scope {
    std::function<std::string(ir::VariableId)> variable;  ///< none: there are no variables
    std::function<std::string(ir::ConstantId)> constant;
    std::string element;                          ///< for findings
    std::string received;                         ///< the variable that holds what a trigger receives
    std::map<std::string, prism::ExprPtr> bound;  ///< parameters of a function
};

/// The expression. After findings, some expression.
[[nodiscard]] prism::ExprPtr expression(Context&, const Scope&, const ir::Expr&);
/// A condition; R15: each comparison of a clock is `true`.
[[nodiscard]] prism::ExprPtr condition(Context&, const Scope&, const ir::Expr&);
/// The value of a variable: of type real too, a whole number.
[[nodiscard]] prism::ExprPtr whole_value(Context&, const Scope&, const ir::Expr&);

}  // namespace robochart::prism_emit
