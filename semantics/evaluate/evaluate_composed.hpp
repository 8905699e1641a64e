// SPDX-License-Identifier: Apache-2.0
// Constructs composed values and accesses their parts (private to this component).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "semantics/evaluate/environment.hpp"

namespace robochart::ir {

/// Returns the set of these values: ascending, without duplicates.
[[nodiscard]] Value set_of(std::vector<Value> members);
/// Returns a matrix from its elements, which are given row by row.
[[nodiscard]] Value matrix_of(std::vector<Value> elements, std::int64_t columns);
/// Returns the set { low to high }. Throws std::length_error if it is too large.
[[nodiscard]] Value range_set(std::int64_t low, std::int64_t high, diagnostics::Span where);
/// Returns a sequence as the set of its pairs of position and element.
[[nodiscard]] Value pairs_of(const Value& sequence);
/// Returns a string as a value with one part per character.
[[nodiscard]] Value string_value(const diagnostics::ForeignText&);
/// Returns the part at a 1-based position. A position that does not exist is a fault.
[[nodiscard]] Value part_at(const Value& whole, std::int64_t place, diagnostics::Span where);
/// Applies a function value (a set of pairs) to arguments. Arguments outside its domain are a fault.
[[nodiscard]] Value apply_function(const Value& function, const std::vector<Value>& arguments, diagnostics::Span where);
/// True if `item` is one of the parts of `whole`.
[[nodiscard]] bool is_part(const Value& whole, const Value& item);
/// Returns the bound values from index `from` on: a single value unchanged, or several values as a tuple.
[[nodiscard]] Value bound_tuple(const std::vector<std::pair<std::string, Value>>& bindings, std::size_t from);

}  // namespace robochart::ir
