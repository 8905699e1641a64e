// SPDX-License-Identifier: Apache-2.0
// Reads values for the constants that a model or its properties do not define. Each constant has one value or a range.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "prism/explore/evaluation.hpp"

namespace robochart::prism {

/// Thrown if the given value of a constant is invalid.
class BadValue : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A constant with at least one value.
struct Series {
    std::string name;
    std::vector<Value> values;
};

/// Reads a text such as "N=4:6,T=0:10:100,p=1/3": single values, low:high or low:step:high. Each bound is an expression
/// without names. Only the constants in `open` are allowed. Throws BadValue.
[[nodiscard]] std::vector<Series> read_series(const std::string& text, const std::vector<Constant>& open);

/// Returns the constants without a definition.
[[nodiscard]] std::vector<Constant> open_constants(const std::vector<Constant>& constants);

/// Returns every combination of the values; the last series varies fastest. Returns one empty combination if there is
/// no series. Throws BadValue if there are too many combinations.
[[nodiscard]] std::vector<Values> combinations(const std::vector<Series>& series);

}  // namespace robochart::prism
