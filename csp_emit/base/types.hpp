// SPDX-License-Identifier: Apache-2.0
// Converts types of the model to CSPM sets, and values of the model to CSPM values (semantics 3.13).
#pragma once

#include "csp_emit/base/project.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Returns the finite set of a type's values: a name (core_nat, P_Colour) or an expression.
[[nodiscard]] cspm::ExprPtr type_set(const Project&, ir::TypeId);
/// Returns the CSPM expression for a value of a type.
[[nodiscard]] cspm::ExprPtr value_literal(const Project&, ir::TypeId, const ir::Value&);
/// Returns the value of a variable that has no initial value in the model (semantics 3.6).
[[nodiscard]] cspm::ExprPtr default_literal(const Project&, ir::TypeId);
/// Returns the CSPM name of a declared type: `P_T`.
[[nodiscard]] std::string type_name(const ir::Type&);
/// Returns the CSPM constructor of an enumeration literal: `P_E_L`.
[[nodiscard]] std::string literal_name(const ir::Type&, std::size_t literal);
/// Returns a tuple, or a single part unchanged (semantics 3.13: products, records, vectors and rows of matrices).
[[nodiscard]] cspm::ExprPtr tuple_or_one(const std::vector<cspm::ExprPtr>& parts);
/// True if the type is nat, int or real.
[[nodiscard]] bool is_numeric(const ir::Type&);

}  // namespace robochart::csp_emit
