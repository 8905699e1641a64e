// SPDX-License-Identifier: Apache-2.0
// Lists the values of a type in a finite instantiation.
#pragma once

#include <cstddef>
#include <vector>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// Returns all values of a type in ascending order. The first value is not necessarily the default value. Throws
/// std::length_error if there are more than `limit`.
[[nodiscard]] std::vector<Value> carrier_values(const System&, const Instantiation&, TypeId,
                                                std::size_t limit = 1U << 20U);
/// Returns the initial value of a variable for which the model gives none (semantics 3.6): 0, true, the first literal,
/// the empty sequence or the empty set.
[[nodiscard]] Value default_value(const System&, const Instantiation&, TypeId);
/// True if a value belongs to the finite carrier of a type.
[[nodiscard]] bool in_carrier(const System&, const Instantiation&, TypeId, const Value&);

}  // namespace robochart::ir
