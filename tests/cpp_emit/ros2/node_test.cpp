// SPDX-License-Identifier: Apache-2.0
// Tests the node of a generated package in the stub of ROS 2. The test configures and activates the node, and sends
// messages cycle by cycle. The expected messages follow from the model and the mapping.
#include <fmt/format.h>

#include "tests/cpp_emit/models.hpp"
#include "tests/cpp_emit/ros2/package.hpp"

namespace robochart::cpp_emit::ros2::node_test {
namespace {

/// One cycle calls two operations, which publish on two topics.
const char* const two_topics = R"(package order
interface Acts { go(w : nat) halt() horn() }
interface Ins { event clear event obstacle }
stm M { requires Acts uses Ins initial i
    state Driving { entry go(1) }
    state Held { entry halt(); horn() }
    transition t0 { from i to Driving }
    transition t1 { from Driving to Held trigger obstacle }
    transition t2 { from Held to Driving trigger clear } }
)";
const char* const two_topics_mapping = R"(ros2 for M {
    publish operation go as std_msgs/Int64 on "waypoint_goal" { data = w }
    publish operation halt as geometry_msgs/Twist on "cmd_vel" { }
    receive event obstacle as std_msgs/Empty on "obstacle"
    receive event clear as std_msgs/Empty on "clear"
})";

TEST_F(Package, WithoutAMappingHasTopicsOfStdMsgs) {
    emit(testing::load_corpus("swarm_taxis"), "SwarmTaxis");
    drive("SwarmTaxisFSM_node.hpp", R"(
int main() {
    swarm_taxis::SwarmTaxisFSMNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    EXPECT(network.running().size() == 1 && network.running()[0]->period == 0.1);
    network.tick();
    EXPECT(taken<std_msgs::msg::Empty>("/swarm_taxis/out/move_forward").size() == 1);
    EXPECT(taken<std_msgs::msg::String>("/swarm_taxis/state").back().data == "Forward");
    network.tick();
    EXPECT(taken<std_msgs::msg::Empty>("/swarm_taxis/out/move_forward").empty());
    EXPECT(taken<std_msgs::msg::String>("/swarm_taxis/state").empty());
    network.send("/swarm_taxis/in/illumination", std_msgs::msg::Bool{true});
    network.tick();
    EXPECT(taken<std_msgs::msg::Bool>("/swarm_taxis/variable/illuminated").back().data);
    EXPECT(taken<std_msgs::msg::Float64>("/swarm_taxis/variable/avoidance_radius").back().data == 0.2);
    for (int i = 0; i < 3; ++i) network.tick();
    network.send("/swarm_taxis/in/robot_detected", std_msgs::msg::Empty{});
    network.tick();
    EXPECT(taken<std_msgs::msg::Empty>("/swarm_taxis/out/calc_avoidance_heading").size() == 1);
    network.send("/swarm_taxis/in/heading", std_msgs::msg::Float64{0.5});
    network.tick();
    const auto turns = taken<std_msgs::msg::Float64>("/swarm_taxis/out/start_turning");
    EXPECT(turns.size() == 1 && turns[0].data == 0.5);
    return 0;
})");
}

TEST_F(Package, CarriesNumbersAndEnumerations) {
    emit(testing::load_model(testing::typed_model), "Mod");
    drive("M_node.hpp", R"(
int main() {
    p::MNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    network.tick();
    const auto went = taken<std_msgs::msg::Float64MultiArray>("/mod/out/go");
    EXPECT(went.size() == 1 && went[0].data == (std::vector<double>{0.5, 3}));
    network.send("/mod/in/see", std_msgs::msg::Int64{2});   // no light
    network.send("/mod/in/count", std_msgs::msg::Int64{-1});  // no natural number
    network.tick();
    EXPECT(taken<std_msgs::msg::Int64>("/mod/out/lamp").empty());
    network.send("/mod/in/see", std_msgs::msg::Int64{1});
    network.tick();
    EXPECT(taken<std_msgs::msg::Int64>("/mod/out/lamp").back().data == 1);
    EXPECT(taken<std_msgs::msg::Int64>("/mod/variable/level").back().data == 7);
    network.send("/mod/in/count", std_msgs::msg::Int64{4});
    network.tick();
    EXPECT(taken<std_msgs::msg::Int64>("/mod/sent/done").back().data == 4);
    EXPECT(network.running().empty());
    // It has ended: it runs again only from the beginning.
    EXPECT(node.deactivate().label() == "inactive");
    EXPECT(node.activate().label() == "inactive");
    EXPECT(node.cleanup().label() == "unconfigured");
    EXPECT(started(node));
    network.tick();
    EXPECT(taken<std_msgs::msg::Float64MultiArray>("/mod/out/go").size() == 2);  // with that of the cycle of see
    return 0;
})");
}

/// A RoboSim model: a lamp that is on for one cycle after its button was pressed, in cycles of two time units.
const char* const lamp = R"(package lamp
interface Button { event pressed }
interface Light { lit(bright : boolean) }
stm Switch {
    cycleDef cycle == 2
    input context { uses Button }
    output context { requires Light }
    initial i
    state Off { entry $lit(false) }
    state On { entry $lit(true) }
    transition t0 { from i to Off }
    transition t1 { from Off to On exec condition $pressed }
    transition t2 { from Off to Off exec condition not $pressed }
    transition t3 { from On to Off exec }
}
)";

/// Each tick of the timer runs one cycle. It reads the messages since the previous tick, and empties their registers.
TEST_F(Package, OfRoboSimRunsOneCycleAtEveryTick) {
    Options options;
    options.unit = 100'000'000;  // a time unit of 0.1 s
    emit(testing::load_model(lamp, "test.rst"), "Switch", "", {}, options);
    drive("Switch_node.hpp", R"(
int main() {
    lamp::SwitchNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    EXPECT(network.running().size() == 1 && network.running()[0]->period == 0.2);
    const auto lights = [] {
        std::string text;
        for (const auto& message : taken<std_msgs::msg::Bool>("/switch/out/lit")) text += message.data ? '1' : '0';
        return text;
    };
    network.tick();
    EXPECT(lights() == "0");
    network.send("/switch/in/pressed", std_msgs::msg::Empty{});
    network.send("/switch/in/pressed", std_msgs::msg::Empty{});
    EXPECT(lights().empty());  // a message changes nothing before the next cycle
    network.tick();
    EXPECT(lights() == "0");  // it enters Off again, then reads that the button was pressed
    network.tick();
    EXPECT(lights() == "1");
    network.tick();
    EXPECT(lights() == "0");  // the register was emptied: it does not go on again
    network.tick();
    EXPECT(lights() == "0");
    return 0;
})");
}

/// The trace hook logs inputs and outputs in the notation of docs/traces.md.
TEST_F(Package, WritesALog) {
    emit(testing::load_model(testing::typed_model), "Mod");
    drive("M_node.hpp", R"(
#include <fstream>
#include <sstream>
int main() {
    Network& network = Network::get();
    network.parameters["log"] = std::string("run.trace");
    p::MNode node;
    EXPECT(started(node));
    network.tick();
    network.send("/mod/in/see", std_msgs::msg::Int64{1});
    network.tick();
    network.send("/mod/in/count", std_msgs::msg::Int64{4});
    network.tick();
    std::ostringstream log;
    log << std::ifstream("run.trace").rdbuf();
    EXPECT(log.str() == "robochart-trace 1\ncomponent p::Mod\ncycle 1\nrun 1\ngo!0.5!3 tock\n"
                        "see?Green lamp!Green level!7 go!0.5!3 tock\ncount?4 done!4 terminate\n");
    return 0;
})",
          true);
}

