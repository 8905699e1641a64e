// SPDX-License-Identifier: Apache-2.0
// Tests the analysis of the lengths of lists that machines build.
#include "conformance/model/longer_lists.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

/// Returns the bounds of the lists that may be longer than received ones.
std::vector<std::int64_t> bounds_of(const std::string& body) {
    const test::ModelFolder folder("stm M { event e : Seq(boolean) event out_ : Seq(boolean) event go\n" + body +
                                   " initial i state A { } transition t0 { from i to A } }\n");
    test::Model model(folder.path());
    std::vector<std::int64_t> bounds;
    for (const auto& [type, longest] : separate_longer_lists(model.system, model.instantiation))
        bounds.push_back(longest);
    return bounds;
}

/// Returns a chain of variables. Each variable is twice the concatenation of the previous one. The first variable is
/// received and has at most two items.
std::string doubled(int count) {
    std::string text = "var x0 : Seq(boolean) transition r { from A to A trigger e ? x0 }\n";
    for (int i = 1; i <= count; ++i)
        text += fmt::format(
            "var x{0} : Seq(boolean) transition d{0} {{ from A to A trigger go action x{0} = x{1} ^ x{1} }}\n", i,
            i - 1);
    return text;
}

TEST(LongerLists, HaveTheSumOfTheLengths) {
    EXPECT_THAT(bounds_of(doubled(1)), testing::ElementsAre(4));
    EXPECT_THAT(bounds_of(doubled(3)), testing::UnorderedElementsAre(4, 8, 16));
}

/// 2^80 exceeds every length, and each length is found only once.
TEST(LongerLists, WithoutALengthHaveNoBound) {
    const std::vector<std::int64_t> bounds = bounds_of(doubled(80));
    EXPECT_THAT(bounds, testing::Each(testing::Le(1'000'000)));
    EXPECT_EQ(bounds.size(), 18U);  // 2^2 to 2^19
}

/// Lists that depend on themselves have no bound, and neither do variables that read them, in any order of declaration.
TEST(LongerLists, ThatGrowInALoopHaveNoBound) {
    const std::string loop =
        " transition t1 { from A to A trigger e ? x action a = b ^ x ; b = a ; c = a ^ x ; d = x ^ x }\n";
    EXPECT_THAT(bounds_of("var x : Seq(boolean) var a : Seq(boolean) var b : Seq(boolean) var c : Seq(boolean) "
                          "var d : Seq(boolean)" +
                          loop),
                testing::ElementsAre(4));
    EXPECT_THAT(bounds_of("var d : Seq(boolean) var c : Seq(boolean) var b : Seq(boolean) var a : Seq(boolean) "
                          "var x : Seq(boolean)" +
                          loop),
                testing::ElementsAre(4));
}

}  // namespace
}  // namespace robochart::conformance
