// SPDX-License-Identifier: Apache-2.0
// Runs a generated node that uses an action, services, conditions and deadlines, with servers that this program plays.
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <geometry_msgs/msg/pose_stamped.hpp>
#include <geometry_msgs/msg/twist.hpp>
#include <nav2_msgs/action/navigate_to_pose.hpp>
#include <rclcpp_action/rclcpp_action.hpp>
#include <sensor_msgs/msg/laser_scan.hpp>
#include <sensor_msgs/msg/range.hpp>
#include <std_msgs/msg/empty.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_msgs/msg/u_int8.hpp>
#include <std_srvs/srv/set_bool.hpp>
#include <std_srvs/srv/trigger.hpp>

#include "robot.hpp"
#include "shared.hpp"

namespace robochart::ros2_client {
namespace {

using namespace std::chrono_literals;
using diagnostic_msgs::msg::DiagnosticArray;
using geometry_msgs::msg::PoseStamped;
using geometry_msgs::msg::Twist;
using nav2_msgs::action::NavigateToPose;
using sensor_msgs::msg::LaserScan;
using sensor_msgs::msg::Range;
using std_msgs::msg::Empty;
using std_msgs::msg::String;
using std_msgs::msg::UInt8;
using std_srvs::srv::SetBool;
using std_srvs::srv::Trigger;

/// What the action server does with a goal: the x coordinate of the goal.
enum Behaviour { succeed = 1, reject = 2, abort_goal = 3, wait_for_cancel = 4, silence = 5 };

/// A server of the action. It works in a thread for each goal.
class Server {
public:
    explicit Server(rclcpp::Node& node) {
        server_ = rclcpp_action::create_server<NavigateToPose>(
            &node, "navigate_to_pose",
            [](const rclcpp_action::GoalUUID&, std::shared_ptr<const NavigateToPose::Goal> goal) {
                return behaviour_of(*goal) == reject ? rclcpp_action::GoalResponse::REJECT
                                                     : rclcpp_action::GoalResponse::ACCEPT_AND_EXECUTE;
            },
            [](const std::shared_ptr<Goal>&) { return rclcpp_action::CancelResponse::ACCEPT; },
            [this](const std::shared_ptr<Goal>& goal) { threads_.emplace_back([this, goal] { execute(goal); }); });
    }
    ~Server() {
        ends_ = true;
        for (std::thread& thread : threads_) thread.join();
    }
    [[nodiscard]] int canceled() const { return canceled_; }

private:
    using Goal = rclcpp_action::ServerGoalHandle<NavigateToPose>;

    static int behaviour_of(const NavigateToPose::Goal& goal) { return static_cast<int>(goal.pose.pose.position.x); }
    void execute(const std::shared_ptr<Goal>& goal) {
        const auto result = std::make_shared<NavigateToPose::Result>();
        const int behaviour = behaviour_of(*goal->get_goal());
        if (behaviour == succeed) {
            for (const float left : {5.0F, 0.5F}) {
                std::this_thread::sleep_for(300ms);
                const auto feedback = std::make_shared<NavigateToPose::Feedback>();
                feedback->distance_remaining = left;
                goal->publish_feedback(feedback);
            }
            std::this_thread::sleep_for(300ms);
            return goal->succeed(result);
        }
        if (behaviour == abort_goal) return goal->abort(result);
        while (!goal->is_canceling() && !ends_) std::this_thread::sleep_for(5ms);
        if (behaviour == silence || ends_) return;
        ++canceled_;
        goal->canceled(result);
    }

    rclcpp_action::Server<NavigateToPose>::SharedPtr server_;
    std::vector<std::thread> threads_;
    std::atomic<bool> ends_{false};
    std::atomic<int> canceled_{0};
};

class Guide : public ::testing::Test {
protected:
    void SetUp() override {
        robot_.receive<String>(
            "/guide/state", [this](const String& m) { states_.add(m.data); }, rclcpp::QoS(100).transient_local());
        robot_.receive<UInt8>("say", [this](const UInt8& m) { said_.add(m.data); });
        robot_.receive<Twist>("cmd_vel", [this](const Twist& m) { speeds_.add(m.linear.x); });
        robot_.receive<DiagnosticArray>("/diagnostics",
                                        [this](const DiagnosticArray& m) { levels_.add(m.status.at(0).level); });
        docking_ = robot_.node().create_service<SetBool>(
            "dock", [this](const std::shared_ptr<rmw_request_id_t> id, const SetBool::Request::SharedPtr request) {
                SetBool::Response answer;
                answer.success = docks_;
                fast_.add(request->data);
                if (answers_) docking_->send_response(*id, answer);
            });
        undocking_ = robot_.node().create_service<Trigger>(
            "undock", [](const Trigger::Request::SharedPtr, const Trigger::Response::SharedPtr answer) {
                answer->success = true;
            });
        ASSERT_TRUE(robot_.start());
        ASSERT_TRUE(is_in("Idle"));
        ASSERT_TRUE(is_heard(wanted_) && is_heard(range_) && is_heard(halt_) && is_heard(mode_) && is_heard(scan_));
        std::this_thread::sleep_for(500ms);  // until the servers are connected
    }
    bool is_in(const std::string& state) {
        return wait_until([&] {
            const auto states = states_.values();
            return !states.empty() && states.back() == state;
        });
    }
    void want(int behaviour) {
        PoseStamped message;
        message.pose.position.x = behaviour;
        wanted_->publish(message);
    }
    void measure(float distance) {
        Range message;
        message.range = distance;
        range_->publish(message);
    }
    bool says(int number) {
        return wait_until([&] {
            const std::vector<int> said = said_.values();
            return std::find(said.begin(), said.end(), number) != said.end();
        });
    }

