// SPDX-License-Identifier: Apache-2.0
// Tests the behaviour of a control cycle, construct by construct. Each expectation is derived from the rule that it
// names (semantics 3.3-3.10, codegen 5.2: R1-R8). The models are as small as the rule allows and report through output
// events.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::behaviour_test {
namespace {

using testing::component_named;
using testing::Controller;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Registers;

/// A machine M with these contents.
class Machine : public Controller {
public:
    explicit Machine(const std::string& body, const std::string& around = "")
        : Machine(testing::load_model("package p\n" + around + "stm M {\n" + body + "\n}\n"), "M") {}
    Machine(const ir::System& system, const std::string& name) : Controller(system, component_named(system, name)) {}
};

/// An operation of the platform. Unlike an output, it may be called several times in a cycle.
const char* const tell = "interface Tell { x(value : nat) }\n";
const char* const tell_int = "interface Tell { x(value : int) }\n";
const char* const start = "initial i transition t0 { from i to A }\n";

// ---------------------------------------------------------------- inputs (R1, R2)

TEST(Inputs, AreLostAtTheEndOfTheCycle) {
    Machine m(std::string("event a event b event x ") + start +
              "state A {} state B {} state C {}"
              "transition t1 { from A to B trigger a }"
              "transition t2 { from B to C trigger b action x }");
    EXPECT_THAT(m.cycle({{"b.in", ""}}), IsEmpty());
    EXPECT_THAT(m.cycle({{"a.in", ""}}), IsEmpty());
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_THAT(m.cycle({{"b.in", ""}}), ElementsAre("x.out"));
}

TEST(Inputs, AreConsumedOnceInACycle) {
    Machine m(std::string("event a event x : nat ") + start +
              "state A {} state B {} state C {}"
              "transition t1 { from A to B trigger a action x!1 }"
              "transition t2 { from B to C trigger a action x!2 }");
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("x.out(1)"));
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("x.out(2)"));
}

TEST(Inputs, GuardsSeeTheIncomingValueAndDoNotConsume) {
    // Semantics 3.4, "Guards": v starts at 0, so a guard on the old value would refuse 2 and accept nothing else.
    Machine m(std::string("event a : nat event x : nat var v : nat = 0 ") + start +
              "state A {} state B {}"
              "transition t1 { from A to B trigger a?v condition v > 1 action x!v }"
              "transition t2 { from A to A trigger a?v condition v == 1 action x!1 }");
    EXPECT_THAT(m.cycle({{"a.in", "1"}}), ElementsAre("x.out(1)"));
    EXPECT_THAT(m.cycle({{"a.in", "0"}}), IsEmpty());
    EXPECT_THAT(m.cycle({{"a.in", "2"}}), ElementsAre("x.out(2)"));
}

TEST(Inputs, InActionsAreAwaited) {
    Machine m(std::string("event a : nat event b event x : nat var v : nat = 0 ") + start +
              "state A { entry a?v ; x!v } state B {} transition t1 { from A to B trigger b }");
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_THAT(m.cycle({{"b.in", ""}}), IsEmpty());  // the entry action can't be interrupted
    EXPECT_THAT(m.cycle({{"a.in", "2"}, {"b.in", ""}}), ElementsAre("x.out(2)"));
    EXPECT_THAT(m.state(), HasSubstr("state=B"));
}

// ---------------------------------------------------------------- urgency (R3, R6)

TEST(Urgency, RunsToQuiescence) {
    Machine m(std::string("requires Tell ") + start +
                  "state A { entry x(1) } state B { entry x(2) } state C {}"
                  "transition t1 { from A to B } transition t2 { from B to C }",
              tell);
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(1)", "xCall(2)"));
    EXPECT_EQ(m.state(), "state=C");
}

TEST(Urgency, ALoopWithoutTimeReachesTheStepBound) {
    Machine m(std::string(start) + "state A {} transition t1 { from A to A }");
    m.cycle();
    EXPECT_EQ(m.result(), RC_STEP_BOUND);
}

