// SPDX-License-Identifier: Apache-2.0
// The parts of rclcpp_action that generated nodes use, for tests: a client, for which the test is the server. ROS 2 is
// not in Debian 12, so the names and signatures are those of its published headers (Humble, Jazzy).
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/rclcpp.hpp"

namespace rclcpp_action {

enum class ResultCode : std::int8_t { UNKNOWN = 0, SUCCEEDED = 4, CANCELED = 5, ABORTED = 6 };

template <class Action>
class ClientGoalHandle {
public:
    using SharedPtr = std::shared_ptr<ClientGoalHandle>;
    struct WrappedResult {
        ResultCode code = ResultCode::UNKNOWN;
        std::shared_ptr<typename Action::Result> result;
    };
    bool canceled = false;  ///< for the test: a cancellation was requested
};

template <class Action>
class Client {
public:
    using SharedPtr = std::shared_ptr<Client>;
    using Handle = ClientGoalHandle<Action>;
    struct SendGoalOptions {
        std::function<void(typename Handle::SharedPtr)> goal_response_callback;
        std::function<void(typename Handle::SharedPtr, const std::shared_ptr<const typename Action::Feedback>)>
            feedback_callback;
        std::function<void(const typename Handle::WrappedResult&)> result_callback;
    };
    /// A goal, as its server sees it.
    struct Sent {
        typename Action::Goal goal;
        SendGoalOptions options;
        typename Handle::SharedPtr handle = std::make_shared<Handle>();

        void accept() const { options.goal_response_callback(handle); }
        void reject() const { options.goal_response_callback(nullptr); }
        void feed(const typename Action::Feedback& feedback) const {
            options.feedback_callback(handle, std::make_shared<const typename Action::Feedback>(feedback));
        }
        void end(ResultCode code) const {
            options.result_callback({code, std::make_shared<typename Action::Result>()});
        }
    };
    /// Returns all goals of this type of action, by the name of the server.
    static std::map<std::string, std::vector<Sent>>& goals() {
        static std::map<std::string, std::vector<Sent>> sent;
        return sent;
    }

    explicit Client(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] bool action_server_is_ready() const { return rclcpp::Network::get().servers.count(name_) != 0; }
    void async_send_goal(const typename Action::Goal& goal, const SendGoalOptions& options) {
        goals()[name_].push_back({goal, options});
    }
    void async_cancel_goal(typename Handle::SharedPtr handle) { handle->canceled = true; }

private:
    std::string name_;
};

template <class Action, class AnyNode>
std::shared_ptr<Client<Action>> create_client(AnyNode, const std::string& name) {
    return std::make_shared<Client<Action>>(name[0] == '/' ? name : "/" + name);
}

}  // namespace rclcpp_action
