// SPDX-License-Identifier: Apache-2.0
// Compares generated processes with CSPM that was written by hand from the reference (semantics 3.3 to 3.8). Processes
// are equal if they refine each other in the failures-divergences model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::behaviour_test {
namespace {

using testing::check_equivalence;
using testing::load_model;

std::string compare_untimed(const std::string& rct, const std::string& definitions) {
    const auto m = load_model(rct);
    if (!m->diagnostics.ok()) return m->messages();
    return check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", definitions);
}

std::string compare_timed(const std::string& rct, const std::string& definitions) {
    const auto m = load_model(rct);
    if (!m->diagnostics.ok()) return m->messages();
    return check_equivalence(*m, Time::timed, "S::D__(0)", "Spec", definitions);
}

/// Returns a machine S with events a to f without values.
std::string machine(const std::string& body) {
    return "stm S {\n event a event b event c event d event f event g event n:nat event m:nat\n" + body + "}\n";
}

TEST(States, CompositeEntersOutsideInAndExitsInsideOut) {
    EXPECT_EQ(compare_untimed(
                  machine(R"(
        initial i
        state C {
            entry a
            exit d
            initial j
            state L { entry b exit c }
            transition u { from j to L }
        }
        state D { entry g }
        transition t0 { from i to C }
        transition t1 { from C to D trigger f action n ! 1 }
    )"),
                  "Spec = S::a.out -> S::b.out -> S::f.in -> S::c.out -> S::d.out -> S::n.out.1 -> S::g.out -> STOP"),
              "holds");
}

TEST(States, SelfTransitionRunsExitAndEntry) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state A { entry a exit b }
        transition t0 { from i to A }
        transition t1 { from A to A trigger c }
    )"),
                              "Spec = S::a.out -> S::c.in -> S::b.out -> Spec"),
              "holds");
}

TEST(States, OuterTransitionsCompeteWithInnerOnes) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state C {
            initial j
            state L { }
            state M { }
            transition u0 { from j to L }
            transition u1 { from L to M trigger a action b }
        }
        state D { }
        transition t0 { from i to C }
        transition t1 { from C to D trigger a action c }
    )"),
                              // In the inner state, `a` may trigger either transition. While `b` is offered, the outer
                              // transition is not possible.
                              "Spec = S::a.in -> (S::b.out -> S::a.in -> S::c.out -> STOP |~| S::c.out -> STOP)"),
              "holds");
}

TEST(States, InnerFinalLeavesTheCompositeWaiting) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state C {
            initial j
            final k
            transition u0 { from j to k action a }
        }
        state D { }
        transition t0 { from i to C }
        transition t1 { from C to D trigger b action c }
    )"),
                              "Spec = S::a.out -> S::b.in -> S::c.out -> STOP"),
              "holds");
}

TEST(States, TopLevelFinalTerminates) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        final k
        transition t0 { from i to k action a }
    )"),
                              "Spec = S::a.out -> S::terminate -> SKIP"),
              "holds");
}

TEST(Transitions, GuardOnTheIncomingValueRefusesTheOthers) {
    EXPECT_EQ(compare_untimed(machine(R"(
        var x:nat
        initial i
        state A { }
        state B { entry m ! x }
        transition t0 { from i to A }
        transition t1 { from A to B trigger n ? x condition x > 0 }
    )"),
                              "Spec = S::n.in?v:{1,2} -> S::m.out!v -> STOP"),
              "holds");
}

const char* const racing_machine = R"(
        var x:nat
        initial i
        state C {
            exit g
            initial j
            state L { exit a ; m ! x }
            transition u0 { from j to L }
        }
        state D { entry m ! x }
        transition t0 { from i to C }
        transition t1 { from C to D trigger n ? x }
    )";

TEST(Transitions, InnerExitsRaceWithTheStore) {
    // Semantics 3.4: the value is stored while the inner states are left. The source state's own exit action follows
    // both.
    EXPECT_EQ(compare_untimed(machine(racing_machine),
                              "Spec = S::n.in?v -> S::a.out -> (S::m.out.0 -> Rest(v) |~| S::m.out!v -> Rest(v))\n"
                              "Rest(v) = S::g.out -> S::m.out!v -> STOP"),
              "holds");
}