TEST(Urgency, ALoopWithTimeDoesNot) {
    Machine m(std::string("event x ") + start + "state A { entry x ; wait(1) } transition t1 { from A to A }");
    for (int i = 0; i < 3; ++i) {
        EXPECT_THAT(m.cycle(), ElementsAre("x.out"));
        EXPECT_EQ(m.result(), RC_QUIESCENT);
    }
}

TEST(Urgency, OutputsAreASequence) {
    // docs/conformance.md, A2: a cycle may make any number of outputs, in order.
    Machine m(std::string("event x : nat event y ") + start + "state A { entry x!1 ; x!2 ; y }");
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)", "x.out(2)", "y.out"));
    EXPECT_THAT(m.cycle(), IsEmpty());
}

// ---------------------------------------------------------------- order within a transition (semantics 3.4)

const char* const nest = R"(
event leave event inner event enter requires Tell
initial i transition t0 { from i to O }
state O {
    initial j state P { entry x(1) exit x(2) } state Q { entry x(3) exit x(4) }
    transition u0 { from j to P }
    transition u1 { from P to Q trigger inner }
    entry x(0) exit x(5)
}
state R {}
transition t1 { from O to R trigger leave action x(6) }
transition t2 { from R to O trigger enter }
)";

TEST(Order, EntersFromTheOutside) {
    Machine m(nest, tell);
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(0)", "xCall(1)"));
}

TEST(Order, ExitsFromTheInsideThenActionThenEntry) {
    Machine m(nest, tell);
    m.cycle();
    EXPECT_THAT(m.cycle({{"inner.in", ""}}), ElementsAre("xCall(2)", "xCall(3)"));
    EXPECT_THAT(m.cycle({{"leave.in", ""}}), ElementsAre("xCall(4)", "xCall(5)", "xCall(6)"));
}

TEST(Order, ReEntryStartsAtTheInitialNode) {
    Machine m(nest, tell);
    m.cycle({{"inner.in", ""}});
    m.cycle({{"leave.in", ""}});
    EXPECT_THAT(m.cycle({{"enter.in", ""}}), ElementsAre("xCall(0)", "xCall(1)"));
    EXPECT_EQ(m.state(), "state=O_P");
}

TEST(Order, InnerTransitionsGoFirst) {
    Machine m(nest, tell);
    m.cycle();
    EXPECT_THAT(m.cycle({{"inner.in", ""}, {"leave.in", ""}}),
                ElementsAre("xCall(2)", "xCall(3)", "xCall(4)", "xCall(5)", "xCall(6)"));
}

TEST(Order, SelfTransitionsExitAndEnter) {
    Machine m(std::string("event a requires Tell ") + start +
                  "state A { entry x(1) exit x(2) } transition t1 { from A to A trigger a action x(3) }",
              tell);
    m.cycle();
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("xCall(2)", "xCall(3)", "xCall(1)"));
}

TEST(Order, ExitsMayTakeTime) {
    Machine m(
        "event leave event x : nat initial i transition t0 { from i to O }"
        "state O { initial j state P { exit x!1 ; wait(1) } transition u0 { from j to P } exit x!2 ; wait(1) }"
        "state R { entry x!3 } transition t1 { from O to R trigger leave }");
    m.cycle();
    EXPECT_THAT(m.cycle({{"leave.in", ""}}), ElementsAre("x.out(1)"));
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(2)"));
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(3)"));
}

// ---------------------------------------------------------------- nodes

const char* const fork = R"(
event a : nat event x : nat event b var v : nat = 0
initial i transition t0 { from i to A }
state A {} state B { entry x!1 } state C { entry x!2 } junction j
transition t1 { from A to j trigger a?v }
transition t2 { from j to B condition v == 1 }
transition t3 { from j to C condition v == 2 }
)";

TEST(Nodes, JunctionsChooseByGuard) {
    EXPECT_THAT(Machine(fork).cycle({{"a.in", "1"}}), ElementsAre("x.out(1)"));
    EXPECT_THAT(Machine(fork).cycle({{"a.in", "2"}}), ElementsAre("x.out(2)"));
}

