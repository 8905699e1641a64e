// SPDX-License-Identifier: Apache-2.0
// Tests the machine, controller and module of the aggregation model, the first case study of the paper. The expected
// outputs are derived from the model text (corpus/aggregation). Reals are in hundredths, and one cycle is one time
// unit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cpp_emit/harness.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"

namespace robochart::cpp_emit::aggregation_test {
namespace {

using testing::component_named;
using testing::Controller;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::Registers;

class Machine : public ::testing::Test {
protected:
    const ir::System system_ = ir::samples::aggregation();
    Controller controller_{system_, component_named(system_, "AggregationFSM")};
};

TEST_F(Machine, ListsInputsAndOutputs) {
    const rc_interface& interface = controller_.interface();
    EXPECT_STREQ(interface.component, "AggregationFSM");
    EXPECT_EQ(interface.scale, 100);
    ASSERT_EQ(interface.inputs, 2U);  // no inputs for the shared speeds, which are never read
    EXPECT_STREQ(interface.input[0].name, "seeWall.in");
    EXPECT_STREQ(interface.input[1].name, "seeRobot.in");
}

TEST_F(Machine, FirstCycleEntersS1) {
    EXPECT_THAT(controller_.cycle(), ElementsAre("MoveClockwiseCall(-75,-1088)"));
    EXPECT_EQ(controller_.result(), RC_QUIESCENT);
    EXPECT_EQ(controller_.state(), "state=S1");
    EXPECT_THAT(controller_.cycle(), IsEmpty());
}

TEST_F(Machine, NothingRunsBeforeTheFirstCycle) {
    const auto before = controller_.image();
    controller_.reset();
    EXPECT_EQ(controller_.image(), before);
}

TEST_F(Machine, RobotThenWall) {
    controller_.cycle();
    EXPECT_THAT(controller_.cycle({{"seeRobot.in", ""}}), ElementsAre("RotateClockwiseCall(-502)"));
    EXPECT_THAT(controller_.cycle({{"seeRobot.in", ""}}), IsEmpty());
    EXPECT_THAT(controller_.cycle({{"seeWall.in", ""}}), ElementsAre("MoveClockwiseCall(-75,-1088)"));
}

TEST_F(Machine, BothInputsInOneCycleGoThereAndBack) {
    controller_.cycle();
    EXPECT_THAT(controller_.cycle({{"seeRobot.in", ""}, {"seeWall.in", ""}}),
                ElementsAre("RotateClockwiseCall(-502)", "MoveClockwiseCall(-75,-1088)"));
    EXPECT_EQ(controller_.state(), "state=S1");
}

class Module : public ::testing::Test {
protected:
    const ir::System system_ = ir::samples::aggregation();
    Controller controller_{system_, component_named(system_, "Aggregation")};
};

TEST_F(Module, OperationWritesTheSpeedsAndTakesACycle) {
    // Semantics 3.8: the writes of the operation itself are visible, but its call is not. The order is that of the
    // entry action.
    EXPECT_THAT(controller_.cycle(), ElementsAre("set_angularSpeed(-75)", "set_linearSpeed(-1088)"));
    EXPECT_THAT(controller_.cycle({{"seeRobot.in", ""}}), ElementsAre("set_angularSpeed(-502)", "set_linearSpeed(0)"));
}

TEST_F(Module, TransitionsWaitForTheOperationsEnd) {
    // In the first cycle, S1's entry action is still running, so seeRobot is refused and lost.
    controller_.cycle({{"seeRobot.in", ""}});
    EXPECT_THAT(controller_.cycle(), IsEmpty());
}

TEST_F(Module, OneSpeedPerCycleThoughBothInputsAreRaised) {
    const Registers both = {{"seeRobot.in", ""}, {"seeWall.in", ""}};
    controller_.cycle();
    EXPECT_THAT(controller_.cycle(both), ElementsAre("set_angularSpeed(-502)", "set_linearSpeed(0)"));
    EXPECT_THAT(controller_.cycle(both), ElementsAre("set_angularSpeed(-75)", "set_linearSpeed(-1088)"));
}

TEST_F(Module, EqualStatesHaveEqualBytes) {
    controller_.cycle();
    controller_.cycle();
    const auto rested = controller_.image();
    for (const char* input : {"seeRobot.in", "seeWall.in"}) controller_.cycle({{input, ""}});
    controller_.cycle();
    EXPECT_EQ(controller_.state(), "state=S1");
    EXPECT_EQ(controller_.image(), rested);
}

TEST_F(Module, ControllerAndModuleAgree) {
    Controller inner(system_, component_named(system_, "AggregationController"));
    const Registers robot = {{"seeRobot.in", ""}};
    for (const Registers& inputs : {Registers{}, robot, robot, Registers{{"seeWall.in", ""}}})
        EXPECT_EQ(inner.cycle(inputs), controller_.cycle(inputs));
}

}  // namespace
}  // namespace robochart::cpp_emit::aggregation_test