/// The model has wheels, a distance, a position, constants without a value, and whole numbers.
const char* const wheeled = R"(package p
enumeration Mode { slow fast }
datatype Place { x : real y : real }
interface I { move(lv : real, av : real) stop() goal(at : Place) var level : int }
interface E { event obstacle : real event seen : Place event bump event done : nat event tell : nat }
stm M { requires I uses E const SPEED : real const LIMIT : nat const ON : boolean const MODE : Mode
    var d : real var q : Place var n : nat initial i
    state A { entry move(SPEED, 0.25) }
    state B { entry stop() }
    transition t0 { from i to A }
    transition t1 { from A to B trigger obstacle?d condition d < 0.5 }
    transition t2 { from B to A trigger bump action stop() }
    transition t3 { from B to B trigger seen?q action goal(q) ; level = LIMIT }
    transition t4 { from B to B trigger tell?n action done!n } }
controller C { requires I uses E sref m = M connection C on obstacle to m on obstacle connection C on seen to m on seen
    connection C on bump to m on bump connection C on tell to m on tell connection m on done to C on done }
robotic platform R { provides I uses E }
module Mod { rref r = R cref c = C connection r on obstacle to c on obstacle (_async)
    connection r on seen to c on seen (_async) connection r on bump to c on bump (_async)
    connection r on tell to c on tell (_async) connection c on done to r on done (_async) }
)";

const char* const wheels = R"(ros2 for Mod {
    publish operation move as geometry_msgs/Twist on "cmd_vel" { linear.x = lv  angular.z = av }
    publish operation stop as geometry_msgs/msg/Twist on "cmd_vel" { linear.y = -2 }
    publish operation goal as geometry_msgs/PoseStamped on "/goal_pose" {
        header.stamp = now header.frame_id = "a \"map\"%s"
        pose.position.x = at.x pose.position.y = at.y pose.orientation.w = 1
    }
    receive event obstacle as sensor_msgs/Range on "scan" { value = range }
    receive event seen as geometry_msgs/Point on "~/seen" with best_effort depth 1 { value.x = y value.y = x }
    publish event done as std_msgs/UInt8 on "done" with transient_local { data = value }
    publish variable level as std_msgs/Int16 on "level" { data = value }
}
)";

/// Items of a mapping have conditions. If a field of a message does not satisfy the condition, the message has no
/// effect. Comparisons with NaN are false.
TEST_F(Package, TakesMessagesUnderConditions) {
    emit(testing::load_model(two_topics), "M", R"(ros2 for M {
    receive event obstacle as sensor_msgs/Range on "range" when range < 0.3 and radiation_type == 1
    receive event clear as my_msgs/Lamp on "lamp" with depth 1 when on == true and colour != 2
    publish operation halt as std_msgs/Empty on "halt"
})");
    drive("M_node.hpp", R"(
#include <limits>
std::string state_after(float range, std::uint8_t kind) {
    sensor_msgs::msg::Range message;
    message.range = range;
    message.radiation_type = kind;
    Network::get().send("/range", message);
    Network::get().tick();
    const auto states = taken<std_msgs::msg::String>("/m/state");
    return states.empty() ? "" : states.back().data;
}
std::string state_after(const my_msgs::msg::Lamp& lamp) {
    Network::get().send("/lamp", lamp);
    Network::get().tick();
    const auto states = taken<std_msgs::msg::String>("/m/state");
    return states.empty() ? "" : states.back().data;
}
int main() {
    order::MNode node;
    EXPECT(started(node));
    Network::get().tick();
    EXPECT(taken<std_msgs::msg::String>("/m/state").back().data == "Driving");
    EXPECT(state_after(0.3F, 1).empty());  // not less than the float32 of 0.3
    EXPECT(state_after(0.29F, 0).empty());
    EXPECT(state_after(std::numeric_limits<float>::quiet_NaN(), 1).empty());
    EXPECT(state_after(0.29F, 1) == "Held");
    EXPECT(state_after(my_msgs::msg::Lamp{2, true}).empty());
    EXPECT(state_after(my_msgs::msg::Lamp{1, false}).empty());
    EXPECT(state_after(my_msgs::msg::Lamp{1, true}) == "Driving");
    return 0;
})");
}

/// When a topic falls silent, an event is raised once. Every message ends the silence, even one without effect. The
/// stop command is published when an active node is deactivated or shut down, when the program ends, and when the
/// controller ends.
TEST_F(Package, KnowsWhenATopicIsSilentAndStopsTheRobot) {
    emit(testing::load_model(R"(package p
interface Acts { go() horn() }
interface Ins { event near event lost event quit }
stm M { requires Acts uses Ins initial i
    state A { entry go() } final f
    transition t0 { from i to A }
    transition t1 { from A to A trigger lost action horn() }
    transition t2 { from A to f trigger quit } transition t3 { from A to A trigger near } }
)"),
         "M", R"(ros2 for M {
    publish operation go as geometry_msgs/Twist on "cmd_vel" with best_effort { linear.x = 1 }
    receive event near as sensor_msgs/Range on "range" when range < 0.3
    receive event lost as deadline 0.5 on "range"
    on deactivate publish geometry_msgs/Twist on "cmd_vel" { linear.x = 0 angular.z = 0.5 }
    on deactivate publish std_msgs/Bool on "brake" { data = true }
})");
    drive("M_node.hpp", R"(
using geometry_msgs::msg::Twist;
/// One stop command for each topic.
bool stopped() {
    const auto twists = taken<Twist>("/cmd_vel");
    const auto brakes = taken<std_msgs::msg::Bool>("/brake");
    return twists.size() == 1 && twists[0].linear.x == 0 && twists[0].angular.z == 0.5 && brakes.size() == 1 &&
           brakes[0].data;
}
std::size_t horns() {
    Network::get().tick();
    taken<Twist>("/cmd_vel");
    return taken<std_msgs::msg::Empty>("/m/out/horn").size();
}
int main() {
    Network& network = Network::get();
    {
        p::MNode node;
        EXPECT(node.configure().label() == "inactive");
        EXPECT(network.quality["/cmd_vel"] == "best_effort, volatile, 10");
        network.shut_down();
        EXPECT(taken<Twist>("/cmd_vel").empty());  // it is not active
        EXPECT(node.activate().label() == "active");
        EXPECT(horns() == 0);
        network.nanoseconds += 400'000'000;
        EXPECT(horns() == 0);
        network.send("/range", sensor_msgs::msg::Range{});
        network.nanoseconds += 400'000'000;
        EXPECT(horns() == 0);
        network.nanoseconds += 100'000'000;
        EXPECT(horns() == 1);
        network.nanoseconds += 900'000'000;
        EXPECT(horns() == 0);  // once
        EXPECT(node.deactivate().label() == "inactive" && stopped());
        network.nanoseconds += 900'000'000;
        EXPECT(node.activate().label() == "active" && horns() == 0);  // the pause does not count
        network.nanoseconds += 500'000'000;
        EXPECT(horns() == 1);
        network.shut_down();
        EXPECT(stopped());
        EXPECT(node.shutdown().label() == "finalized" && stopped());
    }
    EXPECT(network.pre_shutdown.empty());
    network.order.clear();
    p::MNode node;
    EXPECT(started(node));
    (void)horns();
    network.send("/m/in/quit", std_msgs::msg::Empty{});
    network.tick();
    EXPECT(stopped() && network.running().empty());
    return 0;
})");
}

