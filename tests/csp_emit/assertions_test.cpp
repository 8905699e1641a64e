// SPDX-License-Identifier: Apache-2.0
// Tests every form of assertion in its semantic models (docs/semantics.md, "Assertions"). The answers follow by hand
// from the semantics of the small machines.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::assertions_test {
namespace {

using testing::decide_obligations;
using testing::decide_with;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::load_model;

// Ready offers a and b, and the environment chooses. Chosen makes this choice internally. More offers a third event.
const char* const machines = R"(
interface I {
    event a
    event b
}
stm Ready {
    uses I
    initial i
    state S {
    }
    final f
    transition t0 {
        from i
        to S
    }
    transition t1 {
        from S
        to f
        trigger a
    }
    transition t2 {
        from S
        to f
        trigger b
    }
}
stm Twin {
    uses I
    initial start
    state Waiting {
    }
    final over
    transition t0 {
        from start
        to Waiting
    }
    transition t1 {
        from Waiting
        to over
        trigger b
    }
    transition t2 {
        from Waiting
        to over
        trigger a
    }
}
stm Chosen {
    uses I
    initial i
    junction j
    state A {
    }
    state B {
    }
    final f
    transition t0 {
        from i
        to j
    }
    transition t1 {
        from j
        to A
    }
    transition t2 {
        from j
        to B
    }
    transition t3 {
        from A
        to f
        trigger a
    }
    transition t4 {
        from B
        to f
        trigger b
    }
}
stm OnlyA {
    uses I
    initial i
    state S {
    }
    final f
    transition t0 {
        from i
        to S
    }
    transition t1 {
        from S
        to f
        trigger a
    }
}
)";

std::vector<std::string> decide_claims(const std::string& assertions, Time time) {
    const auto m = load_model(machines, assertions);
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
    return decide_obligations(*m, time);
}

TEST(Assertions, ComponentsAreComparedByTheNamesOfTheirEvents) {
    for (const Time time : {Time::untimed, Time::timed})
        EXPECT_THAT(decide_claims("assertion A : Ready equals Twin\n"
                                  "assertion B : Ready refines Chosen\n"
                                  "assertion C : Chosen does not refine Ready\n"
                                  "assertion D : Chosen refines Ready in the traces model\n"
                                  "assertion E : Ready refines Chosen in the failures model\n"
                                  "assertion F : Chosen does not refine Ready in the failures model\n",
                                  time),
                    ElementsAre("holds", "holds", "holds", "holds", "holds", "holds"));
}

// `not equal` holds if at least one of the two refinements fails.
TEST(Assertions, NotEqualIsTheFailureOfOneRefinement) {
    for (const Time time : {Time::untimed, Time::timed})
        EXPECT_THAT(decide_claims("assertion A : Ready is not equal to Twin\n"
                                  "assertion B : Ready is not equal to Chosen\n"
                                  "assertion C : Chosen is not equal to Ready\n"
                                  "assertion D : Ready is not equal to Chosen in the traces model\n"
                                  "assertion E : OnlyA is not equal to Chosen in the traces model\n"
                                  "assertion F : Ready is not equal to Chosen in the failures model\n",
                                  time),
                    ElementsAre("fails", "holds", "holds", "fails", "holds", "holds"));
}

TEST(Assertions, TickTockComparesComponents) {
    EXPECT_THAT(decide_claims("timed assertion A : Ready equals Twin in the tick-tock model\n"
                              "timed assertion B : Ready refines Chosen in the tick-tock model\n"
                              "timed assertion C : Chosen refines Ready in the tick-tock model\n"
                              "timed assertion D : Chosen is not equal to Ready in the tick-tock model\n"
                              "timed assertion E : Ready is not equal to Twin in the tick-tock model\n",
                              Time::timed),
                ElementsAre("holds", "holds", "fails", "holds", "fails"));
}

TEST(Assertions, WhatAModelCannotTellIsSaid) {
    EXPECT_THAT(decide_claims("untimed assertion A : Ready equals Twin in the tick-tock model\n"
                              "untimed assertion B : Ready is deadlock-free in the traces model\n"
                              "untimed assertion C : Ready is divergence-free in the failures model\n"
                              "untimed assertion D : Ready is timelock-free\n",
                              Time::untimed),
                ::testing::Each(HasSubstr("no check: ")));
    EXPECT_THAT(
        decide_claims("timed assertion A : Ready is deterministic in the tick-tock model\n"
                      "timed assertion B : P refines Ready in the tick-tock model\n"
                      "timed csp P csp-begin\nP = STOP\ncsp-end\n",
                      Time::timed),
        ElementsAre(HasSubstr("no check: "), ::testing::AllOf(HasSubstr("P__sem__events is not defined"),
                                                              HasSubstr("`P__sem__events = Ready::sem__events`"))));
}

TEST(Assertions, PropertiesInTheFailuresModel) {
    EXPECT_THAT(decide_claims("untimed assertion A : Ready is not deadlock-free in the failures model\n"
                              "untimed assertion B : Ready is deterministic in the failures model\n"
                              "untimed assertion C : Chosen is not deterministic in the failures model\n"
                              "untimed assertion D : Ready terminates in the failures model\n",
                              Time::untimed),
                ElementsAre("holds", "holds", "holds", "holds"));
    EXPECT_THAT(decide_claims("timed assertion A : Ready is timelock-free in the tick-tock model\n", Time::timed),
                ElementsAre("fails"));  // the machine can terminate, and a terminated process lets no time pass
}

