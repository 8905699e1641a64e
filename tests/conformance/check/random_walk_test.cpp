// SPDX-License-Identifier: Apache-2.0
// Tests random walks for components that are too large for exhaustive checks. They find seeded faults, report them with
// small counterexamples, and claim nothing if they find none.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/check/random_walk.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

using ::testing::HasSubstr;

constexpr WalkOptions few{20'000, 10, 7};

Result walk_by_hand(int fault, bool waits = true, const WalkOptions& options = few) {
    process::EventTable events;
    test::GraphSystem model(test::turner_model(waits), events);
    const Alphabet alphabet(test::turner_interface(), events);
    std::string error;
    const auto object = test::hand_made("turner", fault, error);
    EXPECT_NE(object, nullptr) << error;
    return run_random_walks(model, alphabet, object->interface(), 1, {}, options);
}

TEST(Walks, ClaimNothingOfACorrectController) {
    const Result result = walk_by_hand(0);
    EXPECT_EQ(result.outcome, Outcome::inconclusive);
    EXPECT_THAT(result.reason, HasSubstr("no difference in "));
    EXPECT_THAT(result.reason, HasSubstr("20000 cycles together"));
    EXPECT_GE(result.code_states, 2U);
}

/// Uses the faults of objects/turner.cpp that the exhaustive check finds (conformance_check_test.cpp) and that are
/// visible in traces or refusals.
TEST(Walks, FindTheFaultsOfControllersWrittenByHand) {
    for (const int fault : {1, 2, 3, 4, 5}) {
        const Result result = walk_by_hand(fault);
        EXPECT_EQ(result.outcome, Outcome::differs) << "fault " << fault << ": " << result.reason;
        EXPECT_THAT(result.reason, HasSubstr("(found by guided walks)"));
        EXPECT_LE(result.cycles.size(), 6U) << "made smaller: the exhaustive check needs a few cycles";
    }
}

/// Without waits, one cycle with seeRobot, seeWall and speed may call DriveCall twice.
TEST(Walks, FindThatAModelIsNotSchedulable) {
    const Result result = walk_by_hand(0, false);
    EXPECT_NE(result.outcome, Outcome::conforms);
    EXPECT_NE(result.outcome, Outcome::inconclusive) << result.reason;
}

TEST(Walks, AreTheSameForTheSameSeed) {
    const Result one = walk_by_hand(1);
    const Result two = walk_by_hand(1);
    EXPECT_EQ(one.reason, two.reason);
    EXPECT_EQ(one.code_cycles, two.code_cycles);
    EXPECT_EQ(one.cycles.size(), two.cycles.size());
}

/// Runs `conform` with a limit that the exhaustive check reaches immediately.
TEST(Walks, FollowWhereALimitIsReached) {
    test::Model project("corpus/swarm_taxis");
    Options options;
    options.limits.max_states = 50;
    options.walks = few;
    const Result right = conform(project.system, project.instantiation, project.first_module(), options,
                                 project.sources, project.diagnostics);
    EXPECT_EQ(right.outcome, Outcome::inconclusive);
    EXPECT_THAT(right.reason, HasSubstr("no difference in "));
    options.walks.cycles = 0;
    const Result none = conform(project.system, project.instantiation, project.first_module(), options, project.sources,
                                project.diagnostics);
    EXPECT_EQ(none.outcome, Outcome::inconclusive);
    EXPECT_THAT(none.reason, ::testing::Not(HasSubstr("walks")));
}

}  // namespace
}  // namespace robochart::conformance