TEST(Nodes, JunctionsWithoutATrueGuardBlock) {
    Machine m(fork);
    EXPECT_THAT(m.cycle({{"a.in", "0"}}), IsEmpty());
    EXPECT_EQ(m.result(), RC_QUIESCENT);
    EXPECT_THAT(m.cycle({{"a.in", "1"}}), IsEmpty());
}

TEST(Nodes, TheFinalNodeTerminates) {
    Machine m(std::string("event a event x ") + start +
              "state A {} final F transition t1 { from A to F trigger a action x }");
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("x.out"));
    EXPECT_EQ(m.result(), RC_TERMINATED);
    EXPECT_THAT(m.cycle({{"a.in", ""}}), IsEmpty());
    EXPECT_EQ(m.result(), RC_TERMINATED);
}

TEST(Nodes, AnInnerFinalNodeOnlyRests) {
    // Semantics 3.4, "No completion semantics".
    Machine m(
        "event a event x initial i transition t0 { from i to O }"
        "state O { initial j final F transition u0 { from j to F } exit x }"
        "state R {} transition t1 { from O to R trigger a }");
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_EQ(m.result(), RC_QUIESCENT);
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("x.out"));
}

// ---------------------------------------------------------------- during actions (semantics 3.3)

TEST(During, RunsOnceAnEntry) {
    Machine m(std::string("event a event x ") + start + "state A { during x } transition t1 { from A to A trigger a }");
    EXPECT_THAT(m.cycle(), ElementsAre("x.out"));
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("x.out"));
}

TEST(During, IsCutWhenTheStateIsLeft) {
    Machine m(std::string("event a event x : nat ") + start +
              "state A { during x!1 ; wait(2) ; x!2 } state B {} transition t1 { from A to B trigger a }");
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)"));
    EXPECT_THAT(m.cycle({{"a.in", ""}}), IsEmpty());
    for (int i = 0; i < 3; ++i) EXPECT_THAT(m.cycle(), IsEmpty());
}

TEST(During, GoesOnBesideInnerTransitions) {
    Machine m(
        "event a event x : nat initial i transition t0 { from i to O }"
        "state O { initial j state P {} state Q { entry x!7 }"
        "  transition u0 { from j to P } transition u1 { from P to Q trigger a }"
        "  during x!1 ; wait(2) ; x!2 }");
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)"));
    EXPECT_THAT(m.cycle({{"a.in", ""}}), ElementsAre("x.out(7)"));
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(2)"));
}

TEST(During, OfACompositeStartsWithItsFirstChildsEntry) {
    Machine m(
        "requires Tell initial i transition t0 { from i to O }"
        "state O { initial j state P { entry x(1) ; wait(1) ; x(2) } transition u0 { from j to P } during x(3) }",
        tell);
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(1)"));
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(2)", "xCall(3)"));
}

// ---------------------------------------------------------------- time (R5)

TEST(Time, ClocksAdvanceBetweenCycles) {
    Machine m(std::string("event x clock T ") + start +
              "state A {} state B {} transition t1 { from A to B condition since(T) >= 3 action x }");
    for (int cycle = 1; cycle <= 3; ++cycle) EXPECT_THAT(m.cycle(), IsEmpty()) << cycle;
    EXPECT_THAT(m.cycle(), ElementsAre("x.out"));
}

TEST(Time, AClockIsZeroForTheRestOfItsResetsCycle) {
    Machine m(std::string("event a event x clock T ") + start +
              "state A {} state B {}"
              "transition t1 { from A to B trigger a # T }"
              "transition t2 { from B to A condition since(T) >= 1 action x }");
    m.cycle();
    m.cycle();
    EXPECT_THAT(m.cycle({{"a.in", ""}}), IsEmpty());
    EXPECT_THAT(m.cycle(), ElementsAre("x.out"));
}

