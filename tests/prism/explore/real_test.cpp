// SPDX-License-Identifier: Apache-2.0
// Tests real numbers: fractions stay exact, and enclosures contain the exact value.
#include "prism/explore/real.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::prism {
namespace {

TEST(PrismReal, DecimalsAreExact) {
    EXPECT_EQ(decimal("0.1"), Rational(1, 10));
    EXPECT_EQ(decimal("1.5e-3"), Rational(3, 2000));
    EXPECT_EQ(decimal(".5"), Rational(1, 2));
    EXPECT_EQ(decimal("12E+2"), Rational(1200));
    EXPECT_EQ(decimal("01"), Rational(1));
    EXPECT_EQ((Real(decimal("0.1")) + Real(decimal("0.2"))).compare(Real(decimal("0.3"))), 0);
}

TEST(PrismReal, EnclosuresOfFractionsHoldThemAndAreTight) {
    std::uint64_t seed = 1;
    for (int i = 0; i < 2000; ++i) {
        const auto above = static_cast<std::int64_t>(diagnostics::splitmix64(seed) >> 20U);
        const auto below =
            static_cast<std::int64_t>(diagnostics::splitmix64(seed) >> (20U + static_cast<unsigned>(i % 40))) + 1;
        const Rational value(i % 2 == 0 ? above : -above, below);
        const Enclosure bounds = enclose(value);
        EXPECT_LE(Rational(bounds.low), value);
        EXPECT_GE(Rational(bounds.high), value);
        EXPECT_LE(bounds.high, std::nextafter(std::nextafter(bounds.low, 1e300), 1e300));
        EXPECT_EQ(bounds.low == bounds.high, Rational(bounds.low) == value);
    }
    EXPECT_EQ(enclose(Rational(1, 2)), (Enclosure{0.5, 0.5}));
    const Rational tiny = decimal("1e-400") / 1;
    EXPECT_EQ(enclose(tiny).low, 0);
    EXPECT_GT(enclose(tiny).high, 0);
    EXPECT_TRUE(std::isinf(enclose(decimal("1e400")).high));
    EXPECT_FALSE(std::isinf(enclose(decimal("1e400")).low));
}

TEST(PrismReal, FractionsThatGrowBecomeEnclosures) {
    Real value(Rational(1, 3));
    for (int i = 0; i < 20; ++i) value = value * value;  // 3^-(2^20)
    EXPECT_FALSE(value.is_exact());
    EXPECT_LE(value.bounds().low, 0);
    EXPECT_GT(value.bounds().high, 0);
    EXPECT_LT(value.bounds().high, 1e-300);
}

TEST(PrismReal, WholePowersAndLogarithmsAreExact) {
    EXPECT_EQ(logarithm(Real(std::int64_t{8}), Real(std::int64_t{2})).compare(Real(std::int64_t{3})), 0);
    EXPECT_EQ(power(Real(Rational(1, 2)), Real(std::int64_t{-3})).compare(Real(std::int64_t{8})), 0);
    const Real root = power(Real(std::int64_t{2}), Real(Rational(1, 2)));
    EXPECT_FALSE(root.is_exact());
    EXPECT_EQ((root * root).compare(Real(std::int64_t{2})), std::nullopt);
    EXPECT_EQ(root.compare(Real(Rational(141421356, 100000000))), 1);
    EXPECT_EQ(root.compare(Real(Rational(141421357, 100000000))), -1);
}

const Real zero(std::int64_t{0});
const Real one(std::int64_t{1});
const Real two(std::int64_t{2});
const Real half(Rational(1, 2));
constexpr double infinity = std::numeric_limits<double>::infinity();
const Real infinite(Enclosure{infinity, infinity});

TEST(PrismReal, InfinityIsAValue) {
    EXPECT_EQ((one / zero).text(), "Infinity");
    EXPECT_EQ((zero - one / zero).text(), "-Infinity");
    EXPECT_EQ(((zero - two) / zero).text(), "-Infinity");
    EXPECT_EQ((one / infinite).text(), "0");
    EXPECT_EQ((infinite * two + one).text(), "Infinity");
    EXPECT_EQ(logarithm(zero, two).text(), "-Infinity");
    EXPECT_EQ(logarithm(two, one).text(), "Infinity");
    EXPECT_EQ(power(zero, Real(std::int64_t{-1})).text(), "Infinity");
    EXPECT_EQ(power(infinite, zero).text(), "1");
    EXPECT_EQ(power(two, infinite).text(), "Infinity");
    EXPECT_EQ(power(half, infinite).text(), "0");
    EXPECT_EQ((one / zero).compare(infinite), 0);
    EXPECT_EQ(infinite.compare(Real(std::int64_t{1'000'000})), 1);
    EXPECT_EQ((zero - infinite).compare(infinite), -1);
}

/// Returns "0/0 has no value" if there is no value, "?" if it is unknown whether there is one, and "" if there is one.
std::string problem_of(const std::function<Real()>& operation) {
    try {
        (void)operation();
        return "";
    } catch (const Unclear&) {
        return "?";
    } catch (const std::domain_error& error) {
        return error.what();
    }
}

TEST(PrismReal, WhatHasNoValueThrows) {
    EXPECT_EQ(problem_of([] { return zero / zero; }), "0/0 has no value");
    EXPECT_EQ(problem_of([] { return infinite / infinite; }), "Infinity/Infinity has no value");
    EXPECT_EQ(problem_of([] { return infinite - infinite; }), "Infinity - Infinity has no value");
    EXPECT_EQ(problem_of([] { return zero * infinite; }), "0 * Infinity has no value");
    EXPECT_NE(problem_of([] { return logarithm(zero - two, two); }), "");
    EXPECT_NE(problem_of([] { return logarithm(one, one); }), "");
    EXPECT_NE(problem_of([] { return power(zero - two, half); }), "");
    EXPECT_NE(problem_of([] { return power(one, infinite); }), "");
    EXPECT_EQ(problem_of([] { return Real(*floor_of(infinite)); }), "Infinity is not an integer");
}

/// If an enclosure contains 0, the quotient may be infinite or have no value.
TEST(PrismReal, EnclosuresHoldEveryCase) {
    const Real small(Enclosure{0, 0.25});
    const Enclosure quotient = (one / small).bounds();
    EXPECT_LE(quotient.low, 4);
    EXPECT_EQ(quotient.high, infinity);
    EXPECT_EQ((one / Real(Enclosure{-1, 1})).bounds(), (Enclosure{-infinity, infinity}));
    EXPECT_EQ(problem_of([&] { return small / small; }), "?");
    EXPECT_EQ(problem_of([&] { return zero / small; }), "?");
    EXPECT_EQ(problem_of([&] { return small * infinite; }), "?");
    EXPECT_EQ(logarithm(small, two).bounds().low, -infinity);
    EXPECT_GE(logarithm(small, two).bounds().high, -2);
    EXPECT_EQ(problem_of([&] { return logarithm(Real(Enclosure{-1, 1}), two); }), "?");
}

TEST(PrismReal, Text) {
    EXPECT_EQ(Real(Rational(1, 4)).text(), "0.25");
    EXPECT_EQ(Real(Rational(1, 3)).text(), "1/3");
    EXPECT_EQ(Real(std::int64_t{-7}).text(), "-7");
}

}  // namespace
}  // namespace robochart::prism
