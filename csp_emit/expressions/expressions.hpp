// Expressions of the model as CSPM expressions. Arithmetic is clipped to the carrier of its type by RoboTool's
// functions (semantics 3.13: Plus, Minus, Mult, Div, Modulus, Neg); reals are whole numbers of 1/scale.
#pragma once

#include <functional>

#include "csp_emit/base/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// What the names of an expression stand for at the place where it is emitted.
struct Scope {
    std::function<cspm::ExprPtr(ir::VariableId)> variable;
    std::function<cspm::ExprPtr(ir::ConstantId)> constant;
    std::function<cspm::ExprPtr(ir::ClockId)> clock;       ///< since(C)
    std::function<cspm::ExprPtr(ir::NodeId)> entry_clock;  ///< sinceEntry(S)
    cspm::ExprPtr trigger_value;
    bool placed = true;  ///< calls know their place in the model, for reports; not what no state evaluates
};

/// The expression; what CSPM cannot say is reported by name (RC-C01).
[[nodiscard]] cspm::ExprPtr expression(const Project&, const Scope&, const ir::Expr&);
/// The expression as a value of another numeric type: whole numbers become reals in units of 1/scale.
[[nodiscard]] cspm::ExprPtr expression_as(const Project&, const Scope&, const ir::Expr&, ir::TypeId wanted);
/// Preconditions of all functions the expressions call, for `pre &` (semantics 3.5); empty if there are none.
[[nodiscard]] std::vector<cspm::ExprPtr> preconditions(const Project&, const Scope&, const ir::Expr&);
/// The value `whole` of a type with `value` in place of one of its parts. The path leads to the part: the place of a
/// field or of a tuple's part (a number, fields from 0), the index of a sequence or vector, two indices of a matrix.
[[nodiscard]] cspm::ExprPtr component(const Project&, ir::TypeId type, const cspm::ExprPtr& whole,
                                      const std::vector<cspm::ExprPtr>& path, const cspm::ExprPtr& value);
/// CSPM name of a function of the model: `f`, in a package `P_f`; its precondition is `pre_` and that name.
[[nodiscard]] std::string function_name(const ir::Function&);

/// Calls `visit` on the expression and all its parts, outermost first.
void walk(const ir::Expr&, const std::function<void(const ir::Expr&)>& visit);
/// Whether a part of the expression satisfies the predicate.
[[nodiscard]] bool mentions(const ir::Expr&, const std::function<bool(const ir::Expr&)>& predicate);

}  // namespace robochart::csp_emit
