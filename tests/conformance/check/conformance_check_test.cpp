// SPDX-License-Identifier: Apache-2.0
// Tests the checker. Correct controllers must conform. Each faulty controller must differ. The cycle, the inputs and
// the expected event follow from the model by hand.
#include "conformance/check/conformance_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/conformance/support.hpp"

namespace robochart::conformance {
namespace {

using test::Edge;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Result judge_turner(int fault, std::vector<Edge> model = test::turner_model(),
                    const Interface& interface = test::turner_interface()) {
    std::string error;
    const auto object = test::hand_made("turner", fault, error);
    EXPECT_TRUE(object) << error;
    if (!object) return {};
    process::EventTable events;
    test::GraphSystem system(std::move(model), events);
    return judge_component(system, events, interface, object->interface(), 1, {});
}

TEST(Judge, RightControllerConforms) {
    const Result result = judge_turner(0);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_EQ(result.code_states, 3U);              // start, driving, turning
    EXPECT_EQ(result.code_cycles, 3U * 2 * 2 * 3);  // every state under every valuation
    EXPECT_THAT(result.cycles, IsEmpty());
    EXPECT_THAT(result.warnings, IsEmpty());
    EXPECT_GT(result.product.states, 0U);
}

// With seeWall and speed = 2, the model must drive at 2. With speed = -2 the defect is hidden, because the model may
// ignore the speed.
TEST(Judge, WrongArgument) {
    const Result result = judge_turner(1);
    ASSERT_EQ(result.outcome, Outcome::differs);
    ASSERT_EQ(result.cycles.size(), 3U);
    EXPECT_THAT(result.cycles[0].outputs, ElementsAre("Drive(2)"));
    EXPECT_THAT(result.cycles[1].inputs, ElementsAre("seeRobot"));
    EXPECT_THAT(result.cycles[2].inputs, ElementsAre("seeWall", "speed = 2"));
    EXPECT_THAT(result.cycles[2].outputs, ElementsAre("Drive(-2)"));
    EXPECT_EQ(result.expected, "Drive(2)");
    EXPECT_EQ(result.cycles[1].state, "state=turning");
}

// Rule R2: an input is lost at the end of its cycle.
TEST(Judge, InputKeptForTheNextCycle) {
    const Result result = judge_turner(2);
    ASSERT_EQ(result.outcome, Outcome::differs);
    ASSERT_EQ(result.cycles.size(), 2U);
    EXPECT_THAT(result.cycles[0].inputs, ElementsAre("seeRobot"));
    EXPECT_THAT(result.cycles[1].inputs, IsEmpty());
    EXPECT_THAT(result.cycles[1].outputs, ElementsAre("Turn()"));
    EXPECT_EQ(result.expected, "end of cycle");
}

// Rule R5: no further action follows a wait in the same cycle.
TEST(Judge, WaitDropped) {
    const Result result = judge_turner(3);
    ASSERT_EQ(result.outcome, Outcome::differs);
    ASSERT_EQ(result.cycles.size(), 1U);
    EXPECT_THAT(result.cycles[0].outputs, ElementsAre("Drive(2)", "Turn()"));
}

// Rule R3: if an output is missing, the end of the cycle is a tock that maximal progress forbids.
TEST(Judge, OutputLost) {
    const Result result = judge_turner(4);
    ASSERT_EQ(result.outcome, Outcome::differs);
    ASSERT_EQ(result.cycles.size(), 2U);
    EXPECT_THAT(result.cycles[1].inputs, ElementsAre("seeRobot"));
    EXPECT_THAT(result.cycles[1].outputs, IsEmpty());
    EXPECT_EQ(result.expected, "Turn()");
    EXPECT_THAT(result.reason, HasSubstr("ends its cycle"));
    EXPECT_EQ(result.raw.back(), "tock");
}

TEST(Judge, OutputTooMany) {
    const Result result = judge_turner(5);
    ASSERT_EQ(result.outcome, Outcome::differs);
    ASSERT_EQ(result.cycles.size(), 2U);
    EXPECT_THAT(result.cycles[1].outputs, ElementsAre("Turn()", "Drive(2)"));
}

TEST(Judge, PreconditionViolated) {
    const Result result = judge_turner(6);
    ASSERT_EQ(result.outcome, Outcome::differs);
    EXPECT_THAT(result.reason, HasSubstr("precondition"));
    EXPECT_THAT(result.cycles.back().inputs, ElementsAre("seeRobot"));
}

// Rule R6: a loop without time is a divergence.
TEST(Judge, StepBoundIsDivergence) {
    const Result result = judge_turner(7);
    ASSERT_EQ(result.outcome, Outcome::differs);
    EXPECT_THAT(result.reason, HasSubstr("step bound"));
    EXPECT_THAT(result.cycles.back().inputs, ElementsAre("seeRobot"));
}

TEST(Judge, MemoryOutsideTheState) {
    const Result result = judge_turner(8);
    ASSERT_EQ(result.outcome, Outcome::differs);
    EXPECT_THAT(result.reason, HasSubstr("two results"));
}

// The state contains a counter that does not affect the behaviour. So the code is correct, but its states are not
// canonical.
TEST(Judge, StateNotCanonical) {
    const Result result = judge_turner(9);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_GT(result.code_states, 3U);
    EXPECT_THAT(result.warnings, ElementsAre(HasSubstr("canonical")));
}

TEST(Judge, InitialLeavesBytesUnwritten) {
    const Result result = judge_turner(10);
    ASSERT_EQ(result.outcome, Outcome::differs);
    EXPECT_THAT(result.reason, HasSubstr("initial"));
}

TEST(Judge, Termination) {
    const Result early = judge_turner(11);
    ASSERT_EQ(early.outcome, Outcome::differs);
    EXPECT_THAT(early.reason, HasSubstr("termination"));
    EXPECT_EQ(early.expected, "end of cycle");

    const std::vector<Edge> drives_once{{0, "T::DriveCall.2", 1}, {1, "tick", 2}};
    const Result right = judge_turner(11, drives_once);
    EXPECT_EQ(right.outcome, Outcome::conforms) << right.reason;
    const Result goes_on = judge_turner(0, drives_once);
    ASSERT_EQ(goes_on.outcome, Outcome::differs);
    EXPECT_EQ(goes_on.expected, "termination");
}

// The `terminate` event of a machine is visible (semantics 3.9). The check hides it, so that only ✓ counts.
TEST(Judge, TerminateEventIsHidden) {
    const Result result =
        judge_turner(11, {{0, "T::DriveCall.2", 1}, {1, "T::terminate", 2}, {1, "tock", 1}, {2, "tick", 3}});
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

// Rule R4: with both inputs, the same machine without its waits drives twice in a cycle. It is schedulable, but not
// with cycles that make each output at most once. The code waits for the next cycle, so it differs.
TEST(Judge, OutputsAreASequence) {
    const Result result = judge_turner(0, test::turner_model(false));
    ASSERT_EQ(result.outcome, Outcome::differs);
    EXPECT_THAT(result.reason, HasSubstr("ends its cycle although the model must go on"));
    EXPECT_EQ(result.expected, "Turn()");
    ASSERT_TRUE(result.register_cycles);
    EXPECT_FALSE(result.register_cycles->holds);
    EXPECT_THAT(result.register_cycles->reason, HasSubstr("Drive(2) a second time in one cycle"));
    const std::vector<Cycle>& cycles = result.register_cycles->cycles;
    ASSERT_EQ(cycles.size(), 1U);
    EXPECT_THAT(cycles[0].inputs, ElementsAre("seeRobot", "seeWall"));
    EXPECT_THAT(cycles[0].outputs, ElementsAre("Drive(2)", "Turn()"));
}

TEST(Judge, WithWaitsEachOutputIsMadeOnceACycle) {
    const Result result = judge_turner(0);
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.register_cycles && result.deadlines);
    EXPECT_TRUE(result.register_cycles->holds);
    EXPECT_TRUE(result.deadlines->holds);
}

// The model makes infinitely many outputs in one cycle. This is no τ loop, because outputs are visible, but no control
// cycle exists either.
TEST(Judge, OutputsWithoutEndAreNotSchedulable) {
    const Result result = judge_turner(0, {{0, "T::DriveCall.2", 0}, {0, "tock", 0}});
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_THAT(result.reason, HasSubstr("infinitely many steps without time passing"));
}

// Rule R7: if the model waits for an input with a deadline of 0, time stops in the model. The code must report a missed
// deadline there and nowhere else.
TEST(Judge, DeadlinesOnInputsAreReportedByTheCode) {
    const std::vector<Edge> waits{{0, "T::DriveCall.2", 1}, {1, "tock", 2}, {2, "T::seeRobot.in", 1}};
    const Result silent = judge_turner(4, waits);
    ASSERT_EQ(silent.outcome, Outcome::differs);
    EXPECT_THAT(silent.reason, HasSubstr("misses a deadline and does not report it"));
    EXPECT_EQ(silent.cycles.size(), 2U);
    ASSERT_TRUE(silent.deadlines);
    EXPECT_FALSE(silent.deadlines->holds);
    EXPECT_EQ(silent.deadlines->cycles.size(), 2U);
    const Result right = judge_turner(13, waits);
    EXPECT_EQ(right.outcome, Outcome::conforms) << right.reason;
    const std::vector<Edge> goes_on{{0, "T::DriveCall.2", 1}, {1, "tock", 1}, {1, "T::seeRobot.in", 1}};
    const Result wrong = judge_turner(13, goes_on);
    ASSERT_EQ(wrong.outcome, Outcome::differs);
    EXPECT_THAT(wrong.reason, HasSubstr("the code misses a deadline"));
    EXPECT_EQ(wrong.expected, "end of cycle");
}

// Rule R7: this model stops time without any input.
TEST(Judge, TimelockOfTheModelIsNotSchedulable) {
    const Result result =
        judge_turner(0, {{0, "T::DriveCall.2", 1}, {1, "tock", 2}, {2, "tock", 2}, {2, "T::seeRobot.in", 3}});
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    ASSERT_EQ(result.cycles.size(), 2U);
    EXPECT_THAT(result.cycles[1].inputs, ElementsAre("seeRobot"));
    EXPECT_THAT(result.cycles[1].state, HasSubstr("s3"));
}

// Rule R7: another machine can still take an input, but time stops after the input, too.
TEST(Judge, ATimelockBesideAnInputIsNotSchedulable) {
    const Result result =
        judge_turner(13, {{0, "T::DriveCall.2", 1}, {1, "tock", 2}, {2, "T::seeRobot.in", 3}, {3, "T::seeWall.in", 2}});
    ASSERT_EQ(result.outcome, Outcome::not_schedulable) << result.reason;
    EXPECT_THAT(result.reason, HasSubstr("can neither go on nor let time pass"));
}

TEST(Judge, DivergenceOfTheModelIsNotSchedulable) {
    const Result result = judge_turner(0, {{0, "T::DriveCall.2", 1}, {1, "tau", 2}, {2, "tau", 1}});
    ASSERT_EQ(result.outcome, Outcome::not_schedulable);
    EXPECT_THAT(result.reason, HasSubstr("without time passing"));
}

TEST(Judge, InputMissingFromTheInterface) {
    Interface interface = test::turner_interface();
    interface.inputs.pop_back();
    process::EventTable events;
    const Alphabet alphabet(interface, events);
    test::GraphSystem system(test::turner_model(), events);
    ModelGraph graph(system, alphabet);
    EXPECT_THROW((void)check_schedulability(graph, alphabet, 1, {}), AlphabetError);
    EXPECT_EQ(judge_turner(0, {{0, "T::jump.in", 0}}).outcome, Outcome::differs);
}

TEST(Judge, LimitsAreInconclusive) {
    std::string error;
    const auto object = test::hand_made("turner", 0, error);
    ASSERT_TRUE(object) << error;
    process::EventTable events;
    test::GraphSystem system(test::turner_model(), events);
    refine::Limits limits;
    limits.max_states = 3;
    const Result result = judge_component(system, events, test::turner_interface(), object->interface(), 1, limits);
    EXPECT_EQ(result.outcome, Outcome::inconclusive);
    EXPECT_FALSE(result.reason.empty());
}

}  // namespace
}  // namespace robochart::conformance
