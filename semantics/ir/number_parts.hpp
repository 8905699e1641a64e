// SPDX-License-Identifier: Apache-2.0
// Finds the numbers in values of a type.
#pragma once

#include <compare>
#include <cstddef>
#include <vector>

#include "semantics/ir/ir.hpp"

namespace robochart::ir {

/// A number in a value: the value itself, or a part of it.
struct NumberPart {
    std::vector<std::size_t> path;  ///< the position of the part at each level, outermost first
    TypeKind kind = TypeKind::real;
    friend auto operator<=>(const NumberPart&, const NumberPart&) = default;
};

/// If the type is nat, int, real, or a product or record of such types, returns the numbers in a value of the type, in
/// their order. The result is empty for all other types.
[[nodiscard]] std::vector<NumberPart> number_parts(const System& system, TypeId type);

/// Returns true for sequences of nat, int or real.
[[nodiscard]] bool is_number_sequence(const System& system, TypeId type);

/// Returns true if the type or a part of the type is a type of numbers, or has no finite set of values.
[[nodiscard]] bool has_numbers(const System& system, TypeId type);

}  // namespace robochart::ir