TEST(Time, SinceEntryCountsFromTheEndOfTheEntryAction) {
    Machine m(
        std::string("event x ") + start +
        "state A { entry wait(1) } state B {} transition t1 { from A to B condition sinceEntry(A) >= 2 action x }");
    for (int cycle = 1; cycle <= 3; ++cycle) EXPECT_THAT(m.cycle(), IsEmpty()) << cycle;  // entered in cycle 2
    EXPECT_THAT(m.cycle(), ElementsAre("x.out"));
}

TEST(Time, ClocksSaturateSoThatStatesAreFinite) {
    Machine m(std::string("event a clock T ") + start +
              "state A {} state B {} transition t1 { from A to B trigger a condition since(T) < 2 }");
    for (int i = 0; i < 5; ++i) m.cycle();
    const auto before = m.image();
    m.cycle();
    EXPECT_EQ(m.image(), before);
}

TEST(Time, WaitsTakeWholeCycles) {
    Machine m(std::string("requires Tell ") + start + "state A { entry x(1) ; wait(2) ; x(2) ; wait(0) ; x(3) }", tell);
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(1)"));
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(2)", "xCall(3)"));
}

TEST(Time, LongerCyclesAdvanceByTheirLength) {
    const ir::System system =
        testing::load_model(std::string("package p stm M { event x clock T ") + start +
                            "state A {} state B {} transition t1 { from A to B condition since(T) >= 3 action x } }");
    Options options;
    options.cycle_length = 2;
    Controller m(system, component_named(system, "M"), options);
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_THAT(m.cycle(), IsEmpty());
    EXPECT_THAT(m.cycle(), ElementsAre("x.out"));  // 4 units after the start
}

// ---------------------------------------------------------------- deadlines (R7, semantics 3.10)

TEST(Deadlines, OfAStatementAreMissedWhenItIsNotOverInTime) {
    Machine m(std::string("event a event x ") + start + "state A { entry a <{ 2 } ; x }");
    Machine awaiting(std::string("event a : nat var v : nat event x ") + start + "state A { entry a?v <{ 2 } ; x }");
    for (int cycle = 1; cycle <= 2; ++cycle) {
        EXPECT_THAT(awaiting.cycle(), IsEmpty());
        EXPECT_EQ(awaiting.result(), RC_QUIESCENT) << cycle;  // two units may pass
    }
    awaiting.cycle();
    EXPECT_EQ(awaiting.result(), RC_DEADLINE);
    awaiting.reset();
    awaiting.cycle();
    awaiting.cycle();
    EXPECT_THAT(awaiting.cycle({{"a.in", "1"}}), ElementsAre("x.out"));
    for (int cycle = 1; cycle <= 4; ++cycle) awaiting.cycle();
    EXPECT_EQ(awaiting.result(), RC_QUIESCENT);  // the statement met its deadline, so the deadline has ended
    EXPECT_THAT(m.cycle(), ElementsAre("a.out", "x.out"));
    EXPECT_EQ(m.result(), RC_QUIESCENT);
}

TEST(Deadlines, OfATransitionCountWhileItsGuardHolds) {
    Machine m(std::string("event a event b event c clock T ") + start +
              "state A {} state B {} transition t1 { from A to B trigger a <{ 1 } condition since(T) >= 2 }"
              "transition t2 { from A to B trigger b } transition t3 { from B to A trigger c # T }");
    for (int cycle = 0; cycle <= 2; ++cycle) m.cycle();  // the guard holds from time 2 on
    EXPECT_EQ(m.result(), RC_QUIESCENT);
    const auto at_two = m.image();
    m.cycle();
    EXPECT_EQ(m.result(), RC_DEADLINE);
    m.restore(at_two);
    m.cycle({{"b.in", ""}});  // any transition from A meets the deadline
    EXPECT_EQ(m.result(), RC_QUIESCENT);
    for (int cycle = 1; cycle <= 4; ++cycle) m.cycle();
    EXPECT_EQ(m.result(), RC_QUIESCENT);
}

// ---------------------------------------------------------------- statements and values