/// An operation calls a service, whose answer raises an event. If there is no service or no answer, another event is
/// raised once after the given time.
TEST_F(Package, CallsServices) {
    emit(testing::load_model(R"(package p
interface Acts { dock(fast : boolean) }
interface Ins { event docked event failed event lost event again }
stm M { requires Acts uses Ins initial i
    state Docking { entry dock(true) } state Docked { } state Failed { } state Lost { }
    transition t0 { from i to Docking }
    transition t1 { from Docking to Docked trigger docked } transition t2 { from Docking to Failed trigger failed }
    transition t3 { from Docking to Lost trigger lost }
    transition t4 { from Docked to Docking trigger again } transition t5 { from Failed to Docking trigger again }
    transition t6 { from Lost to Docking trigger again } }
)"),
         "M", R"(ros2 for M {
    call operation dock as std_srvs/SetBool on "dock" { data = fast }
    receive event docked as answer of dock when success == true
    receive event failed as answer of dock when success == false
    receive event lost as deadline 5 of dock
    receive event again as std_msgs/Empty on "again"
})");
    drive("M_node.hpp", R"(
using std_srvs::srv::SetBool;
std::string state() {
    Network::get().tick();
    const auto states = taken<std_msgs::msg::String>("/m/state");
    return states.empty() ? "" : states.back().data;
}
void wait_for(std::int64_t seconds) { Network::get().nanoseconds += seconds * 1'000'000'000; }
/// Answers the only request; false if it is not the expected one.
bool answered(bool success) {
    auto& requests = Network::get().requests["/dock"];
    if (requests.size() != 1 || !std::any_cast<const SetBool::Request&>(requests[0].first).data) return false;
    const auto answer = requests[0].second;
    requests.clear();
    answer(std::any(SetBool::Response{success, ""}));
    return true;
}
int main() {
    Network& network = Network::get();
    p::MNode node;
    EXPECT(started(node));
    EXPECT(state() == "Docking");
    EXPECT(logged("/dock: no service, not called") && network.requests["/dock"].empty());
    wait_for(4);
    EXPECT(state().empty());
    wait_for(1);
    EXPECT(state() == "Lost");
    network.servers.insert("/dock");
    network.send("/again", std_msgs::msg::Empty{});
    EXPECT(state() == "Docking");
    wait_for(4);
    EXPECT(answered(true) && state() == "Docked");
    wait_for(9);
    EXPECT(state().empty());  // it has been answered
    network.send("/again", std_msgs::msg::Empty{});
    EXPECT(state() == "Docking" && answered(false) && state() == "Failed");
    // An answer during a pause raises no event, and the time does not go on.
    network.send("/again", std_msgs::msg::Empty{});
    EXPECT(state() == "Docking");
    EXPECT(node.deactivate().label() == "inactive" && answered(true));
    wait_for(9);
    EXPECT(node.activate().label() == "active" && state().empty());
    return 0;
})");
}

/// Operations send and cancel a goal of an action. Its replies raise events in the same order, for any behaviour of the
/// server.
TEST_F(Package, CallsActions) {
    emit(testing::load_model(R"(package p
datatype Goal { x : real y : real }
interface Acts { goTo(at : Goal) stop() note(left : real) }
interface Ins { event go : real event halt event taken event refused event left : real event arrived event failed
    event stopped event lost }
stm M { requires Acts uses Ins var g : Goal var d : real initial i
    state Idle { } state Asked { } state Driving { } state Arrived { } state Failed { } state Stopped { } state Lost { }
    transition t0 { from i to Idle }
    transition t1 { from Idle to Asked trigger go?d action g.x = d ; goTo(g) }
    transition t2 { from Asked to Driving trigger taken } transition t3 { from Asked to Failed trigger refused }
    transition t4 { from Driving to Driving trigger left?d action note(d) }
    transition t5 { from Driving to Arrived trigger arrived } transition t6 { from Driving to Failed trigger failed }
    transition t7 { from Driving to Stopped trigger stopped }
    transition t8 { from Driving to Driving trigger halt action stop() }
    transition h { from Asked to Asked trigger halt action stop() }
    transition t9 { from Asked to Lost trigger lost } transition l { from Driving to Lost trigger lost }
    transition a { from Arrived to Asked trigger go?d action g.x = d ; goTo(g) }
    transition b { from Failed to Asked trigger go?d action g.x = d ; goTo(g) }
    transition c { from Stopped to Asked trigger go?d action g.x = d ; goTo(g) }
    transition d { from Lost to Asked trigger go?d action g.x = d ; goTo(g) }
    transition e { from Driving to Asked trigger go?d action g.x = d ; goTo(g) } }
)"),
         "M", R"(ros2 for M {
    call operation goTo as action nav2_msgs/NavigateToPose on "navigate_to_pose" {
        pose.header.stamp = now pose.header.frame_id = "map" pose.pose.position.x = at.x pose.pose.position.y = at.y }
    call operation stop as cancel of goTo
    receive event taken as accepted of goTo
    receive event refused as rejected of goTo
    receive event left as feedback of goTo when number_of_recoveries < 3 { value = distance_remaining }
    receive event arrived as succeeded of goTo
    receive event failed as aborted of goTo when error_code == 0
    receive event stopped as canceled of goTo
    receive event lost as deadline 60 of goTo
    receive event go as std_msgs/Float64 on "go" { value = data }
    receive event halt as std_msgs/Empty on "halt"
})");
    folder_.run(
        "grep -q '<depend>rclcpp_action</depend>' package.xml && grep -q '<depend>nav2_msgs</depend>' package.xml");
    drive("M_node.hpp", R"(
using nav2_msgs::action::NavigateToPose;
using rclcpp_action::ResultCode;
using Client = rclcpp_action::Client<NavigateToPose>;
std::string state() {
    Network::get().tick();
    const auto states = taken<std_msgs::msg::String>("/m/state");
    return states.empty() ? "" : states.back().data;
}
std::string go(double x) {
    Network::get().send("/go", std_msgs::msg::Float64{x});
    return state();
}
void wait_for(std::int64_t seconds) { Network::get().nanoseconds += seconds * 1'000'000'000; }
NavigateToPose::Feedback distance(float left, std::int16_t recoveries = 0) {
    NavigateToPose::Feedback feedback;
    feedback.distance_remaining = left;
    feedback.number_of_recoveries = recoveries;
    return feedback;
}
int main() {
    Network& network = Network::get();
    auto& goals = Client::goals()["/navigate_to_pose"];
    p::MNode node;
    EXPECT(started(node));
    EXPECT(state() == "Idle");
    // Without a server, only the deadline raises an event.
    EXPECT(go(1) == "Asked" && goals.empty() && logged("navigate_to_pose: no action server, not called"));
    wait_for(60);
    EXPECT(state() == "Lost");
    network.servers.insert("/navigate_to_pose");
    network.seconds = 7;
    EXPECT(go(2.5) == "Asked" && goals.size() == 1);
    EXPECT(goals[0].goal.pose.pose.position.x == 2.5 && goals[0].goal.pose.header.frame_id == "map");
    // Replies before the goal has been accepted are dropped.
    goals[0].feed(distance(9));
    goals[0].end(ResultCode::SUCCEEDED);
    EXPECT(state().empty());
    goals[0].accept();
    EXPECT(state() == "Driving");
    goals[0].feed(distance(1.5));
    EXPECT(state().empty() && taken<std_msgs::msg::Float64>("/m/out/note").back().data == 1.5);
    goals[0].feed(distance(1.0, 3));
    EXPECT(state().empty() && taken<std_msgs::msg::Float64>("/m/out/note").empty());
    goals[0].end(ResultCode::SUCCEEDED);
    EXPECT(state() == "Arrived");
    wait_for(90);
    EXPECT(state().empty());  // the deadline has ended
    // A rejection.
    EXPECT(go(3) == "Asked" && goals.size() == 2);
    goals[1].reject();
    EXPECT(state() == "Failed");
    // A cancellation before the server has accepted the goal waits until then.
    EXPECT(go(4) == "Asked");
    network.send("/halt", std_msgs::msg::Empty{});
    EXPECT(state().empty() && !goals[2].handle->canceled);
    goals[2].accept();
    EXPECT(goals[2].handle->canceled && state() == "Driving");
    goals[2].end(ResultCode::CANCELED);
    goals[2].feed(distance(9));  // late
    EXPECT(state() == "Stopped" && taken<std_msgs::msg::Float64>("/m/out/note").empty());
    // A later goal replaces the earlier one, whose result raises no event.
    EXPECT(go(5) == "Asked");
    goals[3].accept();
    EXPECT(state() == "Driving" && go(6) == "Asked");
    goals[3].end(ResultCode::ABORTED);
    EXPECT(state().empty());
    goals[4].accept();
    EXPECT(state() == "Driving");
    network.send("/halt", std_msgs::msg::Empty{});
    EXPECT(state().empty() && goals[4].handle->canceled && !goals[3].handle->canceled);
    goals[4].end(ResultCode::ABORTED);
    EXPECT(state() == "Failed");
    // A pause cancels the goal, and its result raises no event.
    EXPECT(go(7) == "Asked");
    goals[5].accept();
    EXPECT(state() == "Driving" && node.deactivate().label() == "inactive" && goals[5].handle->canceled);
    goals[5].end(ResultCode::CANCELED);
    EXPECT(node.activate().label() == "active" && state().empty());
    // After cleanup, nothing is left of the goals.
    EXPECT(node.deactivate().label() == "inactive" && node.cleanup().label() == "unconfigured");
    goals[5].accept();
    return 0;
})");
}

