// SPDX-License-Identifier: Apache-2.0
// Chooses the numbers with which code is tested that uses the number types of the robot (docs/conformance.md, "Numbers
// on the robot"). A region is a set of numbers for which each condition has the same answer. The chosen numbers are
// random numbers, and numbers at the boundaries of regions.
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

/// A number of the code, and the number of the model that it represents.
struct TriedNumber {
    std::int64_t bits = 0;              ///< bits of the code's number: a double, or a 64-bit integer
    std::optional<std::int64_t> units;  ///< the model's number if it is a decimal; no value: equal to the code's
};
/// One number for each part of a value, or for each item of a sequence.
using TriedValue = std::vector<TriedNumber>;

/// A set of values for which each condition and comparison has the same answer.
struct TriedRegion {
    bool boundary = false;            ///< the linear form of some condition is 0 in this region
    std::vector<std::size_t> places;  ///< indices of the explored values in this region
    std::vector<TriedValue> values;   ///< first the explored values, in the order of `places`
};

/// The type of the numbers, and the conditions about them.
struct NumberSpace {
    std::vector<ir::NumberPart> parts;  ///< one part for sequences: all items have its kind
    std::vector<ir::Cut> cuts;
    std::int64_t scale = 1;         ///< the number of units that represent 1; a power of ten
    bool sequences = false;         ///< true if the values are sequences of numbers
    std::size_t most_items = 4096;  ///< the length of the longest sequence

    [[nodiscard]] const ir::NumberPart& part(std::size_t number) const { return parts.at(sequences ? 0 : number); }
};
/// Returns the numbers and conditions of a type. `type` is the index of the type in ValueModel::types.
[[nodiscard]] NumberSpace number_space(const ir::System& system, const ir::ValueModel& model, std::size_t type);

/// Returns the exact sign of a cut's form for this value: -1, 0 or 1; or 2 if the cut reads a window that contains no
/// place of the sequence. The value must consist of finite numbers.
[[nodiscard]] int sign_of(const NumberSpace& space, const ir::Cut& cut, const TriedValue& value);
/// Returns the double nearest to a decimal literal.
[[nodiscard]] double nearest_double(const std::string& decimal);
/// Converts a number of the model to the number of the code. A real (in units) becomes the nearest double. A whole
/// number does not change.
[[nodiscard]] TriedNumber nearest_number(const NumberSpace& space, const ir::NumberPart& part, std::int64_t number);
/// Converts each part of a value as nearest_number does. Reals are in units.
[[nodiscard]] TriedValue nearest_value(const NumberSpace& space, const std::vector<std::int64_t>& numbers);
/// Returns the model's value as text, such as "(0.1, 0.30000000000000004)" or "<30 times 0.1, 0.2>".
[[nodiscard]] std::string value_text(const NumberSpace& space, const TriedValue& value);

/// Returns the explored values, up to `random` further values of each region, and the numbers next to each number on
/// the boundary of a condition. The same arguments give the same values.
[[nodiscard]] std::vector<TriedRegion> numbers_to_try(const NumberSpace& space, const ir::ExploredValues& explored,
                                                      std::size_t random, diagnostics::Pollable& budget);

}  // namespace robochart::conformance
