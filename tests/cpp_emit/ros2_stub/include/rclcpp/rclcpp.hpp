// SPDX-License-Identifier: Apache-2.0
// The parts of rclcpp that generated nodes use, for tests. Messages are delivered immediately, and timers fire when the
// test requests it. ROS 2 is not in Debian 12, so the names and signatures are those of its published headers (Humble,
// Jazzy).
#pragma once

#include <any>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <future>
#include <initializer_list>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "builtin_interfaces/msg/time.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"

namespace rclcpp {

class QoS {
public:
    explicit QoS(std::size_t depth) : depth_(depth) {}

    QoS& reliable() { return reliable_ = true, *this; }
    QoS& best_effort() { return reliable_ = false, *this; }
    QoS& transient_local() { return latched_ = true, *this; }
    QoS& durability_volatile() { return latched_ = false, *this; }
    /// Applies the policy Depth of QosOverridingOptions.
    void override_depth(std::size_t depth) { depth_ = depth; }

    /// Returns the quality of service as text, for example "reliable, volatile, 10".
    [[nodiscard]] std::string text() const {
        return std::string(reliable_ ? "reliable" : "best_effort") +
               (latched_ ? ", transient_local, " : ", volatile, ") + std::to_string(depth_);
    }

private:
    std::size_t depth_;
    bool reliable_ = true;
    bool latched_ = false;
};

enum class QosPolicyKind { Depth, Durability, History, Reliability };

class QosOverridingOptions {
public:
    QosOverridingOptions() = default;
    QosOverridingOptions(std::initializer_list<QosPolicyKind> policies) : policies_(policies) {}
    [[nodiscard]] const std::vector<QosPolicyKind>& get_policy_kinds() const { return policies_; }

private:
    std::vector<QosPolicyKind> policies_;
};

/// The state that the test inspects. Topics have their full names, and timers are in the order of their creation.
struct Network {
    std::map<std::string, std::vector<std::function<void(const std::any&)>>> listeners;
    std::map<std::string, std::vector<std::any>> published;
    std::vector<std::string> order;               ///< the topic of each published message, without diagnostics
    std::map<std::string, std::string> quality;   ///< of publishers and subscriptions
    std::map<std::string, std::size_t> policies;  ///< number of policies that parameters may override
    std::map<std::string, std::any> parameters;   ///< as given on the command line
    std::map<std::string, rcl_interfaces::msg::ParameterDescriptor> declared;
    std::set<std::string> broken;  ///< topics whose publishers throw
    std::vector<std::string> log;  ///< warnings and errors
    std::int32_t seconds = 0;      ///< of the clock
    std::int64_t nanoseconds = 0;  ///< added to the seconds
    struct Timer {
        double period = 0;
        bool cancelled = false;
        std::function<void()> callback;
    };
    std::vector<std::weak_ptr<Timer>> timers;
    /// Requests to services, by name: the request, and the function that delivers its answer.
    std::map<std::string, std::vector<std::pair<std::any, std::function<void(const std::any&)>>>> requests;
    std::set<std::string> servers;                      ///< services that exist
    std::map<int, std::function<void()>> pre_shutdown;  ///< callbacks of the context, by number

    /// Ends the program.
    void shut_down() const {
        for (const auto& [number, callback] : pre_shutdown) callback();
    }
    static Network& get() {
        static Network network;
        return network;
    }
    template <class Message>
    void send(const std::string& topic, const Message& message) {
        for (const auto& listener : listeners.at(topic)) listener(message);
    }
    /// Returns the timers that exist and are running.
    [[nodiscard]] std::vector<std::shared_ptr<Timer>> running() const {
        std::vector<std::shared_ptr<Timer>> result;
        for (const auto& weak : timers)
            if (const auto timer = weak.lock(); timer && !timer->cancelled) result.push_back(timer);
        return result;
    }
    void tick() const {
        for (const auto& timer : running()) timer->callback();
    }
};

class NodeOptions {};

struct PreShutdownCallbackHandle {
    int number = 0;
};

class Context {
public:
    PreShutdownCallbackHandle add_pre_shutdown_callback(std::function<void()> callback) {
        static int last = 0;
        Network::get().pre_shutdown[++last] = std::move(callback);
        return {last};
    }
    bool remove_pre_shutdown_callback(const PreShutdownCallbackHandle& handle) {
        return Network::get().pre_shutdown.erase(handle.number) == 1;
    }
};

namespace node_interfaces {

class NodeBaseInterface {
public:
    [[nodiscard]] std::shared_ptr<Context> get_context() const { return std::make_shared<Context>(); }
};

}  // namespace node_interfaces

struct PublisherOptions {
    QosOverridingOptions qos_overriding_options;
};
struct SubscriptionOptions {
    QosOverridingOptions qos_overriding_options;
};

template <class Message>
class Subscription {
public:
    using SharedPtr = std::shared_ptr<Subscription>;