/// A list is received completely or not at all. If a message has more items than the capacity, or an item that is not a
/// value of the model, it is logged and raises no event. The controller continues.
TEST_F(Package, RefusesArraysThatDoNotFit) {
    emit(testing::load_model("package p import sequence_toolkit::*\n"
                             "stm M { event scan : Seq(real) event seen : nat var s : Seq(real) initial i\n"
                             "state A { } transition t0 { from i to A }\n"
                             "transition t1 { from A to A trigger scan?s action seen!(size(s)) } }"),
         "M",
         "ros2 for M { receive event scan as sensor_msgs/LaserScan on \"scan\" { value = ranges capacity 3 }\n"
         "publish event seen as std_msgs/Int64 on \"seen\" { data = value } }");
    drive("M_node.hpp", R"(
#include <limits>
sensor_msgs::msg::LaserScan scan_of(std::vector<float> ranges) {
    sensor_msgs::msg::LaserScan scan;
    scan.ranges = ranges;
    return scan;
}
std::int64_t seen(const sensor_msgs::msg::LaserScan& scan) {
    Network::get().send("/scan", scan);
    Network::get().tick();
    const auto all = taken<std_msgs::msg::Int64>("/seen");
    return all.empty() ? -1 : all.back().data;
}
int main() {
    p::MNode node;
    EXPECT(started(node));
    EXPECT(seen(scan_of({0.5F, 1.5F, 2})) == 3);
    EXPECT(seen(scan_of({})) == 0);
    EXPECT(Network::get().log.empty());
    EXPECT(seen(scan_of({0.5F, 1.5F, 2, 3})) == -1);
    EXPECT(logged("a message for scan is refused: ranges has 4 items, and the capacity is 3"));
    EXPECT(seen(scan_of({0.5F, std::numeric_limits<float>::infinity()})) == -1);
    EXPECT(logged("a message for scan has no value of Seq"));
    EXPECT(seen(scan_of({0.5F})) == 1);
    EXPECT(!Network::get().running().empty());
    return 0;
})");
}

ir::InstantiationOptions chosen_constants() {
    ir::InstantiationOptions options;
    options.constants = {{"SPEED", "1.5"}, {"LIMIT", "7"}};
    return options;
}

/// In one cycle the model calls halt, horn and go(1), so their messages are published in this order. An operation that
/// the user has written begins when the messages of earlier calls have been published. An exception of a publisher does
/// not end the program.
TEST_F(Package, PublishesInTheOrderOfTheCalls) {
    emit(testing::load_model(two_topics), "M", two_topics_mapping);
    drive("M_node.hpp", R"(
class Robot : public order::MMessages {
public:
    void horn() override { before = Network::get().order; }
    std::vector<std::string> before;
};
void both() {
    Network& network = Network::get();
    network.order.clear();
    network.send("/clear", std_msgs::msg::Empty{});
    network.send("/obstacle", std_msgs::msg::Empty{});
    network.tick();
}
int main() {
    using Topics = std::vector<std::string>;
    Network& network = Network::get();
    auto robot = std::make_unique<Robot>();
    Robot& mine = *robot;
    {
        order::MNode node(rclcpp::NodeOptions(), std::move(robot));
        EXPECT(started(node));
        network.tick();
        EXPECT(network.order == (Topics{"/waypoint_goal", "/m/state"}));
        both();
        EXPECT(mine.before == Topics{"/cmd_vel"});
        EXPECT(network.order == (Topics{"/cmd_vel", "/waypoint_goal"}));
    }
    order::MNode node;
    EXPECT(started(node));
    network.tick();
    network.log.clear();
    network.broken.insert("/cmd_vel");
    both();
    EXPECT(network.order == (Topics{"/m/out/horn", "/waypoint_goal"}));
    EXPECT(logged("/cmd_vel: not published: the publisher is broken"));
    return 0;
})");
}

/// A variable keeps its value, so the node receives it whenever it is configured. It receives events only while it is
/// active.
TEST_F(Package, TakesVariablesWheneverItIsConfigured) {
    emit(testing::load_model(R"(package latch
interface Acts { drive(v : real) }
interface Sh { var limit : real = 0 }
interface Ins { event tick }
stm M { requires Acts requires Sh uses Ins initial i state S { entry drive(limit) }
    transition t0 { from i to S } transition t1 { from S to S trigger tick } }
)"),
         "M", R"(ros2 for M {
    publish operation drive as std_msgs/Float64 on "drive" { data = v }
    receive variable limit as std_msgs/Float64 on "limit" with transient_local { value = data }
    receive event tick as std_msgs/Float64 on "limit" with transient_local
})");
    drive("M_node.hpp", R"(
int main() {
    using Number = std_msgs::msg::Float64;
    latch::MNode node;
    Network& network = Network::get();
    EXPECT(node.configure().label() == "inactive");
    network.send("/limit", Number{0.5});
    EXPECT(node.activate().label() == "active");
    network.tick();
    auto driven = taken<Number>("/drive");
    EXPECT(driven.size() == 1 && driven[0].data == 0.5);
    EXPECT(node.deactivate().label() == "inactive");
    network.send("/limit", Number{0.25});
    EXPECT(node.activate().label() == "active");
    network.tick();
    EXPECT(taken<Number>("/drive").empty());  // no event tick
    network.send("/limit", Number{0.125});
    network.tick();
    driven = taken<Number>("/drive");
    EXPECT(driven.size() == 1 && driven[0].data == 0.125);
    // Cleaned up, it forgets the value.
    EXPECT(node.deactivate().label() == "inactive" && node.cleanup().label() == "unconfigured" && started(node));
    network.tick();
    driven = taken<Number>("/drive");
    EXPECT(driven.size() == 1 && driven[0].data == 0);
    return 0;
})");
}

/// The log contains the constants of the generated code. It has comments about what is no event of the model: messages
/// that were not published, cycles that were lost, pauses. A configuration without cycles has no run.
TEST_F(Package, LogsWhatTheModelDoesNotKnow) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    drive("M_node.hpp", R"(
#include <fstream>
#include <sstream>
std::string text_of(const char* file) {
    std::ostringstream log;
    log << std::ifstream(file).rdbuf();
    return log.str();
}
int main() {
    Network& network = Network::get();
    network.parameters["log"] = std::string("run.trace");
    p::MNode node;
    EXPECT(started(node));
    network.tick();
    sensor_msgs::msg::Range range;
    range.range = 0.25F;
    network.send("/scan", range);
    network.nanoseconds += 140'000'000;  // not one and a half cycles
    network.tick();
    EXPECT(network.log.empty());
    network.send("/mod/in/tell", std_msgs::msg::Int64{256});
    network.nanoseconds += 1'000'000'000;
    network.tick();
    EXPECT(logged("9 control cycles are lost"));
    EXPECT(node.deactivate().label() == "inactive");
    network.nanoseconds += 2'500'000'000;
    EXPECT(node.activate().label() == "active");
    network.tick();
    EXPECT(node.deactivate().label() == "inactive" && node.cleanup().label() == "unconfigured");
    EXPECT(started(node));
    EXPECT(node.shutdown().label() == "finalized");
    EXPECT(network.log.empty());
    EXPECT(text_of("run.trace") ==
           "robochart-trace 1\ncomponent p::Mod\ncycle 1\n"
           "const p::C::m::LIMIT=7\nconst p::C::m::MODE=slow\nconst p::C::m::ON=true\nconst p::C::m::SPEED=1.5\n"
           "run 1\nmove!1.5!0.25 tock\nobstacle?0.25 stop! tock\n"
           "// lost cycles: 9\ntell?256 done!256 stop! tock\n// not published, unfit: done\n"
           "// pause of 2.500000 s\ntock\n");
    return 0;
})",
          true);
}