TEST(Statements, BranchesMayTakeTime) {
    Machine m(std::string("event a : boolean requires Tell var v : boolean = false ") + start +
                  "state A { entry a?v ; if v then x(1) ; wait(1) ; x(2) else x(3) end ; x(4) }",
              tell);
    EXPECT_THAT(m.cycle({{"a.in", "true"}}), ElementsAre("xCall(1)"));
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(2)", "xCall(4)"));
    m.reset();
    EXPECT_THAT(m.cycle({{"a.in", "false"}}), ElementsAre("xCall(3)", "xCall(4)"));
}

TEST(Values, ArithmeticIsClippedToTheCarrier) {
    // Semantics 3.13: int is {-2..2} here, so 2 + 1 yields its first operand.
    Machine m(
        std::string("requires Tell var v : int = 2 ") + start + "state A { entry v = v + 1 ; x(v) ; v = v - 1 ; x(v) }",
        tell_int);
    EXPECT_THAT(m.cycle(), ElementsAre("xCall(2)", "xCall(1)"));
}

TEST(Values, BooleansStartTrueAndRealsAreScaled) {
    Machine m(std::string("event x : boolean event y : real var v : boolean var r : real = 0.25 ") + start +
              "state A { entry x!v ; y!r }");
    EXPECT_EQ(m.interface().scale, 100);
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)", "y.out(25)"));
}

TEST(Values, EnumerationsAreNumbered) {
    Machine m(std::string("event a : Light event x : Light var v : Light ") + start +
                  "state A {} transition t1 { from A to A trigger a?v condition v != Light::Red action x!v }",
              "enumeration Light { Red Green }\n");
    ASSERT_EQ(m.interface().inputs, 1U);
    EXPECT_STREQ(m.interface().input[0].text[1], "p_Light_Green");
    EXPECT_THAT(m.cycle({{"a.in", "p_Light_Red"}}), IsEmpty());
    EXPECT_THAT(m.cycle({{"a.in", "p_Light_Green"}}), ElementsAre("x.out(1)"));
}

TEST(Values, SharedVariablesAreWrittenFromOutside) {
    // Semantics 3.7: the machine has a copy of the variable, so it sees its own writes.
    Machine m(std::string("requires I event x : nat ") + start +
                  "state A {} state B { entry v = 0 } transition t1 { from A to B condition v == 2 action x!v }",
              "interface I { var v : nat }\n");
    EXPECT_THAT(m.cycle({{"set_EXT_v", "1"}}), IsEmpty());
    EXPECT_THAT(m.cycle({{"set_EXT_v", "2"}}), ElementsAre("x.out(2)", "set_v(0)"));
}

// ---------------------------------------------------------------- names

TEST(Names, KeepClearOfCppAndOfEachOther) {
    Machine m(
        "requires I event stop event double : nat var int : nat = 1 initial default transition switch { from default "
        "to class }"
        "state class { entry stop() ; double!int } state at {} transition enter_class { from class to at trigger stop "
        "}",
        "interface I { stop() }\n");
    EXPECT_THAT(m.cycle(), ElementsAre("stopCall", "double.out(1)"));
    m.cycle({{"stop.in", ""}});
    EXPECT_THAT(m.state(), HasSubstr("state=at"));
}

// ---------------------------------------------------------------- operations (semantics 3.8)

std::string with_operation(const std::string& operation, const std::string& body) {
    return "package p\ninterface I { op(a : nat) }\ninterface E { event x : nat event e event b : nat }\n" + operation +
           "\nstm M { requires I uses E " + body +
           " }\ncontroller C { uses E sref m = M opref o = op connection m on x to C on x connection C on e to m on e "
           "connection C on b to m on b }\n";
}

const char* const counting = R"(
operation op(a : nat) {
    precondition a > 0
    uses E
    var n : nat = 0
    initial i state S { entry n = n + a ; x!n ; wait(1) } final F
    transition t0 { from i to S } transition t1 { from S to F }
})";

TEST(Operations, StartAfreshAtEachCall) {
    const ir::System system = testing::load_model(
        with_operation(counting, std::string(start) + "state A { entry op(1) } transition t1 { from A to A }"));
    Machine m(system, "C");
    for (int i = 0; i < 3; ++i) EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)"));
}

