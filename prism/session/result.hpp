// SPDX-License-Identifier: Apache-2.0
// Declares the result of a property.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "prism/explore/real.hpp"
#include "prism/sampling/estimate.hpp"
#include "prism/syntax/syntax.hpp"

namespace robochart::prism {

struct Result {
    enum class Kind : std::uint8_t {
        truth,   ///< the result is true or false
        number,  ///< `low` is the value, or an enclosure of it
        range,   ///< from `low` to `high`, over several states
        states,  ///< the states in `printed`, which have the least or the greatest value
        unknown  ///< `reason` contains the cause
    };
    Kind kind = Kind::unknown;
    bool truth = false;
    Type type = Type::boolean;  ///< for numbers: integer or real
    Real low, high;
    std::string where;   ///< for a false result: a state in which it does not hold
    std::string reason;  ///< for unknown results; for numbers: why an enclosure is wider than requested, otherwise ""
    std::vector<std::pair<std::string, std::string>> printed;  ///< for filters: states with values
    std::optional<Estimate> estimate;  ///< for samples: the number is their mean, and the result is not certain
};

}  // namespace robochart::prism