/// With immediate dispatch, a separate cycle reads each message at once, and the timer goes on. A message that
/// raises no event begins no cycle while the node is inactive.
TEST_F(Package, RunsACycleWhenAnInputArrives) {
    Options options;
    options.dispatch = Dispatch::immediate;
    emit(testing::load_model(two_topics), "M", two_topics_mapping, {}, options);
    drive("M_node.hpp", R"(
#include <fstream>
#include <sstream>
int main() {
    Network& network = Network::get();
    network.parameters["log"] = std::string("run.trace");
    order::MNode node;
    EXPECT(started(node));
    network.send("/obstacle", std_msgs::msg::Empty{});  // the first cycle enters Driving and takes the event
    EXPECT(taken<std_msgs::msg::Int64>("/waypoint_goal").size() == 1);
    EXPECT(taken<geometry_msgs::msg::Twist>("/cmd_vel").size() == 1);
    network.nanoseconds += 1'000'000;
    network.send("/clear", std_msgs::msg::Empty{});
    network.send("/obstacle", std_msgs::msg::Empty{});
    EXPECT(taken<std_msgs::msg::Int64>("/waypoint_goal").size() == 1);
    EXPECT(taken<geometry_msgs::msg::Twist>("/cmd_vel").size() == 1);
    network.tick();
    EXPECT(taken<std_msgs::msg::Int64>("/waypoint_goal").empty());
    EXPECT(node.deactivate().label() == "inactive");
    network.send("/clear", std_msgs::msg::Empty{});
    EXPECT(taken<std_msgs::msg::Int64>("/waypoint_goal").empty());
    std::ostringstream log;
    log << std::ifstream("run.trace").rdbuf();
    EXPECT(log.str() == "robochart-trace 1\ncomponent order::M\ncycle 1\n"
                        "// immediate dispatch: cycles have different lengths\n"
                        "run 1\nobstacle? go!1 halt! horn! tock\nclear? go!1 tock\nobstacle? halt! horn! tock\ntock\n");
    return 0;
})",
          true);
}

/// A component that counts time needs cycles of the same length. The finding names the first element that counts time.
TEST_F(Package, WithTimeHasNoImmediateDispatch) {
    Options options;
    options.dispatch = Dispatch::immediate;
    const auto findings = [&](const std::string& machine) {
        const std::string model = "package p\ninterface E { event e event out : nat }\n" + machine;
        return emit_package(testing::load_model(model), "M", "", {}, options).findings;
    };
    const auto contains = [](const std::string& text, const std::string& part) {
        return text.find(part) != std::string::npos ? ::testing::AssertionSuccess()
                                                    : ::testing::AssertionFailure() << part << " is not in " << text;
    };
    const std::string head =
        "stm M { uses E clock T initial i state A { } state B { }\ntransition t0 { from i to A }\n";
    EXPECT_TRUE(contains(findings(head + "transition t1 { from A to B trigger e action #T } }"), "RC-R14"));
    for (const auto& [transition, text] : std::vector<std::pair<std::string, std::string>>{
             {"transition t1 { from A to B condition since(T) >= 2 } }", "RC-R13 --dispatch"},
             {"transition t1 { from A to B condition since(T) >= 2 } }",
              "--dispatch immediate needs a model that counts no time, but 'M' reads a clock"},
             {"transition t1 { from A to B condition sinceEntry(A) >= 2 } }", "'M' reads a clock"},
             {"transition t1 { from A to B trigger e action wait(1) } }", "'M' waits"},
             {"transition t1 { from A to B trigger e action wait([1, 2]) } }", "'M' waits"},
             {"transition t1 { from A to B trigger e <{ 2 } } }", "'M' has a deadline"}})
        EXPECT_TRUE(contains(findings(head + transition), text)) << transition;
    EXPECT_TRUE(contains(emit_package(testing::load_model(lamp, "test.rst"), "Switch", "", {}, options).findings,
                         "is written in RoboSim"));
}

/// If the log cannot be written, or if the build has no trace hook, the node is not configured.
TEST_F(Package, IsNotConfiguredWithoutItsLog) {
    emit(testing::load_model(two_topics), "M", two_topics_mapping);
    for (const bool traced : {true, false})
        drive("M_node.hpp", R"(
int main() {
    Network& network = Network::get();
    network.parameters["log"] = std::string("no/such/folder/run.trace");
    order::MNode node;
    EXPECT(node.configure().label() == "unconfigured");
    EXPECT(logged("parameter log: "));
    return 0;
})",
              traced);
}

TEST_F(Package, PublishesAndReceivesWhatTheMappingSays) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    drive("M_node.hpp", R"(
#include <limits>
int main() {
    using Twist = geometry_msgs::msg::Twist;
    p::MNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    network.tick();
    auto twists = taken<Twist>("/cmd_vel");
    EXPECT(twists.size() == 1 && twists[0].linear.x == 1.5 && twists[0].linear.y == 0 && twists[0].angular.z == 0.25);
    sensor_msgs::msg::Range range;
    range.range = std::numeric_limits<float>::infinity();  // nothing is in sight: no number of the model
    network.send("/scan", range);
    range.range = std::numeric_limits<float>::quiet_NaN();
    network.send("/scan", range);
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").empty());
    range.range = 0.75F;
    network.send("/scan", range);
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").empty());
    range.range = 0.25F;
    network.send("/scan", range);
    network.tick();
    twists = taken<Twist>("/cmd_vel");
    EXPECT(twists.size() == 1 && twists[0].linear.y == -2 && twists[0].linear.x == 0);
    // Two operations of one cycle on one topic: in the order in which the model calls them.
    network.send("/mod/in/bump", std_msgs::msg::Empty{});
    network.tick();
    twists = taken<Twist>("/cmd_vel");
    EXPECT(twists.size() == 2 && twists[0].linear.y == -2 && twists[1].linear.x == 1.5);
    network.send("/scan", range);
    network.tick();
    // A record by its fields, the time of the cycle, a text.
    network.seconds = 42;
    geometry_msgs::msg::Point point;
    point.x = 3;
    point.y = 4;
    network.send("/mod/seen", point);
    network.tick();
    const auto goals = taken<geometry_msgs::msg::PoseStamped>("/goal_pose");
    EXPECT(goals.size() == 1 && goals[0].pose.position.x == 4 && goals[0].pose.position.y == 3);
    EXPECT(goals[0].header.stamp.sec == 42 && goals[0].header.frame_id == "a \\\"map\\\"%s");
    EXPECT(goals[0].pose.orientation.w == 1);
    EXPECT(taken<std_msgs::msg::Int16>("/level").back().data == 7);
    // What the field cannot hold is not published, and not cut off.
    network.log.clear();
    network.send("/mod/in/tell", std_msgs::msg::Int64{256});
    network.tick();
    EXPECT(taken<std_msgs::msg::UInt8>("/done").empty() && logged("done has a value that its message cannot hold"));
    network.send("/mod/in/tell", std_msgs::msg::Int64{255});
    network.tick();
    EXPECT(taken<std_msgs::msg::UInt8>("/done").back().data == 255);
    return 0;
})");
}

