// SPDX-License-Identifier: Apache-2.0
// Tests the search for events of outer states that are processed second in a cycle, after an event of an inner state or
// after a timeout. The search also finds the states in which this happens.
#include "conformance/check/overtaken_events.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Returns the overtaken events of a robot. It has an emergency stop around a composite state with these members.
std::vector<OvertakenEvent> overtaken_in(const std::string& inside) {
    const test::ModelFolder folder(
        "interface Motion { go() halt() brake() }\n"
        "stm M {\n requires Motion\n event obstacle event stop event clear : nat\n clock T\n var x : nat\n initial i\n"
        " state Moving { initial j\n" +
        inside +
        " }\n state Stopped { entry brake() }\n transition t0 { from i to Moving }\n"
        " transition t1 { from Moving to Stopped trigger stop }\n}");
    test::Model model(folder.path());
    diagnostics::Diagnostics found;
    const Result result =
        conform(model.system, model.instantiation, model.machine_named("M"), Options(), model.sources, found);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    return result.overtaken;
}

// With both events, the code halts and then brakes. With only `stop`, it brakes.
TEST(OvertakenEvents, OfAnOuterStateAfterThoseOfAnInnerOne) {
    const auto overtaken = overtaken_in(R"(
        state Driving { }
        state Held { entry halt() }
        transition a { from j to Driving }
        transition b { from Driving to Held trigger obstacle }
        transition c { from Held to Driving trigger clear ? x action go() })");
    ASSERT_EQ(overtaken.size(), 1U);
    EXPECT_EQ(overtaken[0].event, "stop");
    EXPECT_THAT(overtaken[0].by, ElementsAre("obstacle", "clear"));
    EXPECT_FALSE(overtaken[0].due);
    EXPECT_THAT(overtaken[0].places, ElementsAre(HasSubstr("Driving ("), HasSubstr("Held (")));
}

// Driving has a timeout two units after its entry. In that cycle `stop` is processed second.
TEST(OvertakenEvents, AfterATimeoutThatIsDue) {
    const auto overtaken = overtaken_in(R"(
        state Driving { }
        state Held { entry halt() }
        transition a { from j to Driving #T }
        transition b { from Driving to Held condition since(T) >= 2 })");
    ASSERT_EQ(overtaken.size(), 1U);
    EXPECT_EQ(overtaken[0].event, "stop");
    EXPECT_TRUE(overtaken[0].due);
    EXPECT_THAT(overtaken[0].by, IsEmpty());
}

// With `obstacle` and without it, the exit action halts and then the robot brakes. So the outputs do not show that
// `obstacle` was processed first.
TEST(OvertakenEvents, AreNotShownByAnExitActionThatBothShare) {
    EXPECT_THAT(overtaken_in(R"(
        state Driving { exit halt() }
        state Held { }
        transition a { from j to Driving }
        transition b { from Driving to Held trigger obstacle })"),
                IsEmpty());
}

// Here the inner transition makes no output, so the order is not observable.
TEST(OvertakenEvents, AreNotShownByTransitionsWithoutOutputs) {
    EXPECT_THAT(overtaken_in(R"(
        state Driving { }
        state Held { }
        transition a { from j to Driving }
        transition b { from Driving to Held trigger obstacle })"),
                IsEmpty());
}

}  // namespace
}  // namespace robochart::conformance