    Subscription(std::string topic, const QoS& qos) : topic_(std::move(topic)), qos_(qos) {}
    ~Subscription() { Network::get().listeners.erase(topic_); }
    [[nodiscard]] QoS get_actual_qos() const { return qos_; }

private:
    std::string topic_;
    QoS qos_;
};

template <class Message>
class Publisher {
public:
    Publisher(std::string topic, const QoS& qos) : topic_(std::move(topic)), qos_(qos) {}
    virtual ~Publisher() = default;
    [[nodiscard]] QoS get_actual_qos() const { return qos_; }
    virtual void publish(const Message& message) {
        if (Network::get().broken.count(topic_) != 0) throw std::runtime_error("the publisher is broken");
        if (topic_ != "/diagnostics") Network::get().order.push_back(topic_);
        Network::get().published[topic_].push_back(message);
    }
    [[nodiscard]] const char* get_topic_name() const { return topic_.c_str(); }
    [[nodiscard]] std::size_t get_subscription_count() const { return Network::get().listeners[topic_].size(); }

private:
    std::string topic_;
    QoS qos_;
};

/// A client of a service. The test answers its requests.
template <class Service>
class Client {
public:
    using SharedPtr = std::shared_ptr<Client>;
    using SharedFuture = std::shared_future<std::shared_ptr<typename Service::Response>>;

    explicit Client(std::string name) : name_(std::move(name)) {}
    [[nodiscard]] bool service_is_ready() const { return Network::get().servers.count(name_) != 0; }
    [[nodiscard]] const char* get_service_name() const { return name_.c_str(); }
    template <class Callback>
    void async_send_request(std::shared_ptr<typename Service::Request> request, Callback&& callback) {
        Network::get().requests[name_].emplace_back(*request, [callback](const std::any& answer) {
            std::promise<std::shared_ptr<typename Service::Response>> promise;
            promise.set_value(
                std::make_shared<typename Service::Response>(std::any_cast<const typename Service::Response&>(answer)));
            callback(SharedFuture(promise.get_future()));
        });
    }

private:
    std::string name_;
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

class Time {
public:
    Time() : nanoseconds_(Network::get().seconds * std::int64_t{1'000'000'000} + Network::get().nanoseconds) {}
    operator builtin_interfaces::msg::Time() const {
        return {static_cast<std::int32_t>(nanoseconds_ / 1'000'000'000),
                static_cast<std::uint32_t>(nanoseconds_ % 1'000'000'000)};
    }
    Duration operator-(const Time& other) const {
        return Duration::from_seconds(static_cast<double>(nanoseconds_ - other.nanoseconds_) * 1e-9);
    }

private:
    std::int64_t nanoseconds_;
};

class Logger {};

inline void init(int, const char* const*) {}
inline bool shutdown() {
    return true;
}

enum class ParameterType { PARAMETER_NOT_SET, PARAMETER_BOOL, PARAMETER_INTEGER, PARAMETER_DOUBLE, PARAMETER_STRING };

class ParameterValue {
public:
    explicit ParameterValue(double value) : ParameterValue(std::any(value)) {}
    explicit ParameterValue(std::any value) : value_(std::move(value)) {}
    [[nodiscard]] ParameterType get_type() const {
        if (value_.type() == typeid(double)) return ParameterType::PARAMETER_DOUBLE;
        return value_.type() == typeid(std::int64_t) ? ParameterType::PARAMETER_INTEGER
                                                     : ParameterType::PARAMETER_STRING;
    }
    template <class Value>
    [[nodiscard]] Value get() const {
        return std::any_cast<Value>(value_);
    }
    [[nodiscard]] const std::any& any() const { return value_; }

private:
    std::any value_;
};

class CallbackGroup {
public:
    using SharedPtr = std::shared_ptr<CallbackGroup>;
};

template <class AnyNode, class Callback>
TimerBase::SharedPtr create_timer(AnyNode, Clock::SharedPtr, Duration period, Callback&& callback,
                                  CallbackGroup::SharedPtr = nullptr) {
    auto timer = std::make_shared<Network::Timer>();
    timer->period = period.seconds();
    timer->callback = std::forward<Callback>(callback);
    Network::get().timers.push_back(timer);
    return std::make_shared<TimerBase>(timer);
}

/// Writes a line to the log, from a format and its arguments.
template <class... Arguments>
void stub_log(const Logger&, const char* format, const Arguments&... arguments) {
    char line[1000];
    if constexpr (sizeof...(arguments) == 0)
        std::snprintf(line, sizeof line, "%s", format);
    else
        std::snprintf(line, sizeof line, format, arguments...);
    Network::get().log.emplace_back(line);
    std::fprintf(stderr, "%s\n", line);
}

}  // namespace rclcpp

#define RCLCPP_INFO(logger, ...) ::rclcpp::stub_log(logger, __VA_ARGS__)
#define RCLCPP_WARN(logger, ...) ::rclcpp::stub_log(logger, __VA_ARGS__)
#define RCLCPP_ERROR(logger, ...) ::rclcpp::stub_log(logger, __VA_ARGS__)
#define RCLCPP_WARN_ONCE(logger, ...)                  \
    do {                                               \
        static bool logged = false;                    \
        if (!logged) RCLCPP_WARN(logger, __VA_ARGS__); \
        logged = true;                                 \
    } while (false)
#define RCLCPP_WARN_THROTTLE(logger, clock, milliseconds, ...) \
    do {                                                       \
        static_cast<void>(clock);                              \
        static_assert((milliseconds) > 0, "a duration");       \
        RCLCPP_WARN(logger, __VA_ARGS__);                      \
    } while (false)
#define RCLCPP_ERROR_THROTTLE(...) RCLCPP_WARN_THROTTLE(__VA_ARGS__)
