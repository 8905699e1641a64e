// SPDX-License-Identifier: Apache-2.0
// Tests models on which plausible algorithms give a wrong answer. Comments state the wrong and the correct answer.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Explored;

void expect_encloses(const Result& found, double value) {
    ASSERT_EQ(found.kind, Result::Kind::number) << found.reason;
    const Enclosure bounds = found.low.bounds();
    EXPECT_LE(bounds.low, value);
    EXPECT_GE(bounds.high, value);
    EXPECT_LE(bounds.high - bounds.low, 1e-6 * value);
}

/// An iteration that stops at small changes gives a wrong answer (Haddad and Monmege, Interval iteration algorithm for
/// MDPs and IMDPs, 2018). The event is n heads in a row before n tails in a row, where the count starts again after
/// each change. By symmetry the probability is 1/2.
TEST(PrismTraps, SlowConvergenceIsNoConvergence) {
    constexpr int n = 18;
    const std::string model =
        "dtmc const int n; module M s:[-n..n] init 0;\n"
        "[] s>=0 & s<n -> 0.5:(s'=s+1) + 0.5:(s'=s=0 ? -1 : 0); [] s<0 & s>-n -> 0.5:(s'=s-1) + 0.5:(s'=0);\n"
        "[] s=n | s=-n -> true; endmodule\n";
    // The wrong algorithm iterates from 0 until the value of the initial state changes by less than a millionth of
    // itself.
    std::vector<double> value(2 * n + 1, 0);
    value[2 * n] = 1;
    double before = 0;
    for (int sweep = 0; sweep < 10'000; ++sweep) {
        std::vector<double> next = value;
        for (int s = -n + 1; s < n; ++s) {
            const int on = s >= 0 ? s + 1 : s - 1;
            const int back = s == 0 ? -1 : 0;
            next[static_cast<std::size_t>(s + n)] =
                0.5 * value[static_cast<std::size_t>(on + n)] + 0.5 * value[static_cast<std::size_t>(back + n)];
        }
        value = next;
        if (value[n] > 0 && value[n] - before < 1e-6 * value[n]) break;
        before = value[n];
    }
    EXPECT_LT(value[n], 0.1);
    const Values constants{{"n", {Type::integer, n, {}}}};
    expect_encloses(Explored(model, constants).ask("P=? [ F s=n ]"), 0.5);
    EXPECT_EQ(Explored(model, constants).ask("P=? [ F s=n ]", {1e-6, true, nullptr}).low.text(), "0.5");
}

/// In a loop without cost, an iteration from 0 stays in the loop and answers 0. Leaving it costs 7.
TEST(PrismTraps, ALoopThatCostsNothingIsNoWayToTheGoal) {
    const std::string model =
        "mdp module M s:[0..2]; [a] s=0 -> (s'=1); [a] s=1 -> (s'=0); [b] s=0 -> (s'=2); [] s=2 -> true; endmodule\n"
        "rewards [b] true : 7; endrewards\n";
    expect_encloses(Explored(model).ask("Rmin=? [ F s=2 ]"), 7);
    EXPECT_EQ(Explored(model).ask("Rmin=? [ F s=2 ]", {1e-6, true, nullptr}).low.text(), "7");
    EXPECT_TRUE(std::isinf(Explored(model).ask("Rmax=? [ F s=2 ]").low.bounds().low));
}

/// In an end component, an iteration from 1 stays at 1, because the loop preserves this bound. The correct value is
/// 0.3.
TEST(PrismTraps, AnEndComponentKeepsNoBoundFromAbove) {
    const std::string model =
        "mdp module M s:[0..3]; [] s=0 -> (s'=1); [] s=1 -> 0.5:(s'=0) + 0.5:(s'=1);\n"
        "[] s=1 -> 0.3:(s'=2) + 0.7:(s'=3); [] s>=2 -> true; endmodule\n";
    const Result most = Explored(model).ask("Pmax=? [ F s=2 ]");
    expect_encloses(most, 0.3);
    EXPECT_EQ(Explored(model).ask("Pmin=? [ F s=2 ]").low.bounds().high, 0);
    EXPECT_TRUE(Explored(model).ask("P<=0.31 [ F s=2 ]").truth);
}

/// If the goal is reached with probability below 1, the expected reward is infinite, however close the probability is
/// to 1.
TEST(PrismTraps, ARewardThatIsNeverCollectedInFullIsInfinite) {
    const std::string chain =
        "dtmc module M s:[0..2]; [] s=0 -> 0.999999:(s'=1) + 0.000001:(s'=2); [] s>0 -> true; endmodule\n"
        "rewards s=0 : 1; endrewards\n";
    EXPECT_TRUE(std::isinf(Explored(chain).ask("R=? [ F s=1 ]").low.bounds().low));
    EXPECT_FALSE(Explored(chain).ask("R<=1000000 [ F s=1 ]").truth);
    expect_encloses(Explored(chain).ask("R=? [ F s>0 ]"), 1);
    // For an mdp, the minimum is finite if some scheduler reaches the goal with probability 1. The maximum is finite if
    // all schedulers do.
    const std::string choice =
        "mdp module M s:[0..1]; [stay] s=0 -> true; [go] s=0 -> (s'=1); [] s=1 -> true; endmodule\n"
        "rewards [go] true : 3; endrewards\n";
    expect_encloses(Explored(choice).ask("Rmin=? [ F s=1 ]"), 3);
    EXPECT_TRUE(std::isinf(Explored(choice).ask("Rmax=? [ F s=1 ]").low.bounds().low));
}

}  // namespace
}  // namespace robochart::prism
