// SPDX-License-Identifier: Apache-2.0
// Tests the properties that are checked for every component. Comments next to the answers for the small machines give
// the reasons.
#include "csp_emit/core_properties.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

#include "checker/cspm/session.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::core_properties_test {
namespace {

using testing::load_model;
using testing::Model;

/// Maps "S: deadlock-free" to "holds" or "fails". `(information)` follows if the property is not required.
std::map<std::string, std::string> decide_properties(const std::string& rct, Time time = Time::timed) {
    const auto read = load_model(rct);
    const Emission emission = read->emit(time, true);
    EXPECT_TRUE(read->diagnostics.ok()) << read->messages();
    cspm::Session session(emission.script);
    std::map<std::string, std::string> result;
    for (const Obligation& obligation : emission.obligations) {
        if (obligation.firing) continue;  // not an assertion; see tests/app/command/firing_test.cpp
        EXPECT_EQ(obligation.assertions.size(), 1U);
        const bool holds = session.check(*obligation.assertions.front(), {}).verdict.outcome == refine::Outcome::holds;
        result[obligation.component + ": " + obligation.property_text] =
            std::string(holds ? "holds" : "fails") + (obligation.information ? " (information)" : "");
    }
    return result;
}

/// A machine that waits for `e` in A, goes to B, and returns after a while.
const std::string sound = R"(stm S { event e clock T initial i
state A { } state B { entry #T }
transition t0 { from i to A }
transition t1 { from A to B trigger e }
transition t2 { from B to A condition since(T) >= 2 } })";

TEST(CoreProperties, AreAskedOfEveryMachine) {
    const std::map<std::string, std::string> expected{
        {"state machine S: deadlock-free", "holds"},
        {"state machine S: divergence-free", "holds"},
        {"state machine S: timelock-free", "holds"},
        {"state machine S: T is reset before it is read", "holds"},
        {"state machine S: deterministic", "holds (information)"},
        {"state machine S: never terminates", "holds (information)"},
        {"state machine S: A is reachable", "holds (information)"},
        {"state machine S: B is reachable", "holds (information)"},
    };
    EXPECT_EQ(decide_properties(sound), expected);
}

TEST(CoreProperties, WithoutTimeNeitherTimelocksNorClocksAreAskedFor) {
    const auto found = decide_properties(sound, Time::untimed);
    EXPECT_EQ(found.size(), 6U);
    EXPECT_FALSE(found.contains("state machine S: timelock-free"));
}

TEST(CoreProperties, AStateThatNothingLeavesIsADeadlock) {
    const auto found = decide_properties(R"(stm S { event e initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e } })");
    EXPECT_EQ(found.at("state machine S: deadlock-free"), "fails");
    EXPECT_EQ(found.at("state machine S: timelock-free"), "holds") << "time passes in B";
}

TEST(CoreProperties, TerminationIsNeitherADeadlockNorATimelock) {
    for (const Time time : {Time::timed, Time::untimed}) {
        const auto found = decide_properties(R"(stm S { event e initial i state A { } final f
transition t0 { from i to A } transition t1 { from A to f trigger e } })",
                                             time);
        EXPECT_EQ(found.at("state machine S: deadlock-free"), "holds");
        EXPECT_EQ(found.at("state machine S: never terminates"), "fails (information)");
        EXPECT_TRUE(time == Time::untimed || found.at("state machine S: timelock-free") == "holds");
    }
}

TEST(CoreProperties, TransitionsWithoutTriggerForEverDiverge) {
    const auto found = decide_properties(R"(stm S { event e initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B } transition t2 { from B to A } })");
    EXPECT_EQ(found.at("state machine S: divergence-free"), "fails");
}

