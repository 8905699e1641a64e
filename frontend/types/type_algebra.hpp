// SPDX-License-Identifier: Apache-2.0
// Constructs and combines semantic types (private to the front end).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "frontend/types/types.hpp"

namespace robochart::frontend {

[[nodiscard]] TypePtr make_type(TypeForm form, std::vector<TypePtr> args = {});
[[nodiscard]] TypePtr make_vector(TypePtr element, long size);
[[nodiscard]] TypePtr make_matrix(TypePtr element, long rows, long columns);
/// Returns the component of a product with one component, and every other type unchanged.
[[nodiscard]] TypePtr simplify_type(const TypePtr& type);
[[nodiscard]] bool is_number(const TypePtr& type);
/// Returns a set, relation, function or sequence type as a set type, or null for other types.
[[nodiscard]] TypePtr as_set(const TypePtr& type);
/// Returns a product, vector or matrix type as a product type, or null for other types.
[[nodiscard]] TypePtr as_product(const TypePtr& type);
/// Returns the smallest type that contains both, or null if there is none.
[[nodiscard]] TypePtr join_types(const TypePtr& a, const TypePtr& b);

/// The types that the type variables of a generic function have in a call.
using TypeBindings = std::map<std::string, TypePtr>;
/// Matches an argument type with a parameter type and binds type variables. Returns false if it does not match.
[[nodiscard]] bool match_types(const TypePtr& formal, const TypePtr& actual, TypeBindings& bindings);
/// Returns the type with bound variables replaced. Unbound variables become `any`; unbound numeric variables become
/// `nat`, which fits every number.
[[nodiscard]] TypePtr substitute_variables(const TypePtr& type, const TypeBindings& bindings);

}  // namespace robochart::frontend
