// SPDX-License-Identifier: Apache-2.0
// Tests number literals and checked arithmetic.
#include "semantics/ir/numbers.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "semantics/ir/arithmetic.hpp"

namespace robochart::ir {
namespace {

constexpr auto least = std::numeric_limits<std::int64_t>::min();
constexpr auto most = std::numeric_limits<std::int64_t>::max();

TEST(Numbers, Integers) {
    EXPECT_EQ(parse_integer("-12"), -12);
    EXPECT_EQ(parse_integer("9223372036854775807"), most);
    EXPECT_EQ(parse_integer("9223372036854775808"), std::nullopt);
    for (const char* text : {"", "-", "1x", "0.5", " 1"}) EXPECT_EQ(parse_integer(text), std::nullopt) << text;
}

TEST(Numbers, DecimalsAreExactAndShort) {
    const auto text = [](const char* literal) {
        const auto decimal = parse_decimal(literal);
        return decimal ? to_string(*decimal) : "none";
    };
    EXPECT_EQ(text("-0.75"), "-0.75");
    EXPECT_EQ(text("10.88"), "10.88");
    EXPECT_EQ(text("0.50"), "0.5");
    EXPECT_EQ(text("3.0"), "3");
    EXPECT_EQ(text("-0.05"), "-0.05");
    EXPECT_EQ(text("0.000000000000000001"), "0.000000000000000001");
    EXPECT_EQ(text("0.0000000000000000001"), "none");
    EXPECT_EQ(text("1.-5"), "none");
    EXPECT_EQ(text(".5"), "none");
}

TEST(Numbers, CheckedArithmetic) {
    EXPECT_EQ(checked_add(most, 1), std::nullopt);
    EXPECT_EQ(checked_subtract(least, 1), std::nullopt);
    EXPECT_EQ(checked_subtract(0, least), std::nullopt);
    EXPECT_EQ(checked_multiply(most, 2), std::nullopt);
    EXPECT_EQ(floor_divide(least, -1), std::nullopt);
    EXPECT_EQ(floor_modulus(least, -1), 0);
    EXPECT_EQ(floor_divide(1, 0), std::nullopt);
    EXPECT_EQ(multiply_divide(most, most, most), most);
    EXPECT_EQ(multiply_divide(-1, 1, 2), -1);
    EXPECT_EQ(multiply_divide(1, 1, 0), std::nullopt);
    EXPECT_EQ(power_of_ten(18), 1000000000000000000);
    EXPECT_EQ(power_of_ten(19), std::nullopt);
}

}  // namespace
}  // namespace robochart::ir