/// Without the assumption, the environment could refuse every call and every output, and thereby stop time.
TEST(CoreProperties, ThePlatformTakesCallsAndOutputsAtOnce) {
    const auto found = decide_properties(R"(interface I { move(x : nat) } interface V { var v : nat }
stm S { requires I requires V event e event o : nat initial i
state A { entry move(1); send o!1; v = 1 }
transition t0 { from i to A } transition t1 { from A to A trigger e } })");
    EXPECT_EQ(found.at("state machine S: timelock-free"), "holds");
}

TEST(CoreProperties, AnInputThatMustComeInTimeStopsTime) {
    const auto found =
        decide_properties(R"(stm S { event e : nat event g var x : nat initial i state A { entry e?x <{1} }
transition t0 { from i to A } transition t1 { from A to A trigger g } })");
    EXPECT_EQ(found.at("state machine S: timelock-free"), "fails") << "nobody has to send e within one unit";
}

TEST(CoreProperties, AClockThatIsReadBeforeItIsReset) {
    const auto found = decide_properties(R"(stm S { event e clock T initial i state A { }
transition t0 { from i to A } transition t1 { from A to A trigger e #T condition since(T) >= 2 } })");
    EXPECT_EQ(found.at("state machine S: T is reset before it is read"), "fails");
}

TEST(CoreProperties, AClockThatNothingReadsIsNotAskedAbout) {
    const auto found = decide_properties(R"(stm S { event e clock T initial i state A { entry #T }
transition t0 { from i to A } transition t1 { from A to A trigger e } })");
    EXPECT_FALSE(found.contains("state machine S: T is reset before it is read"));
}

TEST(CoreProperties, AStateThatCannotBeEntered) {
    const auto found = decide_properties(R"(stm S { event e initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e condition false }
transition t2 { from A to A trigger e } transition t3 { from B to A trigger e } })");
    EXPECT_EQ(found.at("state machine S: A is reachable"), "holds (information)");
    EXPECT_EQ(found.at("state machine S: B is reachable"), "fails (information)");
}

TEST(CoreProperties, AModuleIsAskedAboutTheStatesOfItsMachines) {
    const auto found = decide_properties(R"(stm S { event e event never initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to A trigger e } transition t2 { from A to B trigger never }
transition t3 { from B to A trigger e } }
controller C { event e sref s = S connection C on e to s on e }
module M { robotic platform P { event e } cref c = C connection P on e to c on e ( _async ) })");
    EXPECT_EQ(found.at("state machine S: B is reachable"), "holds (information)");
    EXPECT_EQ(found.at("module M: c::s::A is reachable"), "holds (information)");
    EXPECT_TRUE(found.contains("controller C: s::B is reachable"));
    EXPECT_FALSE(found.contains("state machine M::c::s: deadlock-free")) << "asked where it is defined";
}

/// The channel of the call belongs to the controller, not to the machine.
TEST(CoreProperties, AClockOfAMachineWhoseOperationCallsThePlatform) {
    const auto found = decide_properties(R"(interface I { move() } interface J { turn() }
operation turn() { requires I initial i final f transition t { from i to f action move() } }
controller C { requires I opref o = turn event e
  stm S { requires J event e clock T initial i state A { entry turn() }
    transition t0 { from i to A } transition t1 { from A to A trigger e condition since(T) >= 1 } }
  connection C on e to S on e })");
    EXPECT_EQ(found.at("state machine C::S: T is reset before it is read"), "fails");
}

TEST(CoreProperties, AnOperationIsNotAskedAboutOnItsOwn) {
    const auto found = decide_properties(R"(interface I { move() }
operation move() { initial i final f transition t { from i to f } }
stm S { requires I event e initial i state A { entry move() }
transition t0 { from i to A } transition t1 { from A to A trigger e } }
controller C { opref m = move sref s = S event e connection C on e to s on e })");
    for (const auto& [what, answer] : found) EXPECT_EQ(what.find("move"), std::string::npos) << what;
    EXPECT_EQ(found.at("state machine S: timelock-free"), "holds") << "a call of the platform there";
}

}  // namespace
}  // namespace robochart::csp_emit::core_properties_test
