// SPDX-License-Identifier: Apache-2.0
// Tests `event E is missed in S for N time units` (docs/assertions.md, "Missed events"). The answers follow from the
// waits of the small machines, by hand.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit {
namespace {

using testing::claims;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::model;

/// A machine that goes from Moving::Go to Moving::Busy with `go`, and from Moving to Halted with `stop`, with these
/// parts.
std::string moving(const std::string& busy, const std::string& rest = "", const std::string& trigger = "stop") {
    return "interface O { act() turn() }\nstm S { requires O event go event stop event out var n : nat = 0 initial i "
           "state Moving { initial j state Go { } state Busy { " +
           busy +
           " } transition a { from j to Go } transition b { from Go to Busy trigger go } "
           "transition c { from Busy to Go } } state Halted { } transition d { from i to Moving } "
           "transition e { from Moving to Halted trigger " +
           trigger + " } transition f { from Halted to Moving trigger stop } " + rest + " }";
}

std::string claim(const std::string& where, int units, bool missed = false) {
    static int number = 0;
    return "assertion A" + std::to_string(++number) + " : event stop is " + (missed ? "" : "not ") + "missed in " +
           where + (units == 0 ? "" : " for " + std::to_string(units) + " time units") + "\n";
}

std::vector<std::string> decided(const std::string& text, const std::string& claimed) {
    const auto m = model(text, claimed);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
    return claims(*m, Time::timed);
}

TEST(MissedEvents, AreThoseThatNothingTakesWhileTimePasses) {
    const std::string three = moving("entry wait(3)");
    EXPECT_THAT(decided(three, claim("S::Moving", 0) + claim("S::Moving", 3) + claim("S::Moving", 4)),
                ElementsAre("fails", "fails", "holds"));
    EXPECT_THAT(decided(three, claim("S::Moving", 1, true) + claim("S::Moving", 3, true) + claim("S::Moving", 4, true)),
                ElementsAre("holds", "holds", "fails"));
    EXPECT_THAT(decided(three, claim("S::Moving::Go", 0) + claim("S::Moving::Busy", 3) + claim("S::Moving::Busy", 4) +
                                   claim("S::Halted", 0) + claim("S", 3) + claim("S", 4)),
                ElementsAre("holds", "fails", "holds", "holds", "fails", "holds"));
}

TEST(MissedEvents, AreNoneWhereTheStateWaits) {
    EXPECT_THAT(decided(moving("", "clock T"), claim("S::Moving", 0) + claim("S", 0)), ElementsAre("holds", "holds"));
    EXPECT_THAT(decided(moving("during wait(3)"), claim("S::Moving", 0)), ElementsAre("holds"))
        << "a during action is interrupted";
    EXPECT_THAT(decided(moving("entry stop"), claim("S::Moving", 0)), ElementsAre("holds")) << "the action takes it";
    EXPECT_THAT(decided(moving("entry send out; stop; wait(1)"), claim("S::Moving", 0) + claim("S::Moving", 2)),
                ElementsAre("fails", "holds"));
}

/// Busy is left and entered again immediately, but the event is offered in between.
TEST(MissedEvents, AStateThatIsPassedTakesTheEvent) {
    EXPECT_THAT(decided(moving("entry wait(2)"), claim("S::Moving", 2) + claim("S::Moving", 3)),
                ElementsAre("fails", "holds"));
    const std::string passed =
        "stm S { event go event stop initial i state A { entry wait(2) } state B { entry wait(2) } transition a { from "
        "i "
        "to A } transition b { from A to B } transition c { from B to A } transition d { from A to A trigger stop } }";
    EXPECT_THAT(decided(passed, claim("S", 4) + claim("S", 5)), ElementsAre("fails", "holds"));
}

TEST(MissedEvents, TimePassesWhereTheEventIsOnOffer) {
    const std::string text =
        "stm S { event stop clock T initial i state A { } state B { entry wait(2) } transition a { from i to A #T } "
        "transition b { from A to B condition since(T) >= 3 } transition c { from A to A trigger stop } "
        "transition d { from B to A #T } }";
    EXPECT_THAT(decided(text, claim("S", 2) + claim("S", 3)), ElementsAre("fails", "holds"));
}

TEST(MissedEvents, ThePlatformTakesCallsAndOutputsAtOnce) {
    EXPECT_THAT(decided(moving("entry send out; act()"), claim("S::Moving", 0)), ElementsAre("holds"));
}

TEST(MissedEvents, ConditionsCount) {
    EXPECT_THAT(decided(moving("", "", "stop condition n > 0"), claim("S::Moving", 0) + claim("S::Moving", 1000)),
                ElementsAre("fails", "fails"));
}

TEST(MissedEvents, AStateIsOneFromItsEntryActionUntilItIsLeft) {
    const std::string text =
        "stm S { event go event stop initial i state A { exit wait(2) } state B { entry wait(2) initial j state C { } "
        "transition k { from j to C action wait(3) } } transition a { from i to A } transition b { from A to B trigger "
        "go action wait(5) } transition c { from A to A trigger stop } transition d { from B to A trigger stop } }";
    EXPECT_THAT(decided(text, claim("S::A", 0) + claim("S::B", 5) + claim("S::B", 6) + claim("S::B::C", 0) +
                                  claim("S", 12) + claim("S", 13)),
                ElementsAre("holds", "fails", "holds", "holds", "fails", "holds"));
}

TEST(MissedEvents, AStateIsKnownInOperationsThatSeveralCall) {
    const std::string text =
        "operation turn() { initial i final f transition t { from i to f action wait(2) } }\n"
        "interface O { turn() }\ncontroller K { opref o = turn stm S { requires O event go event stop initial i state "
        "A "
        "{ entry turn() } state B { entry turn(); wait(1) } transition a { from i to A } transition b { from A to B "
        "trigger go } transition c { from A to A trigger stop } transition d { from B to A trigger stop } } }";
    EXPECT_THAT(decided(text, claim("K::S::A", 2) + claim("K::S::A", 3) + claim("K::S::B", 3) + claim("K::S::B", 4)),
                ElementsAre("fails", "holds", "fails", "holds"));
}

TEST(MissedEvents, TheEndOfTheMachineCountsForNothing) {
    const std::string text =
        "stm S { event stop initial i state A { } final f transition a { from i to A } transition b { from A to f "
        "trigger stop } }";
    EXPECT_THAT(decided(text, claim("S", 0)), ElementsAre("holds"));
}

TEST(MissedEvents, AnEventThatIsTakenBetweenBeginsTheCountAnew) {
    const std::string text =
        "stm S { event stop initial i state A { } state B { entry wait(2) } transition a { from i to A } "
        "transition b { from A to B trigger stop } transition c { from B to B trigger stop } }";
    EXPECT_THAT(decided(text, claim("S", 2) + claim("S", 3)), ElementsAre("fails", "holds"));
}

TEST(MissedEvents, HaveNoCheckWithoutTime) {
    const auto m = model(moving("entry wait(3)"), "assertion A : event stop is not missed in S\n");
    EXPECT_THAT(claims(*m, Time::untimed), ElementsAre(HasSubstr("an event is missed while time passes")));
}

}  // namespace
}  // namespace robochart::csp_emit
