// SPDX-License-Identifier: Apache-2.0
#include "prism/markov/solve/perturbation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/policy_iteration.hpp"

namespace robochart::markov {
namespace {

Interval enclosing(const Rational& value) {
    const auto near = value.convert_to<double>();
    if (std::isinf(near)) return {std::numeric_limits<double>::max(), infinity};  // values are not negative
    double low = near;
    double high = near;
    while (Rational(low) > value) low = std::nextafter(low, -infinity);
    while (Rational(high) < value) high = std::nextafter(high, infinity);
    return {low, high};
}

/// Returns the factor 1+d for these numbers, or infinity.
double spread_factor(std::span<const Interval> numbers) {
    double factor = 1;
    for (const Interval& number : numbers)
        if (number.high > 0) factor = std::max(factor, number.low() > 0 ? number.high / number.low() : infinity);
    return factor;
}

/// Returns the power, rounded up.
double power(double base, std::size_t exponent) {
    double result = 1;
    for (; exponent > 0; exponent /= 2, base *= base)
        if (exponent % 2 == 1) result *= base;
    return result;
}

System<Rational> with_low_probabilities(const System<Interval>& system, std::vector<Rational>& numbers) {
    for (const Interval& number : system.numbers) numbers.emplace_back(number.low());
    System<Rational> result{system.first_choice, system.first_entry, system.unknown, system.number, {}, {}, numbers};
    for (const Interval& outside : system.outside) result.outside.emplace_back(outside.low());
    result.constant.resize(system.choices());
    return result;
}

}  // namespace

std::optional<SystemSolution<Interval>> rational_bounds(const System<Interval>& system, Policy first,
                                                        Direction direction, double most,
                                                        const EliminationLimit& limit) {
    const double factor = power(std::max(spread_factor(system.numbers), spread_factor(system.outside)), system.size());
    if (!(factor < 2)) return std::nullopt;
    const auto finite = [](const Interval& constant) { return constant.high < infinity; };
    if (!std::ranges::all_of(system.constant, finite)) return std::nullopt;
    std::vector<Rational> numbers;
    System<Rational> exact = with_low_probabilities(system, numbers);
    const auto solved = [&](Policy policy, double (*bound)(const Interval&)) {
        for (std::size_t choice = 0; choice < system.choices(); ++choice)
            exact.constant[choice] = Rational(bound(system.constant[choice]));
        return iterate_policies<Rational>(
            exact, std::move(policy), limit,
            [&](const Rational& value, const Rational& offered) { return is_better(offered, value, direction); },
            [](std::uint32_t) { return true; }, std::numeric_limits<std::uint64_t>::max());
    };
    const auto low = solved(std::move(first), [](const Interval& constant) { return constant.low(); });
    if (!low) return std::nullopt;
    const auto high = solved(low->policy, [](const Interval& constant) { return constant.high; });
    if (!high) return std::nullopt;
    SystemSolution<Interval> solution{std::vector<Interval>(system.size()), high->policy};
    for (std::size_t unknown = 0; unknown < system.size(); ++unknown) {
        solution.values[unknown].negated_low = enclosing(low->values[unknown]).negated_low / factor;
        solution.values[unknown].high = std::min(enclosing(high->values[unknown]).high * factor, most);
    }
    return solution;
}

}  // namespace robochart::markov
