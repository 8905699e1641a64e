// SPDX-License-Identifier: Apache-2.0
// Tests counterexamples in terms of the model for each form of claim: the path, the missed deadline, the loop.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/app/command.hpp"

namespace robochart::app::testing::counterexample_text_test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

const char* const machines = R"(
interface O { go() }
stm Late { event a event b initial i state A { } state B { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger a <{ 2 } }
  transition t2 { from B to B trigger b } }
stm Sends { event a event b initial i state A { } transition t0 { from i to A }
  transition t1 { from A to A trigger a action b <{ 1 } } }
stm Calls { requires O event a initial i state A { } transition t0 { from i to A }
  transition t1 { from A to A trigger a action go() } }
stm Spins { event a initial i state A { } state B { } state C { } transition t0 { from i to A }
  transition t1 { from A to B trigger a }
  transition t2 { from B to C }
  transition t3 { from C to B } }
stm Stops { event a initial i state A { } state B { } transition t0 { from i to A }
  transition t1 { from A to B trigger a } }
stm Ends { event a initial i state A { } final f transition t0 { from i to A }
  transition t1 { from A to f trigger a } }
stm Runs { event a initial i state A { } transition t0 { from i to A } transition t1 { from A to A trigger a } }
)";

/// Returns the report of this claim.
std::string reported(const std::string& claim) {
    const TemporaryFile model("reported.rct", machines);
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/reported.assertions") << claim << "\n";
    const Ran ran = run({"check", folder});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    return ran.out;
}

TEST(CounterexampleText, ATimelockNamesTheDeadlineThatWasMissed) {
    EXPECT_THAT(
        reported("timed assertion A : Late is timelock-free"),
        AllOf(HasSubstr("2 time units pass"), HasSubstr("why time cannot pass: the deadline of Late::t1 has run out ("),
              HasSubstr("reported.rct:5)")));
    EXPECT_THAT(reported("timed assertion A : Sends is timelock-free"),
                AllOf(HasSubstr("at b (deadline left = 0)"), HasSubstr("the deadline of Sends::t1 has run out ("),
                      HasSubstr("reported.rct:8)")));
    EXPECT_THAT(reported("timed assertion A : Calls is timelock-free"),
                HasSubstr("time cannot pass: call go waits for the environment, which may refuse it ("));
    EXPECT_THAT(reported("timed assertion A : Ends is timelock-free"),
                HasSubstr("time cannot pass: it has terminated"));
}

TEST(CounterexampleText, ADivergenceShowsItsLoop) {
    EXPECT_THAT(reported("untimed assertion A : Spins is divergence-free"),
                AllOf(HasSubstr("then for ever:"), HasSubstr("t2: B -> C"), HasSubstr("t3: C -> B"),
                      HasSubstr("go on internally for ever")));
}

TEST(CounterexampleText, ADeadlockInTimeIsNoDivergence) {
    EXPECT_THAT(reported("timed assertion A : Stops is deadlock-free"),
                AllOf(HasSubstr("now at t=0: in B"), HasSubstr("why nothing is possible any more but that time passes"),
                      Not(HasSubstr("internally"))));
}

/// Two machines of a controller. After 22 time units, the second machine waits for the first one indefinitely: the
/// clock has counted to 20, and the wait takes 2 more.
const char* const late = R"(
interface V { var y : nat }
interface K { event c }
stm Slow { requires V clock C initial i state S { } state T { entry wait(2) ; y = 1 } state U { }
  transition t0 { from i to S action # C }
  transition t1 { from S to T condition since(C) >= 20 }
  transition t2 { from T to U } }
stm Other { uses K requires V initial i state S { } state T { entry c }
  transition t0 { from i to S }
  transition t1 { from S to T condition y == 1 } }
robotic platform P { provides V }
controller Both { requires V sref slow = Slow sref other = Other sref never = Never connection other on c to never on c }
stm Never { uses K initial i state S { } transition t0 { from i to S } }
module M { robotic platform P { provides V } cref both = Both }
)";