    Robot robot_{"guide"};
    Server server_{robot_.node()};
    Shared<std::string> states_;
    Shared<int> said_, levels_;
    Shared<bool> fast_;
    Shared<double> speeds_;
    std::atomic<bool> docks_{true}, answers_{true};
    rclcpp::Service<SetBool>::SharedPtr docking_;
    rclcpp::Service<Trigger>::SharedPtr undocking_;
    rclcpp::Publisher<PoseStamped>::SharedPtr wanted_ = robot_.publisher<PoseStamped>("wanted");
    rclcpp::Publisher<Range>::SharedPtr range_ = robot_.publisher<Range>("range", rclcpp::SensorDataQoS());
    rclcpp::Publisher<LaserScan>::SharedPtr scan_ = robot_.publisher<LaserScan>("scan", rclcpp::SensorDataQoS());
    rclcpp::Publisher<UInt8>::SharedPtr mode_ = robot_.publisher<UInt8>("mode");
    rclcpp::Publisher<Empty>::SharedPtr halt_ = robot_.publisher<Empty>("halt");
};

/// Goal accepted, feedback, success; then the services.
TEST_F(Guide, ReachesAGoalAndDocks) {
    want(succeed);
    ASSERT_TRUE(wait_until([&] { return !fast_.values().empty(); }));
    ASSERT_TRUE(says(1));  // one feedback above 1
    ASSERT_TRUE(is_in("Idle"));
    EXPECT_EQ(fast_.values(), std::vector<bool>{false});
    ASSERT_TRUE(speeds_.reaches(4));
    EXPECT_EQ(speeds_.values(), (std::vector<double>{0, 0.5, 0.1, 0}));
    const std::vector<std::string> states = states_.values();
    EXPECT_EQ(states.front(), "Idle");
    EXPECT_NE(std::find(states.begin(), states.end(), "Going_Moving"), states.end())
        << ::testing::PrintToString(states);
}

TEST_F(Guide, AGoalIsRejectedAbortedOrCanceled) {
    want(reject);
    ASSERT_TRUE(speeds_.reaches(3));
    ASSERT_TRUE(is_in("Idle"));
    want(abort_goal);
    ASSERT_TRUE(speeds_.reaches(5));
    ASSERT_TRUE(is_in("Idle"));
    want(wait_for_cancel);
    ASSERT_TRUE(is_in("Going_Moving"));
    halt_->publish(Empty());
    ASSERT_TRUE(speeds_.reaches(7));
    ASSERT_TRUE(is_in("Idle"));
    EXPECT_EQ(server_.canceled(), 1);
    EXPECT_TRUE(said_.values().empty());
}

TEST_F(Guide, ADeadlineOfAnAction) {
    want(silence);
    ASSERT_TRUE(says(100));
    EXPECT_TRUE(is_in("Idle"));
}

TEST_F(Guide, ADeactivationCancelsTheGoalAndStops) {
    want(wait_for_cancel);
    ASSERT_TRUE(is_in("Going_Moving"));
    ASSERT_TRUE(robot_.change(Transition::TRANSITION_DEACTIVATE));
    EXPECT_TRUE(wait_until([&] { return server_.canceled() == 1; }));
    EXPECT_TRUE(wait_until([&] { return speeds_.values().back() == 0; }));
}

TEST_F(Guide, AServiceRefusesOrIsSilent) {
    docks_ = false;
    want(succeed);
    ASSERT_TRUE(wait_until([&] { return fast_.values().size() == 1; }));
    ASSERT_TRUE(is_in("Idle"));
    EXPECT_TRUE(said_.values().empty());
    answers_ = false;
    want(succeed);
    ASSERT_TRUE(says(99));
    EXPECT_EQ(fast_.values(), (std::vector<bool>{false, false}));
}

TEST_F(Guide, ConditionsAndTheDeadlineOfATopic) {
    measure(1);
    measure(2);
    std::this_thread::sleep_for(300ms);
    EXPECT_TRUE(said_.values().empty());
    measure(4);
    ASSERT_TRUE(says(3));   // far
    ASSERT_TRUE(says(55));  // silent for half a second
    std::this_thread::sleep_for(1s);
    EXPECT_EQ(said_.values(), (std::vector<int>{3, 55}));  // once
    measure(0.2F);
    ASSERT_TRUE(speeds_.reaches(2));  // close
}

TEST_F(Guide, EnumerationsAndArrays) {
    UInt8 mode;
    mode.data = 3;  // no literal
    mode_->publish(mode);
    LaserScan scan;
    scan.ranges = {1, 2};
    scan_->publish(scan);
    std::this_thread::sleep_for(300ms);
    scan.ranges.assign(361, 1.0F);  // more than the capacity
    scan_->publish(scan);
    std::this_thread::sleep_for(300ms);
    scan.ranges.assign(360, 1.0F);
    scan_->publish(scan);
    std::this_thread::sleep_for(300ms);
    scan.ranges = {1, 2, 3, 4};
    scan_->publish(scan);
    ASSERT_TRUE(says(4));
    mode.data = 2;
    mode_->publish(mode);
    ASSERT_TRUE(says(7));
    const std::vector<int> said = said_.values();
    EXPECT_EQ(std::count(said.begin(), said.end(), 7), 1);
}

TEST_F(Guide, ReportsItsHealthEachSecond) {
    ASSERT_TRUE(levels_.reaches(2));
    for (const int level : levels_.values()) EXPECT_EQ(level, diagnostic_msgs::msg::DiagnosticStatus::OK);
}

}  // namespace
}  // namespace robochart::ros2_client

int main(int count, char** words) {
    ::testing::InitGoogleTest(&count, words);
    rclcpp::init(count, words);
    const int result = RUN_ALL_TESTS();
    rclcpp::shutdown();
    return result;
}
