// SPDX-License-Identifier: Apache-2.0
// Tests the search for events that are raised without effect. It finds which events these are, for how many consecutive
// cycles, and the state of the machine during these cycles.
#include "conformance/check/missed_events.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<MissedEvent> missed_in(const std::string& members, std::uint32_t cycle_length = 1) {
    const test::ModelFolder folder(
        "stm M {\n event e event f\n initial i state A { }\n transition t0 { from i to A }\n" + members + "\n}");
    test::Model model(folder.path());
    diagnostics::Diagnostics found;
    Options options;
    options.cycle_length = cycle_length;
    const Result result =
        conform(model.system, model.instantiation, model.machine_named("M"), options, model.sources, found);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    return result.missed;
}

// The cycle that takes f starts a wait of four units, which spans three more cycles. The wait is over in the fourth
// cycle, which takes e.
TEST(MissedEvents, OfAnEntryActionThatWaits) {
    const auto missed = missed_in(R"(
        state B { entry wait(4) }
        transition t1 { from A to B trigger f }
        transition t2 { from B to A trigger e })");
    ASSERT_EQ(missed.size(), 1U);
    EXPECT_EQ(missed[0].event, "e");
    EXPECT_EQ(missed[0].reasons.at(0).why, MissedWhile::busy);
    EXPECT_EQ(missed[0].cycles, 3U);
    EXPECT_THAT(missed[0].reasons.at(0).places, ElementsAre(HasSubstr("enters M::B (")));
}

TEST(MissedEvents, NoneWhereAnActionEndsWithItsCycle) {
    const std::string members = R"(
        state B { entry wait(2) }
        transition t1 { from A to B trigger f }
        transition t2 { from B to A trigger e })";
    EXPECT_THAT(missed_in(members, 2), IsEmpty());
    ASSERT_EQ(missed_in(members).size(), 1U);
    EXPECT_EQ(missed_in(members).front().cycles, 1U);
}

// t1 leads from A, which waits for f, to B, which waits for e. While the action of t1 runs, both events are missed.
TEST(MissedEvents, OfAnActionOfATransition) {
    const auto missed = missed_in(R"(
        state B { }
        transition t1 { from A to B trigger f action wait(3) }
        transition t2 { from B to A trigger e })");
    ASSERT_EQ(missed.size(), 2U);
    EXPECT_EQ(missed[0].event, "e");
    EXPECT_EQ(missed[1].event, "f");
    for (const MissedEvent& event : missed) {
        EXPECT_EQ(event.reasons.at(0).why, MissedWhile::busy);
        EXPECT_EQ(event.cycles, 2U);
        EXPECT_THAT(event.reasons.at(0).places, ElementsAre(HasSubstr("takes M::t1 (")));
    }
}

// Actions follow one another indefinitely, and each starts in the cycle in which the previous one ends. The event that
// the state waits for is never taken.
TEST(MissedEvents, WithoutBoundWhereActionsFollowEachOther) {
    const auto missed = missed_in(R"(
        state B { entry wait(2) }
        transition t1 { from A to B trigger f }
        transition t2 { from B to B }
        transition t3 { from B to A trigger e })");
    ASSERT_EQ(missed.size(), 1U);
    EXPECT_EQ(missed[0].event, "e");
    EXPECT_EQ(missed[0].reasons.at(0).why, MissedWhile::busy);
    EXPECT_EQ(missed[0].cycles, std::nullopt);
}

// The transition with e has a condition that never becomes true. f leaves the state.
TEST(MissedEvents, WhereNoConditionHolds) {
    const auto missed = missed_in(R"(
        var n : nat
        state B { entry n = 0 }
        transition t1 { from A to B trigger f }
        transition t2 { from B to A trigger e condition n > 0 }
        transition t3 { from B to A trigger f })");
    ASSERT_EQ(missed.size(), 1U);
    EXPECT_EQ(missed[0].event, "e");
    EXPECT_EQ(missed[0].reasons.at(0).why, MissedWhile::condition);
    EXPECT_EQ(missed[0].cycles, std::nullopt);
    EXPECT_THAT(missed[0].reasons.at(0).places, ElementsAre(HasSubstr("M::B")));
}

// f resets C in the cycle that enters B. The next three cycles start in the entry action, which ends in the last of
// them, when C is 3. The cycle after them starts in B with C = 4. The condition holds at 5.
TEST(MissedEvents, CountsBothReasonsInARow) {
    const auto missed = missed_in(R"(
        clock C
        state B { entry wait(3) }
        transition t1 { from A to B trigger f # C }
        transition t2 { from B to A trigger e condition since(C) >= 5 })");
    ASSERT_EQ(missed.size(), 1U);
    EXPECT_EQ(missed[0].event, "e");
    EXPECT_EQ(missed[0].cycles, 4U);
    ASSERT_EQ(missed[0].reasons.size(), 2U);
    EXPECT_EQ(missed[0].reasons[0].why, MissedWhile::busy);
    EXPECT_EQ(missed[0].reasons[0].cycles, 3U);
    EXPECT_EQ(missed[0].reasons[1].why, MissedWhile::condition);
    EXPECT_EQ(missed[0].reasons[1].cycles, 1U);
}

// No event is missed: a during action disables no transition, a state without a transition for e does not wait for e,
// and a transition without a condition takes it.
TEST(MissedEvents, NoneWhereEachIsTakenOrNotAwaited) {
    EXPECT_THAT(missed_in(R"(
        var n : nat
        state B { during wait(3) ; n = 1 }
        transition t1 { from A to B trigger f }
        transition t2 { from B to A trigger e }
        transition t3 { from B to A trigger e condition n > 0 })"),
                IsEmpty());
}

}  // namespace
}  // namespace robochart::conformance