TEST_F(Package, HasAQualityOfServiceForEachKind) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    drive("M_node.hpp", R"(
int main() {
    p::MNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    EXPECT(network.quality["/cmd_vel"] == "reliable, volatile, 10");
    EXPECT(network.quality["/level"] == "reliable, transient_local, 1");
    EXPECT(network.quality["/mod/state"] == "reliable, transient_local, 1");
    EXPECT(network.quality["/scan"] == "best_effort, volatile, 5");
    EXPECT(network.quality["/mod/in/bump"] == "reliable, volatile, 10");
    EXPECT(network.quality["/mod/seen"] == "best_effort, volatile, 1");
    EXPECT(network.quality["/done"] == "reliable, transient_local, 10");
    EXPECT(network.quality["/diagnostics"] == "reliable, volatile, 10");  // which no parameter changes
    EXPECT(network.policies.size() + 1 == network.quality.size());
    for (const auto& [topic, policies] : network.policies) EXPECT(policies == 4);
    // Parameters override the quality of service, also when the node is configured a second time.
    network.parameters["qos_overrides./cmd_vel.publisher.depth"] = std::int64_t{3};
    network.parameters["qos_overrides./scan.subscription.depth"] = std::int64_t{1};
    p::MNode other;
    for (int times = 0; times < 2; ++times) {
        EXPECT(started(other));
        EXPECT(network.quality["/cmd_vel"] == "reliable, volatile, 3");
        EXPECT(network.quality["/scan"] == "best_effort, volatile, 1");
        EXPECT(other.deactivate().label() == "inactive" && other.cleanup().label() == "unconfigured");
    }
    return 0;
})");
}

TEST_F(Package, RunsCyclesWhileItIsActive) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    drive("M_node.hpp", R"(
int main() {
    using Twist = geometry_msgs::msg::Twist;
    Network& network = Network::get();
    network.parameters["cycle"] = 0.02;
    p::MNode node;
    network.tick();
    EXPECT(network.quality.empty());
    EXPECT(node.activate().label() == "unconfigured");
    EXPECT(node.configure().label() == "inactive");
    sensor_msgs::msg::Range near;
    near.range = 0.25F;
    network.send("/scan", near);  // not taken
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").empty() && taken<std_msgs::msg::String>("/mod/state").empty());
    EXPECT(node.activate().label() == "active");
    EXPECT(network.running().size() == 1 && network.running()[0]->period == 0.02);
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").size() == 1 && taken<std_msgs::msg::String>("/mod/state").back().data == "A");
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").empty());
    // A message that no cycle has seen is forgotten, and those that come meanwhile too; the state stays.
    network.send("/scan", near);
    EXPECT(node.deactivate().label() == "inactive" && network.running().empty());
    network.send("/scan", near);
    network.tick();
    EXPECT(node.activate().label() == "active");
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").empty() && taken<std_msgs::msg::String>("/mod/state").empty());
    network.send("/scan", near);
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").size() == 1 && taken<std_msgs::msg::String>("/mod/state").back().data == "B");
    // Cleaned up and configured, it begins anew.
    EXPECT(node.deactivate().label() == "inactive" && node.cleanup().label() == "unconfigured");
    EXPECT(network.listeners["/scan"].empty());
    EXPECT(started(node));
    network.tick();
    EXPECT(taken<Twist>("/cmd_vel").back().linear.x == 1.5);
    EXPECT(taken<std_msgs::msg::String>("/mod/state").back().data == "A");
    EXPECT(node.shutdown().label() == "finalized" && network.running().empty());
    for (const std::string& line : network.log)  // of each configuration
        EXPECT(line.find("a time unit of the model lasts 0.02 s") != std::string::npos);
    return 0;
})");
}

/// The parameter `cycle` changes all clocks and timeouts, so a value other than that of the time unit is refused.
TEST_F(Package, KeepsTheDeclaredTimeUnit) {
    Options options;
    options.cycle_length = 2;
    options.unit = 10'000'000;
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants(), options);
    drive("M_node.hpp", R"(
int main() {
    Network& network = Network::get();
    {
        p::MNode node;
        EXPECT(started(node));
        EXPECT(network.running().size() == 1 && network.running()[0]->period == 0.02);
        EXPECT(network.declared.at("cycle_scale").read_only);
    }
    for (const std::any& other : {std::any(0.1), std::any(0.0201)}) {
        network.parameters = {{"cycle", other}};
        p::MNode node;
        EXPECT(node.configure().label() == "unconfigured");
        EXPECT(logged("parameter cycle: a cycle is 2 time units of the model (20 ms"));
}
network.parameters = {{"cycle", 0.1}, {"cycle_scale", std::int64_t{5}}};
{
    p::MNode node;
    EXPECT(started(node));
    EXPECT(network.running().size() == 1 && network.running()[0]->period == 0.1);
    EXPECT(logged("5 times as long as declared"));
}
network.parameters = {{"cycle_scale", std::int64_t{5}}};
p::MNode node;
EXPECT(node.configure().label() == "unconfigured");
return 0;
}
)");
}

TEST_F(Package, SaysHowLongATimeUnitIs) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    drive("M_node.hpp", R"(
int main() {
    Network& network = Network::get();
    {
        p::MNode node;
        EXPECT(started(node));
        EXPECT(network.log.empty());
    }
    network.parameters = {{"cycle", 0.02}};
    p::MNode node;
    EXPECT(started(node));
    EXPECT(logged("a time unit of the model lasts 0.02 s, so its clocks and timeouts are 0.2 times as long"));
    return 0;
}
)");
}

TEST_F(Package, RefusesConstantsThatItWasNotGeneratedFor) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    drive("M_node.hpp", R"(
int main() {
    Network& network = Network::get();
    {
        network.parameters = {{"constants.SPEED", 1.5}, {"constants.MODE", std::string("slow")}};
        p::MNode node;
        EXPECT(started(node));
        for (const char* name : {"cycle", "log", "constants.SPEED", "constants.LIMIT", "constants.ON", "constants.MODE"})
            EXPECT(network.declared.at(name).read_only && !network.declared.at(name).description.empty());
        EXPECT(network.declared.size() == 6);
        EXPECT(network.declared["constants.LIMIT"].description.find("p::C::m::LIMIT") != std::string::npos);
    }
    for (const auto& [name, value] : std::map<std::string, std::any>{{"constants.SPEED", 1.0},
                                                                     {"constants.LIMIT", std::int64_t{8}},
                                                                     {"constants.ON", false},
                                                                     {"constants.MODE", std::string("fast")}}) {
        network.parameters = {{name, value}};
        p::MNode node;
        EXPECT(node.configure().label() == "unconfigured");
        EXPECT(logged(name));
    }
    network.parameters = {{"cycle", 0.0}};
    try {
        p::MNode node;
        return __LINE__;
    } catch (const std::invalid_argument&) {
    }
    // A whole number in a file of parameters is a number, too; a text is not.
    network.parameters = {{"cycle", std::int64_t{2}}};
    {
        p::MNode node;
        EXPECT(started(node));
        EXPECT(network.running().size() == 1 && network.running()[0]->period == 2.0);
    }
    for (const std::any& wrong : {std::any(std::int64_t{0}), std::any(std::int64_t{3601}), std::any(std::string("1"))}) {
        network.parameters = {{"cycle", wrong}};
        p::MNode node;
        EXPECT(node.configure().label() == "unconfigured");
        EXPECT(logged("parameter cycle: "));
    }
    network.parameters = {{"constants.SPEED", std::int64_t{1}}};
    {
        p::MNode node;
        EXPECT(node.configure().label() == "unconfigured");
        EXPECT(logged("constants.SPEED"));
    }
    return 0;
})");
}

/// A mapping gives the parameter of a constant another name.
TEST_F(Package, HasParametersOfTheMapping) {
    emit(testing::load_model(wheeled), "Mod",
         std::string(wheels).replace(std::string(wheels).rfind('}'), 1,
                                     "parameter SPEED as \"limits.max_speed\" parameter p::C::m::ON as \"enabled\" }"),
         chosen_constants());
    drive("M_node.hpp", R"(
int main() {
    Network& network = Network::get();
    {
        p::MNode node;
        EXPECT(started(node));
        for (const char* name : {"limits.max_speed", "enabled", "constants.LIMIT", "constants.MODE"})
            EXPECT(network.declared.count(name) == 1);
        EXPECT(network.declared.size() == 6 && network.declared.count("constants.SPEED") == 0);
    }
    network.parameters = {{"limits.max_speed", 1.0}};
    p::MNode node;
    EXPECT(node.configure().label() == "unconfigured" && logged("limits.max_speed"));
    return 0;
})");
    folder_.run("grep -q '^    # limits.max_speed: 1.5$' config/mod.yaml");
}

