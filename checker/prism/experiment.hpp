// Values for the constants that a model or its properties leave open: one each, or a range to try.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "checker/prism/explore/evaluation.hpp"

namespace robochart::prism {

/// What was given for a constant is no value for it.
class BadValue : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// A constant with the values it takes, at least one.
struct Series {
    std::string name;
    std::vector<Value> values;
};

/// Reads "N=4:6,T=0:10:100,p=1/3": single values, low:high, low:step:high; each side an expression without names.
/// Only constants in `open` are known. Throws BadValue.
[[nodiscard]] std::vector<Series> read_series(const std::string& text, const std::vector<Constant>& open);

/// The constants without a value of their own.
[[nodiscard]] std::vector<Constant> open_constants(const std::vector<Constant>& constants);

/// Every combination of the values; the last series changes fastest. One empty combination where there is no series.
/// Throws BadValue where there are too many.
[[nodiscard]] std::vector<Values> combinations(const std::vector<Series>& series);

}  // namespace robochart::prism
