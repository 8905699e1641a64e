// The answer to a property.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "checker/prism/explore/real.hpp"
#include "checker/prism/sampling/estimate.hpp"
#include "checker/prism/syntax/syntax.hpp"

namespace robochart::prism {

struct Result {
    enum class Kind : std::uint8_t {
        truth,   ///< it holds, or not
        number,  ///< `low` is the value, or an enclosure of it
        range,   ///< from `low` to `high`, over several states
        states,  ///< those of `printed`, which have the least or the greatest value
        unknown  ///< `reason` says why
    };
    Kind kind = Kind::unknown;
    bool truth = false;
    Type type = Type::boolean;  ///< of numbers: integer or real
    Real low, high;
    std::string where;   ///< of what does not hold: a state in which it does not
    std::string reason;  ///< of unknown; of numbers: why an enclosure is wider than asked for, "" where none is
    std::vector<std::pair<std::string, std::string>> printed;  ///< by filters: states with values
    std::optional<Estimate> estimate;  ///< of samples: the number is their mean, and nothing is certain
};

}  // namespace robochart::prism
