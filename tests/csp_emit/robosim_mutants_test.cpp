// SPDX-License-Identifier: Apache-2.0
// Tests wrong interpretations of RoboSim, which are planted in the text of the emitted script (docs/robosim.md,
// "Meaning"). Each makes a small model differ from its specification, which follows from the rules. The reference warns
// of some of these interpretations; the others are natural mistakes in the control cycle.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"
#include "tests/csp_emit/robosim_models.hpp"

namespace robochart::csp_emit::robosim_test {
namespace {

using testing::Model;

/// A model, and a process to which it is equal in failures and divergences.
struct Claimed {
    std::string model, specification;
    std::string component = "S";
};

/// Replaces a text everywhere in the script.
struct Edit {
    std::string from, to;
};

struct Mutant {
    const char* reading;  ///< what the mutant gets wrong
    const Claimed& claimed;
    std::vector<Edit> edits;
};

std::string replace_all(std::string text, const Edit& edit) {
    std::size_t count = 0;
    for (std::size_t at = text.find(edit.from); at != std::string::npos; at = text.find(edit.from, at), ++count) {
        text.replace(at, edit.from.size(), edit.to);
        at += edit.to.size();
    }
    EXPECT_GT(count, 0U) << "the script has no " << edit.from;
    return text;
}

/// Returns the verdicts on both refinements, after the edits.
std::vector<std::string> decide(const Claimed& claimed, const std::vector<Edit>& edits) {
    const auto model =
        testing::model_of({{"model.rst", claimed.model},
                           {"model.rsa", "csp Spec csp-begin\n" + claimed.specification +
                                             "\ncsp-end\nassertion A : " + claimed.component + " equals Spec\n"}});
    const Emission emission = model->emit(Time::timed);
    EXPECT_TRUE(model->diagnostics.ok()) << model->messages();
    std::string text = cspm::print(emission.script);
    for (const Edit& edit : edits) text = replace_all(std::move(text), edit);
    const auto source = model->sources.add("mutant.csp", text);
    const cspm::Script script = cspm::read(model->sources, source, model->diagnostics);
    EXPECT_TRUE(model->diagnostics.ok()) << model->messages() << text;
    if (!model->diagnostics.ok()) return {};
    return testing::decide_script(script);
}

bool all_hold(const std::vector<std::string>& verdicts) {
    return !verdicts.empty() &&
           std::ranges::all_of(verdicts, [](const std::string& verdict) { return verdict == "holds"; });
}

const std::string idle = "state A { } transition t0 { from i to A } transition t1 { from A to A exec } ";

// ---------------------------------------------------------------- the models

const Claimed frame{machine("event a event b : boolean", "", idle, "2"),
                    "R = S::registerRead.S::i_a?x -> SKIP ||| S::registerRead.S::i_b?x?y -> SKIP\n"
                    "Spec = R ; S::endexec -> tock -> tock -> Spec"};

const Claimed twice{machine("", "event o",
                            "state A { } transition t0 { from i to A action $o ; $o } "
                            "transition t1 { from A to A exec }"),
                    "Spec = S::registerWrite.S::o_o -> STOP"};

const Claimed last{machine("event e", "", "final F transition t0 { from i to F }", "2"),
                   "Spec = S::registerRead.S::i_e?x -> S::endexec -> (S::terminate -> SKIP [] tock -> tock -> Spec)"};

const Claimed stuck{machine("event e", "",
                            "state A { } transition t0 { from i to A } "
                            "transition t1 { from A to A exec condition $e }"),
                    "Spec = S::registerRead.S::i_e?full -> if full then S::endexec -> tock -> Spec else STOP"};

/// The machine tests $e twice in a cycle.
const Claimed tested{machine("event e", "event o event p",
                             "state A { } state B { } state D { } transition t0 { from i to A } "
                             "transition t1 { from A to B condition $e action $o } "
                             "transition t2 { from B to D condition $e action $p } "
                             "transition t3 { from B to D condition not $e } "
                             "transition t4 { from D to D exec } transition t5 { from A to A exec condition not $e }"),
                     "Spec = S::registerRead.S::i_e?full -> if full then S::registerWrite.S::o_o -> "
                     "S::registerWrite.S::o_p -> End else S::endexec -> tock -> Spec\n"
                     "End = S::endexec -> tock -> S::registerRead.S::i_e?x -> End"};

const Claimed stored{machine("event e : boolean", "event o : boolean",
                             "var v : boolean state A { } transition t0 { from i to A } "
                             "transition t1 { from A to A exec condition $e?v action $o!v } "
                             "transition t2 { from A to A exec condition not $e }"),
                     "Spec = S::registerRead.S::i_e?full?x -> Run(full,x)\n"
                     "Run(full,x) = S::endexec -> tock -> S::registerRead.S::i_e?f?y -> "
                     "if full then S::registerWrite.S::o_o!x -> Run(f,y) else Run(f,y)"};

/// The value of an empty register is arbitrary. The machine stores it.
const Claimed arbitrary{machine("event e : boolean", "event o : boolean",
                                "var v : boolean state A { } transition t0 { from i to A } "
                                "transition t1 { from A to A condition not $e?v action $o!v ; exec } "
                                "transition t2 { from A to A exec condition $e }"),
                        "Spec = S::registerRead.S::i_e?full?x -> if full then S::endexec -> tock -> Spec else "
                        "S::registerWrite.S::o_o!x -> S::endexec -> tock -> Spec"};

/// The variable is in both contexts.
const Claimed own_write{"interface I { var x : boolean }\n" +
                            machine("requires I", "requires I event o : boolean",
                                    "state A { } transition t0 { from i to A action $x = not $x ; $o!$x } "
                                    "transition t1 { from A to A exec }"),
                        "Spec = S::registerRead.S::i_x?a -> S::registerWrite.S::o_x!(not a) -> "
                        "S::registerWrite.S::o_o!(not a) -> End\n"
                        "End = S::endexec -> tock -> S::registerRead.S::i_x?b -> End"};

const Claimed clocks{machine("", "event o",
                             "clock C state A { } state B { } transition t0 { from i to A action #C } "
                             "transition t1 { from A to A exec condition since(C) < 4 } "
                             "transition t2 { from A to B condition since(C) >= 4 action $o } "
                             "transition t3 { from B to B exec }",
                             "2"),
                     "W = tock -> tock -> SKIP\n"
                     "Spec = S::endexec -> W ; S::endexec -> W ; S::registerWrite.S::o_o -> End\n"
                     "End = S::endexec -> W ; End"};

const Claimed reset{machine("", "event o",
                            "clock C state A { } state B { } transition t0 { from i to A } "
                            "transition t1 { from A to B exec #C } "
                            "transition t2 { from B to B exec condition since(C) >= 1 action $o } "
                            "transition t3 { from B to B exec condition since(C) < 1 }"),
                    "Spec = S::endexec -> tock -> S::endexec -> tock -> End\n"
                    "End = S::endexec -> tock -> S::registerWrite.S::o_o -> End"};

const Claimed waiting{machine("", "event early",
                              "clock C state A { during exec } state E { } transition t0 { from i to A action #C } "
                              "transition t1 { from A to E condition since(C) == 1 action $early } "
                              "transition t2 { from A to E condition since(C) == 2 } "
                              "transition t3 { from E to E exec }",
                              "2"),
                      "Spec = S::endexec -> tock -> tock -> Spec"};

const Claimed resumed{machine("", "event o event p",
                              "state A { exit $p } state B { } transition t0 { from i to A action $o ; exec ; $o } "
                              "transition t1 { from A to B exec } transition t2 { from B to B exec }"),
                      "Spec = S::registerWrite.S::o_o -> S::endexec -> tock -> S::registerWrite.S::o_o -> "
                      "S::endexec -> tock -> S::registerWrite.S::o_p -> End\n"
                      "End = S::endexec -> tock -> End"};

const std::string once = "\nEnd = C::endexec -> tock -> End\nOnce(e) = e -> End\n";
const Claimed in_time{sender_and_reader(1), "Spec = C::endexec -> tock -> Once(C::registerWrite.C::o_got)" + once, "C"};
const Claimed too_early{sender_and_reader(0), "Spec = Once(C::registerWrite.C::o_none)" + once, "C"};
const Claimed too_late{sender_and_reader(2),
                       "Spec = C::endexec -> tock -> C::endexec -> tock -> Once(C::registerWrite.C::o_none)" + once,
                       "C"};

const Claimed unconnected{
    "controller C { cycleDef cycle == 1 event yes stm A { cycleDef cycle == 1 "
    "input context { event e } output context { event yes event lost } initial i state Z { } "
    "transition t0 { from i to Z } "
    "transition t1 { from Z to Z condition $e action $lost ; $yes ; exec } "
    "transition t2 { from Z to Z condition not $e action exec } } "
    "connection A on yes to C on yes }",
    "Spec = (C::registerWrite.C::o_yes -> C::endexec -> tock -> Spec) |~| "
    "(C::endexec -> tock -> Spec)",
    "C"};

const Claimed both_call{two_callers("$go(0)", "$go(1)"),
                        "Spec = C::registerWrite.C::o_go.0 -> STOP |~| C::registerWrite.C::o_go.1 -> STOP", "C"};

const Claimed in_any_order{two_callers("$go(0)", "$stay()"),
                           "Spec = (C::registerWrite.C::o_go.0 -> C::registerWrite.C::o_stay -> End) |~| "
                           "(C::registerWrite.C::o_stay -> C::registerWrite.C::o_go.0 -> End)\n"
                           "End = C::endexec -> tock -> End",
                           "C"};

const Claimed of_the_whole{two_callers("skip", "skip", "2"), "Spec = C::endexec -> tock -> tock -> Spec", "C"};

const std::string ending_parts =
    "stm S { cycleDef cycle == 1 input context { } output context { event o } initial i final F "
    "transition t0 { from i to F action $o } }\n"
    "stm T { cycleDef cycle == 1 input context { } output context { } initial i state A { } "
    "final F transition t0 { from i to A } transition t1 { from A to F exec } }\n"
    "controller C { cycleDef cycle == 1 event o sref s = S sref t = T connection s on o to C on o }\n";
const Claimed together{ending_parts,
                       "Spec = C::registerWrite.C::o_o -> C::endexec -> tock -> Last\n"
                       "Last = C::endexec -> (C::terminate -> SKIP [] tock -> Last)",
                       "C"};

/// One machine changes a variable of the controller, and another machine reads it.
const Claimed shared{
    "interface I { var x : boolean = false }\n"
    "stm S { cycleDef cycle == 1 input context { } output context { requires I } initial i "
    "state A { } transition t0 { from i to A action $x = true } transition t1 { from A to A exec } }\n"
    "stm T { cycleDef cycle == 1 input context { requires I } output context { event o : boolean } "
    "initial i state A { } transition t0 { from i to A action $o!$x } "
    "transition t1 { from A to A exec action $o!$x } }\n"
    "controller C { cycleDef cycle == 1 uses I event o : boolean sref s = S sref t = T "
    "connection t on o to C on o }",
    "Spec = C::registerWrite.C::o_o.false -> Run\n"
    "Run = C::endexec -> tock -> C::registerWrite.C::o_o.true -> Run",
    "C"};

// ---------------------------------------------------------------- the mutants

std::vector<Mutant> mutants_of_the_frame() {
    const std::string end = "(terminate -> SKIP [] tock -> (wait(cycle__ - 1) ; Cycle__(cycle__)))";
    const std::string once_only = "([] x__:{| registerWrite.o_o |} @ x__ -> STOP)";
    return {
        {"an output may happen twice in a cycle",
         twice,
         {{once_only, "(let R__ = [] x__:{| registerWrite.o_o |} @ x__ -> R__ within R__)"}}},
        {"registers are read in one order", frame, {{"?x__ -> SKIP ||| registerRead", "?x__ -> SKIP ; registerRead"}}},
        {"one register is read", frame, {{"?x__ -> SKIP ||| registerRead", "?x__ -> SKIP [] registerRead"}}},
        {"registers need not be read", frame, {{"; startexec", "/\\ startexec"}}},
        {"a cycle has one time unit", frame, {{"wait(cycle__ - 1)", "SKIP"}}},
        {"a cycle has a time unit more", frame, {{"wait(cycle__ - 1)", "wait(cycle__)"}}},
        {"the first cycle begins with its wait",
         frame,
         {{"Cycle__(cycle_length)", "(wait(cycle_length) ; Cycle__(cycle_length))"}}},
        {"it terminates between the time units too",
         last,
         {{end, "(terminate -> SKIP [] tock -> (terminate -> SKIP [] (wait(cycle__ - 1) ; Cycle__(cycle__))))"}}},
        {"it must terminate", last, {{end, "(terminate -> SKIP)"}}},
        {"it never terminates", last, {{end, "(tock -> (wait(cycle__ - 1) ; Cycle__(cycle__)))"}}},
        {"it terminates during the execution",
         last,
         {{"/\\ endexec -> SKIP)", "/\\ (endexec -> SKIP [] terminate -> SKIP))"},
          {"F__ = endexec -> final_state__", "F__ = endexec -> final_state__ [] terminate -> SKIP"}}},
        {"time passes in a cycle that cannot end",
         stuck,
         {{"(STOP /\\ endexec -> SKIP)", "(let R__ = STOP /\\ (endexec -> SKIP [] tock -> R__) within R__)"},
          {"v__e & endexec -> transition_t1__(v__e)",
           "(v__e & endexec -> transition_t1__(v__e) [] not v__e & tock -> A__(v__e))"}}},
        {"the value of an empty register is fixed",
         arbitrary,
         {{"registerRead.i_e?x__ -> SKIP",
           "(registerRead.i_e.true?x__ -> SKIP [] registerRead.i_e.false.false -> SKIP)"}}},
        {"an empty register has no new value",
         arbitrary,
         {{"initial_node__(full__, in__)", "initial_node__(full__, full__ and in__)"}}},
    };
}

std::vector<Mutant> mutants_of_the_body() {
    return {
        {"a test empties the register",
         tested,
         {{"TID_t1 -> action_of_t1__(v__e)", "TID_t1 -> action_of_t1__(false)"}}},
        {"registers keep their content", stored, {{"transition_t2__(full__, in__)", "transition_t2__(v__e, v__e_)"}}},
        {"exec stores the value of the next cycle",
         stored,
         {{"action_of_t1__(x__, v__e, v__e_)", "action_of_t1__(v__e_, v__e, v__e_)"}}},
        {"the effect of an exec transition comes at once",
         stored,
         {{"endexec -> transition_t1__(v__e, v__e_, v__e_)",
           "internal__.TID_t0 -> action_of_t1__(v__e_, v__e, v__e_)"}}},
        {"its own write is not seen", own_write, {{"-> action_of_t0___2(not v__x)", "-> action_of_t0___2(v__x)"}}},
        {"clocks stand", clocks, {{"transition_t1__(clock_step(c_C, 5))", "transition_t1__(c_C)"}}},
        {"clocks count cycles",
         clocks,
         {{"startexec -> entering_A__(c_C)", "startexec -> entering_A__(clock_step(c_C, 5))"},
          {"tock -> transition_t1__(clock_step(c_C, 5))", "tock -> transition_t1__(c_C)"}}},
        {"an exec transition resets its clock before the wait", reset, {{"entering_B__(0)", "entering_B__(1)"}}},
        {"transitions are taken during the wait",
         waiting,
         {{"A_during___2(c_C) = startexec",
           "A_during___2(c_C) = c_C == 1 & internal__.TID_t1 -> action_of_t1__ [] startexec"}}},
        {"an exec in an action is passed over",
         resumed,
         {{"= endexec -> action_of_t0___3", "= internal__.TID_t0 -> action_of_t0___4"}}},
        {"an action begins anew in the next cycle",
         resumed,
         {{"startexec -> action_of_t0___4", "startexec -> action_of_t0__"}}},
        {"exit actions run before the wait",
         resumed,
         {{"A__ = endexec", "A__ = registerWrite.o_p -> endexec"},
          {"startexec -> exit_action_of_A__", "startexec -> entering_B__"}}},
    };
}

std::vector<Mutant> mutants_of_compositions() {
    return {
        {"events between machines are not emptied", too_late, {{"; emptied__ -> SKIP", ""}}},
        {"events between machines are emptied before they are read",
         in_time,
         {{"; emptied__ -> SKIP", ""},
          {"r::registerRead.r::i_sig?x__ -> SKIP", "emptied__ -> r::registerRead.r::i_sig?x__ -> SKIP"}}},
        {"events between machines are shown",
         in_time,
         {{"w::registerWrite.w::o_sig -> PassOn__", "w::registerWrite.w::o_sig -> registerWrite.o_none -> PassOn__"}}},
        {"the register between machines is full at the beginning", too_early, {{"|] Empty_0__", "|] Register_0__"}}},
        {"an unconnected input is always empty",
         unconnected,
         {{"registerRead.i_e?x__ -> SKIP", "registerRead.i_e.false -> SKIP"}}},
        {"an unconnected output is shown",
         unconnected,
         {{"A::terminate <- terminate",
           "A::terminate <- terminate, A::registerWrite.A::o_lost <- registerWrite.o_yes"}}},
        {"each machine may write an output once",
         both_call,
         {{"[] ([] x__:{| B::registerWrite.B::o_go |}", "||| ([] x__:{| B::registerWrite.B::o_go |}"}}},
        {"the environment chooses the order of writes",
         in_any_order,
         {{"A::registerWrite.A::o_go?x__ -> registerWrite.o_go!x__",
           "registerWrite.o_go?x__ -> A::registerWrite.A::o_go!x__"},
          {"B::registerWrite.B::o_stay -> registerWrite.o_stay",
           "registerWrite.o_stay -> B::registerWrite.B::o_stay"}}},
        {"the cycle ends when one machine has ended its own",
         in_any_order,
         {{"A::endexec -> SKIP ||| B::endexec -> SKIP", "A::endexec -> SKIP [] B::endexec -> SKIP"}}},
        {"parts run in their own cycles", of_the_whole, {{"A::D__(id__, cycle_C_C)", "A::D__(id__, cycle_C_A_A)"}}},
        {"one machine terminates alone", together, {{"[| {| terminate, tock |} |] t::D__", "[| {| tock |} |] t::D__"}}},
        {"a shared variable begins with another value", shared, {{"Register_0__(false)", "Register_0__(true)"}}},
        {"a write of a shared variable has no effect",
         shared,
         {{"?y__ -> Register_0__(y__)", "?y__ -> Register_0__(x__)"}}},
    };
}

void expect_killed(const std::vector<Mutant>& mutants) {
    for (const Mutant& mutant : mutants) {
        EXPECT_TRUE(all_hold(decide(mutant.claimed, {}))) << mutant.reading;
        const std::vector<std::string> verdicts = decide(mutant.claimed, mutant.edits);
        EXPECT_FALSE(verdicts.empty() || all_hold(verdicts)) << "not killed: " << mutant.reading;
    }
}

TEST(RoboSimMutants, OfTheFrameAreKilled) {
    expect_killed(mutants_of_the_frame());
}

TEST(RoboSimMutants, OfTheBodyAreKilled) {
    expect_killed(mutants_of_the_body());
}

TEST(RoboSimMutants, OfCompositionsAreKilled) {
    expect_killed(mutants_of_compositions());
}

}  // namespace
}  // namespace robochart::csp_emit::robosim_test