TEST(Transitions, AStoreIsDoneBeforeTimePasses) {
    // The store is hidden: after one time unit, `m` sends the new value.
    EXPECT_EQ(
        compare_timed(machine(racing_machine),
                      "Timed(OneStep) {\n"
                      "Run = S::n.in?v -> ((S::a.out -> (S::m.out.0 -> Rest(v) |~| New(v))) [> S::a.out -> New(v))\n"
                      "New(v) = S::m.out!v -> Rest(v)\n"
                      "Rest(v) = S::g.out -> S::m.out!v -> STOP\n"
                      "Spec = timed_priority(Run)\n}\n"),
        "holds");
}

TEST(Transitions, DeadlinesReadTheVariableThatTheGuardAsksTheInputFor) {
    // x is always 0, so the guard is false for the process that monitors the deadline, which never stops time
    // (semantics 3.10).
    EXPECT_EQ(compare_timed(machine(R"(
        var x:nat
        initial i
        state A { }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger n ? x <{ 1 } condition x > 0 }
    )"),
                            "Timed(OneStep) {\nSpec = S::n.in?v:{1,2} -> STOP\n}\n"),
              "holds");
}

TEST(Transitions, TheSameTriggerTwiceIsAnInternalChoice) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state A { }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger a action b }
        transition t2 { from A to B trigger a action c }
    )"),
                              "Spec = S::a.in -> (S::b.out -> STOP |~| S::c.out -> STOP)"),
              "holds");
}

TEST(Transitions, OneWithoutTriggerCompetesWithATrigger) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state A { }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger a action b }
        transition t2 { from A to B action c }
    )"),
                              "Spec = (S::a.in -> S::b.out -> STOP) [> (S::c.out -> STOP)"),
              "holds");
}

TEST(Transitions, JunctionWithTwoTrueGuardsChooses) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        junction j
        state A { }
        transition t0 { from i to j }
        transition t1 { from j to A condition 1 > 0 action a }
        transition t2 { from j to A condition 2 > 1 action b }
        transition t3 { from j to A condition 2 > 3 action c }
    )"),
                              "Spec = S::a.out -> STOP |~| S::b.out -> STOP"),
              "holds");
}

TEST(Transitions, JunctionWithoutTrueGuardBlocks) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        junction j
        state A { }
        transition t0 { from i to j action a }
        transition t1 { from j to A condition 1 > 2 action b }
    )"),
                              "Spec = S::a.out -> STOP"),
              "holds");
}

TEST(Actions, PrivateAssignmentsAndConditionals) {
    EXPECT_EQ(compare_untimed(machine(R"(
        var x:nat = 1, y:nat
        initial i
        state A { entry x = x + 1 ; y = x ; if y == 2 then m ! y else m ! 0 end ; if x == 0 then a else skip end ; b }
        transition t0 { from i to A }
    )"),
                              "Spec = S::m.out.2 -> S::b.out -> STOP"),
              "holds");
}

TEST(Actions, ArithmeticIsClippedToTheType) {
    EXPECT_EQ(compare_untimed(machine(R"(
        var x:nat = 2
        initial i
        state A { entry x = x + 1 ; m ! x }
        transition t0 { from i to A }
    )"),
                              "Spec = S::m.out.2 -> STOP"),
              "holds");
}

TEST(Actions, DuringActionsAreCutAtAnyPoint) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state A { during a ; b }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger c action d }
    )"),
                              R"(
        Cut = S::c.in -> S::d.out -> STOP
        Spec = S::a.out -> (S::b.out -> Cut [] Cut) [] Cut)"),
              "holds");
}

TEST(Actions, AssignmentsOfDuringActionsMayComeTooLate) {
    EXPECT_EQ(compare_untimed(machine(R"(
        var x:nat
        initial i
        state A { during a ; x = 1 }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger c condition x == 0 action d }
    )"),
                              R"(
        Cut = S::c.in -> S::d.out -> STOP
        Spec = S::a.out -> (Cut [> STOP) [] Cut)"),
              "holds");
}

TEST(Actions, DuringActionRunsInParallelWithInnerStates) {
    EXPECT_EQ(compare_untimed(machine(R"(
        initial i
        state C {
            during a
            initial j
            state L { during b }
            transition u0 { from j to L }
        }
        state D { }
        transition t0 { from i to C }
        transition t1 { from C to D trigger c }
    )"),
                              R"(
        Spec = (S::a.out -> SKIP ||| S::b.out -> SKIP ; STOP) /\ S::c.in -> STOP)"),
              "holds");
}