TEST(Operations, LeaveNoTraceInTheState) {
    const ir::System system = testing::load_model(with_operation(
        counting, std::string(start) + "state A {} state B { entry op(1) } state D { entry op(2) }"
                                       "transition t1 { from A to B trigger e } transition t2 { from B to D trigger e }"
                                       "transition t3 { from D to A trigger e }"));
    Machine m(system, "C");
    m.cycle();
    const auto rested = m.image();
    for (int i = 0; i < 3; ++i) {
        m.cycle({{"e.in", ""}});
        m.cycle();
    }
    EXPECT_EQ(m.state(), "state=A");
    EXPECT_EQ(m.image(), rested);
}

TEST(Operations, OutsideTheirPreconditionAreReported) {
    const ir::System system =
        testing::load_model(with_operation(counting, std::string(start) + "state A { entry op(0) }"));
    Machine m(system, "C");
    EXPECT_THAT(m.cycle(), ElementsAre());
    EXPECT_EQ(m.result(), RC_PRECONDITION);
}

TEST(Operations, OutsideTheirPreconditionEndTheCycleAndLaterOnes) {
    const ir::System system = testing::load_model(
        with_operation(counting, std::string(start) + "state A { entry x!1 ; op(0) ; x!2 during x!2 }"));
    Machine m(system, "C");
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)"));
    EXPECT_EQ(m.result(), RC_PRECONDITION);
    EXPECT_THAT(m.cycle(), ElementsAre());
    EXPECT_EQ(m.result(), RC_PRECONDITION);
}

// The machine that would run next does nothing in that cycle.
TEST(Operations, OutsideTheirPreconditionEndTheCycleOfOtherMachines) {
    const ir::System system = testing::load_model(
        "package p\ninterface I { op(a : nat) }\ninterface E { event x : nat }\n"
        "operation op(a : nat) { precondition a > 0 initial i final F transition t0 { from i to F } }\n"
        "stm M { requires I initial i transition t0 { from i to A } state A { entry op(0) } }\n"
        "stm N { uses E initial i transition t0 { from i to A } state A { entry x!1 } }\n"
        "controller C { uses E sref m = M sref n = N opref o = op connection n on x to C on x }");
    Machine m(system, "C");
    EXPECT_THAT(m.cycle(), ElementsAre());
    EXPECT_EQ(m.result(), RC_PRECONDITION);
}

TEST(Operations, MayReceive) {
    const char* const receiving = R"(
operation op(a : nat) {
    uses E
    var v : nat
    initial i state S {} final F
    transition t0 { from i to S } transition t1 { from S to F trigger b?v condition v == a }
})";
    const ir::System system = testing::load_model(with_operation(
        receiving,
        std::string(start) + "state A { entry op(2) ; x!1 } state B {} transition t1 { from A to B trigger e }"));
    Machine m(system, "C");
    EXPECT_THAT(m.cycle({{"b.in", "1"}}), IsEmpty());
    EXPECT_THAT(m.cycle({{"e.in", ""}}), IsEmpty());
    EXPECT_THAT(m.cycle({{"b.in", "2"}}), ElementsAre("x.out(1)"));
}

TEST(Operations, InADuringActionAreCutWithIt) {
    const ir::System system = testing::load_model(with_operation(
        counting,
        std::string(start) + "state A { during op(1) ; x!2 } state B {} transition t1 { from A to B trigger e }"));
    Machine m(system, "C");
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(1)"));
    const auto running = m.image();
    EXPECT_THAT(m.cycle(), ElementsAre("x.out(2)"));
    m.restore(running);
    // During actions run first, so this one ends before the transition. If the event came one cycle earlier, the
    // transition would interrupt it.
    EXPECT_THAT(m.cycle({{"e.in", ""}}), ElementsAre("x.out(2)"));
    EXPECT_EQ(m.state(), "state=B during_A=idle");
}

}  // namespace
}  // namespace robochart::cpp_emit::behaviour_test