/// Returns the first counterexample in the report of a claim about `late`.
nlohmann::json of_late(const std::string& claim, std::string* text = nullptr) {
    const TemporaryFile model("late.rct", late);
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/late.assertions") << claim << "\n";
    const Ran ran = run({"check", folder, "--format", "json"});
    EXPECT_EQ(ran.exit, 1) << ran.out << ran.err;
    if (text != nullptr) *text = run({"check", folder}).out;
    const auto report = nlohmann::json::parse(ran.out, nullptr, false);
    return report.is_discarded() ? nlohmann::json() : report["assertions"][0]["counterexample"];
}

// The check renames tock, which makes deadlocks visible. The counterexample must still show that time passes.
TEST(CounterexampleText, TimePassesWhateverTheCheckCallsIt) {
    std::string text;
    const auto run = of_late("timed assertion A : M is deadlock-free", &text);
    EXPECT_THAT(text,
                AllOf(HasSubstr("t=20   slow    t1: S -> T"), HasSubstr("t=22   slow    write y = 1"),
                      HasSubstr("t=22   other   t1: S -> T"), HasSubstr("now at t=22: slow: in U"),
                      HasSubstr("then for ever:\n                 t=22   1 time unit passes"), Not(HasSubstr("tock"))));
    EXPECT_EQ(run["schema"], "robochart-verify/run/1");
    EXPECT_EQ(run["time"], 22);
    EXPECT_EQ(run["end"]["kind"], "deadlock");
    std::vector<std::pair<int, int>> passing;
    for (const auto& step : run["steps"])
        if (step["kind"] == "tock") passing.emplace_back(step["time"].get<int>(), step["units"].get<int>());
    EXPECT_THAT(passing, ElementsAre(std::pair(0, 20), std::pair(20, 2), std::pair(22, 1)));
    EXPECT_EQ(run["steps"].back()["n"], run["loopStart"]);
}

TEST(CounterexampleText, EveryStepNamesItsMachineItsElementAndItsPlace) {
    const auto run = of_late("timed assertion A : M is deadlock-free");
    const auto find = [&](const std::string& text, const std::string& component) {
        for (const auto& step : run["steps"])
            if (step["text"] == text && step.value("component", "") == component) return step;
        ADD_FAILURE() << text;
        return nlohmann::json();
    };
    const auto fired = find("t1: S -> T", "M::both::slow");
    EXPECT_EQ(fired["kind"], "transition");
    EXPECT_EQ(fired["element"], "Slow::t1");
    EXPECT_EQ(fired["line"], 6);
    EXPECT_EQ(fired["column"], 3);
    EXPECT_EQ(fired["endLine"], 6);
    EXPECT_EQ(fired["hidden"], true);
    EXPECT_EQ(run["events"][fired["raw"].get<std::size_t>()], "τ(M::both::slow::internal__.M::both::slow::TID_t1)");
    for (const auto& machine : fired["machines"]) {
        if (machine["component"] == "M::both::slow") {
            EXPECT_EQ(machine["active"], nlohmann::json::array({"Slow::T"}));
        }
    }
    const auto written = find("write y = 1", "M::both::slow");
    EXPECT_EQ(written["kind"], "assignment");
    EXPECT_EQ(written["via"], "entry action of T");
    EXPECT_EQ(written["values"], nlohmann::json::array({{{"value", "1"}, {"type", "nat"}}}));
    const auto heard = find("others write y = 1", "M::both::other");
    EXPECT_EQ(heard["kind"], "externalWrite");
    EXPECT_EQ(heard["element"], "V::y");
    EXPECT_EQ(
        heard["changes"],
        nlohmann::json::array({{{"component", "M::both::other"}, {"name", "y"}, {"before", "0"}, {"after", "1"}}}));
}