/// The node reports on /diagnostics once per second, when cycles are lost, and when the controller stops.
TEST_F(Package, ReportsItsHealth) {
    emit(testing::load_model(testing::typed_model), "Mod");
    drive("M_node.hpp", R"(
using diagnostic_msgs::msg::DiagnosticArray;
using diagnostic_msgs::msg::DiagnosticStatus;
/// The only report since the last call; an empty status without one.
DiagnosticStatus report() {
    const auto reports = taken<DiagnosticArray>("/diagnostics");
    return reports.size() == 1 && reports[0].status.size() == 1 ? reports[0].status[0] : DiagnosticStatus{};
}
std::string value_of(const DiagnosticStatus& status, const std::string& key) {
    for (const auto& fact : status.values)
        if (fact.key == key) return fact.value;
    return "";
}
void wait_for(std::int64_t milliseconds) { Network::get().nanoseconds += milliseconds * 1'000'000; }
int main() {
    Network& network = Network::get();
    p::MNode node;
    EXPECT(node.configure().label() == "inactive" && report().name.empty());
    EXPECT(node.activate().label() == "active");
    network.tick();
    DiagnosticStatus status = report();
    EXPECT(status.level == DiagnosticStatus::OK && status.name == "mod: controller" && status.message == "active");
    EXPECT(value_of(status, "state") == "A" && value_of(status, "cycles") == "1");
    EXPECT(value_of(status, "lost cycles") == "0");
    for (int i = 0; i < 9; ++i) wait_for(100), network.tick();
    EXPECT(network.published["/diagnostics"].empty());
    wait_for(100);
    network.tick();
    EXPECT(value_of(report(), "cycles") == "11");
    wait_for(500);
    network.tick();
    EXPECT(network.published["/diagnostics"].empty());
    wait_for(500);
    network.tick();
    status = report();
    EXPECT(status.level == DiagnosticStatus::WARN && status.message == "lost control cycles");
    EXPECT(value_of(status, "cycles") == "13" && value_of(status, "lost cycles") == "8");
    for (int i = 0; i < 10; ++i) wait_for(100), network.tick();
    EXPECT(report().level == DiagnosticStatus::OK);
    EXPECT(node.deactivate().label() == "inactive" && report().message == "inactive");
    EXPECT(node.activate().label() == "active");
    wait_for(100);
    network.send("/mod/in/see", std_msgs::msg::Int64{1});
    network.tick();
    network.send("/mod/in/count", std_msgs::msg::Int64{4});
    network.tick();
    EXPECT(report().message == "terminated");
    EXPECT(node.deactivate().label() == "inactive" && network.published["/diagnostics"].empty());
    return 0;
})");
}

TEST_F(Package, WarnsOfOperationsWithoutImplementation) {
    emit(testing::load_model(testing::typed_model), "Mod",
         "ros2 for Mod { publish operation go as geometry_msgs/Vector3 on \"go\" { x = a y = b } }");
    drive("M_node.hpp", R"(
class Robot : public p::MMessages {
public:
    void lamp(p::Mod_core::Light colour) override { shown = colour; }
    p::Mod_core::Light shown = p::Mod_core::Light::Red;
};
int main() {
    Network& network = Network::get();
    const auto run = [&](p::MNode& node) {
        for (int i = 0; i < 2; ++i) {
            network.send("/mod/in/see", std_msgs::msg::Int64{1});
            network.tick();
        }
        (void)node;
    };
    {
        auto robot = std::make_unique<Robot>();
        Robot& mine = *robot;
        p::MNode node(rclcpp::NodeOptions(), std::move(robot));
        EXPECT(started(node));
        run(node);
        EXPECT(mine.shown == p::Mod_core::Light::Green && network.log.empty());
        EXPECT(taken<std_msgs::msg::Int64>("/mod/out/lamp").empty());
    }
    {
        p::MNode node;
        network.listeners["/mod/out/lamp"].push_back([](const std::any&) {});
        EXPECT(started(node));
        run(node);
        EXPECT(network.log.empty());
        network.listeners.erase("/mod/out/lamp");
        run(node);
        EXPECT(logged("operation lamp is called and nobody does it"));
        EXPECT(taken<geometry_msgs::msg::Vector3>("/go").back().y == 3);
    }
    return 0;
})");
}

