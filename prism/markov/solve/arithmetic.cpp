// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/arithmetic.hpp"

namespace robochart::markov {

std::vector<Interval> convert_numbers(const std::vector<Number>& numbers, const std::vector<Rational>&,
                                      const Interval&) {
    std::vector<Interval> result;
    result.reserve(numbers.size());
    for (const Number number : numbers) result.emplace_back(number.low, number.high);
    return result;
}

std::vector<Rational> convert_numbers(const std::vector<Number>& numbers, const std::vector<Rational>& exact,
                                      const Rational&) {
    if (exact.size() != numbers.size()) throw Unsupported("the model was built without exact numbers");
    return exact;
}

}  // namespace robochart::markov
