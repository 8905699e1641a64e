// SPDX-License-Identifier: Apache-2.0
// A generated node in another process, and a client of it in this process.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include <lifecycle_msgs/msg/transition.hpp>
#include <lifecycle_msgs/srv/change_state.hpp>
#include <lifecycle_msgs/srv/get_state.hpp>
#include <rclcpp/rclcpp.hpp>

namespace robochart::ros2_client {

using Transition = lifecycle_msgs::msg::Transition;

/// Waits until the condition is true, at most for this time. Returns whether it became true.
bool wait_until(const std::function<bool()>& condition, std::chrono::milliseconds limit = std::chrono::seconds(10));

/// A program in another process.
class Process {
public:
    explicit Process(const std::vector<std::string>& words);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Sends a signal and waits for the end. Returns the exit code, or 128 and the signal that ended the program.
    int end(int signal);

private:
    pid_t id_;
};

class Robot {
public:
    /// Starts a node with parameters such as "cycle:=0.01". The program is `run_NODE` in the installed package NODE, if
    /// none is given.
    explicit Robot(const std::string& node, const std::vector<std::string>& parameters = {},
                   const std::string& program = "");
    ~Robot();

    /// Requests a transition of the lifecycle. Returns whether it succeeded.
    bool change(std::uint8_t transition);
    bool start() { return change(Transition::TRANSITION_CONFIGURE) && change(Transition::TRANSITION_ACTIVATE); }
    /// Returns the label of the lifecycle's state.
    std::string state();

    template <class Message>
    typename rclcpp::Publisher<Message>::SharedPtr publisher(const std::string& topic,
                                                             const rclcpp::QoS& quality = rclcpp::QoS(10)) {
        return client_->create_publisher<Message>(topic, quality);
    }
    /// Receives messages in the thread of the client.
    template <class Message, class Function>
    void receive(const std::string& topic, Function function, const rclcpp::QoS& quality = rclcpp::QoS(1000)) {
        subscriptions_.push_back(client_->create_subscription<Message>(topic, quality, function));
    }
    [[nodiscard]] Process& process() { return process_; }
    [[nodiscard]] rclcpp::Node& node() { return *client_; }

private:
    Process process_;
    rclcpp::Node::SharedPtr client_;
    rclcpp::executors::SingleThreadedExecutor executor_;
    rclcpp::Client<lifecycle_msgs::srv::ChangeState>::SharedPtr change_;
    rclcpp::Client<lifecycle_msgs::srv::GetState>::SharedPtr state_;
    std::vector<rclcpp::SubscriptionBase::SharedPtr> subscriptions_;
    std::thread thread_;
};

/// Waits until the node has connected to the publisher.
template <class Publisher>
bool is_heard(const Publisher& publisher) {
    return wait_until([&] { return publisher->get_subscription_count() > 0; });
}

}  // namespace robochart::ros2_client
