// SPDX-License-Identifier: Apache-2.0
// Tests models that cannot run in control cycles. For each cause, the report contains the rule, the elements of the
// model that are involved, and a suggested fix.
#include "conformance/check/standstill.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/check/partial_readings.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// Returns a machine with the parts that all models of this test share.
std::string braking_machine(const std::string& declarations, const std::string& parts) {
    return "interface Brakes { Brake() }\nstm M {\n requires Brakes event go " + declarations +
           "\n initial i state Idle { }\n transition t0 { from i to Idle }\n" + parts + "\n}";
}

Result run_in_cycles(const std::string& text, Options options) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    diagnostics::Diagnostics found;
    return conform(model.system, model.instantiation, model.machine_named("M"), options, model.sources, found);
}

Result run_in_cycles(const std::string& text, std::uint32_t cycle_length = 1) {
    Options options;
    options.cycle_length = cycle_length;
    return run_in_cycles(text, options);
}

/// Returns a matcher for the place of an element: "t2: B -> B (/tmp/.../model.rct:7)".
auto element(const std::string& text, int line) {
    return testing::AllOf(testing::StartsWith(text + " ("), testing::EndsWith(fmt::format("/model.rct:{})", line)));
}

std::string code_of_cause(const Result& result) {
    return result.explanation.rule == nullptr ? "" : std::string(result.explanation.rule->code);
}

const std::string endless_loop = braking_machine("var n : nat",
                                                 "state B { entry n = 1 } transition t1 { from Idle to B trigger go }\n"
                                                 "transition t2 { from B to B condition n > 0 }");

TEST(Standstill, OfStepsWithoutEndNamesTheTransitionsOfTheLoop) {
    const Result result = run_in_cycles(endless_loop);
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(result), "RC-K01");
    EXPECT_THAT(result.explanation.where, Contains(element("t2: B -> B", 7)));
    EXPECT_THAT(result.explanation.where, Not(Contains(HasSubstr("t1"))));
    EXPECT_THAT(result.explanation.remedy, HasSubstr("give t2: B -> B"));
    EXPECT_THAT(result.reason, element("the model takes infinitely many steps without time passing, entering B", 6));
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_THAT(result.cycles[0].inputs, ElementsAre("go"));
}

TEST(Standstill, OfOutputsWithoutEndNamesTheOutputToo) {
    const Result result = run_in_cycles(braking_machine(
        "event x", "state B { entry x } transition t1 { from Idle to B trigger go }\ntransition t2 { from B to B }"));
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(result), "RC-K02");
    EXPECT_THAT(result.explanation.where, Contains(element("output x, entry action of B", 6)));
    EXPECT_THAT(result.explanation.where, Contains(element("t2: B -> B", 7)));
}

// The time that a call takes depends on the component. In the controller that defines the operation, the call may take
// time.
TEST(Standstill, InfiniteCallsAreReportedAsTakingNoTime) {
    const Result result =
        run_in_cycles(braking_machine("",
                                      "state B { entry Brake() } transition t1 { from Idle to B trigger go }\n"
                                      "transition t2 { from B to B }"));
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(result), "RC-K02");
    EXPECT_THAT(result.explanation.where,
                ElementsAre(element("call Brake, entry action of B", 6), element("t2: B -> B", 7)));
    EXPECT_THAT(result.explanation.remedy, HasSubstr("operations take no time here"));
}

// The wait starts together with the deadline of 3 and takes 5 units, so the deadline is too short by 2.
TEST(Standstill, AtADeadlineSaysByHowMuchItIsTooShort) {
    const Result result = run_in_cycles(
        braking_machine("event x", "state B { entry (wait(5) ; x) <{3} } transition t1 { from Idle to B trigger go }"));
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(result), "RC-K03");
    EXPECT_THAT(result.explanation.where, Contains(element("the deadline of M::B is over", 6)));
    EXPECT_THAT(result.explanation.remedy, HasSubstr("at least 2 time units longer"));
    EXPECT_THAT(result.reason, element("the model can neither go on nor let time pass, entry action of B, waiting", 6));
    ASSERT_EQ(result.cycles.size(), 4U);
    for (const Cycle& cycle : result.cycles) EXPECT_THAT(cycle.state, element("entry action of B, waiting", 6));
    const Result remedied = run_in_cycles(
        braking_machine("event x", "state B { entry (wait(5) ; x) <{5} } transition t1 { from Idle to B trigger go }"));
    EXPECT_EQ(remedied.outcome, Outcome::conforms) << remedied.reason;
    EXPECT_EQ(code_of_cause(remedied), "");
}

