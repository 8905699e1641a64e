// SPDX-License-Identifier: Apache-2.0
// Translates expressions of the model to CSPM. RoboTool's functions clip arithmetic to the carrier of its type
// (semantics 3.13: Plus, Minus, Mult, Div, Modulus, Neg). Reals are integers in units of 1/scale.
#pragma once

#include <functional>

#include "csp_emit/base/project.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// The meanings of the names in an emitted expression.
struct Scope {
    std::function<cspm::ExprPtr(ir::VariableId)> variable;
    std::function<cspm::ExprPtr(ir::ConstantId)> constant;
    std::function<cspm::ExprPtr(ir::ClockId)> clock;       ///< since(C)
    std::function<cspm::ExprPtr(ir::NodeId)> entry_clock;  ///< sinceEntry(S)
    cspm::ExprPtr trigger_value;
    bool placed = true;  ///< calls carry their place in the model for reports; false for expressions that no state
                         ///< evaluates
};

/// Translates the expression. Constructs that CSP cannot express are reported by name (RC-C01).
[[nodiscard]] cspm::ExprPtr translate_expression(const Project&, const Scope&, const ir::Expr&);
/// Returns the expression converted to another numeric type: integers become reals in units of 1/scale.
[[nodiscard]] cspm::ExprPtr expression_as(const Project&, const Scope&, const ir::Expr&, ir::TypeId type);
/// Returns the value of an event, converted to the type of the variable that receives it. If the scale is not 1, a
/// variable of whole numbers cannot receive a real, and the reception is rejected by name (RC-C01).
[[nodiscard]] cspm::ExprPtr received_as(const Project&, const cspm::ExprPtr& value, ir::TypeId event,
                                        ir::TypeId variable, diagnostics::Span reception);
/// Returns the preconditions of all functions that the expression calls, for `pre &` (semantics 3.5). The result is
/// empty if there are none.
[[nodiscard]] std::vector<cspm::ExprPtr> translate_preconditions(const Project&, const Scope&, const ir::Expr&);
/// Returns the value `whole` with `value` in place of one part. `path` selects the part. Its elements are positions of
/// fields (numbers from 0) and of tuple parts, the index of a sequence or vector, and two indices of a matrix.
[[nodiscard]] cspm::ExprPtr replace_component(const Project&, ir::TypeId type, const cspm::ExprPtr& whole,
                                              const std::vector<cspm::ExprPtr>& path, const cspm::ExprPtr& value);
/// Returns the CSPM name of a function of the model: `f`, or `P_f` in a package. The name of its precondition is `pre_`
/// followed by this name.
[[nodiscard]] std::string function_name(const ir::Function&);

/// Calls `visit` on the expression and all its parts, outermost first.
void walk_parts(const ir::Expr&, const std::function<void(const ir::Expr&)>& visit);
/// True if some part of the expression satisfies the predicate.
[[nodiscard]] bool has_part(const ir::Expr&, const std::function<bool(const ir::Expr&)>& predicate);

}  // namespace robochart::csp_emit
