// Values with parts: building and taking apart (private to this component).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "semantics/evaluate/environment.hpp"

namespace robochart::ir {

/// The set of some values: ascending, without duplicates.
[[nodiscard]] Value set_of(std::vector<Value> members);
/// Elements row by row as rows of so many columns.
[[nodiscard]] Value matrix_of(std::vector<Value> elements, std::int64_t columns);
/// { low to high }. Throws std::length_error when it is huge.
[[nodiscard]] Value range_set(std::int64_t low, std::int64_t high, diagnostics::Span where);
/// A sequence as the set of its pairs of place and element.
[[nodiscard]] Value pairs_of(const Value& sequence);
/// The characters of a string as parts.
[[nodiscard]] Value string_value(const diagnostics::ForeignText&);
/// The part at a 1-based place; a fault outside.
[[nodiscard]] Value part(const Value& whole, std::int64_t place, diagnostics::Span where);
/// A function value (pairs) at its arguments; a fault outside its domain.
[[nodiscard]] Value applied(const Value& function, const std::vector<Value>& arguments, diagnostics::Span where);
/// Whether `whole` has `item` among its parts.
[[nodiscard]] bool is_part(const Value& whole, const Value& item);
/// The bound values from index `from` on: one as it is, several as a tuple.
[[nodiscard]] Value bound_tuple(const std::vector<std::pair<std::string, Value>>& bindings, std::size_t from);

}  // namespace robochart::ir
