// SPDX-License-Identifier: Apache-2.0
// Tests choices that the model leaves open (reference API A6). By default the code takes the first alternative. With
// `--all-choices` the check explores every alternative, and all of them must be runs of the model.
#include <gtest/gtest.h>

#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

/// The code takes t1 and j1 by default.
const char* const either = "tests/conformance/models/either";

TEST(Choices, TheFirstIsOneOfAll) {
    test::Model model(either);
    test::Bench bench(model, model.machine_named("M"));
    const Result first = bench.check_code();
    EXPECT_EQ(first.outcome, Outcome::conforms) << first.reason;
    EXPECT_EQ(first.code_states, 3U);  // before the first cycle, Waiting, Left: t2 is never taken
    bench.explore_choices();
    const Result all = bench.check_code();
    EXPECT_EQ(all.outcome, Outcome::conforms) << all.reason;
    EXPECT_EQ(all.code_states, 4U);  // and the state Right, which t2 and j1 reach
}

/// A wrong target of t0 or t4 is found by default. A wrong target of t2, j1 or t5 is found only if the second
/// alternative is explored. A wrong target of t1 or j2 is the target of the other alternative, which the model allows.
TEST(Choices, FaultsBehindOtherChoicesAreFound) {
    test::Model model(either);
    test::Bench bench(model, model.machine_named("M"));
    const auto found = [&] {
        std::size_t differ = 0;
        for (std::uint32_t site = 0; site < 7; ++site)
            differ += bench.check_code(cpp_emit::Fault::wrong_target, site).outcome == Outcome::differs ? 1U : 0U;
        return differ;
    };
    ASSERT_EQ(bench.site_count(cpp_emit::Fault::wrong_target), 7U);
    EXPECT_EQ(found(), 2U);
    bench.explore_choices();
    ASSERT_EQ(bench.site_count(cpp_emit::Fault::wrong_target), 7U);
    EXPECT_EQ(found(), 5U);
}

/// The machine waits for one or two units. By default the code waits for one unit, but the model allows both.
TEST(Choices, TheLengthOfAWait) {
    test::Model model(test::ModelFolder(R"(
stm S {
    event left
    initial i
    state A { entry wait([1, 2]) ; left }
    transition t0 { from i to A }
    transition t1 { from A to A }
}
)")
                          .path());
    test::Bench bench(model, model.machine_named("S"));
    const Result first = bench.check_code();
    EXPECT_EQ(first.outcome, Outcome::conforms) << first.reason;
    bench.explore_choices();
    const Result all = bench.check_code();
    EXPECT_EQ(all.outcome, Outcome::conforms) << all.reason;
    EXPECT_GT(all.code_states, first.code_states);
}

/// The models have inner and outer transitions that are both enabled, and several machines.
TEST(Choices, CompositesAndTeams) {
    for (const char* folder :
         {"tests/conformance/models/nested", "tests/conformance/models/team", "corpus/aggregation"}) {
        test::Model model(folder);
        test::Bench bench(model, model.first_module());
        bench.explore_choices();
        const Result all = bench.check_code();
        EXPECT_EQ(all.outcome, Outcome::conforms) << folder << ": " << all.reason << " " << all.expected;
    }
}

}  // namespace
}  // namespace robochart::conformance
