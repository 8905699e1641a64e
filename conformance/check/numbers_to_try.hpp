// SPDX-License-Identifier: Apache-2.0
// Chooses the numbers with which code over the types of deployment is run (docs/conformance.md, "Numbers on the
// robot"): numbers at the boundaries of the regions in which no condition changes its answer, and random numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "semantics/data/value_model.hpp"
#include "semantics/ir/number_parts.hpp"

namespace robochart::conformance {

/// A number of the model, and the number of the code that stands for it.
struct TriedNumber {
    std::int64_t bits = 0;              ///< of the code's number: a double, or a 64-bit integer
    std::optional<std::int64_t> units;  ///< the model's number, if it is a decimal; otherwise it is the code's number
};
/// One number for each part of a value.
using TriedValue = std::vector<TriedNumber>;

/// A set of values for which all conditions and comparisons have the same answers.
struct TriedRegion {
    bool boundary = false;            ///< the linear form of some condition is 0 in this region
    std::vector<std::size_t> places;  ///< the explored values in this region, by index
    std::vector<TriedValue> values;   ///< first those of the places, in their order
};

/// The type of the numbers, and the conditions about them.
struct NumberSpace {
    std::vector<ir::NumberPart> parts;
    std::vector<ir::Cut> cuts;
    std::int64_t scale = 1;  ///< the number of units that represent 1; a power of ten
};
/// The numbers and conditions of a type. `type` is the index of the type in ValueModel::types.
[[nodiscard]] NumberSpace number_space(const ir::System& system, const ir::ValueModel& model, std::size_t type);

/// The exact sign of the form of a cut: -1, 0 or 1. The value consists of finite numbers.
[[nodiscard]] int sign_of(const NumberSpace& space, const ir::Cut& cut, const TriedValue& value);
/// The double nearest to a decimal literal.
[[nodiscard]] double nearest_double(const std::string& decimal);
/// Converts a number of the model to the code's number: a real, in units, to the nearest double. A whole number is not
/// changed.
[[nodiscard]] TriedNumber nearest_number(const NumberSpace& space, const ir::NumberPart& part, std::int64_t number);
/// Converts each part of a value in this way; reals are in units.
[[nodiscard]] TriedValue nearest_value(const NumberSpace& space, const std::vector<std::int64_t>& numbers);
/// The model's value, as in "(0.1, 0.30000000000000004)".
[[nodiscard]] std::string value_text(const NumberSpace& space, const TriedValue& value);

/// The explored values, up to `random` further values of each region, and the adjacent numbers on both sides of each
/// number that lies on the boundary of a condition. The same arguments give the same values.
[[nodiscard]] std::vector<TriedRegion> numbers_to_try(const NumberSpace& space, const ir::ExploredValues& explored,
                                                      std::size_t random, diagnostics::Pollable& budget);

}  // namespace robochart::conformance
