// SPDX-License-Identifier: Apache-2.0
// Runs the whole check on the two case studies, and on variants of them that are not schedulable.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "conformance/check/conform.hpp"
#include "tests/conformance/bench.hpp"

namespace robochart::conformance {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

Result conform_component(test::Model& model, const ir::ComponentRef& component, const Options& options = {}) {
    const auto start = std::chrono::steady_clock::now();
    const Result result =
        conform(model.system, model.instantiation, component, options, model.sources, model.diagnostics);
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    fmt::print(
        "{}: {} code states, {} cycles, {} model states, {} product states, {} transitions, {} spec nodes, "
        "schedulability {} states in {:.2f} s, refinement {:.2f} s, all {:.2f} s\n",
        component.path, result.code_states, result.code_cycles, result.model_states, result.product.states,
        result.product.transitions, result.product.spec_nodes, result.schedulability.states,
        result.schedulability.seconds, result.product.seconds, taken.count());
    return result;
}

Result conform_module(const std::string& folder, const Options& options = {}) {
    test::Model model(folder);
    return conform_component(model, model.first_module(), options);
}

TEST(CaseStudies, AggregationConforms) {
    const Result result = conform_module("corpus/aggregation");
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_THAT(result.warnings, testing::IsEmpty());
    EXPECT_GT(result.code_cycles, 0U);
}

TEST(CaseStudies, SwarmTaxisConforms) {
    const Result result = conform_module("corpus/swarm_taxis");
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
    EXPECT_THAT(result.warnings, testing::IsEmpty());
}

TEST(CaseStudies, NestedConforms) {
    const Result result = conform_module("tests/conformance/models/nested");
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

// If a machine is checked alone, the environment may write its shared variables.
TEST(CaseStudies, NestedMachineConforms) {
    test::Model model("tests/conformance/models/nested");
    const Result result = conform_component(model, model.machine_named("Nested"));
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

// Every shared variable that the machine reads has a register.
TEST(CaseStudies, SwarmTaxisMachineConforms) {
    test::Model model("corpus/swarm_taxis");
    const Result result = conform_component(model, model.machine_named("SwarmTaxisFSM"));
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

// The carrier of reals is small, to keep the number of valuations small.
TEST(CaseStudies, SwarmTaxisControllerConforms) {
    ir::InstantiationOptions few;
    few.ranges = {{"nat", {0, 0}}, {"int", {0, 0}}, {"real", {0, 0}}};
    test::Model model("corpus/swarm_taxis", few);
    const Result result = conform_component(model, model.first_controller());
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

TEST(CaseStudies, ControllersConform) {
    test::Model nested("tests/conformance/models/nested");
    const Result small = conform_component(nested, nested.first_controller());
    EXPECT_EQ(small.outcome, Outcome::conforms) << small.reason;
    test::Model model("corpus/aggregation");
    const Result result = conform_component(model, model.first_controller());
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

// Code and model advance by two time units per cycle. The operations wait for one time unit, so the wait ends within
// the cycle.
TEST(CaseStudies, AggregationConformsInCyclesOfTwo) {
    Options options;
    options.cycle_length = 2;
    const Result result = conform_module("corpus/aggregation", options);
    EXPECT_EQ(result.outcome, Outcome::conforms) << result.reason;
}

void expect_twice(const Result& result, const std::vector<std::string>& inputs, const std::string& output) {
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.register_cycles);
    EXPECT_FALSE(result.register_cycles->holds);
    EXPECT_THAT(result.register_cycles->reason, HasSubstr(output + " a second time in one cycle"));
    ASSERT_EQ(result.register_cycles->cycles.size(), 1U);
    EXPECT_THAT(result.register_cycles->cycles[0].inputs, ::testing::UnorderedElementsAreArray(inputs));
}

// Rule R4: without their waits, the operations set a speed twice if a robot is seen in the first cycle.
TEST(CaseStudies, AggregationWithoutWaitsSetsASpeedTwice) {
    const Result result =
        conform_module(test::changed_copy("corpus/aggregation/aggregation.rct", "; wait(1)", "").path());
    expect_twice(result, {"seeRobot"}, "angularSpeed = -5.02");
    EXPECT_THAT(result.register_cycles->cycles[0].outputs, ElementsAre("angularSpeed = -0.75", "linearSpeed = -10.88"));
}

// If the machine is checked alone, the operations that it calls are platform calls, which take no time.
TEST(CaseStudies, AggregationMachineAloneCallsAnOperationTwice) {
    test::Model model("corpus/aggregation");
    const Result result = conform_component(model, model.machine_named("AggregationFSM"));
    expect_twice(result, {"seeWall", "seeRobot"}, "MoveClockwise(-0.75, -10.88)");
    EXPECT_THAT(result.register_cycles->cycles[0].outputs,
                ElementsAre("MoveClockwise(-0.75, -10.88)", "RotateClockwise(-5.02)"));
}

// If {detected, turned} occur in one cycle, the machine enters, leaves and enters Forward again, which makes two moves.
TEST(CaseStudies, SwarmTaxisWithoutWaitsMovesTwice) {
    const Result result =
        conform_module(test::changed_copy("corpus/swarm_taxis/swarm_taxis.rct", "; wait(1)", "").path());
    ASSERT_EQ(result.outcome, Outcome::conforms) << result.reason;
    ASSERT_TRUE(result.register_cycles);
    EXPECT_FALSE(result.register_cycles->holds);
    EXPECT_EQ(result.register_cycles->cycles.size(), 1U);
}

}  // namespace
}  // namespace robochart::conformance
