// Shared by the ROS 2 nodes of generated controllers that call actions. Sends the goal of an action, and orders the
// action's events. Written by robochart-verify.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <rclcpp/rclcpp.hpp>
#include <rclcpp_action/rclcpp_action.hpp>

namespace robochart::ros2 {

/// Sends goals to an action server and stores the last one. After send(), the functions of `events` are called in this
/// order, for any behaviour of server and network: rejected; or accepted, then feedback any number of times, then at
/// most one of succeeded, aborted and canceled. A later goal replaces the goal: then no function is called for the
/// earlier one any more.
template <class Action>
class Goal {
public:
    using Client = ::rclcpp_action::Client<Action>;
    using Handle = ::rclcpp_action::ClientGoalHandle<Action>;

    struct Events {
        std::function<void()> accepted;
        std::function<void()> rejected;
        std::function<void(const typename Action::Feedback&)> feedback;
        std::function<void(const typename Action::Result&)> succeeded;
        std::function<void(const typename Action::Result&)> aborted;
        std::function<void(const typename Action::Result&)> canceled;
    };
    Events events;

    void connect(typename Client::SharedPtr client) { client_ = std::move(client); }
    void release() {
        forget();
        client_.reset();
    }
    [[nodiscard]] bool is_connected() const { return client_ != nullptr; }
    [[nodiscard]] bool has_server() const { return client_->action_server_is_ready(); }

    /// Gives up the last goal: its events are not called any more. The server continues with it.
    void forget() {
        ++number_;
        stage_ = Stage::none;
        handle_.reset();
        cancel_when_accepted_ = false;
    }
    /// Sends a goal. Throws what rclcpp_action throws.
    void send(const typename Action::Goal& goal) {
        forget();
        const std::uint64_t number = number_;
        typename Client::SendGoalOptions options;
        options.goal_response_callback = [this, number](const typename Handle::SharedPtr& handle) {
            if (number == number_ && stage_ == Stage::sent) answer(handle);
        };
        options.feedback_callback = [this, number](const typename Handle::SharedPtr&,
                                                   const std::shared_ptr<const typename Action::Feedback>& feedback) {
            if (number == number_ && stage_ == Stage::accepted && events.feedback) events.feedback(*feedback);
        };
        options.result_callback = [this, number](const typename Handle::WrappedResult& result) {
            if (number == number_ && stage_ == Stage::accepted) end(result);
        };
        stage_ = Stage::sent;
        client_->async_send_goal(goal, options);
    }

    /// Requests that the server cancels the goal. If the server has not accepted the goal yet, the request waits.
    /// Throws what rclcpp_action throws.
    void cancel() {
        if (stage_ == Stage::sent) cancel_when_accepted_ = true;
        if (stage_ == Stage::accepted) client_->async_cancel_goal(handle_);
    }

private:
    enum class Stage { none, sent, accepted };

    void answer(const typename Handle::SharedPtr& handle) {
        if (!handle) {
            stage_ = Stage::none;
            if (events.rejected) events.rejected();
            return;
        }
        handle_ = handle;
        stage_ = Stage::accepted;
        if (events.accepted) events.accepted();
        if (std::exchange(cancel_when_accepted_, false)) client_->async_cancel_goal(handle_);
    }
    /// Ends the goal. A result without a code is treated as aborted.
    void end(const typename Handle::WrappedResult& result) {
        stage_ = Stage::none;
        handle_.reset();
        const auto& event = function_of(result.code);
        if (event && result.result) event(*result.result);
    }
    [[nodiscard]] const std::function<void(const typename Action::Result&)>& function_of(
        ::rclcpp_action::ResultCode code) const {
        switch (code) {
            case ::rclcpp_action::ResultCode::SUCCEEDED:
                return events.succeeded;
            case ::rclcpp_action::ResultCode::CANCELED:
                return events.canceled;
            case ::rclcpp_action::ResultCode::ABORTED:
            case ::rclcpp_action::ResultCode::UNKNOWN:
                break;
        }
        return events.aborted;
    }

    typename Client::SharedPtr client_;
    typename Handle::SharedPtr handle_;
    std::uint64_t number_ = 0;  ///< number of the goal
    Stage stage_ = Stage::none;
    bool cancel_when_accepted_ = false;
};

}  // namespace robochart::ros2
