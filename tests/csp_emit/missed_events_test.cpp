// SPDX-License-Identifier: Apache-2.0
// Tests `event E is missed in S for N time units` (docs/assertions.md, "Missed events"). The answers follow by hand
// from the waits of the small machines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::missed_events_test {
namespace {

using testing::decide_obligations;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::load_model;

/// Returns a machine with these parts. `go` leads from Moving::Go to Moving::Busy, and `stop` leads from Moving to
/// Halted.
std::string moving_machine(const std::string& busy, const std::string& rest = "", const std::string& trigger = "stop") {
    return "interface O { act() turn() }\nstm S { requires O event go event stop event out var n : nat = 0 initial i "
           "state Moving { initial j state Go { } state Busy { " +
           busy +
           " } transition a { from j to Go } transition b { from Go to Busy trigger go } "
           "transition c { from Busy to Go } } state Halted { } transition d { from i to Moving } "
           "transition e { from Moving to Halted trigger " +
           trigger + " } transition f { from Halted to Moving trigger stop } " + rest + " }";
}

std::string claim_text(const std::string& where, int units, bool missed = false) {
    static int number = 0;
    return "assertion A" + std::to_string(++number) + " : event stop is " + (missed ? "" : "not ") + "missed in " +
           where + (units == 0 ? "" : " for " + std::to_string(units) + " time units") + "\n";
}

std::vector<std::string> decide_missed(const std::string& text, const std::string& claimed) {
    const auto m = load_model(text, claimed);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
    return decide_obligations(*m, Time::timed);
}

TEST(MissedEvents, AreEventsThatNoTransitionTakesWhileTimePasses) {
    const std::string three = moving_machine("entry wait(3)");
    EXPECT_THAT(
        decide_missed(three, claim_text("S::Moving", 0) + claim_text("S::Moving", 3) + claim_text("S::Moving", 4)),
        ElementsAre("fails", "fails", "holds"));
    EXPECT_THAT(decide_missed(three, claim_text("S::Moving", 1, true) + claim_text("S::Moving", 3, true) +
                                         claim_text("S::Moving", 4, true)),
                ElementsAre("holds", "holds", "fails"));
    EXPECT_THAT(decide_missed(three, claim_text("S::Moving::Go", 0) + claim_text("S::Moving::Busy", 3) +
                                         claim_text("S::Moving::Busy", 4) + claim_text("S::Halted", 0) +
                                         claim_text("S", 3) + claim_text("S", 4)),
                ElementsAre("holds", "fails", "holds", "holds", "fails", "holds"));
}

TEST(MissedEvents, AreNoneWhereTheStateWaits) {
    EXPECT_THAT(decide_missed(moving_machine("", "clock T"), claim_text("S::Moving", 0) + claim_text("S", 0)),
                ElementsAre("holds", "holds"));
    EXPECT_THAT(decide_missed(moving_machine("during wait(3)"), claim_text("S::Moving", 0)), ElementsAre("holds"))
        << "a during action is interrupted";
    EXPECT_THAT(decide_missed(moving_machine("entry stop"), claim_text("S::Moving", 0)), ElementsAre("holds"))
        << "the action takes it";
    EXPECT_THAT(decide_missed(moving_machine("entry send out; stop; wait(1)"),
                              claim_text("S::Moving", 0) + claim_text("S::Moving", 2)),
                ElementsAre("fails", "holds"));
}

/// The machine leaves Busy and enters it again immediately, but offers the event in between.
TEST(MissedEvents, AStateThatIsPassedTakesTheEvent) {
    EXPECT_THAT(decide_missed(moving_machine("entry wait(2)"), claim_text("S::Moving", 2) + claim_text("S::Moving", 3)),
                ElementsAre("fails", "holds"));
    const std::string passed =
        "stm S { event go event stop initial i state A { entry wait(2) } state B { entry wait(2) } transition a { from "
        "i "
        "to A } transition b { from A to B } transition c { from B to A } transition d { from A to A trigger stop } }";
    EXPECT_THAT(decide_missed(passed, claim_text("S", 4) + claim_text("S", 5)), ElementsAre("fails", "holds"));
}

TEST(MissedEvents, TimePassesWhereTheEventIsOnOffer) {
    const std::string text =
        "stm S { event stop clock T initial i state A { } state B { entry wait(2) } transition a { from i to A #T } "
        "transition b { from A to B condition since(T) >= 3 } transition c { from A to A trigger stop } "
        "transition d { from B to A #T } }";
    EXPECT_THAT(decide_missed(text, claim_text("S", 2) + claim_text("S", 3)), ElementsAre("fails", "holds"));
}

TEST(MissedEvents, ThePlatformTakesCallsAndOutputsAtOnce) {
    EXPECT_THAT(decide_missed(moving_machine("entry send out; act()"), claim_text("S::Moving", 0)),
                ElementsAre("holds"));
}

TEST(MissedEvents, ConditionsCount) {
    EXPECT_THAT(decide_missed(moving_machine("", "", "stop condition n > 0"),
                              claim_text("S::Moving", 0) + claim_text("S::Moving", 1000)),
                ElementsAre("fails", "fails"));
}

TEST(MissedEvents, AStateIsOneFromItsEntryActionUntilItIsLeft) {
    const std::string text =
        "stm S { event go event stop initial i state A { exit wait(2) } state B { entry wait(2) initial j state C { } "
        "transition k { from j to C action wait(3) } } transition a { from i to A } transition b { from A to B trigger "
        "go action wait(5) } transition c { from A to A trigger stop } transition d { from B to A trigger stop } }";
    EXPECT_THAT(decide_missed(text, claim_text("S::A", 0) + claim_text("S::B", 5) + claim_text("S::B", 6) +
                                        claim_text("S::B::C", 0) + claim_text("S", 12) + claim_text("S", 13)),
                ElementsAre("holds", "fails", "holds", "holds", "fails", "holds"));
}

TEST(MissedEvents, AStateIsKnownInOperationsThatSeveralCall) {
    const std::string text =
        "operation turn() { initial i final f transition t { from i to f action wait(2) } }\n"
        "interface O { turn() }\ncontroller K { opref o = turn stm S { requires O event go event stop initial i state "
        "A "
        "{ entry turn() } state B { entry turn(); wait(1) } transition a { from i to A } transition b { from A to B "
        "trigger go } transition c { from A to A trigger stop } transition d { from B to A trigger stop } } }";
    EXPECT_THAT(decide_missed(text, claim_text("K::S::A", 2) + claim_text("K::S::A", 3) + claim_text("K::S::B", 3) +
                                        claim_text("K::S::B", 4)),
                ElementsAre("fails", "holds", "fails", "holds"));
}

TEST(MissedEvents, TheEndOfTheMachineCountsForNothing) {
    const std::string text =
        "stm S { event stop initial i state A { } final f transition a { from i to A } transition b { from A to f "
        "trigger stop } }";
    EXPECT_THAT(decide_missed(text, claim_text("S", 0)), ElementsAre("holds"));
}

TEST(MissedEvents, AnEventThatIsTakenBetweenBeginsTheCountAnew) {
    const std::string text =
        "stm S { event stop initial i state A { } state B { entry wait(2) } transition a { from i to A } "
        "transition b { from A to B trigger stop } transition c { from B to B trigger stop } }";
    EXPECT_THAT(decide_missed(text, claim_text("S", 2) + claim_text("S", 3)), ElementsAre("fails", "holds"));
}

TEST(MissedEvents, HaveNoCheckWithoutTime) {
    const auto m = load_model(moving_machine("entry wait(3)"), "assertion A : event stop is not missed in S\n");
    EXPECT_THAT(decide_obligations(*m, Time::untimed), ElementsAre(HasSubstr("an event is missed while time passes")));
}

}  // namespace
}  // namespace robochart::csp_emit::missed_events_test
