// SPDX-License-Identifier: Apache-2.0
// Tests which claims the arguments of --assertion select.
#include "driver/settings/claim_selection.hpp"

#include <gtest/gtest.h>

namespace robochart::driver {
namespace {

using Places = std::vector<std::size_t>;
using Words = std::vector<std::string>;

const Words names{"SafeStop", "Live", "SafeStart", "P [T= Q", "a*b", "aXb", "3"};

Places chosen(const Words& words) {
    return select_claims(words, names).chosen;
}

TEST(ClaimSelection, WithoutWordsAllAreMeant) {
    EXPECT_EQ(chosen({}), (Places{0, 1, 2, 3, 4, 5, 6}));
}

TEST(ClaimSelection, NamesAndNumbersAndRanges) {
    EXPECT_EQ(chosen({"Live"}), (Places{1}));
    EXPECT_EQ(chosen({"P [T= Q"}), (Places{3}));
    EXPECT_EQ(chosen({"2"}), (Places{1}));
    EXPECT_EQ(chosen({"2..4"}), (Places{1, 2, 3}));
    EXPECT_EQ(chosen({"6..99"}), (Places{5, 6}));
    EXPECT_EQ(chosen({"4", "1", "SafeStop"}), (Places{0, 3}));
}

TEST(ClaimSelection, Patterns) {
    EXPECT_EQ(chosen({"Safe*"}), (Places{0, 2}));
    EXPECT_EQ(chosen({"*S*t*"}), (Places{0, 2}));
    EXPECT_EQ(chosen({"L?ve"}), (Places{1}));
    EXPECT_EQ(chosen({"*"}), (Places{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(chosen({"a?b"}), (Places{4, 5}));
}

TEST(ClaimSelection, ANameIsNoPatternAndNoNumber) {
    EXPECT_EQ(chosen({"a*b"}), (Places{4}));
    EXPECT_EQ(chosen({"3"}), (Places{6}));
}

TEST(ClaimSelection, WhatMeansNothingIsLost) {
    EXPECT_EQ(select_claims({"Live", "live", "0", "8", "5..2", "Safe", "Z*", "1..", "-1"}, names).lost,
              (Words{"live", "0", "8", "5..2", "Safe", "Z*", "1..", "-1"}));
    EXPECT_EQ(why_lost("8", names, "the model"), "the model has 7 assertions");
    EXPECT_EQ(why_lost("Z*", names, "the model"), "the model has no assertion that fits this pattern");
    EXPECT_EQ(why_lost("Liv", names, "the model"), "the model has no assertion of this name; did you mean 'Live'?");
    EXPECT_EQ(why_lost("x", {}, "s.csp"), "s.csp has no assertions");
}

}  // namespace
}  // namespace robochart::driver
