// SPDX-License-Identifier: Apache-2.0
// Tests bounds that are proved from guesses. The bounds must be correct for any guess.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "prism/markov/solve/arithmetic.hpp"
#include "prism/markov/solve/elimination.hpp"
#include "prism/markov/solve/guess.hpp"
#include "prism/markov/solve/optimum.hpp"
#include "prism/markov/solve/perturbation.hpp"
#include "tests/prism/markov/models/description.hpp"
#include "tests/rounds.hpp"

namespace robochart::markov {
namespace {

/// A system of equations with exact numbers, and the same system with enclosures of these numbers. Every choice leads
/// outside with positive probability, so every policy eventually leads outside.
struct Twins {
    std::vector<Rational> exact_numbers;
    std::vector<Interval> numbers;
    System<Rational> exact;
    System<Interval> enclosed;

    Twins() = default;
    Twins(const Twins&) = delete;
    Twins& operator=(const Twins&) = delete;
};

Interval interval(const Rational& value) {
    const Number number = enclosing(value);
    return {number.low, number.high};
}

std::size_t below(std::mt19937_64& numbers, std::size_t bound) {
    return static_cast<std::size_t>(numbers() % bound);
}

void add_choice(std::mt19937_64& numbers, std::uint32_t unknowns, Twins& twins) {
    std::vector<Rational> weights{Rational(1, below(numbers, 4) == 0 ? 1'000 : 2)};  // the first branch leads outside
    for (std::size_t count = 1 + below(numbers, 3); count > 0; --count) weights.emplace_back(1 + below(numbers, 5));
    Rational sum = 0;
    for (const Rational& weight : weights) sum += weight;
    const auto share = [&](std::size_t at) { return Rational(weights[at] / sum); };
    const Rational constant =
        below(numbers, 3) == 0 ? Rational(0) : Rational(share(0) * Rational(below(numbers, 7), 7));
    twins.exact.outside.push_back(share(0));
    twins.enclosed.outside.push_back(interval(share(0)));
    twins.exact.constant.push_back(constant);
    twins.enclosed.constant.push_back(interval(constant));
    for (std::size_t at = 1; at < weights.size(); ++at) {
        const auto to = static_cast<std::uint32_t>(below(numbers, unknowns));
        for (auto* unknown : {&twins.exact.unknown, &twins.enclosed.unknown}) unknown->push_back(to);
        for (auto* number : {&twins.exact.number, &twins.enclosed.number})
            number->push_back(static_cast<std::uint32_t>(twins.numbers.size()));
        twins.exact_numbers.push_back(share(at));
        twins.numbers.push_back(interval(share(at)));
    }
    twins.exact.first_entry.push_back(twins.exact.unknown.size());
    twins.enclosed.first_entry.push_back(twins.enclosed.unknown.size());
}

void fill(std::mt19937_64& numbers, Twins& twins) {
    const auto unknowns = static_cast<std::uint32_t>(1 + below(numbers, 8));
    for (std::uint32_t unknown = 0; unknown < unknowns; ++unknown) {
        for (std::size_t count = 1 + below(numbers, 3); count > 0; --count) add_choice(numbers, unknowns, twins);
        twins.exact.first_choice.push_back(static_cast<std::uint32_t>(twins.exact.choices()));
        twins.enclosed.first_choice.push_back(static_cast<std::uint32_t>(twins.enclosed.choices()));
    }
    twins.exact.numbers = twins.exact_numbers;
    twins.enclosed.numbers = twins.numbers;
}

void expect_enclosed(const std::vector<Interval>& found, const std::vector<Rational>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t unknown = 0; unknown < expected.size(); ++unknown) {
        EXPECT_LE(Rational(found[unknown].enclosure().low), expected[unknown]);
        EXPECT_GE(Rational(found[unknown].enclosure().high), expected[unknown]);
    }
}

/// Keeps a guess, or changes it by an amount from the size of a rounding error to twice the guess.
void disturb(std::mt19937_64& numbers, Guesses& guesses) {
    const double size = std::ldexp(1.0, -static_cast<int>(below(numbers, 50)));
    const auto disturbed = [&](double value) {
        return below(numbers, 3) == 0 ? value
                                      : value * (1 + size * (static_cast<double>(below(numbers, 2'001)) / 1'000 - 1));
    };
    for (Guess& guess : guesses) guess = {disturbed(guess.low), disturbed(guess.high), disturbed(guess.weight)};
}

TEST(Proof, HoldsWhateverTheGuesses) {
    std::mt19937_64 numbers(9);
    std::size_t proved = 0;
    std::size_t refused = 0;
    for (std::size_t count = 0; count < tests::rounds(3'000); ++count) {
        Twins twins;
        fill(numbers, twins);
        const auto direction = below(numbers, 2) == 0 ? Direction::minimum : Direction::maximum;
        const std::vector<Rational> expected = optimum(twins.exact, {direction, {}}).values;
        const RoundUpward mode;
        GuessIteration iteration(twins.enclosed, direction);
        for (std::size_t sweep = below(numbers, 60); sweep > 0; --sweep) iteration.sweep();
        disturb(numbers, iteration.guesses());
        const auto values = prove(twins.enclosed, direction, iteration.guesses(), infinity);
        ++(values ? proved : refused);
        if (values) expect_enclosed(*values, expected);
        if (HasFailure()) FAIL() << "round " << count;
    }
    EXPECT_GT(proved, refused / 4);
    EXPECT_GT(refused, 0U);
}

TEST(Proof, OfManySweepsIsNarrow) {
    std::mt19937_64 numbers(10);
    for (std::size_t count = 0; count < tests::rounds(300); ++count) {
        Twins twins;
        fill(numbers, twins);
        const auto direction = below(numbers, 2) == 0 ? Direction::minimum : Direction::maximum;
        const std::vector<Rational> expected = optimum(twins.exact, {direction, {}}).values;
        const RoundUpward mode;
        GuessIteration iteration(twins.enclosed, direction);
        iteration.set_tie(1e-9);
        for (std::size_t sweep = 0; sweep < 200'000 && iteration.sweep() > 0; ++sweep) {
        }
        const auto values = prove(twins.enclosed, direction, iteration.guesses(), infinity);
        ASSERT_TRUE(values) << "round " << count;
        expect_enclosed(*values, expected);
        EXPECT_LE(relative_width(*values), 1e-9) << "round " << count;
        if (HasFailure()) return;
    }
}

TEST(Proof, RationalBoundsAreNarrow) {
    std::mt19937_64 numbers(11);
    for (std::size_t count = 0; count < tests::rounds(500); ++count) {
        Twins twins;
        fill(numbers, twins);
        const auto direction = below(numbers, 2) == 0 ? Direction::minimum : Direction::maximum;
        const std::vector<Rational> expected = optimum(twins.exact, {direction, {}}).values;
        const RoundUpward mode;
        const auto found = rational_bounds(twins.enclosed, leaving_policy(twins.enclosed), direction, infinity, {});
        ASSERT_TRUE(found);
        expect_enclosed(found->values, expected);
        EXPECT_LE(relative_width(found->values), 1e-13);
    }
}

TEST(Elimination, EndsAtItsLimit) {
    std::mt19937_64 numbers(12);
    std::optional<Twins> twins;
    do fill(numbers, twins.emplace());
    while (twins->exact.size() < 5);
    const Policy policy(twins->exact.first_choice.begin(), twins->exact.first_choice.end() - 1);
    const std::vector<Rational> side(twins->exact.size(), 1);
    EXPECT_TRUE(eliminate(twins->exact, policy, {side}, {}));
    EXPECT_FALSE(eliminate(twins->exact, policy, {side}, {.operations = 1}));
}

TEST(Elimination, RefusesAPolicyThatStays) {
    // States 0 and 1 lead to each other, or outside.
    const std::vector<Rational> one{1};
    const System<Rational> system{{0, 2, 3}, {0, 1, 1, 2}, {1, 0}, {0, 0}, {0, 1, 0}, {0, 1, 0}, one};
    EXPECT_FALSE(eliminate(system, {0, 2}, {{1, 1}}, {}));
    const auto solved = eliminate(system, {1, 2}, {{1, 1}}, {});
    ASSERT_TRUE(solved);
    EXPECT_EQ(solved->front(), (std::vector<Rational>{1, 2}));
}

}  // namespace
}  // namespace robochart::markov
