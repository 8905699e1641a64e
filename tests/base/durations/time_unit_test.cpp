// SPDX-License-Identifier: Apache-2.0
// Tests time units, and durations as numbers of units.
#include <gtest/gtest.h>

#include "base/durations/time_unit.hpp"

namespace robochart::durations {
namespace {

constexpr std::int64_t tenth = second / 10;

TEST(TimeUnit, AreExactMultiplesOrErrors) {
    EXPECT_EQ(count_units(3 * second, tenth).units, 30);
    EXPECT_EQ(count_units(0, tenth).units, 0);
    EXPECT_EQ(count_units(3 * second, tenth).error, "");
    EXPECT_EQ(count_units(150 * millisecond, tenth).error,
              "150 ms is not a multiple of the time unit 100 ms: the neighbours are 100 ms and 200 ms; `unit 50 ms` "
              "would do");
    EXPECT_NE(count_units(tenth - 1, tenth).error, "") << "never rounded";
}

TEST(TimeUnit, TextsHaveTheDecimalsOfTheUnit) {
    EXPECT_EQ(time_text(30, tenth), "t=30 (3.0 s)");
    EXPECT_EQ(time_text(0, tenth), "t=0 (0.0 s)");
    EXPECT_EQ(time_text(150, 20 * millisecond), "t=150 (3.00 s)");
    EXPECT_EQ(time_text(2, second), "t=2 (2 s)");
    EXPECT_EQ(time_text(2, 60 * second), "t=2 (120 s)");
    EXPECT_EQ(time_text(7, std::nullopt), "t=7");
    EXPECT_EQ(units_text(30, tenth), "30 units (3 s)");
    EXPECT_EQ(units_text(1, std::nullopt), "1 unit");
    EXPECT_EQ(duration_text(1500 * millisecond), "1.5 s");
    EXPECT_EQ(seconds_text(20 * millisecond), "0.02");
    EXPECT_EQ(time_text(INT64_MAX, tenth), "t=9223372036854775807") << "a time that no number of nanoseconds holds";
}

TEST(TimeUnit, SecondsAreReadExactly) {
    EXPECT_EQ(nanoseconds_of_seconds("0.1"), tenth);
    EXPECT_EQ(nanoseconds_of_seconds("0.10"), tenth);
    EXPECT_EQ(nanoseconds_of_seconds("12"), 12 * second);
    EXPECT_EQ(nanoseconds_of_seconds("0.000000001"), 1);
    for (const char* const wrong : {"", ".", "1e3", "-1", "0.0000000001", "99999999999", "1.2.3", "1 "})
        EXPECT_FALSE(nanoseconds_of_seconds(wrong)) << wrong;
    EXPECT_EQ(nanoseconds_of_seconds(0.1), tenth);
    EXPECT_FALSE(nanoseconds_of_seconds(1e12));
}

TEST(TimeUnit, WhatASecondIs) {
    EXPECT_EQ(second_text(tenth), "1 second = 10 units");
    EXPECT_EQ(second_text(2 * second), "1 time unit = 2 s");
    EXPECT_TRUE(second_text(std::nullopt).starts_with("1 second = 1 time unit"));
}

}  // namespace
}  // namespace robochart::durations