TEST(Memory, OthersMayWriteRequiredVariablesAtAnyTime) {
    // Reading is one hidden step. Later writes of other machines do not change the value that was read.
    EXPECT_EQ(compare_untimed(R"(
        interface I { var x:nat }
        stm S {
            requires I
            initial i
            state A { entry x = x + 1 }
            transition t0 { from i to A }
        })",
                              R"(
        Before(x) = (S::set_EXT_x?y -> Before(y)) [> Pending(Plus(x,1,core_nat))
        Pending(v) = S::set_x!v -> After [] S::set_EXT_x?y -> Pending(v)
        After = S::set_EXT_x?y -> After
        Spec = Before(0))"),
              "holds");
}

TEST(Memory, GuardsSeeExternalWrites) {
    EXPECT_EQ(compare_untimed(R"(
        interface I { var x:nat }
        stm S {
            requires I
            event a
            initial i
            state A { }
            state B { }
            transition t0 { from i to A }
            transition t1 { from A to B trigger a condition x == 1 }
        })",
                              R"(
        A(x) = S::set_EXT_x?y -> A(y) [] x == 1 & S::a.in -> B
        B = S::set_EXT_x?y -> B
        Spec = A(0))"),
              "holds");
}

TEST(Memory, OthersMayWriteUntilTheArgumentsOfACallAreRead) {
    // RoboTool's process is share__choice(exited -> SKIP) ; share__choice(get_x?x -> goCall.x -> SKIP), in which
    // goCall.x is outside a share__choice.
    EXPECT_EQ(compare_untimed(R"(
        interface I { var x:nat }
        interface O { go(v:nat) }
        stm S {
            requires I requires O
            event a
            initial i
            state A { }
            state B { }
            transition t0 { from i to A }
            transition t1 { from A to B trigger a action go(1) ; go(x) }
        })",
                              R"(
        A(x) = S::set_EXT_x?y -> A(y) [] S::a.in -> Left(x)
        Left(x) = (S::set_EXT_x?y -> Left(y)) [> S::goCall.1 -> Read(x)
        Read(x) = (S::set_EXT_x?y -> Read(y)) [> S::goCall.x -> B
        B = S::set_EXT_x?y -> B
        Spec = A(0))"),
              "holds");
}

TEST(Memory, OthersMayWriteAtTheExitsOfATransitionAndNotBetweenItsCalls) {
    // RoboTool's process is Active = ENTRY ; ... share__choice(exit -> SKIP) ; EXIT ; share__choice(exited -> SKIP),
    // then the action and enter.
    EXPECT_EQ(compare_untimed(R"(
        interface I { var x:nat }
        interface O { go(v:nat) }
        stm S {
            requires I requires O
            event a
            initial i
            state A { exit go(0) }
            state B { entry go(2) }
            transition t0 { from i to A }
            transition t1 { from A to B trigger a action go(1) }
        })",
                              R"(
        A = S::set_EXT_x?y -> A [] S::a.in -> Exit
        Exit = (S::set_EXT_x?y -> Exit) [> S::goCall.0 -> Exited
        Exited = (S::set_EXT_x?y -> Exited) [> S::goCall.1 -> S::goCall.2 -> B
        B = S::set_EXT_x?y -> B
        Spec = A)"),
              "holds");
}

TEST(Operations, UndefinedOnesAreOneEvent) {
    EXPECT_EQ(compare_untimed(R"(
        interface O { go(x:nat, y:boolean) stop() }
        stm S {
            requires O
            var v:nat = 2
            initial i
            state A { entry go(v, false) ; stop() }
            transition t0 { from i to A }
        })",
                              "Spec = S::goCall.2.false -> S::stopCall -> STOP"),
              "holds");
}

// As in a trigger, a value that violates the condition is refused. x is 1 when the machine waits for the second value.
TEST(Actions, ReceiveOnlyWhatSatisfiesTheCondition) {
    EXPECT_EQ(compare_untimed(machine(R"(
        var x : nat = 1 var y : nat
        initial i
        state A { entry n [| y > x |] ? y ; m ! y ; n [| x == y - x |] ? y ; m ! y }
        transition t0 { from i to A }
    )"),
                              "Spec = S::n.in.2 -> S::m.out.2 -> S::n.in.2 -> S::m.out.2 -> STOP"),
              "holds");
}

TEST(Actions, AConditionOnWhatIsSentIsRefused) {
    const auto m = load_model(machine(R"(
        var x : nat initial i state A { entry n [| x == 0 |] ! x } transition t0 { from i to A })"));
    EXPECT_NE(m->messages().find("a condition on a communication that receives no value in an action"),
              std::string::npos)
        << m->messages();
}

TEST(Time, WaitsCountTocksAndOutputsAreNotUrgent) {
    EXPECT_EQ(compare_timed(machine(R"(
        initial i
        state A { entry a ; wait(2) ; b }
        transition t0 { from i to A }
    )"),
                            R"(
        A0 = S::a.out -> tock -> tock -> B0 [] tock -> A0
        B0 = S::b.out -> Rest [] tock -> B0
        Rest = tock -> Rest
        Spec = A0)"),
              "holds");
}

TEST(Time, PlatformCallsAreUrgent) {
    EXPECT_EQ(compare_timed(R"(
        interface O { go() }
        stm S { requires O initial i state A { entry go() } transition t0 { from i to A } })",
                            R"(
        Rest = tock -> Rest
        Spec = S::goCall -> Rest)"),
              "holds");
}

TEST(Time, ATransitionFiresAsSoonAsItsClockAllows) {
    EXPECT_EQ(compare_timed(machine(R"(
        clock T
        initial i
        state A { }
        state B { entry a }
        transition t0 { from i to A # T }
        transition t1 { from A to B trigger b condition since(T) < 2 }
        transition t2 { from A to B condition since(T) >= 3 }
    )"),
                            R"(
        In = S::b.in -> Out
        Spec = In [] tock -> (In [] tock -> tock -> Out)
        Out = S::a.out -> Rest [] tock -> Out
        Rest = tock -> Rest)"),
              "holds");
}

TEST(Time, AMissedDeadlineStopsTime) {
    EXPECT_EQ(compare_timed(machine(R"(
        initial i
        state A { entry a <{1} }
        transition t0 { from i to A }
    )"),
                            R"(
        Spec = S::a.out -> Rest [] tock -> S::a.out -> Rest
        Rest = tock -> Rest)"),
              "holds");
}

TEST(Time, WaitIntervalsChoose) {
    EXPECT_EQ(compare_timed(machine(R"(
        initial i
        state A { entry wait([1,2]) ; a }
        transition t0 { from i to A }
    )"),
                            R"(
        Spec = tock -> Out |~| tock -> tock -> Out
        Out = S::a.out -> Rest [] tock -> Out
        Rest = tock -> Rest)"),
              "holds");
}

TEST(Time, TerminationIsNotUrgentInAMachine) {
    EXPECT_EQ(compare_timed(machine(R"(
        initial i
        final k
        transition t0 { from i to k }
    )"),
                            "Spec = S::terminate -> SKIP [] tock -> Spec"),
              "holds");
}

TEST(Time, SinceEntryCountsFromTheEndOfTheEntryAction) {
    EXPECT_EQ(compare_timed(machine(R"(
        initial i
        state A { entry wait(2) }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B condition sinceEntry(A) >= 1 action a }
    )"),
                            R"(
        Spec = tock -> tock -> tock -> Out
        Out = S::a.out -> Rest [] tock -> Out
        Rest = tock -> Rest)"),
              "holds");
}

TEST(Time, ATransitionsDeadlineIsWatchedWhileItsGuardHolds) {
    EXPECT_EQ(compare_timed(machine(R"(
        initial i
        state A { }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger a <{1} }
    )"),
                            R"(
        Spec = S::a.in -> Rest [] tock -> S::a.in -> Rest
        Rest = tock -> Rest)"),
              "holds");
}

