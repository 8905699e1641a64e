// SPDX-License-Identifier: Apache-2.0
// Tests the meaning of RoboSim (docs/robosim.md). Compares small models with processes that were written by hand from
// its rules. Each specification follows from the rule that its test names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/csp_emit/fixture.hpp"
#include "tests/csp_emit/robosim_models.hpp"

namespace robochart::csp_emit::robosim_test {
namespace {

using testing::decide_obligations;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::Model;

std::unique_ptr<Model> load(const std::string& rst, const std::string& rsa = "") {
    std::vector<std::pair<std::string, std::string>> files{{"model.rst", rst}};
    if (!rsa.empty()) files.emplace_back("model.rsa", rsa);
    auto model = testing::model_of(files);
    EXPECT_TRUE(model->diagnostics.ok()) << model->messages();
    return model;
}

/// Returns "holds" if the component has exactly the behaviour of Spec in failures and divergences. Tries variables as
/// parameters and in memory processes.
std::string compare(const std::string& rst, const std::string& specification, const std::string& component = "S") {
    const auto model =
        load(rst, "csp Spec csp-begin\n" + specification + "\ncsp-end\nassertion A : " + component + " equals Spec\n");
    const std::vector<std::string> found = decide_obligations(*model, Time::timed);
    if (found.size() != 1) return model->messages();
    if (found[0] != "holds") return found[0];
    for (const std::string& verdict : testing::decide_script(model->emit_with_memories(Time::timed).script))
        if (verdict != "holds") return "with memories: " + verdict;
    return "holds";
}

const char* const loop = "state A { } transition t0 { from i to A } transition t1 { from A to A exec } ";

// ---------------------------------------------------------------- the frame

TEST(RoboSim, ACycleReadsAllInputsInAnyOrderThenRunsThenWaits) {
    EXPECT_EQ(compare(machine("event a event b : boolean", "", loop, "2"),
                      "R = S::registerRead.S::i_a?x -> SKIP ||| S::registerRead.S::i_b?x?y -> SKIP\n"
                      "Spec = R ; S::endexec -> tock -> tock -> Spec"),
              "holds");
}

TEST(RoboSim, AnEmptyRegisterHasAnyValue) {
    EXPECT_EQ(compare(machine("event e : boolean", "",
                              "var v : boolean = false state A { } transition t0 { from i to A } "
                              "transition t1 { from A to A exec condition not $e?v } "
                              "transition t2 { from A to A exec condition $e /\\ v } "
                              "transition t3 { from A to A exec condition $e /\\ not v }"),
                      "Spec = S::registerRead.S::i_e?x?y -> S::endexec -> tock -> Spec"),
              "holds");
}

TEST(RoboSim, ASecondWriteOfAnOutputWaitsForEver) {
    EXPECT_EQ(compare(machine("", "event o",
                              "state A { } transition t0 { from i to A action $o ; $o } "
                              "transition t1 { from A to A exec }"),
                      "Spec = S::registerWrite.S::o_o -> STOP"),
              "holds");
    EXPECT_EQ(compare(machine("", "event o",
                              "state A { } transition t0 { from i to A action $o ; exec ; $o } "
                              "transition t1 { from A to A exec }"),
                      "Spec = S::registerWrite.S::o_o -> S::endexec -> tock -> S::registerWrite.S::o_o -> End\n"
                      "End = S::endexec -> tock -> End"),
              "holds");
}

TEST(RoboSim, AMachineThatCannotReachExecStopsTime) {
    EXPECT_EQ(
        compare(machine("event e", "",
                        "state A { } transition t0 { from i to A } transition t1 { from A to A exec condition $e }"),
                "Spec = S::registerRead.S::i_e?full -> if full then S::endexec -> tock -> Spec else STOP"),
        "holds");
}

TEST(RoboSim, AFinalMachineTerminatesBeforeTheFirstTockOrGoesOn) {
    EXPECT_EQ(
        compare(machine("event e", "", "final F transition t0 { from i to F }", "2"),
                "Spec = S::registerRead.S::i_e?x -> S::endexec -> (S::terminate -> SKIP [] tock -> tock -> Spec)"),
        "holds");
}

// ---------------------------------------------------------------- the body

TEST(RoboSim, ReadingARegisterDoesNotEmptyIt) {
    EXPECT_EQ(compare(machine("event e", "event o event p",
                              "state A { } state B { } state C { } transition t0 { from i to A } "
                              "transition t1 { from A to B condition $e action $o } "
                              "transition t2 { from B to C condition $e action $p } "
                              "transition t3 { from B to C condition not $e } "
                              "transition t4 { from C to C exec } transition t5 { from A to A exec condition not $e }"),
                      "Spec = S::registerRead.S::i_e?full -> if full then S::registerWrite.S::o_o -> "
                      "S::registerWrite.S::o_p -> End else S::endexec -> tock -> Spec\n"
                      "End = S::endexec -> tock -> S::registerRead.S::i_e?x -> End"),
              "holds");
}

TEST(RoboSim, AnExecTransitionStoresTheValueThatMadeItsConditionTrue) {
    EXPECT_EQ(compare(machine("event e : boolean", "event o : boolean",
                              "var v : boolean state A { } transition t0 { from i to A } "
                              "transition t1 { from A to A exec condition $e?v action $o!v } "
                              "transition t2 { from A to A exec condition not $e }"),
                      "Spec = S::registerRead.S::i_e?full?x -> Run(full,x)\n"
                      "Run(full,x) = S::endexec -> tock -> S::registerRead.S::i_e?f?y -> "
                      "if full then S::registerWrite.S::o_o!x -> Run(f,y) else Run(f,y)"),
              "holds");
}

TEST(RoboSim, WhatFollowsExecSeesTheNewRegisters) {
    const std::string rest =
        "Spec = S::registerRead.S::i_x?a -> S::endexec -> tock -> S::registerRead.S::i_x?b -> "
        "S::registerWrite.S::o_o!b -> End\nEnd = S::endexec -> tock -> S::registerRead.S::i_x?b -> End";
    const std::string variable = "interface I { var x : boolean }\n";
    EXPECT_EQ(compare(variable + machine("requires I", "event o : boolean",
                                         "state A { } transition t0 { from i to A action exec ; $o!$x } "
                                         "transition t1 { from A to A exec }"),
                      rest),
              "holds");
    EXPECT_EQ(compare(variable + machine("requires I", "event o : boolean",
                                         "state B { } state A { } transition t0 { from i to B } "
                                         "transition t2 { from B to A exec action $o!$x } "
                                         "transition t1 { from A to A exec }"),
                      rest),
              "holds")
        << "also the action of an exec transition";
}

TEST(RoboSim, TheValueAfterAColonIsTheReceivedOneAndElsewhereTheOldOne) {
    EXPECT_EQ(
        compare(machine("event e : boolean", "event o event p",
                        "var v : boolean = false state A { } state B { } transition t0 { from i to A } "
                        "transition t1 { from A to B condition $e?v : (v) action $o } "
                        "transition t2 { from A to B condition not $e?v : (v) action $p } "
                        "transition t3 { from B to B exec }"),
                "Spec = S::registerRead.S::i_e?full?x -> (if full and x then S::registerWrite.S::o_o -> End "
                "else S::registerWrite.S::o_p -> End)\nEnd = S::endexec -> tock -> S::registerRead.S::i_e?f?y -> End"),
        "holds");
    EXPECT_EQ(compare(machine("event e : boolean", "event o",
                              "var v : boolean = false state A { } state B { } transition t0 { from i to A } "
                              "transition t1 { from A to B condition $e?v /\\ v action $o } "
                              "transition t2 { from A to A exec }"),
                      "Spec = S::registerRead.S::i_e?f?x -> S::endexec -> tock -> Spec"),
              "holds")
        << "v is false for ever: t1 is never taken, so nothing is stored";
}

TEST(RoboSim, AMachineSeesItsOwnWriteOfAVariableOfBothContexts) {
    EXPECT_EQ(
        compare("interface I { var x : boolean }\n" +
                    machine("requires I", "requires I event o : boolean",
                            "state A { } transition t0 { from i to A action $x = not $x ; $o!$x } "
                            "transition t1 { from A to A exec }"),
                "Spec = S::registerRead.S::i_x?a -> S::registerWrite.S::o_x!(not a) -> "
                "S::registerWrite.S::o_o!(not a) -> End\nEnd = S::endexec -> tock -> S::registerRead.S::i_x?b -> End"),
        "holds");
}

TEST(RoboSim, ClocksCountTimeUnitsAndChangeBetweenCyclesOnly) {
    EXPECT_EQ(
        compare(machine("", "event o",
                        "clock C state A { } state B { } transition t0 { from i to A action #C } "
                        "transition t1 { from A to A exec condition since(C) < 4 } "
                        "transition t2 { from A to B condition since(C) >= 4 action $o } "
                        "transition t3 { from B to B exec }",
                        "2"),
                "W = tock -> tock -> SKIP\nSpec = S::endexec -> W ; S::endexec -> W ; S::registerWrite.S::o_o -> End\n"
                "End = S::endexec -> W ; End"),
        "holds");
}

TEST(RoboSim, ResetsOfAnExecTransitionHappenInTheNextCycle) {
    EXPECT_EQ(compare(machine("", "event o",
                              "clock C state A { } state B { } transition t0 { from i to A } "
                              "transition t1 { from A to B exec #C } "
                              "transition t2 { from B to B exec condition since(C) >= 1 action $o } "
                              "transition t3 { from B to B exec condition since(C) < 1 }"),
                      "Spec = S::endexec -> tock -> S::endexec -> tock -> End\n"
                      "End = S::endexec -> tock -> S::registerWrite.S::o_o -> End"),
              "holds");
}

TEST(RoboSim, NoTransitionIsTakenWhileADuringActionHasEndedTheCycle) {
    EXPECT_EQ(
        compare(machine("", "event early",
                        "clock C state A { during exec } state E { } transition t0 { from i to A action #C } "
                        "transition t1 { from A to E condition since(C) == 1 action $early } "
                        "transition t2 { from A to E condition since(C) == 2 } transition t3 { from E to E exec }",
                        "2"),
                "Spec = S::endexec -> tock -> tock -> Spec"),
        "holds");
}

TEST(RoboSim, AnOutputBesideAnExecTransitionMayComeOrNot) {
    EXPECT_EQ(compare(machine("", "event o",
                              "state A { during $o ; exec } transition t0 { from i to A } "
                              "transition t1 { from A to A exec }"),
                      "Spec = S::registerWrite.S::o_o -> E [] S::endexec -> tock -> Spec\n"
                      "E = S::endexec -> tock -> (Spec |~| Idle)\nIdle = S::endexec -> tock -> Spec"),
              "holds")
        << "a during action that has ended the cycle is over, and the transition starts it anew";
}

TEST(RoboSim, ACompositeStateIsLeftOnlyWhenItsInnerMachineIsSettled) {
    EXPECT_EQ(
        compare(machine("", "event o event p",
                        "state A { initial j state B { entry $o ; exec ; $p exit skip } transition u { from j to B } } "
                        "state D { } transition t0 { from i to A } transition t1 { from A to D exec } "
                        "transition t2 { from D to D exec }"),
                "Spec = S::registerWrite.S::o_o -> S::endexec -> tock -> S::registerWrite.S::o_p -> End\n"
                "End = S::endexec -> tock -> End"),
        "holds");
}

// ---------------------------------------------------------------- controllers and modules

TEST(RoboSim, OperationsRunInTheCyclesOfTheirCaller) {
    EXPECT_EQ(
        compare(
            "interface O { twice() }\noperation twice() { input context { event e } output context { event o } "
            "initial i final F state A { } transition t0 { from i to A action $o } "
            "transition t1 { from A to F exec condition $e } transition t2 { from A to A exec condition not $e } }\n"
            "controller C { cycleDef cycle == 1 event e event o event p opref f = twice "
            "stm S { requires O cycleDef cycle == 1 input context { event e } "
            "output context { event o event p } initial i state B { } "
            "transition t0 { from i to B action twice() ; $p } transition t1 { from B to B exec } } "
            "connection C on e to S on e connection S on o to C on o connection S on p to C on p }",
            "Spec = C::registerRead.C::i_e?f -> C::registerWrite.C::o_o -> Run(f)\n"
            "Run(f) = C::endexec -> tock -> C::registerRead.C::i_e?g -> "
            "if f then C::registerWrite.C::o_p -> End else Run(g)\n"
            "End = C::endexec -> tock -> C::registerRead.C::i_e?g -> End",
            "C"),
        "holds");
}

TEST(RoboSim, AnEventBetweenMachinesIsSeenInTheNextCycleAndInNoOther) {
    const std::string idle = "\nEnd = C::endexec -> tock -> End\nOnce(e) = e -> End\n";
    const std::string got = "C::registerWrite.C::o_got", none = "C::registerWrite.C::o_none";
    const std::string cycle = "C::endexec -> tock -> ";
    EXPECT_EQ(compare(sender_and_reader(0), "Spec = Once(" + none + ")" + idle, "C"), "holds");
    EXPECT_EQ(compare(sender_and_reader(1), "Spec = " + cycle + "Once(" + got + ")" + idle, "C"), "holds");
    EXPECT_EQ(compare(sender_and_reader(2), "Spec = " + cycle + cycle + "Once(" + none + ")" + idle, "C"), "holds");
}

TEST(RoboSim, AnUnconnectedInputHasAnyValueAndAnUnconnectedOutputVanishes) {
    EXPECT_EQ(
        compare("controller C { cycleDef cycle == 1 event yes stm A { cycleDef cycle == 1 "
                "input context { event e } output context { event yes event lost } initial i state Z { } "
                "transition t0 { from i to Z } transition t1 { from Z to Z condition $e action $lost ; $yes ; exec } "
                "transition t2 { from Z to Z condition not $e action exec } } connection A on yes to C on yes }",
                "Spec = (C::registerWrite.C::o_yes -> C::endexec -> tock -> Spec) |~| (C::endexec -> tock -> Spec)",
                "C"),
        "holds");
}

TEST(RoboSim, AnOutputHappensAtMostOnceInACycleOverAllMachines) {
    EXPECT_EQ(compare(two_callers("$go(0)", "$go(1)"),
                      "Spec = C::registerWrite.C::o_go.0 -> STOP |~| C::registerWrite.C::o_go.1 -> STOP", "C"),
              "holds");
}

TEST(RoboSim, WritesOfPartsArePassedOnOneByOneInAnInternalOrder) {
    EXPECT_EQ(compare(two_callers("$go(0)", "$stay()"),
                      "Spec = (C::registerWrite.C::o_go.0 -> C::registerWrite.C::o_stay -> End) |~| "
                      "(C::registerWrite.C::o_stay -> C::registerWrite.C::o_go.0 -> End)\n"
                      "End = C::endexec -> tock -> End",
                      "C"),
              "holds");
}

TEST(RoboSim, PartsRunInTheCycleOfTheWhole) {
    EXPECT_EQ(compare(two_callers("skip", "skip", "2"), "Spec = C::endexec -> tock -> tock -> Spec", "C"), "holds");
}

TEST(RoboSim, PartsTerminateTogetherAndAModuleHidesIt) {
    const std::string part =
        "stm S { cycleDef cycle == 1 input context { } output context { event o } initial i final F "
        "transition t0 { from i to F action $o } }\n"
        "stm T { cycleDef cycle == 1 input context { } output context { } initial i state A { } "
        "final F transition t0 { from i to A } transition t1 { from A to F exec } }\n";
    const std::string controller =
        "controller C { cycleDef cycle == 1 event o sref s = S sref t = T "
        "connection s on o to C on o }\n";
    EXPECT_EQ(compare(part + controller,
                      "Spec = C::registerWrite.C::o_o -> C::endexec -> tock -> Last\n"
                      "Last = C::endexec -> (C::terminate -> SKIP [] tock -> Last)",
                      "C"),
              "holds");
    EXPECT_EQ(compare(part + controller +
                          "module M { cycleDef cycle == 1 robotic platform P { event o } cref c = C "
                          "connection c on o to P on o (_async) }",
                      "Spec = M::registerWrite.M::o_o -> tock -> SKIP", "M"),
              "holds");
}

TEST(RoboSim, AVariableOfThePlatformIsReadAtTheBeginningOfACycleAndItsWritesAreShown) {
    const std::string machines =
        "interface I { var x : boolean = false }\n"
        "stm S { cycleDef cycle == 1 input context { } output context { requires I } initial i state A { } "
        "transition t0 { from i to A action $x = true } transition t1 { from A to A exec } }\n"
        "stm T { cycleDef cycle == 1 input context { requires I } output context { event o : boolean } initial i "
        "state A { } transition t0 { from i to A } transition t1 { from A to A action $o!$x ; exec } }\n"
        "controller C { cycleDef cycle == 1 requires I event o : boolean sref s = S sref t = T "
        "connection t on o to C on o }\n"
        "module M { cycleDef cycle == 1 robotic platform P { provides I event o : boolean } cref c = C "
        "connection c on o to P on o (_async) }";
    EXPECT_EQ(compare(machines,
                      "O(b) = M::registerWrite.M::o_o!b -> SKIP\nX = M::registerWrite.M::o_x!true -> SKIP\n"
                      "Spec = (O(false) ; X |~| X ; O(false)) ; tock -> Rest\nRest = O(true) ; tock -> Rest",
                      "M"),
              "holds");
}

// ---------------------------------------------------------------- claims

TEST(RoboSim, ALengthInAClaimReplacesThatOfTheModel) {
    const std::string spec = "csp Spec csp-begin\nSpec = S::endexec -> tock -> tock -> tock -> Spec\ncsp-end\n";
    const auto model = load(machine("", "", loop), spec +
                                                       "assertion A : S equals Spec with cycleDef of S set to 3\n"
                                                       "assertion B : S equals Spec with cycleDef of S set to 2\n");
    EXPECT_THAT(decide_obligations(*model, Time::timed), ElementsAre("holds", "fails"));
}

TEST(RoboSim, AComponentThatStopsTimeIsDeadlockFreeInRoboToolsSense) {
    const auto model = load(
        machine("event e", "",
                "state A { } transition t0 { from i to A } transition t1 { from A to A exec condition $e }"),
        "assertion A : S is deadlock-free\nassertion B : S is deterministic\nassertion C : S is divergence-free\n");
    EXPECT_THAT(decide_obligations(*model, Time::timed), ElementsAre("holds", "holds", "holds"));
}

TEST(RoboSim, ALoopWithoutExecDiverges) {
    const auto model = load(machine("", "", "state A { } transition t0 { from i to A } transition t1 { from A to A }"),
                            "assertion A : S is divergence-free\n");
    EXPECT_THAT(decide_obligations(*model, Time::timed), ElementsAre("fails"));
}

const char* const chart =
    "stm M { event e event o initial i state A { } transition t0 { from i to A } "
    "transition t1 { from A to A trigger e action o } }\n";

/// Returns the verdicts on the claims about a machine S with this body and the simulation N of the RoboChart machine M.
std::vector<std::string> against_chart(const std::string& body, const std::string& claims) {
    const auto model = testing::model_of({{"chart.rct", chart},
                                          {"model.rst", machine("event e", "event o", body)},
                                          {"model.rsa",
                                           "simulation N of M { cycleDef cycle == 1 input context { event e } "
                                           "output context { event o } }\n" +
                                               claims}});
    EXPECT_TRUE(model->diagnostics.ok()) << model->messages();
    return decide_obligations(*model, Time::timed);
}

TEST(RoboSim, ASimulationIsTheRoboChartComponentInCycles) {
    const std::string body =
        "state A { } transition t0 { from i to A } transition t1 { from A to A condition $e action $o ; exec } "
        "transition t2 { from A to A condition not $e action exec }";
    EXPECT_THAT(against_chart(body,
                              "assertion A : S refines N\nassertion B : N refines S\n"
                              "assertion C : S equals N in the tick-tock model\nassertion D : N is schedulable\n"),
                ElementsAre("holds", "holds", "holds", "holds"));
    const std::string deaf = "state A { } transition t0 { from i to A } transition t1 { from A to A exec }";
    EXPECT_THAT(against_chart(deaf, "assertion A : S refines N\nassertion B : S does not refine N\n"),
                ElementsAre("fails", "holds"));
}

TEST(RoboSim, ACallThatIsUrgentTwiceInACycleIsNotSchedulable) {
    const auto claims_of = [](const std::string& action) {
        const auto model =
            testing::model_of({{"chart.rct",
                                "interface P { go() }\nstm M { requires P event e initial i state A { } "
                                "transition t0 { from i to A } transition t1 { from A to A trigger e action " +
                                    action + " } }\n"},
                               {"model.rsa",
                                "simulation N of M { cycleDef cycle == 1 input context { event e } "
                                "output context { requires P } }\n"
                                "assertion A : N is schedulable\nassertion B : N is not schedulable\n"}});
        EXPECT_TRUE(model->diagnostics.ok()) << model->messages();
        return decide_obligations(*model, Time::timed);
    };
    EXPECT_THAT(claims_of("go() ; go()"), ElementsAre("fails", "holds"));
    EXPECT_THAT(claims_of("go()"), ElementsAre("holds", "fails"));
    EXPECT_THAT(claims_of("wait(1) ; go()"), ElementsAre("holds", "fails"));
    EXPECT_THAT(claims_of("go() ; wait(1) ; go()"), ElementsAre("fails", "holds"))
        << "the second call and the first one of the next input happen in one cycle";
}

// ---------------------------------------------------------------- what is refused

std::string refusal(const std::string& rst, const std::string& rsa = "") {
    std::vector<std::pair<std::string, std::string>> files{{"model.rst", rst}};
    if (!rsa.empty()) files.emplace_back("model.rsa", rsa);
    const auto model = testing::model_of(files);
    if (!model->diagnostics.ok()) return model->messages();
    const std::vector<std::string> found = decide_obligations(*model, Time::timed);
    return found.empty() ? model->messages() : found.front();
}

TEST(RoboSim, ConstructsWithoutAMeaningAreRefusedByName) {
    EXPECT_THAT(refusal(machine("", "", loop, "0.5")), HasSubstr("not a whole number of time units"));
    EXPECT_THAT(
        refusal(machine("event e : boolean", "",
                        "var v : boolean state A { } transition t0 { from i to A action if $e?v then skip end } "
                        "transition t1 { from A to A exec }")),
        HasSubstr("outside of the condition of a transition"));
    EXPECT_THAT(refusal("interface O { f() }\ncontroller C { cycleDef cycle == 1 requires O stm S { requires O "
                        "cycleDef cycle == 1 input context { } output context { } initial i state A { } "
                        "transition t0 { from i to A action f() } transition t1 { from A to A exec } } }"),
                HasSubstr("call `$f`"));
    EXPECT_THAT(refusal("stm S { input context { } output context { } initial i " + std::string(loop) + "}",
                        "assertion A : S is deadlock-free\n"),
                HasSubstr("has no cycleDef"));
}

}  // namespace
}  // namespace robochart::csp_emit::robosim_test
