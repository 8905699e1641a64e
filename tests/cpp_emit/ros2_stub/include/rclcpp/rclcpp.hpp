// As much of rclcpp as generated nodes use, for tests: messages are delivered at once, timers fire when they are asked
// to. ROS 2 is not in Debian 12; the names and signatures are those of its public interface.
#pragma once

#include <any>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rclcpp {

/// What the test sees: topics by their full names, timers in the order of their making.
struct Network {
    std::map<std::string, std::vector<std::function<void(const std::any&)>>> listeners;
    std::map<std::string, std::vector<std::any>> published;
    std::map<std::string, std::any> parameters;  ///< as given on the command line
    struct Timer {
        double period = 0;
        bool cancelled = false;
        std::function<void()> callback;
    };
    std::vector<std::shared_ptr<Timer>> timers;

    static Network& get() {
        static Network network;
        return network;
    }
    template <class Message>
    void send(const std::string& topic, const Message& message) {
        for (const auto& listener : listeners.at(topic)) listener(message);
    }
    void tick() const {
        for (const auto& timer : timers)
            if (!timer->cancelled) timer->callback();
    }
};

class NodeOptions {};
class QoS {
public:
    explicit QoS(std::size_t) {}
};

enum class CallbackGroupType { MutuallyExclusive, Reentrant };
class CallbackGroup {
public:
    using SharedPtr = std::shared_ptr<CallbackGroup>;
};

struct SubscriptionOptions {
    CallbackGroup::SharedPtr callback_group;
};

template <class Message>
class Subscription {
public:
    using SharedPtr = std::shared_ptr<Subscription>;
};

template <class Message>
class Publisher {
public:
    using SharedPtr = std::shared_ptr<Publisher>;

    explicit Publisher(std::string topic) : topic_(std::move(topic)) {}
    void publish(const Message& message) { Network::get().published[topic_].push_back(message); }

private:
    std::string topic_;
};

class TimerBase {
public:
    using SharedPtr = std::shared_ptr<TimerBase>;

    explicit TimerBase(std::shared_ptr<Network::Timer> timer) : timer_(std::move(timer)) {}
    void cancel() { timer_->cancelled = true; }

private:
    std::shared_ptr<Network::Timer> timer_;
};

class Clock {
public:
    using SharedPtr = std::shared_ptr<Clock>;
};

class Duration {
public:
    static Duration from_seconds(double seconds) { return Duration(seconds); }
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    explicit Duration(double seconds) : seconds_(seconds) {}
    double seconds_;
};

class Logger {};

class Node {
public:
    explicit Node(std::string name, const NodeOptions& = NodeOptions()) : name_(std::move(name)) {}
    virtual ~Node() = default;

    CallbackGroup::SharedPtr create_callback_group(CallbackGroupType) { return std::make_shared<CallbackGroup>(); }
    template <class Message, class Callback>
    typename Subscription<Message>::SharedPtr create_subscription(const std::string& topic, const QoS&,
                                                                  Callback callback, const SubscriptionOptions&) {
        Network::get().listeners[full(topic)].push_back(
            [callback](const std::any& message) { callback(std::any_cast<const Message&>(message)); });
        return std::make_shared<Subscription<Message>>();
    }
    template <class Message>
    typename Publisher<Message>::SharedPtr create_publisher(const std::string& topic, const QoS&) {
        return std::make_shared<Publisher<Message>>(full(topic));
    }
    template <class Value>
    Value declare_parameter(const std::string& name, const Value& value) {
        const auto& given = Network::get().parameters;
        const auto found = given.find(name);
        return found == given.end() ? value : std::any_cast<Value>(found->second);
    }
    Clock::SharedPtr get_clock() { return std::make_shared<Clock>(); }
    [[nodiscard]] Logger get_logger() const { return {}; }

private:
    /// A private topic, `~/x`, is below the node's name.
    [[nodiscard]] std::string full(const std::string& topic) const {
        return topic.rfind("~/", 0) == 0 ? "/" + name_ + topic.substr(1) : topic;
    }

    std::string name_;
};

template <class AnyNode, class Callback>
TimerBase::SharedPtr create_timer(AnyNode, const Clock::SharedPtr&, Duration period, Callback callback,
                                  const CallbackGroup::SharedPtr&) {
    auto timer = std::make_shared<Network::Timer>();
    timer->period = period.seconds();
    timer->callback = callback;
    Network::get().timers.push_back(timer);
    return std::make_shared<TimerBase>(timer);
}

}  // namespace rclcpp

#define ROBOCHART_STUB_LOG(logger, ...)    \
    do {                                   \
        static_cast<void>(logger);         \
        std::fprintf(stderr, __VA_ARGS__); \
        std::fputc('\n', stderr);          \
    } while (false)
#define RCLCPP_INFO(logger, ...) ROBOCHART_STUB_LOG(logger, __VA_ARGS__)
#define RCLCPP_WARN(logger, ...) ROBOCHART_STUB_LOG(logger, __VA_ARGS__)
#define RCLCPP_ERROR(logger, ...) ROBOCHART_STUB_LOG(logger, __VA_ARGS__)
