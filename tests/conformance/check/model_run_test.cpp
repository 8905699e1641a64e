// SPDX-License-Identifier: Apache-2.0
// Tests that if generated code differs from its model, the report shows the model's run up to the difference, for every
// kind of search. The report also shows runs that explain notes on deadlines and repeated outputs.
#include "conformance/check/model_run.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "conformance/check/conform.hpp"
#include "conformance/check/partial_readings.hpp"
#include "conformance/check/standstill.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using ::testing::ElementsAre;

/// A machine that brakes three time units after `go`.
const std::string late_brake = R"(interface Brakes { Brake() }
stm M { requires Brakes event go initial i state Idle { } state B { entry wait(3) ; Brake() }
transition t0 { from i to Idle } transition t1 { from Idle to B trigger go } })";

Result with_fault(const std::string& text, cpp_emit::Fault fault, std::uint64_t most_states = 0) {
    const test::ModelFolder folder(text);
    test::Model model(folder.path());
    diagnostics::Diagnostics found;
    Options options;
    options.generator.fault = fault;
    if (most_states > 0) options.limits.max_states = most_states;
    return conform(model.system, model.instantiation, model.machine_named("M"), options, model.sources, found);
}

/// Returns the events of a run, without entries and exits of states.
std::vector<std::string> event_texts(const runs::Run& run) {
    std::vector<std::string> result;
    for (const runs::Step& step : run.steps)
        if (step.event.kind != runs::Kind::entered && step.event.kind != runs::Kind::exited)
            result.push_back(step.event.text);
    return result;
}

std::vector<std::string> offered_events(const runs::Run& run) {
    std::vector<std::string> result;
    for (const runs::Event& event : run.end.offered) result.push_back(event.text);
    return result;
}

// The code ends the cycle in which the model brakes, three time units after `go`. A walk may wait before `go`.
TEST(ModelRun, GoesAsFarAsTheCodeDoes) {
    const Result searched = with_fault(late_brake, cpp_emit::Fault::call_dropped);
    ASSERT_EQ(searched.outcome, Outcome::differs);
    ASSERT_TRUE(searched.explanation.run);
    const runs::Run& run = *searched.explanation.run;
    EXPECT_EQ(searched.explanation.rule, nullptr) << "the fault is not the model's";
    EXPECT_THAT(event_texts(run), ElementsAre("t0: i -> Idle", "input go", "3 time units pass"));
    EXPECT_THAT(offered_events(run), ElementsAre("call Brake"));
    EXPECT_EQ(run.end.why, searched.reason);
    ASSERT_EQ(run.steps.back().machines.size(), 1U);
    EXPECT_EQ(run.steps.back().machines.front().text, "entry action of B, at Brake()");
    EXPECT_EQ(run.time, 3);

    const Result walked = with_fault(late_brake, cpp_emit::Fault::call_dropped, 1);
    ASSERT_EQ(walked.outcome, Outcome::differs) << walked.reason;
    ASSERT_TRUE(walked.explanation.run) << walked.reason;
    EXPECT_THAT(offered_events(*walked.explanation.run), ElementsAre("call Brake"));
}

// The code brakes twice. Its second call is not part of the model's run.
TEST(ModelRun, EndsInFrontOfWhatTheModelDoesNotAllow) {
    const Result result = with_fault(late_brake, cpp_emit::Fault::output_repeated);
    ASSERT_EQ(result.outcome, Outcome::differs);
    ASSERT_TRUE(result.explanation.run);
    EXPECT_THAT(event_texts(*result.explanation.run),
                ElementsAre("t0: i -> Idle", "input go", "3 time units pass", "call Brake"));
    EXPECT_THAT(offered_events(*result.explanation.run), ElementsAre("one time unit passes"));
}

TEST(ModelRun, IsFoundForPartialReadings) {
    const test::ModelFolder folder(late_brake);
    test::Model model(folder.path());
    test::Bench bench(model, model.machine_named("M"));
    for (const cpp_emit::Fault fault : {cpp_emit::Fault::call_dropped, cpp_emit::Fault::output_repeated}) {
        const auto object = bench.compile_fault(fault, 0);
        ASSERT_TRUE(object);
        const Alphabet alphabet(bench.interface(), bench.session().event_table());
        ModelGraph graph(bench.system(), alphabet);
        Result result = judge_partially(graph, alphabet, object->interface(), 1, {});
        ASSERT_EQ(result.outcome, Outcome::differs) << result.reason;
        explain_result(result, bench.session(), bench.process(), alphabet,
                       {bench.script().provenance, model.system, model.instantiation, model.sources}, {});
        ASSERT_TRUE(result.explanation.run);
        EXPECT_EQ(result.explanation.run->time, 3);
    }
}

// x is output twice in the cycle of `go`, so the run ends before the second output.
TEST(ModelRun, ShowsWhereAnOutputIsMadeTwice) {
    const Result result = with_fault(R"(stm M { event go event x : nat initial i state Idle { }
state B { entry x!1 ; x!2 } transition t0 { from i to Idle } transition t1 { from Idle to B trigger go } })",
                                     cpp_emit::Fault::none);
    ASSERT_TRUE(result.register_cycles && result.register_cycles->run) << result.reason;
    EXPECT_THAT(event_texts(*result.register_cycles->run), ElementsAre("t0: i -> Idle", "input go", "output x with 1"));
    EXPECT_THAT(offered_events(*result.register_cycles->run), ::testing::Contains("output x with 2"));
}

// The answer is due one time unit after `go`, and then time stops.
TEST(ModelRun, ShowsWhereADeadlineMayBeMissed) {
    const Result result = with_fault(R"(stm M { event go event answer : nat var x : nat initial i state Idle { }
state B { entry (answer?x) <{1} } transition t0 { from i to Idle } transition t1 { from Idle to B trigger go } })",
                                     cpp_emit::Fault::none);
    ASSERT_TRUE(result.deadlines && result.deadlines->run) << result.reason;
    const runs::Run& run = *result.deadlines->run;
    EXPECT_THAT(event_texts(run), ElementsAre("t0: i -> Idle", "input go", "1 time unit passes"));
    for (const std::string& event : offered_events(run)) EXPECT_THAT(event, ::testing::StartsWith("input answer"));
    EXPECT_FALSE(run.end.offered.empty());
}

}  // namespace
}  // namespace robochart::conformance
