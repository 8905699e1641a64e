// Building and combining semantic types (private to the front end).
#pragma once

#include <map>
#include <string>
#include <vector>

#include "frontend/types/types.hpp"

namespace robochart::frontend {

[[nodiscard]] TypePtr make_type(TypeForm form, std::vector<TypePtr> args = {});
[[nodiscard]] TypePtr make_vector(TypePtr element, long size);
[[nodiscard]] TypePtr make_matrix(TypePtr element, long rows, long columns);
/// A product of one type is that type.
[[nodiscard]] TypePtr simplify(const TypePtr& type);
[[nodiscard]] bool is_number(const TypePtr& type);
/// Sets, relations, functions and sequences as the set they are; null for others.
[[nodiscard]] TypePtr as_set(const TypePtr& type);
/// Products, vectors and matrices as products; null for others.
[[nodiscard]] TypePtr as_product(const TypePtr& type);
/// The smallest type both fit in; null if there is none.
[[nodiscard]] TypePtr joined(const TypePtr& a, const TypePtr& b);

/// What type variables of a generic function stand for in a call.
using TypeBindings = std::map<std::string, TypePtr>;
/// Fits an argument to a parameter's type, binding variables. False if it does not fit.
[[nodiscard]] bool match(const TypePtr& formal, const TypePtr& actual, TypeBindings& bindings);
/// The type with bound variables replaced; unbound ones become `any`, unbound numbers `nat`, which fits every number.
[[nodiscard]] TypePtr substitute(const TypePtr& type, const TypeBindings& bindings);

}  // namespace robochart::frontend
