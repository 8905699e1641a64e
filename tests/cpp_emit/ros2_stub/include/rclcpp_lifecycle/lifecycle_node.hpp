// SPDX-License-Identifier: Apache-2.0
// The parts of rclcpp_lifecycle::LifecycleNode that generated nodes use, for tests. The states are those of
// design.ros2.org/articles/node_lifecycle.html. If a callback fails, the node keeps its state.
#pragma once

#include <any>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_publisher.hpp"

namespace rclcpp_lifecycle {

class State {
public:
    explicit State(std::string label = "unconfigured") : label_(std::move(label)) {}
    [[nodiscard]] const std::string& label() const { return label_; }

private:
    std::string label_;
};

namespace node_interfaces {

class LifecycleNodeInterface {
public:
    enum class CallbackReturn { SUCCESS, FAILURE, ERROR };

    virtual ~LifecycleNodeInterface() = default;
    virtual CallbackReturn on_configure(const State&) { return CallbackReturn::SUCCESS; }
    virtual CallbackReturn on_cleanup(const State&) { return CallbackReturn::SUCCESS; }
    virtual CallbackReturn on_shutdown(const State&) { return CallbackReturn::SUCCESS; }
    virtual CallbackReturn on_activate(const State&) { return CallbackReturn::SUCCESS; }
    virtual CallbackReturn on_deactivate(const State&) { return CallbackReturn::SUCCESS; }
    virtual CallbackReturn on_error(const State&) { return CallbackReturn::FAILURE; }
};

}  // namespace node_interfaces

class LifecycleNode : public node_interfaces::LifecycleNodeInterface {
public:
    explicit LifecycleNode(std::string name, const rclcpp::NodeOptions& = rclcpp::NodeOptions(), bool = true)
        : name_(std::move(name)) {}

    template <class Message, class Callback>
    std::shared_ptr<rclcpp::Subscription<Message>> create_subscription(
        const std::string& topic, const rclcpp::QoS& qos, Callback&& callback,
        const rclcpp::SubscriptionOptions& options = {}) {
        const rclcpp::QoS actual = overridden(topic, "subscription", qos, options.qos_overriding_options);
        rclcpp::Network::get().listeners[full(topic)].push_back(
            [callback](const std::any& message) { callback(std::any_cast<const Message&>(message)); });
        return std::make_shared<rclcpp::Subscription<Message>>(full(topic), actual);
    }
    template <class Message>
    std::shared_ptr<LifecyclePublisher<Message>> create_publisher(const std::string& topic, const rclcpp::QoS& qos,
                                                                  const rclcpp::PublisherOptions& options = {}) {
        const rclcpp::QoS actual = overridden(topic, "publisher", qos, options.qos_overriding_options);
        auto publisher = std::make_shared<LifecyclePublisher<Message>>(full(topic), actual);
        managed_.push_back(publisher);
        return publisher;
    }
    template <class Value>
    Value declare_parameter(const std::string& name, const Value& value,
                            const rcl_interfaces::msg::ParameterDescriptor& descriptor = {}) {
        rclcpp::Network::get().declared[name] = descriptor;
        const auto& given = rclcpp::Network::get().parameters;
        const auto found = given.find(name);
        const Value result = found == given.end() ? value : std::any_cast<Value>(found->second);
        if constexpr (std::is_same_v<Value, double>)
            for (const auto& range : descriptor.floating_point_range)
                if (result < range.from_value || result > range.to_value) throw std::invalid_argument(name);
        return result;
    }
    template <class Service>
    std::shared_ptr<rclcpp::Client<Service>> create_client(const std::string& name) {
        return std::make_shared<rclcpp::Client<Service>>(full(name));
    }
    /// Declares a parameter. Its value may have another type (dynamic_typing). The range applies to doubles.
    rclcpp::ParameterValue declare_parameter(const std::string& name, const rclcpp::ParameterValue& value,
                                             const rcl_interfaces::msg::ParameterDescriptor& descriptor) {
        rclcpp::Network::get().declared[name] = descriptor;
        const auto& given = rclcpp::Network::get().parameters;
        const auto found = given.find(name);
        rclcpp::ParameterValue result = found == given.end() ? value : rclcpp::ParameterValue(found->second);
        if (result.any().type() != value.any().type() && !descriptor.dynamic_typing) throw std::invalid_argument(name);
        if (result.get_type() == rclcpp::ParameterType::PARAMETER_DOUBLE)
            for (const auto& range : descriptor.floating_point_range)
                if (result.get<double>() < range.from_value || result.get<double>() > range.to_value)
                    throw std::invalid_argument(name);
        return result;
    }
    [[nodiscard]] std::shared_ptr<rclcpp::node_interfaces::NodeBaseInterface> get_node_base_interface() const {
        return std::make_shared<rclcpp::node_interfaces::NodeBaseInterface>();
    }
    [[nodiscard]] rclcpp::Clock::SharedPtr get_clock() { return std::make_shared<rclcpp::Clock>(); }
    [[nodiscard]] rclcpp::Time now() const { return {}; }
    [[nodiscard]] const char* get_name() const { return name_.c_str(); }
    [[nodiscard]] rclcpp::Logger get_logger() const { return {}; }

