// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/operators/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace robochart::markov {
namespace {

std::vector<Enclosure> enclosures(const Result<Interval>& result) {
    std::vector<Enclosure> values;
    values.reserve(result.values.size());
    for (State state = 0; state < result.values.size(); ++state)
        values.push_back(!result.infinite.empty() && result.infinite[state] ? Enclosure{infinity, infinity}
                                                                            : result.values[state].enclosure());
    return values;
}

double greatest_width(const std::vector<Enclosure>& values) {
    double width = 0;
    for (const Enclosure& value : values) width = std::max(width, value.relative_width());
    return width;
}

}  // namespace

Solution solve_precisely(const Precision& precision,
                         const std::function<Result<Interval>(const Precision&)>& operation) {
    constexpr double share = 64;
    constexpr double finest = 1e-15;
    Precision working_precision = precision;
    working_precision.relative = std::max(precision.relative / share, finest);
    while (true) {
        Result<Interval> result;
        {
            const RoundUpward mode;
            result = operation(working_precision);
        }
        Solution solution{enclosures(result), std::move(result.strategy), std::move(result.shortfall)};
        const double width = greatest_width(solution.values);
        if (width <= precision.relative) {
            solution.shortfall.clear();
            return solution;
        }
        if (solution.shortfall.empty() && working_precision.relative <= finest)
            solution.shortfall = fmt::format("rounding allows no relative width under {:.1e}", width);
        if (!solution.shortfall.empty()) return solution;
        working_precision.relative = std::max(working_precision.relative / 1e3, finest);
    }
}

}  // namespace robochart::markov