// Before the first event, either machine can start.
TEST(CounterexampleText, WhatElseWasPossibleIsThere) {
    const auto run = of_late("timed assertion A : M is deadlock-free");
    std::set<std::string> begin{run["steps"][0]["component"]};
    for (const auto& offer : run["steps"][0]["offered"]) {
        EXPECT_EQ(offer["kind"], "transition");
        begin.insert(offer["component"]);
    }
    EXPECT_THAT(begin, ElementsAre("M::both::never", "M::both::other", "M::both::slow"));
}

TEST(CounterexampleText, ATimelockHasItsCause) {
    const auto run = of_late("timed assertion A : M is timelock-free");
    EXPECT_EQ(run["time"], 22);
    EXPECT_EQ(run["end"]["kind"], "timelock");
    ASSERT_EQ(run["end"]["causes"].size(), 1U);
    EXPECT_EQ(run["end"]["causes"][0]["text"], "write y = 1 waits for the environment, which may refuse it");
    EXPECT_EQ(run["end"]["causes"][0]["line"], 4);
    EXPECT_EQ(run["end"]["refused"][0]["kind"], "tock");
}

TEST(CounterexampleText, UntimedRunsHaveNoTime) {
    std::string text;
    const auto run = of_late("untimed assertion A : M is deadlock-free", &text);
    EXPECT_THAT(text, Not(HasSubstr("t=")));
    EXPECT_FALSE(run.contains("time"));
    for (const auto& step : run["steps"]) EXPECT_FALSE(step.contains("time"));
}

TEST(CounterexampleText, ReachabilityShowsThePath) {
    EXPECT_THAT(reported("untimed assertion A : Ends::f is not reachable in Ends"),
                AllOf(HasSubstr("t0: i -> A"), HasSubstr("input a"), HasSubstr("why the state has been reached")));
    EXPECT_THAT(reported("untimed assertion A : Late::B is reachable in Late\nassertion B : Runs does not refine Runs"),
                HasSubstr("it refines the other"));
}

/// The clocks and variables have so many values that separate processes store `n` and `m`.
const char* const held = R"(
interface O { go(x : nat) }
stm Held { requires O event a : nat var n : nat = 0 var m : nat = 7 clock C clock D
  initial i state A { } state B { entry n = n + 1 ; if m < 1 then go(0) else go(1) end } state F { entry n = n + 1 }
  state E { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger a ? m #C #D }
  transition t2 { from B to F condition since(C) >= 60 }
  transition t3 { from F to E condition since(D) >= 300 /\ n > 1 } }
)";

// The memory does not store a value that is never read again, but contains an older value. Here the memory of m
// contains 7, although m has received 0.
TEST(CounterexampleText, VariablesOutsideTheProcessAreShownLikeThoseInside) {
    const TemporaryFile model("held.rct", held);
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/held.assertions") << "timed assertion A : Held::E is not reachable in Held\n";
    const Ran script = run({"check", folder, "--print", "timed-script"});
    ASSERT_THAT(script.out, AllOf(HasSubstr("setL_n"), HasSubstr("setL_m"))) << "nothing is held outside";
    const Ran text = run({"check", folder});
    EXPECT_EQ(text.exit, 1) << text.err;
    EXPECT_THAT(text.out, AllOf(HasSubstr("[n = 1]"), HasSubstr("[n = 2]"), Not(HasSubstr("m = 7)")),
                                Not(HasSubstr("store n")), Not(HasSubstr("read n")), HasSubstr("now at t=300: in E")));
    const auto report = nlohmann::json::parse(run({"check", folder, "--format", "json"}).out);
    for (const auto& step : report["assertions"][0]["counterexample"]["steps"]) {
        ASSERT_EQ(step["machines"].size(), 1U) << step["text"];
        for (const auto& variable : step["machines"][0]["variables"]) {
            const bool stored = variable["name"] == "m" && step["kind"] != "transition";
            EXPECT_FALSE(stored && variable["value"] == "7") << step["text"];
        }
    }
}

