// SPDX-License-Identifier: Apache-2.0
// Tests the second case study of the paper, swarm taxis, as a module. The expected outputs are derived from
// corpus/swarm_taxis. One cycle is one time unit, the waits of Forward and Turn take one unit each, and reals are in
// hundredths or finer units (rc_interface::scale).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"

namespace robochart::cpp_emit::swarm_taxis_test {
namespace {

using testing::component_named;
using testing::Controller;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::Registers;

class SwarmTaxis : public ::testing::Test {
protected:
    std::string scale_value(double value) const {
        const double units = value * static_cast<double>(controller_.interface().scale);
        return std::to_string(static_cast<long long>(units + (value < 0 ? -0.5 : 0.5)));
    }

    const ir::System system_ = testing::load_corpus("swarm_taxis");
    Controller controller_{system_, component_named(system_, "SwarmTaxis")};
};

TEST_F(SwarmTaxis, StartsForward) {
    EXPECT_THAT(controller_.cycle(), ElementsAre("MoveForwardCall", "CheckIlluminationStatusCall"));
    EXPECT_THAT(controller_.cycle(), IsEmpty());
    EXPECT_THAT(controller_.state(), HasSubstr("state=Forward"));
}

TEST_F(SwarmTaxis, ReachesCoherenceAtTimeUnit25) {
    // T is reset in cycle 1, and since(T) is k - 1 in cycle k. So the guard since(T) >= 25 first holds in cycle 26.
    controller_.cycle();
    for (int cycle = 2; cycle <= 25; ++cycle) EXPECT_THAT(controller_.cycle(), IsEmpty()) << cycle;
    EXPECT_THAT(controller_.cycle(), ElementsAre("CalcCoherenceHeadingCall"));
    EXPECT_EQ(controller_.result(), RC_QUIESCENT);
}

TEST_F(SwarmTaxis, ARobotNearbyIsAvoided) {
    controller_.cycle();
    EXPECT_THAT(controller_.cycle({{"robotDetected.in", ""}}), ElementsAre("CalcAvoidanceHeadingCall"));
    EXPECT_THAT(controller_.cycle(), IsEmpty());  // the entry action waits for the heading
    EXPECT_THAT(controller_.cycle({{"heading.in", scale_value(0.2)}}),
                ElementsAre("set_desiredTurningDegree(" + scale_value(0.2) + ")", "set_reached(0)",
                            "StartTurningCall(" + scale_value(0.2) + ")"));
    EXPECT_THAT(controller_.cycle(), IsEmpty());  // Turn waits for `turned`
    EXPECT_THAT(controller_.cycle({{"turned.in", ""}}),
                ElementsAre("set_reached(1)", "MoveForwardCall", "CheckIlluminationStatusCall"));
}

TEST_F(SwarmTaxis, AvoidanceResetsTheClock) {
    controller_.cycle();
    for (int i = 0; i < 10; ++i) controller_.cycle();
    controller_.cycle({{"robotDetected.in", ""}});
    controller_.cycle({{"heading.in", "0"}});
    controller_.cycle();
    EXPECT_THAT(controller_.cycle({{"turned.in", ""}}), ::testing::Contains("MoveForwardCall"));
    for (int i = 1; i <= 24; ++i) EXPECT_THAT(controller_.cycle(), IsEmpty()) << i;
    EXPECT_THAT(controller_.cycle(), ElementsAre("CalcCoherenceHeadingCall"));
}

TEST_F(SwarmTaxis, LightSetsTheAvoidanceRadius) {
    controller_.cycle();
    EXPECT_THAT(controller_.cycle({{"illumination.in", "true"}}),
                ElementsAre("set_illuminated(1)", "set_avoidanceRadius(" + scale_value(0.2) + ")", "MoveForwardCall",
                            "CheckIlluminationStatusCall"));
    EXPECT_THAT(controller_.cycle({{"illumination.in", "false"}}),
                ElementsAre("set_illuminated(0)", "set_avoidanceRadius(" + scale_value(0.1) + ")", "MoveForwardCall",
                            "CheckIlluminationStatusCall"));
}

TEST_F(SwarmTaxis, TheFirstTransitionWrittenHasPriority) {
    controller_.cycle();
    EXPECT_THAT(controller_.cycle({{"illumination.in", "true"}, {"robotDetected.in", ""}}),
                ElementsAre("CalcAvoidanceHeadingCall"));
}

}  // namespace
}  // namespace robochart::cpp_emit::swarm_taxis_test