// The traces of a machine that terminates end with ✓. Even then, a state without incoming transitions is not reachable.
TEST(Assertions, StatesOfMachinesThatTerminate) {
    const auto m = load_model(
        "stm S { initial i state A { } state B { } final f transition t0 { from i to A } "
        "transition t1 { from A to f } transition t2 { from B to f } }",
        "assertion A : S::A is reachable in S\nassertion B : S::B is not reachable in S\n"
        "assertion C : S::B is reachable in S\n");
    for (const Time time : {Time::untimed, Time::timed})
        EXPECT_THAT(decide_obligations(*m, time), ElementsAre("holds", "holds", "fails"));
}

/// Returns the verdicts of "C is initialised" and "C is not initialised", for a machine with this body.
std::vector<std::string> decide_initialisation(const std::string& body, Time time) {
    const auto m = load_model(
        "interface W { clock C }\noperation start() { requires W initial i final f "
        "transition t { from i to f #C } }\ninterface O { start() }\n"
        "controller K { opref o = start stm S { requires O clock C clock D event a event b initial i " +
            body + " } }",
        "assertion A : clock K::S::C is initialised\nassertion B : clock K::S::C is not initialised\n");
    EXPECT_TRUE(m->diagnostics.ok()) << m->messages();
    return decide_obligations(*m, time);
}

TEST(Assertions, ClocksAreInitialisedIfResetBeforeTheyAreRead) {
    const auto yes = ElementsAre("holds", "fails");
    const auto no = ElementsAre("fails", "holds");
    const std::string states = "state A { } state B { } state X { } ";
    const std::string read = "transition r { from B to B trigger a condition since(C) > 1 } ";
    for (const Time time : {Time::untimed, Time::timed}) {
        const auto check = [&](const std::string& body) { return decide_initialisation(states + body, time); };
        EXPECT_THAT(check("transition t { from i to B }" + read), no) << "read at once";
        EXPECT_THAT(check("transition t { from i to B #C }" + read), yes) << "reset on the way";
        EXPECT_THAT(check("transition t { from i to A } transition u { from A to B #C }" + read), yes) << "later";
        EXPECT_THAT(check("transition t { from i to B action #C }" + read), yes) << "reset in an action";
        EXPECT_THAT(check("transition t { from i to B action start() }" + read), yes) << "reset in an operation";
        EXPECT_THAT(check("transition t { from i to A } transition u { from A to B trigger a } "
                          "transition v { from A to B trigger b #C }" +
                          read),
                    no)
            << "one way does not reset it";
        EXPECT_THAT(check("transition t { from i to A #C } transition u { from X to B }" + read), yes)
            << "the read is not reachable";
        EXPECT_THAT(check("transition t { from i to A }"), no) << "never reset, never read";
        EXPECT_THAT(check("transition t { from i to B #D }" + read), no) << "another clock";
    }
    // In the timed semantics, the transition that resets C leaves A first. In the untimed semantics, both transitions
    // are possible.
    const std::string race = states +
                             "transition t { from i to A } transition u { from A to B condition since(D) >= 2 } "
                             "transition v { from A to B #C condition since(D) >= 1 }" +
                             read;
    EXPECT_THAT(decide_initialisation(race, Time::timed), yes);
    EXPECT_THAT(decide_initialisation(race, Time::untimed), no);
}

// Laws of tick-tock (Baxter, Ribeiro, Cavalcanti): a refusal before time passes is part of a trace, but a refusal
// before another event is not.
TEST(TickTock, Laws) {
    const auto m = load_model(machines, "timed csp Shift csp-begin\n-- model_shifting\ncsp-end\n");
    const auto results = decide_with(*m, Time::timed, R"(
channel a, b, c, d
instance M = model_shifting({a,b,c,d})
Timed(OneStep) {
  Either = a -> STOP [] b -> STOP
  Neither = (a -> STOP |~| b -> STOP) |~| STOP
  Law = Either |~| STOP
  Wait1 = WAIT(1) ; a -> STOP
  Wait2 = WAIT(1) ; (a -> STOP |~| STOP)
  Late = WAIT(2) ; a -> STOP
  Over = SKIP
}
P1 = (a -> b -> STOP [] c -> STOP) |~| a -> d -> STOP
P2 = (a -> d -> STOP [] c -> STOP) |~| a -> b -> STOP
Stopped = USTOP
-- in failures-divergences the two sides are equal
assert Law [FD= Neither
assert Neither [FD= Law
-- in tick-tock they are not: a may come after b was refused for a time unit
assert not M::TT(Law) [T= M::TT(Neither)
assert M::TT(Neither) [T= M::TT(Law)
assert M::TT(Wait2) [T= M::TT(Wait1)
assert not M::TT(Wait1) [T= M::TT(Wait2)
assert not M::TT(Wait1) [T= M::TT(Late)
assert not M::TT(Late) [T= M::TT(Wait1)
-- a timelock refuses tock, and STOP does not
assert not M::TT(Over) [T= M::TT(Stopped)
assert not M::TT(Stopped) [T= M::TT(Over)
assert not M::TT(Wait1) [T= M::TT(Stopped)
-- refusal testing is finer
assert M::TT(P1) [T= M::TT(P2)
assert M::TT(P2) [T= M::TT(P1)
assert not M::RT(P1) [T= M::RT(P2)
)");
    EXPECT_THAT(results, ::testing::Each("holds"));
    EXPECT_EQ(results.size(), 14U);
}

}  // namespace
}  // namespace robochart::csp_emit::assertions_test
