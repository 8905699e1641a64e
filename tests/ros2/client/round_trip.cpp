// SPDX-License-Identifier: Apache-2.0
// Runs a generated node with random inputs, floods and pauses, and kills it in the middle of a flood. The node writes a
// log; this program writes a file with the messages of the node that arrived, in the order in which they were sent.
// Arguments: the package (warehouse or aggregation), seconds, seed, the log, the file of messages.
#include <signal.h>

#include <algorithm>
#include <fstream>
#include <iostream>
#include <limits>
#include <mutex>
#include <random>
#include <stdexcept>

#include <geometry_msgs/msg/twist.hpp>
#include <geometry_msgs/msg/twist_stamped.hpp>
#include <sensor_msgs/msg/battery_state.hpp>
#include <sensor_msgs/msg/range.hpp>
#include <std_msgs/msg/bool.hpp>
#include <std_msgs/msg/empty.hpp>
#include <std_msgs/msg/float64.hpp>
#include <std_msgs/msg/string.hpp>
#include <std_msgs/msg/u_int32.hpp>

#include "robot.hpp"

namespace robochart::ros2_client {
namespace {

using namespace std::chrono_literals;
using geometry_msgs::msg::Twist;
using geometry_msgs::msg::TwistStamped;
using sensor_msgs::msg::BatteryState;
using sensor_msgs::msg::Range;
using std_msgs::msg::Bool;
using std_msgs::msg::Empty;
using std_msgs::msg::Float64;
using std_msgs::msg::UInt32;

/// The messages that the node has sent, with the times of sending.
class Recording {
public:
    template <class Message, class Word>
    void watch(Robot& robot, const std::string& topic, Word word) {
        robot.receive<Message>(
            topic,
            [this, word](const Message& message, const rclcpp::MessageInfo& info) {
                add(info.get_rmw_message_info().source_timestamp, word(message));
            },
            rclcpp::QoS(100000));
    }
    void write(const std::string& name) {
        const std::lock_guard lock(mutex_);
        std::stable_sort(lines_.begin(), lines_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        std::ofstream file(name);
        for (const auto& [time, line] : lines_) file << line << '\n';
        if (!file.flush()) throw std::runtime_error("cannot write " + name);
        std::cout << lines_.size() << " messages of the node, " << late_ << " of them arrived after a later one\n";
    }

private:
    void add(std::int64_t time, const std::string& line) {
        if (line.empty()) return;
        const std::lock_guard lock(mutex_);
        if (!lines_.empty() && time < lines_.back().first) ++late_;
        lines_.emplace_back(time, line);
    }

    std::mutex mutex_;
    std::vector<std::pair<std::int64_t, std::string>> lines_;
    std::size_t late_ = 0;
};

/// The inputs of a robot: functions that send a message.
using Inputs = std::vector<std::function<void()>>;

template <class Message, class Value>
std::function<void()> input(const rclcpp::PublisherBase::SharedPtr& publisher, Value Message::*field, double value) {
    Message message;
    message.*field = static_cast<Value>(value);
    return [to = std::dynamic_pointer_cast<rclcpp::Publisher<Message>>(publisher), message] { to->publish(message); };
}

std::function<void()> signal_of(Robot& robot, const std::string& topic) {
    return [to = robot.publisher<Empty>(topic)] { to->publish(Empty()); };
}

std::string word_of(const Twist& message) {
    if (message.angular.z > 0) return "";  // sent at a deactivation
    return message.linear.x < 0 ? "reverse!" : "halt!";
}

Inputs warehouse(Robot& robot, Recording& recording) {
    recording.watch<UInt32>(robot, "waypoint_goal", [](const UInt32& m) { return "goTo!" + std::to_string(m.data); });
    recording.watch<Twist>(robot, "cmd_vel", word_of);
    recording.watch<Empty>(robot, "dock", [](const Empty&) { return std::string("dock!"); });
    recording.watch<TwistStamped>(robot, "brake", [](const TwistStamped&) { return std::string("brake!"); });
    recording.watch<std_msgs::msg::String>(robot, "help", [](const auto&) { return std::string("callHelp!"); });

    const auto range = robot.publisher<Range>("range", rclcpp::SensorDataQoS());
    const auto battery = robot.publisher<BatteryState>("battery_state", rclcpp::SensorDataQoS());
    const auto docked = robot.publisher<Bool>("docked");
    Inputs inputs;
    for (const double distance : {0.1, 0.2, 0.3, 0.39, 0.45, 0.5, 2.0, std::numeric_limits<double>::infinity()})
        inputs.push_back(input(range, &Range::range, distance));
    for (const double part : {0.1, 0.5, 0.95}) {
        BatteryState message;
        message.percentage = static_cast<float>(part);
        message.present = true;
        inputs.push_back([battery, message] { battery->publish(message); });
    }
    inputs.push_back(input(docked, &Bool::data, 1));
    inputs.push_back(input(docked, &Bool::data, 0));
    const auto arrived = signal_of(robot, "arrived");
    inputs.insert(inputs.end(), {arrived, arrived, arrived, signal_of(robot, "estop"), signal_of(robot, "reset")});
    return inputs;
}

Inputs aggregation(Robot& robot, Recording& recording) {
    const auto record = [&](const std::string& topic) {
        recording.watch<Float64>(robot, topic,
                                 [topic](const Float64& m) { return topic + ' ' + std::to_string(m.data); });
    };
    record("linear_speed");
    record("angular_speed");
    const auto sees = robot.publisher<Bool>("sees_robot");
    return {input(sees, &Bool::data, 0), input(sees, &Bool::data, 1)};
}

class Run {
public:
    Run(Robot& robot, const Inputs& inputs, unsigned seed) : robot_(robot), inputs_(inputs), random_(seed) {}