TEST(Standstill, BetweenCyclesSaysWhatIsDueAndWhen) {
    const std::string brakes =
        braking_machine("", "state B { entry wait(4) ; Brake() } transition t1 { from Idle to B trigger go }");
    const Result output = run_in_cycles(brakes, 3);
    ASSERT_EQ(output.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(output), "RC-K04");
    EXPECT_THAT(output.explanation.where, ElementsAre(element("call Brake, entry action of B", 6)));
    EXPECT_THAT(output.explanation.remedy, HasSubstr("due 1 time unit after the beginning of a cycle of 3"));
    EXPECT_EQ(run_in_cycles(brakes, 2).outcome, Outcome::conforms);
    EXPECT_EQ(run_in_cycles(brakes, 1).outcome, Outcome::conforms);

    const Result end =
        run_in_cycles(braking_machine("", "final f transition t1 { from Idle to f trigger go action wait(5) }"), 3);
    ASSERT_EQ(end.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(end), "RC-K05");
    EXPECT_THAT(end.explanation.where, ElementsAre(element("terminates behind input go, t1: Idle -> f", 6)));
    EXPECT_THAT(end.explanation.remedy, HasSubstr("due 2 time units after the beginning of a cycle of 3"));
}

TEST(Standstill, BetweenCyclesOfAnInputSaysHowLongTheDeadlineWouldHaveToBe) {
    const std::string asks = "state B { entry wait(1) ; (answer?x) <{%} } transition t1 { from Idle to B trigger go }";
    const auto with_deadline = [&](const std::string& deadline) {
        std::string parts = asks;
        parts.replace(parts.find('%'), 1, deadline);
        return run_in_cycles(braking_machine("event answer : nat var x : nat", parts), 3);
    };
    const Result result = with_deadline("0");
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_EQ(code_of_cause(result), "RC-K06");
    EXPECT_THAT(result.explanation.where, ElementsAre(element("input answer, entry action of B", 6)));
    EXPECT_THAT(result.explanation.remedy, HasSubstr("extend the deadline by 2"));
    EXPECT_EQ(with_deadline("2").outcome, Outcome::conforms);
}

TEST(Standstill, IsExplainedWhereWalksFindIt) {
    Options options;
    options.limits.max_states = 1;
    const Result result = run_in_cycles(endless_loop, options);
    ASSERT_EQ(result.outcome, Outcome::not_schedulable) << result.reason;
    EXPECT_THAT(result.reason, HasSubstr("guided walks"));
    EXPECT_EQ(code_of_cause(result), "RC-K01");
    EXPECT_THAT(result.explanation.where, Contains(element("t2: B -> B", 7)));
}

TEST(Standstill, IsExplainedWhereTheSearchOverPartialReadingsFindsIt) {
    const test::ModelFolder folder(endless_loop);
    test::Model model(folder.path());
    test::Bench bench(model, model.machine_named("M"));
    const auto object = bench.compile_fault(cpp_emit::Fault::none, 0);
    ASSERT_TRUE(object);
    const Alphabet alphabet(bench.interface(), bench.session().event_table());
    ModelGraph graph(bench.system(), alphabet);
    Result result = judge_partially(graph, alphabet, object->interface(), 1, {});
    ASSERT_EQ(result.outcome, Outcome::not_schedulable) << result.reason;
    EXPECT_EQ(code_of_cause(result), "RC-K01");
    explain_result(result, bench.session(), bench.process(), alphabet,
                   {bench.script().provenance, model.system, model.instantiation, model.sources}, {});
    EXPECT_THAT(result.explanation.where, Contains(element("t2: B -> B", 7)));
}

/// If an additional property is violated, such as repeated outputs or missed deadlines, the report names its rule.
TEST(AdditionalProperties, ViolationsReferToTheirRule) {
    const Result twice = run_in_cycles(
        braking_machine("event x : nat", "state B { entry x!1 ; x!2 } transition t1 { from Idle to B trigger go }"));
    ASSERT_EQ(twice.outcome, Outcome::conforms) << twice.reason;
    ASSERT_TRUE(twice.register_cycles && twice.deadlines);
    ASSERT_NE(twice.register_cycles->rule, nullptr);
    EXPECT_EQ(twice.register_cycles->rule->code, "RC-K07");
    EXPECT_EQ(twice.deadlines->rule, nullptr);
    const Result late =
        run_in_cycles(braking_machine("event answer : nat var x : nat",
                                      "state B { entry (answer?x) <{1} } transition t1 { from Idle to B trigger go }"));
    ASSERT_EQ(late.outcome, Outcome::conforms) << late.reason;
    ASSERT_TRUE(late.deadlines && late.deadlines->rule != nullptr);
    EXPECT_EQ(late.deadlines->rule->code, "RC-K08");
    EXPECT_EQ(late.register_cycles->rule, nullptr);
}

}  // namespace
}  // namespace robochart::conformance