// The script stores the received value, reads it for the guard, and starts an action with a call. The counterexample
// shows these steps as one input and one transition after it.
TEST(CounterexampleText, AnInputNamesTheTransitionWhoseActionBeginsWithACall) {
    const TemporaryFile model("guarded.rct", R"(
interface O { go(x : nat) }
stm G { requires O event e : nat var c : nat initial i state A { } state B { }
  transition t0 { from i to A }
  transition t1 { from A to A trigger e ? c condition c == 0 action go(1) }
  transition t2 { from A to B trigger e ? c condition c == 1 action go(2) } }
)");
    const std::string folder = std::filesystem::path(model.path()).parent_path().string();
    std::ofstream(folder + "/guarded.assertions") << "untimed assertion A : G::B is not reachable in G\n";
    EXPECT_THAT(run({"check", folder}).out, HasSubstr("input e with 1 (t2: A -> B)"));
}

TEST(CounterexampleText, TerminationIsSaid) {
    EXPECT_THAT(reported("untimed assertion A : Ends does not terminate"), HasSubstr("why it has terminated"));
    EXPECT_THAT(reported("timed assertion A : Runs terminates"),
                HasSubstr("no run terminates, and none ends in a deadlock"));
}

TEST(CounterexampleText, ClaimsThatNothingBreaksSayWhatIsSo) {
    EXPECT_THAT(reported("untimed assertion A : Runs is not deadlock-free"), HasSubstr("it is deadlock-free"));
    EXPECT_THAT(reported("untimed assertion A : Runs is not deterministic"), HasSubstr("it is deterministic"));
    EXPECT_THAT(reported("untimed assertion A : Runs is not divergence-free"), HasSubstr("it is divergence-free"));
    EXPECT_THAT(reported("untimed assertion A : Runs is not equal to Runs"),
                HasSubstr("each of the two refines the other"));
}

TEST(CounterexampleText, TickTockNamesWhatWasRefused) {
    EXPECT_THAT(reported("timed assertion A : Stops refines Runs in the tick-tock model"),
                AllOf(HasSubstr("refusal of input a"), HasSubstr("why refusal of input a is not allowed here")));
}

/// A module, its controller and its machine have the same deadlock. The text shows the counterexample once, but the
/// data contain it three times.
TEST(CoreProperties, ARunThatComponentsShareIsPrintedOnce) {
    const TemporaryFile model("stuck.rct", R"(
interface I { event go }
robotic platform P { uses I }
stm S {
  uses I
  initial i
  state A { }
  state B { }
  transition t0 { from i to A }
  transition t1 { from A to B trigger go }
}
controller C { uses I sref s = S connection C on go to s on go }
module M { rref p = P cref c = C connection p on go to c on go (_async) }
)");
    const Ran text = run({"check", model.path(), "--no-cache"});
    EXPECT_EQ(text.exit, 1) << text.err;
    EXPECT_EQ(text.out.find("the model does:"), text.out.rfind("the model does:")) << text.out;
    EXPECT_THAT(text.out, HasSubstr("the same run is one of controller C and of state machine S\n"));
    const std::size_t first = text.out.find("by the run of module M above\n");
    ASSERT_NE(first, std::string::npos) << text.out;
    EXPECT_NE(text.out.find("by the run of module M above\n", first + 1), std::string::npos) << text.out;
    const Ran data = run({"check", model.path(), "--no-cache", "--format", "json"});
    std::size_t runs = 0;
    const nlohmann::json report = nlohmann::json::parse(data.out);
    for (const auto& assertion : report.at("assertions")) runs += assertion.contains("counterexample") ? 1U : 0U;
    EXPECT_EQ(runs, 3U);
}

}  // namespace
}  // namespace robochart::app::testing::counterexample_text_test
