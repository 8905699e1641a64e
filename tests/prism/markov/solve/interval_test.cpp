// SPDX-License-Identifier: Apache-2.0
// Compares both kinds of outward rounding with rationals.
#include "prism/markov/solve/interval.hpp"

#include <gtest/gtest.h>
#include <algorithm>

#include <bit>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <random>

#include "prism/markov/solve/arithmetic.hpp"
#include "tests/prism/markov/models/description.hpp"

namespace robochart::markov {
namespace {

/// Returns a random double of any magnitude for which four operations stay finite. It often has few digits, so that
/// some results are exact.
double random_double(std::mt19937_64& numbers, bool negative) {
    const int exponent = static_cast<int>(numbers() % 80) - 40;
    const auto digits = static_cast<double>(numbers() % (numbers() % 2 == 0 ? 16 : std::uint64_t{1} << 53U));
    const double value = std::ldexp(digits + 1, exponent);
    return negative && numbers() % 2 == 0 ? -value : value;
}

Enclosure random_enclosure(std::mt19937_64& numbers, bool negative) {
    const double one = random_double(numbers, negative);
    const double other = numbers() % 3 == 0 ? one : random_double(numbers, negative);
    return {std::min(one, other), std::max(one, other)};
}

Interval interval(Enclosure enclosure) {
    return {enclosure.low, enclosure.high};
}

/// Checks that the bounds are those of the exact result, rounded outward by less than two adjacent doubles.
void expect_tight(const Enclosure& found, const Rational& low, const Rational& high) {
    EXPECT_LE(Rational(found.low), low);
    EXPECT_GE(Rational(found.high), high);
    EXPECT_GT(Rational(std::nextafter(std::nextafter(found.low, infinity), infinity)), low);
    EXPECT_LT(Rational(std::nextafter(std::nextafter(found.high, -infinity), -infinity)), high);
    const auto is_double = [](const Rational& value) { return Rational(value.convert_to<double>()) == value; };
    EXPECT_TRUE(!is_double(low) || Rational(found.low) == low);
    EXPECT_TRUE(!is_double(high) || Rational(found.high) == high);
}

struct Hull {
    Rational low;
    Rational high;
};

template <class Operation>
Hull hull(Enclosure left, Enclosure right, Operation operation) {
    std::vector<Rational> corners;
    for (const double one : {left.low, left.high})
        for (const double other : {right.low, right.high}) corners.push_back(operation(Rational(one), Rational(other)));
    return {*std::ranges::min_element(corners), *std::ranges::max_element(corners)};
}

constexpr int times = 5'000;

/// Computes the operation on intervals with upward rounding.
template <class Operation>
Enclosure upward(Enclosure left, Enclosure right, Operation operation) {
    const RoundUpward mode;
    return operation(interval(left), interval(right)).enclosure();
}

TEST(Intervals, RoundOutward) {
    std::mt19937_64 numbers(7);
    for (int count = 0; count < times; ++count) {
        const Enclosure factor = random_enclosure(numbers, false);
        const Enclosure value = random_enclosure(numbers, true);
        const auto sum =
            hull(factor, value, [](const Rational& one, const Rational& other) { return Rational(one + other); });
        expect_tight(upward(factor, value, [](auto one, auto other) { return one + other; }), sum.low, sum.high);
        const auto difference =
            hull(factor, value, [](const Rational& one, const Rational& other) { return Rational(one - other); });
        expect_tight(upward(factor, value, [](auto one, auto other) { return one - other; }), difference.low,
                     difference.high);
        const auto product =
            hull(factor, value, [](const Rational& one, const Rational& other) { return Rational(one * other); });
        expect_tight(upward(factor, value, [](auto one, auto other) { return one * other; }), product.low,
                     product.high);
        const auto quotient =
            hull(value, factor, [](const Rational& one, const Rational& other) { return Rational(one / other); });
        expect_tight(upward(value, factor, [](auto one, auto other) { return one / other; }), quotient.low,
                     quotient.high);
        if (HasFailure()) FAIL() << factor.low << " .. " << factor.high << ", " << value.low << " .. " << value.high;
    }
}

TEST(Intervals, TheModeEndsWithItsScope) {
    const int before = std::fegetround();
    {
        const RoundUpward mode;
        EXPECT_EQ(std::fegetround(), FE_UPWARD);
    }
    EXPECT_EQ(std::fegetround(), before);
}

TEST(Intervals, BestIsByBothBounds) {
    const Interval one(1, 4);
    const Interval other(2, 3);
    EXPECT_EQ(best_of(one, other, Direction::maximum), Interval(2, 4));
    EXPECT_EQ(best_of(one, other, Direction::minimum), Interval(1, 3));
}

TEST(Enclosures, RoundOutward) {
    std::mt19937_64 numbers(8);
    for (int count = 0; count < times; ++count) {
        const Enclosure left = random_enclosure(numbers, true);
        const Enclosure right = random_enclosure(numbers, true);
        const auto sum =
            hull(left, right, [](const Rational& one, const Rational& other) { return Rational(one + other); });
        expect_tight(left + right, sum.low, sum.high);
        const auto difference =
            hull(left, right, [](const Rational& one, const Rational& other) { return Rational(one - other); });
        expect_tight(left - right, difference.low, difference.high);
        const auto product =
            hull(left, right, [](const Rational& one, const Rational& other) { return Rational(one * other); });
        expect_tight(left * right, product.low, product.high);
        if (right.low <= 0 && right.high >= 0) {
            EXPECT_EQ(left / right, (Enclosure{-infinity, infinity}));
        } else {
            const auto quotient =
                hull(left, right, [](const Rational& one, const Rational& other) { return Rational(one / other); });
            expect_tight(left / right, quotient.low, quotient.high);
        }
        if (HasFailure()) FAIL() << left.low << " .. " << left.high << ", " << right.low << " .. " << right.high;
    }
}

TEST(Enclosures, AtTheEndsOfTheDoubles) {
    constexpr double tiny = 0x1p-1074;
    constexpr double huge = std::numeric_limits<double>::max();
    const Enclosure underflow = Enclosure{tiny, tiny} * Enclosure{0.5, 0.5};
    EXPECT_LE(underflow.low, 0);
    EXPECT_EQ(underflow.high, tiny);
    const Enclosure overflow = Enclosure{huge, huge} * Enclosure{2, 2};
    EXPECT_EQ(overflow.low, huge);
    EXPECT_EQ(overflow.high, infinity);
    const Enclosure both = Enclosure{huge, huge} + Enclosure{huge, huge};
    EXPECT_EQ(both.low, huge);
    EXPECT_EQ(both.high, infinity);
    EXPECT_EQ((Enclosure{infinity, infinity} * Enclosure{0.5, 0.5}), (Enclosure{infinity, infinity}));
    EXPECT_EQ((Enclosure{1, 1} + Enclosure{infinity, infinity}), (Enclosure{infinity, infinity}));
}

TEST(Enclosures, ComplementsAreProbabilities) {
    EXPECT_EQ(complement({0.25, 0.5}), (Enclosure{0.5, 0.75}));
    EXPECT_EQ(complement({0, 0}), (Enclosure{1, 1}));
    EXPECT_EQ(complement({1, 1}), (Enclosure{0, 0}));
    const Enclosure narrow = complement({0x1p-60, 0x1p-60});
    EXPECT_LT(narrow.low, 1);
    EXPECT_EQ(narrow.high, 1);
}

TEST(Enclosures, RelativeWidths) {
    EXPECT_EQ((Enclosure{0.5, 0.5}).relative_width(), 0);
    EXPECT_EQ((Enclosure{infinity, infinity}).relative_width(), 0);
    EXPECT_EQ((Enclosure{0, infinity}).relative_width(), infinity);
    EXPECT_NEAR((Enclosure{0.75, 1}).relative_width(), 0.25, 1e-15);
    EXPECT_TRUE((Enclosure{2, 3}).middle() >= 2 && (Enclosure{2, 3}).middle() <= 3);
}

}  // namespace
}  // namespace robochart::markov