    const State& configure() { return move("unconfigured", "inactive", &LifecycleNode::on_configure); }
    const State& activate() { return move("inactive", "active", &LifecycleNode::on_activate); }
    const State& deactivate() { return move("active", "inactive", &LifecycleNode::on_deactivate); }
    const State& cleanup() { return move("inactive", "unconfigured", &LifecycleNode::on_cleanup); }
    const State& shutdown() { return move(state_.label(), "finalized", &LifecycleNode::on_shutdown); }
    [[nodiscard]] const State& get_current_state() const { return state_; }

    CallbackReturn on_activate(const State&) override {
        for (const auto& weak : managed_)
            if (const auto entity = weak.lock()) entity->on_activate();
        return CallbackReturn::SUCCESS;
    }
    CallbackReturn on_deactivate(const State&) override {
        for (const auto& weak : managed_)
            if (const auto entity = weak.lock()) entity->on_deactivate();
        return CallbackReturn::SUCCESS;
    }

private:
    const State& move(const std::string& from, const char* to,
                      CallbackReturn (LifecycleNode::*callback)(const State&)) {
        if (state_.label() == from && (this->*callback)(state_) == CallbackReturn::SUCCESS) state_ = State(to);
        return state_;
    }
    /// Applies the parameters that the options declare, which is only the depth here. It is an error to declare a
    /// parameter twice.
    rclcpp::QoS overridden(const std::string& topic, const std::string& kind, rclcpp::QoS qos,
                           const rclcpp::QosOverridingOptions& options) {
        rclcpp::Network& network = rclcpp::Network::get();
        if (!options.get_policy_kinds().empty()) {
            const std::string name = "qos_overrides." + full(topic) + "." + kind + ".depth";
            if (!declared_.insert(name).second) throw std::logic_error(name + " has already been declared");
            const auto given = network.parameters.find(name);
            if (given != network.parameters.end())
                qos.override_depth(static_cast<std::size_t>(std::any_cast<std::int64_t>(given->second)));
            network.policies[full(topic)] = options.get_policy_kinds().size();
        }
        network.quality[full(topic)] = qos.text();
        return qos;
    }
    /// Returns the full name of a topic. A private topic, `~/x`, is below the node's name. Other topics are in the root
    /// namespace.
    [[nodiscard]] std::string full(const std::string& topic) const {
        return topic.rfind("~/", 0) == 0 ? "/" + name_ + topic.substr(1) : topic[0] == '/' ? topic : "/" + topic;
    }

    std::string name_;
    State state_;
    std::vector<std::weak_ptr<ManagedEntity>> managed_;
    std::set<std::string> declared_;
};

}  // namespace rclcpp_lifecycle
