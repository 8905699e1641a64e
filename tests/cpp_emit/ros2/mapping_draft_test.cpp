// SPDX-License-Identifier: Apache-2.0
// Tests drafts of mappings: the messages follow from types and names, and the generator accepts each draft.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/cpp_emit/models.hpp"
#include "tests/cpp_emit/ros2/package.hpp"

namespace robochart::cpp_emit::ros2::mapping_draft_test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Returns the options of the command, without exploration.
Options emitting() {
    Options options;
    options.explored = false;
    return options;
}

std::string draft_of(const ir::System& system, const std::string& component) {
    Options options = emitting();
    options.mapping_draft = true;
    const Planned planned = emit_package(system, component, "", {}, options);
    if (planned.emission.files.size() != 1) {
        ADD_FAILURE() << planned.emission.files.size() << " files\n" << planned.findings;
        return "";
    }
    EXPECT_TRUE(planned.emission.files.front().keep) << "an edited draft stays as it is";
    return planned.emission.files.front().text;
}

const char* const robot = R"(package p
import sequence_toolkit::*
datatype Vec { x : real y : real z : real }
datatype Twist { linear : Vec angular : Vec }
datatype Velocity { linear : Vec angular : Vec }
datatype Pose2D { x : real y : real }
datatype Odd { colour : real }
interface I { move(lv : real, av : real) drive(v : Velocity) go(t : Twist) forward(speed : real) grip(a : nat, b : nat)
    paint(o : Odd) stop() }
interface E { event scan : Seq(real) event obstacleDistance : real event batteryLevel : real event bump
    event at : Pose2D event level : nat event words : Seq(nat) event distance : real }
stm M { requires I uses E var s : Seq(real) var d : real var p : Pose2D var n : nat var w : Seq(nat) var v : Velocity
    var t : Twist var o : Odd
    initial i
    state A { entry move(1, 0.25) ; drive(v) ; go(t) ; forward(1) ; grip(1, 2) ; paint(o) ; stop() }
    transition t0 { from i to A }
    transition t1 { from A to A trigger scan ? s } transition t2 { from A to A trigger obstacleDistance ? d }
    transition t3 { from A to A trigger batteryLevel ? d } transition t4 { from A to A trigger bump }
    transition t5 { from A to A trigger at ? p } transition t6 { from A to A trigger level ? n }
    transition t7 { from A to A trigger words ? w } transition t8 { from A to A trigger distance ? d }
}
)";

TEST(MappingDraft, HasTheMessagesOfShapesAndNames) {
    const std::string draft = draft_of(testing::load_model(robot), "M");
    const char* const lines[] = {
        "ros2 for M {",
        "publish operation move as geometry_msgs/Twist on \"cmd_vel\" { linear.x = lv angular.z = av }",
        "publish operation forward as geometry_msgs/Twist on \"cmd_vel\" { linear.x = speed }",
        "publish operation go as geometry_msgs/Twist on \"cmd_vel\" { linear.x = t.linear.x linear.y = t.linear.y",
        "publish operation drive as geometry_msgs/Twist on \"cmd_vel\" { linear.x = v.linear.x",
        "publish operation stop as std_msgs/Empty on \"stop\"\n",
        "// publish operation grip as PACKAGE/TYPE on \"grip\"",
        "// publish operation paint as PACKAGE/TYPE on \"paint\"",
        "receive event scan as sensor_msgs/LaserScan on \"scan\" { value = ranges }",
        "receive event obstacleDistance as sensor_msgs/Range on \"range\" { value = range }",
        "receive event distance as sensor_msgs/Range on \"distance\" { value = range }",  // "range" is in use
        "receive event batteryLevel as sensor_msgs/BatteryState on \"battery_state\" { value = percentage }",
        "receive event bump as std_msgs/Empty on \"bump\"",
        "receive event at as geometry_msgs/Pose2D on \"at\" { value.x = x value.y = y }",
        "receive event level as std_msgs/Int64 on \"level\" { value = data }",
        "// receive event words as PACKAGE/TYPE on \"words\"",
    };
    for (const char* const line : lines) EXPECT_THAT(draft, HasSubstr(line));
}

/// No message has the form of the record of `paint`, so only this operation stops the generator.
TEST(MappingDraft, IsAcceptedByTheGenerator) {
    const ir::System system = testing::load_model(
        "package p\ndatatype Pose2D { x : real y : real }\ndatatype Odd { colour : real }\n"
        "interface I { move(lv : real, av : real) paint(o : Odd) }\ninterface E { event distance : real event at : "
        "Pose2D }\n"
        "stm M { requires I uses E var d : real var p : Pose2D var o : Odd initial i\n"
        " state A { entry move(1, 0.25) ; paint(o) }\n transition t0 { from i to A }\n"
        " transition t1 { from A to A trigger distance ? d } transition t2 { from A to A trigger at ? p } }\n");
    const Planned planned = emit_package(system, "M", draft_of(system, "M"), {}, emitting());
    EXPECT_THAT(planned.findings, Not(HasSubstr("RC-R0"))) << "no item is wrong";
    EXPECT_THAT(planned.findings, HasSubstr("std_msgs has no message for the operation 'paint'"));
}

TEST(MappingDraft, OfTheCorpusIsAccepted) {
    for (const char* const project : {"aggregation", "swarm_taxis"}) {
        const ir::System system = testing::load_corpus(project);
        const std::string name = system.modules.front().name;
        const Planned planned = emit_package(system, name, draft_of(system, name), {}, emitting());
        EXPECT_FALSE(planned.emission.files.empty()) << project << "\n" << planned.findings;
    }
}

}  // namespace
}  // namespace robochart::cpp_emit::ros2::mapping_draft_test