/// x is false while the machine waits to send b.
TEST(Time, DeadlineOfATransitionRestartsWhenItsGuardIsFalse) {
    EXPECT_EQ(compare_timed(machine(R"(
        var x:boolean = true
        initial i
        state A {
            initial j
            state B { }
            transition u0 { from j to B }
            transition u1 { from B to B trigger a action x = false ; b ; x = true }
        }
        state D { }
        transition t0 { from i to A }
        transition t1 { from A to D trigger c <{1} condition x }
    )"),
                            R"(
        Spec = Left(1)
        Left(k) = S::a.in -> Waiting [] S::c.in -> Rest [] k > 0 & tock -> Left(k - 1)
        Waiting = S::b.out -> Left(1) [] tock -> Waiting
        Rest = tock -> Rest)"),
              "holds");
}

TEST(Time, UntimedTreatmentDropsIt) {
    EXPECT_EQ(compare_untimed(machine(R"(
        clock T
        var x:nat
        initial i
        state A { entry wait(2) ; #T ; a <{1} }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger b condition since(T) < 2 /\ x == 0 }
    )"),
                              "Spec = S::a.out -> S::b.in -> STOP"),
              "holds");
}

// x is 0, so the remaining guard of t1 is false in both cases. The guard of t2 disappears, because the clock alone may
// make it true.
TEST(Time, UntimedGuardsKeepWhatReadsNoClock) {
    EXPECT_EQ(compare_untimed(machine(R"(
        clock T
        var x:nat
        initial i
        state A { }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger b condition since(T) < 2 /\ x == 1 }
        transition t2 { from A to B trigger a condition since(T) < 2 \/ x == 1 }
    )"),
                              "Spec = S::a.in -> STOP"),
              "holds");
    EXPECT_EQ(compare_untimed(machine(R"(
        clock T
        var x:nat
        initial i
        state A { }
        state B { }
        transition t0 { from i to A }
        transition t1 { from A to B trigger b condition not (since(T) < 2 \/ x == 0) }
        transition t2 { from A to B trigger a condition not (since(T) < 2 /\ x == 0) }
    )"),
                              "Spec = S::a.in -> STOP"),
              "holds");
}

