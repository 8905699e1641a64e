// SPDX-License-Identifier: Apache-2.0
// Tests operations that call operations. If an operation requires a variable, it uses the variable with that name in
// its caller's scope (semantics 3.8): the caller's own variable or clock, the machine's, or one that the caller itself
// requires.
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"
#include "tests/conformance/check/expect_conforming.hpp"

namespace robochart::conformance {
namespace {

void expect_conforming(const std::string& text) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    ASSERT_FALSE(model.system.controllers.empty());
    EXPECT_GT(test::expect_conforming(model, model.first_controller()).code_cycles, 1U);
}

const std::string interfaces =
    "interface Level { var level : nat } interface Pace { clock T }\n"
    "interface Outer { outer() } interface Inner { inner() } interface Middle { middle() }\n";

const std::string shows = "connection S on o to K on o";

TEST(NestedOperations, AVariableOfTheCallingOperation) {
    expect_conforming(interfaces +
                      "operation inner() { requires Level event o : nat initial i final f\n"
                      "  transition t { from i to f action o!level; wait(1); level = 1 } }\n"
                      "operation outer() { requires Inner event o : nat var level : nat = 2 initial i final f\n"
                      "  transition t { from i to f action inner(); wait(1); o!level } }\n"
                      "controller K { event o : nat opref a = inner opref b = outer\n"
                      "stm S { event o : nat requires Outer initial i state A { entry outer() }\n"
                      "  transition t { from i to A } } " +
                      shows + " }\n");
}

/// The machine and the operation have different variables with the same name. The inner operation accesses each of them
/// in turn.
TEST(NestedOperations, CallersThatMeanDifferentVariables) {
    expect_conforming(interfaces +
                      "operation inner() { requires Level event o : nat initial i final f\n"
                      "  transition t { from i to f action o!level; wait(1); level = 1 } }\n"
                      "operation outer() { requires Inner event o : nat var level : nat = 2 initial i final f\n"
                      "  transition t { from i to f action inner(); wait(1); o!level } }\n"
                      "controller K { event o : nat opref a = inner opref b = outer\n"
                      "stm S { event o : nat uses Level requires Outer requires Inner initial i\n"
                      "  state A { entry level = 0; inner(); wait(1); outer(); wait(1); o!level }\n"
                      "  transition t { from i to A } } " +
                      shows + " }\n");
}

TEST(NestedOperations, ThroughACallerThatRequiresItToo) {
    expect_conforming(interfaces +
                      "operation inner() { requires Level event o : nat initial i junction j final f\n"
                      "  transition t { from i to j } transition t1 { from j to f condition level < 2\n"
                      "  action o!level; wait(1); level = level + 1 }\n"
                      "  transition t2 { from j to f condition level >= 2 action level = 0 } }\n"
                      "operation middle() { requires Level requires Inner event o : nat initial i\n"
                      "  state W { entry inner() } final f\n"
                      "  transition t { from i to W } transition t1 { from W to f action inner() } }\n"
                      "operation outer() { requires Middle requires Inner event o : nat var level : nat = 1 initial i\n"
                      "  final f transition t { from i to f action middle(); inner(); wait(1); o!level } }\n"
                      "controller K { event o : nat event go opref a = inner opref b = middle opref c = outer\n"
                      "stm S { event o : nat event go uses Level requires Outer requires Middle requires Inner\n"
                      "  initial i state A { entry level = 0; outer(); wait(1); middle(); wait(1); o!level }\n"
                      "  transition t { from i to A } transition t1 { from A to A trigger go } }\n" +
                      shows + " connection K on go to S on go }\n");
}

TEST(NestedOperations, AClockOfTheCallingOperation) {
    expect_conforming(interfaces +
                      "operation inner() { requires Pace initial i final f transition t { from i to f action #T } }\n"
                      "operation outer() { requires Inner event o : nat clock T initial i final f\n"
                      "  state V { entry wait(1); inner() } transition t { from i to V }\n"
                      "  transition t1 { from V to f condition since(T) >= 2 action o!1 } }\n"
                      "controller K { event o : nat opref a = inner opref b = outer\n"
                      "stm S { event o : nat requires Outer initial i state A { entry outer() }\n"
                      "  transition t { from i to A } } " +
                      shows + " }\n");
}

/// Only the inner operation reads the clock, and the machine has a clock with the same name.
TEST(NestedOperations, AClockThatOnlyTheInnerOperationReads) {
    expect_conforming(
        interfaces +
        "operation inner() { requires Pace event o : nat initial i final f state V { }\n"
        "  transition t { from i to V } transition t1 { from V to f condition since(T) >= 1 action o!1 } }\n"
        "operation outer() { requires Inner event o : nat clock T initial i final f\n"
        "  transition t { from i to f action #T; inner(); wait(1); inner() } }\n"
        "controller K { event o : nat opref a = inner opref b = outer\n"
        "stm S { event o : nat clock T requires Outer requires Inner initial i\n"
        "  state A { entry wait(1); outer(); wait(1); #T; inner() }\n"
        "  transition t { from i to A } } " +
        shows + " }\n");
}

/// The caller's during action runs the operation at the same time as its exit action or transition, so all of them
/// share one variable.
TEST(NestedOperations, CalledByDuringActionsOfTheCallingOperation) {
    expect_conforming(
        interfaces +
        "operation inner() { requires Level requires Pace event o : nat initial i final f\n"
        "  state W { entry wait(1) } transition t { from i to W action #T }\n"
        "  transition t1 { from W to f condition since(T) >= 1 action o!level; level = 2 } }\n"
        "operation outer() { requires Inner event o : nat event go uses Level uses Pace initial i final f\n"
        "  state V { during inner(); inner() exit wait(1); o!level } transition t { from i to V action level = 1 }\n"
        "  transition t1 { from V to f trigger go action inner(); wait(1); o!level } }\n"
        "controller K { event o : nat event go opref a = inner opref b = outer\n"
        "stm S { event o : nat event go requires Outer initial i state A { entry outer() }\n"
        "  transition t { from i to A } }\n" +
        shows + " connection K on go to S on go }\n");
}

/// The machine sends the value of the caller's variable to another machine, and stores a received value in it.
TEST(NestedOperations, TheirVariablesInARendezvous) {
    expect_conforming(
        interfaces +
        "operation inner() { requires Level event p : nat event q : nat initial i final f\n"
        "  transition t { from i to f action p!level; q?level } }\n"
        "operation outer() { requires Inner event p : nat event q : nat event o : nat\n"
        "  var level : nat = 2 initial i final f\n"
        "  transition t { from i to f action inner(); o!level; wait(1); inner(); wait(1); o!level } }\n"
        "controller K { event o : nat event shown : nat opref a = inner opref b = outer\n"
        "stm S { event p : nat event q : nat event o : nat requires Outer initial i\n"
        "  state A { entry outer() } transition t { from i to A } }\n"
        "stm R { event p : nat event q : nat event shown : nat var y : nat initial i state A { } state B { }\n"
        "  transition t { from i to A }\n"
        "  transition t1 { from A to B trigger p?y condition y > 0 action shown!y; q!1 }\n"
        "  transition t2 { from B to A trigger p?y action q!0 } }\n" +
        shows + " connection R on shown to K on shown connection S on p to R on p connection R on q to S on q }\n");
}

TEST(NestedOperations, TheirVariablesInPreconditionsGuardsWaitsAndDeadlines) {
    expect_conforming(interfaces +
                      "interface Up { up(by : nat) }\n"
                      "operation up(by : nat) { precondition by <= level\n"
                      "  requires Level event o : nat event go initial i final f state V { entry wait(level) }\n"
                      "  transition t { from i to V } transition t1 { from V to f trigger go condition level >= 1\n"
                      "  action o!by } transition t2 { from V to f condition level < 1 action o!by } }\n"
                      "operation outer() { requires Up event o : nat event go uses Level initial i final f\n"
                      "  transition t { from i to f action level = 2; up(1); wait(1); level = 0; up(level) } }\n"
                      "controller K { event o : nat event go opref a = up opref b = outer\n"
                      "stm S { event o : nat event go requires Outer initial i state A { entry outer() }\n"
                      "  transition t { from i to A } }\n" +
                      shows + " connection K on go to S on go }\n");
}

/// Two machines run the same operations, and one of them also calls the inner operation directly. Each machine has its
/// own state.
TEST(NestedOperations, InSeveralMachines) {
    expect_conforming(interfaces +
                      "operation inner() { requires Level requires Pace event o : nat initial i final f state W { }\n"
                      "  transition t { from i to W action #T; o!level }\n"
                      "  transition t1 { from W to f condition since(T) >= level action level = 1 } }\n"
                      "operation outer() { requires Inner event o : nat uses Level uses Pace initial i final f\n"
                      "  transition t { from i to f action level = 2; inner(); o!level } }\n"
                      "controller K { event o : nat event o2 : nat opref a = inner opref b = outer\n"
                      "stm S { event o : nat requires Outer initial i state A { entry outer() }\n"
                      "  transition t { from i to A } }\n"
                      "stm R { event o : nat uses Level uses Pace requires Outer requires Inner initial i\n"
                      "  state A { entry outer(); wait(1); inner(); level = 0; wait(1); inner() }\n"
                      "  transition t { from i to A } }\n" +
                      shows + " connection R on o to K on o2 }\n");
}

/// No operation reads the controller's shared variable. The operations read variables with the same name that belong to
/// their callers.
TEST(NestedOperations, AnOperationsVariableIsNotTheSharedOneOfItsName) {
    expect_conforming(interfaces +
                      "operation inner() { requires Level event o : nat initial i final f\n"
                      "  transition t { from i to f action o!level; level = 1 } }\n"
                      "operation outer() { requires Inner event o : nat uses Level initial i final f\n"
                      "  transition t { from i to f action level = 2; inner(); wait(1); o!level } }\n"
                      "controller K { event o : nat requires Level opref a = inner opref b = outer\n"
                      "stm S { event o : nat requires Level requires Outer initial i\n"
                      "  state A { entry outer(); wait(1); level = 2 } transition t { from i to A } } " +
                      shows + " }\n");
}

}  // namespace
}  // namespace robochart::conformance