    void for_seconds(int seconds) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
        while (std::chrono::steady_clock::now() < end) act();
        flood();
        std::cout << messages_ << " messages to the node, " << floods_ << " floods, " << pauses_ << " pauses\n";
    }

private:
    int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(random_); }
    void send() {
        inputs_[static_cast<std::size_t>(below(static_cast<int>(inputs_.size())))]();
        ++messages_;
    }
    void act() {
        const int kind = below(500);
        if (kind == 0) flood();
        if (kind == 1) pause();
        if (kind == 2) std::this_thread::sleep_for(std::chrono::milliseconds(3000 + below(3000)));
        for (int i = below(3); i >= 0; --i) send();
        std::this_thread::sleep_for(std::chrono::milliseconds(below(200)));
    }
    void flood() {
        ++floods_;
        for (int i = 0; i < 5000; ++i) {
            send();
            if (i % 10 == 0) std::this_thread::sleep_for(1ms);
        }
    }
    void pause() {
        ++pauses_;
        if (!robot_.change(Transition::TRANSITION_DEACTIVATE)) throw std::runtime_error("deactivate fails");
        for (int i = 0; i < 5; ++i) send();
        std::this_thread::sleep_for(std::chrono::milliseconds(below(1500)));
        if (!robot_.change(Transition::TRANSITION_ACTIVATE)) throw std::runtime_error("activate fails");
    }

    Robot& robot_;
    const Inputs& inputs_;
    std::mt19937 random_;
    int messages_ = 0, floods_ = 0, pauses_ = 0;
};

void run(const std::vector<std::string>& words) {
    const std::string& package = words.at(0);
    Recording recording;
    Robot robot(package, {"log:=" + words.at(3)});
    const Inputs inputs = package == "warehouse" ? warehouse(robot, recording) : aggregation(robot, recording);
    if (!robot.change(Transition::TRANSITION_CONFIGURE)) throw std::runtime_error("configure fails");
    std::this_thread::sleep_for(1s);  // until all topics are connected
    if (!robot.change(Transition::TRANSITION_ACTIVATE)) throw std::runtime_error("activate fails");
    Run(robot, inputs, static_cast<unsigned>(std::stoul(words.at(2)))).for_seconds(std::stoi(words.at(1)));
    robot.process().end(SIGKILL);
    std::this_thread::sleep_for(500ms);
    recording.write(words.at(4));
}

}  // namespace
}  // namespace robochart::ros2_client

int main(int count, char** words) {
    rclcpp::init(count, words);
    int code = 0;
    try {
        robochart::ros2_client::run({words + 1, words + count});
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << '\n';
        code = 1;
    }
    rclcpp::shutdown();
    return code;
}