/// The model has two machines in two controllers, and a clock.
TEST_F(Package, HasAStateForEachMachine) {
    emit(testing::load_model(R"(package p
interface I { beep() }
interface E { event e : nat event f }
stm S { uses E requires I clock T var n : nat initial i state A { } state B { entry beep() }
    transition t0 { from i to A action #T } transition t1 { from A to B trigger e?n condition since(T) >= 2 } }
stm U { uses E initial i state A { } state B { } transition t0 { from i to A } transition t1 { from A to B trigger f } }
controller C { uses E requires I sref s = S connection C on e to s on e }
controller D { uses E sref u = U connection D on f to u on f }
robotic platform R { provides I uses E }
module Two { rref r = R cref c = C cref d = D connection r on e to c on e (_async) connection r on f to d on f (_async) }
)"),
         "Two",
         "ros2 for Two { receive event e as my_msgs/Lamp on \"lamp\" { value = colour }\n"
         "  receive event f as my_msgs/Lamp on \"lamp\" }");
    drive("Two_node.hpp", R"(
int main() {
    p::TwoNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    network.tick();
    network.send("/lamp", my_msgs::msg::Lamp{4, true});
    network.tick();
    EXPECT(taken<std_msgs::msg::Empty>("/two/out/beep").empty());  // the clock is at 1
    std::size_t states = 0;
    for (auto& [topic, messages] : network.published)
        if (topic.find("/two/state") == 0 && !messages.empty()) ++states;
    EXPECT(states == 2);
    network.tick();
    network.send("/lamp", my_msgs::msg::Lamp{4, true});
    network.tick();
    EXPECT(taken<std_msgs::msg::Empty>("/two/out/beep").size() == 1);
    return 0;
})");
}

TEST_F(Package, OfAMachineWithoutOperations) {
    emit(testing::load_model("stm M { initial i state A { } transition t0 { from i to A } }"), "M", "ros2 for M { }");
    drive("M_node.hpp", R"(
int main() {
    robot::MNode node;
    EXPECT(started(node));
    Network::get().tick();
    EXPECT(taken<std_msgs::msg::String>("/m/state").back().data == "A");
    return 0;
})");
}

/// Elements have names that the node, its messages, ROS or C++ use. One of these names is also the name of the package.
TEST_F(Package, OfElementsWithNamesOfRos) {
    emit(testing::load_model(R"(package rclcpp_lifecycle
enumeration State { active off }
interface Twist { outbox(message : State, ^now : nat) message(put : real) std_msgs() to_cmd_vel(a0 : nat, a1 : nat) }
interface MOutbox { event unfit : State event on_configure event from_scan : real }
interface MMessages { var last_state : nat var a__b : nat var a_b : nat }
interface MNode { var to_state : nat }
stm M { requires Twist requires MMessages requires MNode uses MOutbox var s : State var r : real initial i
    state A { entry outbox(s, 1); message(0.5); std_msgs(); to_cmd_vel(1, 2) ; a__b = 1 ; a_b = 2 }
    transition t0 { from i to A }
    transition t1 { from A to A trigger unfit?s }
    transition t2 { from A to A trigger on_configure action last_state = 1 ; to_state = 2 }
    transition t3 { from A to A trigger from_scan?r } }
)"),
         "M",
         "ros2 for M { publish operation to_cmd_vel as my_msgs/Lamp on \"cmd_vel\" { colour = a0 on = true }\n"
         "  receive event from_scan as sensor_msgs/Range on \"scan\" { value = range }\n"
         "  publish operation outbox as std_msgs/UInt8 on \"message\" { data = message }\n"
         "  publish variable last_state as std_msgs/Int16 on \"last_state\" { data = value } }");
    for (const char* const compiler : {"g++", "clang++"}) {
        folder_.run("rm -rf build");
        build("-DROBOCHART_TRACE=ON -DCMAKE_CXX_COMPILER=" + std::string(compiler));
    }
}

/// Runs the launch file in a stub of launch: it starts the node, configures it, and activates it once.
TEST_F(Package, IsLaunched) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    write("check.py", R"(
import runpy
from launch.actions import DeclareLaunchArgument, EmitEvent, RegisterEventHandler
from launch_ros.actions import LifecycleNode

made = runpy.run_path('launch/mod.launch.py')['generate_launch_description']().entities
of = lambda kind: [each for each in made if isinstance(each, kind)]
[node] = of(LifecycleNode)
assert (node.package, node.executable, node.name, node.namespace) == ('mod', 'run_mod', 'mod', '')
assert node.parameters[0].variable_name == 'parameters'
assert node.parameters[1]['use_sim_time'].variable_name == 'use_sim_time'
values = {each.name: each.default_value for each in of(DeclareLaunchArgument)}
assert values == {'parameters': '/share/mod/config/mod.yaml', 'autostart': 'true', 'use_sim_time': 'false'}
[configure] = of(EmitEvent)
assert configure.event.transition_id == 1 and configure.event.matches(node) and not configure.event.matches(made[0])
assert configure.condition.predicate_expression.variable_name == 'autostart'
[handler] = [each.event_handler for each in of(RegisterEventHandler)]
assert (handler.start_state, handler.goal_state, handler.node) == ('configuring', 'inactive', node)
assert handler.handle_once  # a later configuration does not activate the node
[activate] = handler.entities
assert activate.event.transition_id == 3 and activate.event.matches(node)
)");
    folder_.run("PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=" + stub() + "/python python3 check.py");
}

/// As docs/ros2.md describes, another package finds the installed one, inherits from its class and uses its node. The
/// package's own test passes, and sources in `own` belong to the package.
TEST_F(Package, IsUsedByAnotherPackage) {
    emit(testing::load_model(two_topics), "M", two_topics_mapping);
    folder_.run(
        "echo 'int main() { return 0; }' > own/mine.cpp && "
        "echo 'add_executable(mine own/mine.cpp)' >> own/own.cmake");
    build("-DBUILD_TESTING=ON -DCMAKE_INSTALL_PREFIX=$PWD/installed");
    folder_.run("test -x build/mine && ctest --test-dir build --output-on-failure && cmake --install build");
    folder_.run("mkdir -p derived/src");
    write("derived/CMakeLists.txt", R"(cmake_minimum_required(VERSION 3.16)
project(my_robot LANGUAGES CXX)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(robot_m REQUIRED)
add_executable(robot src/robot.cpp)
target_link_libraries(robot robot_m::robot_m_node)
ament_package()
)");
    write("derived/src/robot.cpp", R"(#include <robot_m/M_node.hpp>
class Robot : public order::MMessages {
public:
    void horn() override {}
};
int main() {
    order::MNode node(rclcpp::NodeOptions(), std::make_unique<Robot>());
    if (node.configure().label() != "inactive" || node.activate().label() != "active") return 1;
    rclcpp::Network::get().tick();
    return rclcpp::Network::get().order.front() == "/waypoint_goal" ? 0 : 2;
}
)");
    folder_.run("cmake -S derived -B derived/build -DCMAKE_PREFIX_PATH='" + stub() +
                "/cmake;'$PWD/installed && cmake --build derived/build && derived/build/robot");
}

/// With --model-names, nodes, topics and files have the names of the model, which are not converted to snake_case.
TEST_F(Package, MayHaveTheNamesOfTheModel) {
    Options options;
    options.model_names = true;
    options.package = {"1.20.3", "Apache-2.0 OR MIT", "Ada & <co>", "ada@example.org"};
    emit(testing::load_corpus("swarm_taxis"), "SwarmTaxis", "", {}, options);
    folder_.run("test -f launch/SwarmTaxisFSM.launch.py && test -f config/SwarmTaxisFSM.yaml");
    folder_.run("grep -q \"name='SwarmTaxis'\" launch/SwarmTaxisFSM.launch.py");
    folder_.run("grep -q '\"~/out/MoveForward\"' src/SwarmTaxisFSM_node.cpp");
    folder_.run(
        "grep -q '<version>1.20.3</version>' package.xml && grep -q '<license>Apache-2.0 OR MIT</license>' package.xml "
        "&& grep -q '<maintainer email=\"ada@example.org\">Ada &amp; &lt;co&gt;</maintainer>' package.xml");
    folder_.run("head -n 1 src/SwarmTaxisFSM_node.cpp | grep -qx '// SPDX-License-Identifier: Apache-2.0 OR MIT'");
    folder_.run("! find . -name '*.?pp' -o -name '*.py' -o -name 'CMakeLists.txt' | xargs grep -L SPDX | grep .");
}

TEST_F(Package, NamesWhatItNeeds) {
    emit(testing::load_model(wheeled), "Mod", wheels, chosen_constants());
    folder_.run("grep -q '^    cycle: 0.1$' config/mod.yaml && grep -q '^    # constants.SPEED: 1.5$' config/mod.yaml");
    for (const char* const name :
         {"builtin_interfaces", "diagnostic_msgs", "geometry_msgs", "rcl_interfaces", "sensor_msgs", "std_msgs"})
        folder_.run(
            fmt::format("grep -q '<depend>{0}</depend>' package.xml && "
                        "grep -q '^find_package({0} REQUIRED)$' CMakeLists.txt && "
                        "grep -q '${{{0}_TARGETS}}' CMakeLists.txt",
                        name));
    folder_.run("! grep -q my_msgs package.xml");
    folder_.run("grep -q '^install(DIRECTORY launch config DESTINATION share/' CMakeLists.txt");
}

/// The model has shared variables of record types in both directions. The environment writes one of them.
TEST_F(Package, HasVariablesThatAreRecords) {
    emit(testing::load_model(R"(package p
enumeration Light { Red Green }
datatype Place { x : real lamp : Light }
datatype Both { first : Place second : nat }
interface I { var target : Both }
stm M { requires I initial i state A { }
    state B { entry target = Both (| first = Place (| x = 2.5, lamp = Light::Green |), second = 3 |) }
    transition t0 { from i to A } transition t1 { from A to B condition target.second == 7 } }
)"),
         "M", R"(ros2 for M {
    publish variable target as my_msgs/Goal on "target" { x = value.first.x kind = value.first.lamp count = value.second }
    receive variable target as my_msgs/Goal on "wanted" { value.first.x = x value.first.lamp = kind value.second = count }
})");
    drive("M_node.hpp", R"(
int main() {
    using my_msgs::msg::Goal;
    p::MNode node;
    Network& network = Network::get();
    EXPECT(started(node));
    network.tick();
    EXPECT(taken<Goal>("/target").size() == 1);
    network.send("/wanted", Goal{1.5, 2, 7});   // no light
    network.send("/wanted", Goal{1.5, 1, -7});  // no natural number
    network.tick();
    EXPECT(taken<Goal>("/target").empty());
    network.send("/wanted", Goal{1.5, 1, 7});
    network.tick();
    const auto targets = taken<Goal>("/target");
    EXPECT(!targets.empty() && targets.back().x == 2.5F && targets.back().kind == 1 && targets.back().count == 3);
    EXPECT(taken<std_msgs::msg::String>("/m/state").back().data == "B");
    return 0;
})");
}

}  // namespace
}  // namespace robochart::cpp_emit::ros2::node_test