// The guard may also depend on the received value.
TEST(Time, UntimedGuardsKeepConditionsOnTheIncomingValue) {
    EXPECT_EQ(compare_untimed(R"(
        stm S {
            event v : nat
            clock T
            var x:nat
            initial i
            state A { }
            state B { }
            transition t0 { from i to A }
            transition t1 { from A to B trigger v ? x condition since(T) > 1 /\ x == 1 }
        })",
                              "Spec = S::v.in.1 -> STOP"),
              "holds");
}

TEST(Provenance, KeysAreWhatTheCheckerPrints) {
    const auto m = load_model(R"(
        interface I { var x:nat }
        stm S {
            requires I
            event a : nat
            initial i
            state A { entry x = x + 1 ; a ! x }
            transition t0 { from i to A }
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const Provenance provenance = m->emit(Time::untimed).provenance;
    const auto reported = testing::reported_steps(*m, Time::untimed, "S::D__(0)", "RUN({| S::set_EXT_x |})");
    ASSERT_EQ(reported.size(), 3U);
    for (const testing::ReportedStep& step : reported) {
        const auto event = std::ranges::find_if(provenance.events, [&](const auto& entry) {
            return step.event == entry.first || step.event.compare(0, entry.first.size() + 1, entry.first + ".") == 0;
        });
        EXPECT_NE(event, provenance.events.end()) << step.event;
        EXPECT_NE(provenance.definitions.count(step.state.substr(0, step.state.find('('))), 0U) << step.state;
    }
}

/// Reals are in tenths here, so a received whole number is multiplied by ten.
TEST(Receptions, WholeNumbersBecomeReals) {
    const std::string body = R"(
        event high event r:real event h:real
        var x:real = 0.5
        initial i
        state A { entry r ! x }
        state B { entry high }
        state C { entry n ? x ; r ! x }
        transition t0 { from i to A }
        transition t1 { from A to B trigger n ? x condition x > 0.5 }
        transition t2 { from A to C trigger m ? x condition x < 0.5 }
    )";
    EXPECT_EQ(compare_untimed(machine(body),
                              "Spec = S::r.out.5 -> (S::n.in?v:{1, 2} -> S::high.out -> STOP\n"
                              "       [] S::m.in.0 -> S::n.in?v:{0..2} -> S::r.out.(10 * v) -> STOP)"),
              "holds");
}

/// No semantics defines the conversion of 0.5 to a whole number.
TEST(Receptions, RealsDoNotBecomeWholeNumbers) {
    const std::string text = machine(R"(
        event h:real
        var y:nat
        var x:real = 0.5
        initial i
        state A { }
        transition t0 { from i to A }
        transition t1 { from A to A trigger h ? y }
    )");
    const auto m = load_model(text);
    (void)m->emit(Time::untimed);
    EXPECT_THAT(m->codes(), ::testing::Contains("RC-C01"));
}

}  // namespace
}  // namespace robochart::csp_emit::behaviour_test
