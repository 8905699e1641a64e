// SPDX-License-Identifier: Apache-2.0
// Tests that every comparison can be true and false, because carriers extend beyond the values that are compared.
#include <gtest/gtest.h>

#include <algorithm>

#include "semantics/instantiate/instantiate.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

using Numbers = std::vector<std::int64_t>;

/// Returns the instantiation for a machine with these declarations and this guard.
Instantiation of_guard(const std::string& guard, const InstantiationOptions& options = {},
                       const std::string& declarations = "", const std::string& assertions = "") {
    const auto lowered = samples::lower_text(
        "import sequence_toolkit::*\n"
        "stm S { event e : nat var n : nat, m : nat, i : int, x : real, s : Seq(boolean) clock C " +
            declarations +
            " initial j state A { } transition t0 { from j to A } transition t { from A to A condition " + guard +
            " } }",
        assertions);
    return instantiate_system(lowered->system, options, lowered->diagnostics);
}

TEST(Compared, WholeNumbersHaveOneOnEitherSide) {
    EXPECT_EQ(of_guard("n > 5").nat, (Numbers{0, 1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(of_guard("n == 2").nat, (Numbers{0, 1, 2, 3})) << "a counter that starts above it never ends at it";
    EXPECT_EQ(of_guard("n < 1").nat, (Numbers{0, 1, 2})) << "the default has both sides";
    EXPECT_EQ(of_guard("0 > n").nat, (Numbers{0, 1, 2})) << "nothing of nat is below 0";
    EXPECT_EQ(of_guard("i < -4").integer, (Numbers{-5, -4, -3, -2, -1, 0, 1, 2}));
    EXPECT_EQ(of_guard("n in [1, 4]").nat.back(), 5);
}

/// Returns the instantiation for a machine with this guard and this assignment.
Instantiation of_counter(const std::string& guard, const std::string& assignment) {
    return of_guard(guard + " action " + assignment);
}

TEST(Compared, ACounterMayExceedANumberByOneStep) {
    EXPECT_EQ(of_counter("i > -20", "i = i - 7").integer.front(), -27);
    EXPECT_EQ(of_counter("i > -20", "i = i - 7").integer.back(), 7) << "a number of the model";
    EXPECT_EQ(of_counter("i <= 20", "i = i + 9").integer.back(), 29);
    EXPECT_EQ(of_counter("n < 20", "n = n + 9").nat.back(), 29);
    EXPECT_EQ(of_counter("i == 20", "i = i + 9").integer.back(), 21) << "no order";
    EXPECT_EQ(of_counter("n < 20", "m = m + 9").nat.back(), 21) << "another variable";
    EXPECT_EQ(of_counter("n < 20", "n = m + 9").nat.back(), 21) << "no counter";
}

TEST(Compared, OnlyTheTypeThatIsComparedIsWidened) {
    const auto inst = of_guard("i > 2");
    EXPECT_EQ(inst.nat, (Numbers{0, 1, 2}));
    EXPECT_EQ(inst.integer, (Numbers{-2, -1, 0, 1, 2, 3}));
    EXPECT_EQ(of_guard("since(C) > 7").nat, (Numbers{0, 1, 2}));
}

TEST(Compared, RealsReachBeyondDecimals) {
    const auto inst = of_guard("x > 21.25");
    EXPECT_EQ(inst.scale, 100);
    EXPECT_EQ(inst.real.back(), 2200);
    EXPECT_EQ(of_guard("x < -3.5").real.front(), -40);
}

TEST(Compared, RealsHaveANumberBetweenNeighbours) {
    const auto decimals = of_guard("x > 0.3 /\\ x < 0.4");
    EXPECT_EQ(decimals.scale, 100);
    EXPECT_TRUE(std::ranges::binary_search(decimals.real, 35));
    const auto wholes = of_guard("x > 1 /\\ x < 2");
    EXPECT_EQ(wholes.scale, 10);
    EXPECT_TRUE(std::ranges::binary_search(wholes.real, 15));
    EXPECT_EQ(of_guard("x > 0 /\\ x < 2").scale, 1) << "1 is between";
    EXPECT_EQ(of_guard("x == 1 \\/ x == 2").scale, 1) << "no comparison tells 1.5 from 1.7 or 3";
}

TEST(Compared, ConstantsCountWithEachValueThatTheyMayHave) {
    const std::string limit = "const limit : nat = 3";
    EXPECT_EQ(of_guard("n > limit", {}, limit).nat.back(), 4) << "a counter that goes up to the limit ends";
    EXPECT_EQ(of_guard("n > limit", {{{"limit", "6"}}, {}}, limit).nat.back(), 7);
    EXPECT_EQ(of_guard("n > limit + 1", {}, limit).nat.back(), 5);
    EXPECT_EQ(of_guard("n > limit", {}, "const limit : nat").nat, (Numbers{0, 1, 2})) << "it is 0";
    EXPECT_EQ(of_guard("n > limit", {}, limit, "assertion A : S is deterministic with constant limit of S set to 8")
                  .nat.back(),
              9);
    EXPECT_EQ(of_guard("n > limit", {}, limit, "csp Instantiations csp-begin\nconst_S_limit = 5\ncsp-end").nat.back(),
              6);
}

TEST(Compared, WhatIsComputedIsInverted) {
    EXPECT_EQ(of_guard("n - 3 > 5").nat.back(), 9);
    EXPECT_EQ(of_guard("n / 2 > 5").nat.back(), 13) << "12 / 2 is the first above 5";
    EXPECT_EQ(of_guard("10 - i < 4").integer.back(), 10) << "7 would do, 10 is a number of the model";
    EXPECT_EQ(of_guard("n > 2.5").nat.back(), 3) << "n as a real number";
}

TEST(Compared, LengthsOfSequencesAreNumbersToo) {
    EXPECT_EQ(of_guard("n > size(s)").nat.back(), 3);
    EXPECT_EQ(of_guard("n > size(s)", {{}, {{"Seq", {0, 4}}}}).nat.back(), 5);
    EXPECT_EQ(of_guard("size(s) > 1").nat, (Numbers{0, 1, 2})) << "the length is no value of a variable";
}

TEST(Compared, VariablesThatAreComparedMayHaveAnyNumberOfTheModel) {
    EXPECT_EQ(of_guard("n > m", {}, "var k : nat = 7").nat.back(), 8);
    EXPECT_EQ(of_guard("n == m", {}, "var k : nat = 7").nat.back(), 7) << "no order";
    EXPECT_EQ(of_guard("n > 1", {}, "var k : nat = 7").nat.back(), 7) << "k is compared with nothing";
}

TEST(Compared, ChosenCarriersStayAsTheyAre) {
    EXPECT_EQ(of_guard("n > 3", {{}, {{"nat", {0, 3}}}}).nat.back(), 3);
    EXPECT_EQ(of_guard("n > 2", {{}, {{"int", {-2, 2}}}}).nat.back(), 2) << "nat stays within int";
    EXPECT_EQ(of_guard("x > 1 /\\ x < 2", {{}, {{"real", {-2, 2}}}}).scale, 1);
    const std::string block = "csp Instantiations csp-begin\nnametype core_nat = {0..5}\ncsp-end";
    EXPECT_EQ(of_guard("n > 5", {}, "", block).nat.back(), 5);
}

}  // namespace
}  // namespace robochart::ir
