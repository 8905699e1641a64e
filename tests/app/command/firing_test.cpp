// SPDX-License-Identifier: Apache-2.0
// Tests the core property "every transition fires" on models in which it is obvious whether each transition can be
// taken.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/app/command.hpp"

namespace robochart::app::testing::firing_test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

std::string checked(const std::string& model, const std::vector<std::string>& more = {}) {
    const TemporaryFile file("m.rct", model);
    std::vector<std::string> words{"check", file.path(), "--core", "--no-cache"};
    words.insert(words.end(), more.begin(), more.end());
    const Ran ran = run(words);
    EXPECT_LE(ran.exit, 1) << ran.out << ran.err;
    return ran.out;
}

TEST(Firing, AllThatCanBeTakenAre) {
    const std::string out = checked(R"(stm S { event e : nat event o initial i junction j var x : nat
state A { } state B { initial k state C { } transition t4 { from k to C } }
transition t0 { from i to A }
transition t1 { from A to j trigger e?x }
transition t2 { from j to B condition x == 0 action send o }
transition t3 { from j to A condition x > 0 }
transition t5 { from B to A trigger e?x } })");
    EXPECT_THAT(out, HasSubstr("every transition fires"));
    EXPECT_THAT(out, Not(HasSubstr("never taken")));
}

TEST(Firing, ATransitionWhoseGuardIsNeverTrue) {
    const std::string out = checked(R"(stm S { event e initial i var x : nat
state A { entry x = 1 } state B { }
transition t0 { from i to A }
transition t1 { from A to B trigger e }
transition t2 { from B to A trigger e condition x > 1 }
transition t3 { from B to B trigger e condition x == 1 } })");
    EXPECT_THAT(out, HasSubstr("never taken: t2: B -> A ("));
    EXPECT_THAT(out, HasSubstr("m.rct:5)"));
    EXPECT_THAT(out, Not(HasSubstr("t3")));
}

// A machine that waits in an exit action is not at the target of its transition yet, and has not performed the
// transition's action. The state that it will enter shows which transition it is taking.
TEST(Firing, TransitionsThatWaitInAnExitActionAreTaken) {
    const std::string out = checked(R"(stm S { event a event b initial i
state A { exit wait(1) } state B { }
state C { initial k state D { exit wait(1) } transition t6 { from k to D } }
transition t0 { from i to A }
transition t1 { from A to B trigger a }
transition t2 { from A to A trigger a }
transition t3 { from B to C trigger b }
transition t4 { from C to C trigger b }
transition t5 { from C to A trigger b } })");
    EXPECT_THAT(out, HasSubstr("every transition fires"));
    EXPECT_THAT(out, Not(HasSubstr("never taken")));
}

// Both guards may be true, and the step does not show which transition was taken. The check cannot conclude that the
// other transition is never taken.
TEST(Firing, IsUnknownIfAStepMayBeOneOfSeveralTransitions) {
    const std::string out = checked(R"(stm S { event e initial i var x : nat
state A { } state B { }
transition t0 { from i to A }
transition t1 { from A to B trigger e }
transition t2 { from A to B trigger e condition x > 1 }
transition t3 { from B to A trigger e } })",
                                    {"--untimed", "--format", "json"});
    const auto report = nlohmann::json::parse(out);
    for (const auto& row : report["assertions"])
        if (row["core"]["property"] == "every transition fires") {
            EXPECT_EQ(row["answer"], "inconclusive");
            EXPECT_THAT(row["reason"].get<std::string>(),
                        AllOf(HasSubstr("do not tell"), HasSubstr("t1: "), HasSubstr("t2: "), Not(HasSubstr("t3"))));
            return;
        }
    FAIL() << out;
}

/// A machine that never sends `o`.
const std::string silent = R"(stm Silent { event o initial i state A { } state B { entry send o }
transition t0 { from i to A } transition t1 { from A to B condition false } transition t2 { from B to A } }
)";

// The environment of the machine alone may send `never`. In the controller, no component sends it.
TEST(Firing, IsAskedInTheContextOfEachComponent) {
    const std::string out = checked(silent + R"(stm S { event e event never initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to A trigger e } transition t2 { from A to B trigger never }
transition t3 { from B to A trigger e } }
controller C { event e sref s = S sref u = Silent connection C on e to s on e connection u on o to s on never })");
    const std::string inside =
        out.substr(out.find("controller C"), out.find("state machine") - out.find("controller C"));
    EXPECT_THAT(inside, HasSubstr("never taken: s: t2: A -> B ("));
    EXPECT_THAT(inside, HasSubstr("s: t3: B -> A ("));
    EXPECT_THAT(inside, Not(HasSubstr("s: t1")));
    EXPECT_THAT(out.substr(out.find("state machine S\n")), HasSubstr("every transition fires"));
}

// The controller contains two instances of one machine.
TEST(Firing, IsAskedOfEachInstance) {
    const std::string out = checked(silent + R"(stm S { event e initial i state A { } state B { }
transition t0 { from i to A } transition t1 { from A to B trigger e } transition t2 { from B to A } }
controller C { event e sref one = S sref two = S sref u = Silent
connection C on e to one on e connection u on o to two on e })");
    const std::string inside =
        out.substr(out.find("controller C"), out.find("state machine") - out.find("controller C"));
    EXPECT_THAT(inside, HasSubstr("two: t1: A -> B ("));
    EXPECT_THAT(inside, Not(HasSubstr("one: t1")));
}

/// Returns a machine that cycles through 30 states.
std::string ring(const std::string& name) {
    std::string text = "stm " + name + " { event e initial i var x : nat\ntransition t0 { from i to A0 }\n";
    for (int at = 0; at < 30; ++at)
        text += fmt::format("state A{0} {{ }} transition u{0} {{ from A{0} to A{1} trigger e }}\n", at, (at + 1) % 30);
    return text + "transition never { from A0 to A1 condition x > 0 } }\n";
}

// Three such machines in parallel have 27,000 states.
TEST(Firing, IsNotKnownWhereThereAreTooManyStates) {
    const std::string out =
        checked(ring("R") + "controller C { event a event b event c sref r = R sref s = R sref t = R\n" +
                    "connection C on a to r on e connection C on b to s on e connection C on c to t on e }",
                {"--untimed", "--format", "json"});
    const auto report = nlohmann::json::parse(out);
    std::vector<std::string> reasons;
    for (const auto& row : report["assertions"])
        if (row["core"]["property"] == "every transition fires" && row["answer"] == "inconclusive")
            reasons.push_back(row["reason"].get<std::string>());
    EXPECT_THAT(reasons, ElementsAre(HasSubstr("has not been taken in the first 20000 states"))) << out;
}

}  // namespace
}  // namespace robochart::app::testing::firing_test
