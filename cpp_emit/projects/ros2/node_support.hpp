// Shared by the ROS 2 nodes of generated controllers. Converts values to and from fields of messages, and handles
// parameters and quality of service. Written by robochart-verify.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <diagnostic_msgs/msg/diagnostic_array.hpp>
#include <rcl_interfaces/msg/parameter_descriptor.hpp>
#include <rclcpp/rclcpp.hpp>

namespace robochart::ros2 {

/// Stores a value in a field. Returns false and leaves the field unchanged if its type cannot represent the value.
template <class Field, class Value>
[[nodiscard]] bool put(Field& field, Value value) noexcept {
    static_assert(std::is_arithmetic_v<Field>, "the field is no number and no truth value");
    static_assert(std::is_same_v<Field, bool> == std::is_same_v<Value, bool>, "truth values go with bool alone");
    if constexpr (std::is_same_v<Field, bool>) {
        field = value;
    } else if constexpr (std::is_integral_v<Field>) {
        static_assert(std::is_integral_v<Value>, "a real number goes into a field of real numbers");
        const auto wide = static_cast<std::int64_t>(value);
        if (wide < 0) {
            if (std::is_unsigned_v<Field> || wide < static_cast<std::int64_t>(std::numeric_limits<Field>::min()))
                return false;
        } else if (static_cast<std::uint64_t>(wide) > static_cast<std::uint64_t>(std::numeric_limits<Field>::max())) {
            return false;
        }
        field = static_cast<Field>(wide);
    } else {
        const auto wide = static_cast<double>(value);
        if (std::abs(wide) > static_cast<double>(std::numeric_limits<Field>::max())) return false;
        field = static_cast<Field>(wide);
    }
    return true;
}

/// Reads a value from a field. Returns false if it is not a value of the model: a real number must be finite.
template <class Field>
[[nodiscard]] bool take(double& value, const Field& field) noexcept {
    static_assert(std::is_arithmetic_v<Field> && !std::is_same_v<Field, bool>, "the field is no number");
    value = static_cast<double>(field);
    return std::isfinite(value);
}

template <class Field>
[[nodiscard]] bool take(bool& value, const Field& field) noexcept {
    static_assert(std::is_same_v<Field, bool>, "the field is no truth value");
    value = field;
    return true;
}

template <class Field>
[[nodiscard]] bool take(std::int64_t& value, const Field& field) noexcept {
    static_assert(std::is_integral_v<Field> && !std::is_same_v<Field, bool>, "the field is no whole number");
    if constexpr (std::is_unsigned_v<Field>)
        if (static_cast<std::uint64_t>(field) > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
            return false;
    value = static_cast<std::int64_t>(field);
    return true;
}

/// Reads a natural number.
template <class Field>
[[nodiscard]] bool take_nat(std::int64_t& value, const Field& field) noexcept {
    return take(value, field) && value >= 0;
}

/// Reads a literal of an enumeration by its number.
template <class Literal, class Field>
[[nodiscard]] bool take_literal(Literal& value, const Field& field, std::int64_t literals) noexcept {
    std::int64_t number = 0;
    if (!take_nat(number, field) || number >= literals) return false;
    value = static_cast<Literal>(number);
    return true;
}

/// Fills a list with the items of an array; `take_item` converts each item. Returns false if the array has more items
/// than the list can have, or if an item is not a value of the model.
template <class List, class Array, class TakeItem>
[[nodiscard]] bool take_list(List& list, const Array& array, TakeItem take_item) noexcept {
    list = List{};
    if (array.size() > List::most) return false;
    for (const auto& entry : array) {
        typename List::value_type item{};
        if (!take_item(item, entry)) return false;
        list.append(item);
    }
    return true;
}

enum class Comparison { equal, not_equal, less, less_equal, greater, greater_equal };

/// Every comparison with NaN is false, except not_equal.
template <class Value>
[[nodiscard]] bool compare(const Value& a, Comparison comparison, const Value& b) noexcept {
    switch (comparison) {
        case Comparison::equal:
            return a <= b && a >= b;
        case Comparison::not_equal:
            return !(a <= b && a >= b);
        case Comparison::less:
            return a < b;
        case Comparison::less_equal:
            return a <= b;
        case Comparison::greater:
            return a > b;
        case Comparison::greater_equal:
            break;
    }
    return a >= b;
}

/// Returns whether a field satisfies a comparison with a value of a mapping. A real number is compared with the
/// precision of the field.
template <class Field, class Value>
[[nodiscard]] bool holds(const Field& field, Comparison comparison, const Value& value) noexcept {
    if constexpr (std::is_same_v<Field, bool> || std::is_same_v<Value, bool>) {
        static_assert(std::is_same_v<Field, Value>, "truth values go with bool alone");
        return (field == value) == (comparison == Comparison::equal);
    } else if constexpr (std::is_floating_point_v<Field>) {
        return compare(field, comparison, static_cast<Field>(value));
    } else if constexpr (std::is_integral_v<Field> && std::is_integral_v<Value>) {
        if constexpr (std::is_unsigned_v<Field>)
            if (static_cast<std::uint64_t>(field) > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
                return compare(1, comparison, 0);  // greater than every value
        return compare(static_cast<std::int64_t>(field), comparison, static_cast<std::int64_t>(value));
    } else if constexpr (std::is_integral_v<Field>) {
        return compare(static_cast<double>(field), comparison, static_cast<double>(value));
    } else {
        return (field == value) == (comparison == Comparison::equal);
    }
}

/// Calls the function, if there is one.
template <class Function, class Value>
void send(const Function& function, const Value& value) {
    if (function) function(value);
}

/// Tracks the times of control cycles: pauses, and cycles that did not take place because an earlier one took too long.
class Pace {
public:
    void pause(const ::rclcpp::Time& now) {
        paused_ = now;
        last_.reset();
    }
    /// Ends a pause. Returns the seconds since the pause began, or 0 without a pause.
    [[nodiscard]] double resume(const ::rclcpp::Time& now) {
        const double seconds = paused_ ? (now - *paused_).seconds() : 0;
        paused_.reset();
        return seconds;
    }
    /// Begins a cycle. Returns the number of cycles that should have begun since the last one.
    [[nodiscard]] std::int64_t count_lost(const ::rclcpp::Time& now, double period) {
        const double elapsed = last_ ? (now - *last_).seconds() : 0;
        last_ = now;
        return elapsed > 1.5 * period ? std::llround(elapsed / period) - 1 : 0;
    }

private:
    std::optional<::rclcpp::Time> last_, paused_;
};

/// Reports on /diagnostics how the node is doing: once a second, and when its controller stops.
class Health {
public:
    using Status = ::diagnostic_msgs::msg::DiagnosticStatus;
    using Facts = std::vector<std::pair<const char*, std::string>>;

    void count_cycle(std::int64_t lost) {
        ++cycles_;
        lost_ += lost;
        late_ = late_ || lost > 0;
    }
    [[nodiscard]] bool is_due(const ::rclcpp::Time& now) const {
        if (!last_) return true;
        const double elapsed = (now - *last_).seconds();
        return elapsed < 0 || elapsed >= 1;  // the clock of a simulation may go back
    }
    /// Returns a report of the cycles since the last report.
    [[nodiscard]] ::diagnostic_msgs::msg::DiagnosticArray report_cycles(const ::rclcpp::Time& now, const char* node,
                                                                        const Facts& facts) {
        const bool late = std::exchange(late_, false);
        return report(now, node, late ? Status::WARN : Status::OK, late ? "lost control cycles" : "active", facts);
    }
    [[nodiscard]] ::diagnostic_msgs::msg::DiagnosticArray report(const ::rclcpp::Time& now, const char* node,
                                                                 unsigned char level, const char* message,
                                                                 const Facts& facts) {
        last_ = now;
        ::diagnostic_msgs::msg::DiagnosticArray array;
        array.header.stamp = now;
        array.status.resize(1);
        Status& status = array.status.front();
        status.level = level;
        status.name = std::string(node) + ": controller";
        status.message = message;
        status.hardware_id = "none";
        const auto add = [&status](const char* key, const std::string& value) {
            status.values.emplace_back();
            status.values.back().key = key;
            status.values.back().value = value;
        };
        for (const auto& [key, value] : facts) add(key, value);
        add("cycles", std::to_string(cycles_));
        add("lost cycles", std::to_string(lost_));
        return array;
    }

private:
    std::optional<::rclcpp::Time> last_;
    std::int64_t cycles_ = 0;
    std::int64_t lost_ = 0;
    bool late_ = false;  ///< cycles have been lost since the last report
};

/// Watches a topic on which a message must arrive from time to time.
class Watch {
public:
    void hear(const ::rclcpp::Time& now) {
        last_ = now;
        silent_ = false;
    }
    /// Stops the watch: no message is expected.
    void rest() { last_.reset(); }
    /// Returns whether no message has arrived for this time. The result is true only once for each silence.
    [[nodiscard]] bool is_due(const ::rclcpp::Time& now, double seconds) {
        if (silent_ || !last_ || (now - *last_).seconds() < seconds) return false;
        silent_ = true;
        return true;
    }

private:
    std::optional<::rclcpp::Time> last_;
    bool silent_ = false;
};

/// Describes a parameter that is set when the node starts, and cannot be set later.
inline ::rcl_interfaces::msg::ParameterDescriptor at_start(const std::string& description) {
    ::rcl_interfaces::msg::ParameterDescriptor descriptor;
    descriptor.description = description;
    descriptor.read_only = true;
    return descriptor;
}

inline ::rcl_interfaces::msg::ParameterDescriptor at_start(const std::string& description, double low, double high) {
    ::rcl_interfaces::msg::ParameterDescriptor descriptor = at_start(description);
    descriptor.floating_point_range.resize(1);
    descriptor.floating_point_range[0].from_value = low;
    descriptor.floating_point_range[0].to_value = high;
    return descriptor;
}

/// Declares a parameter with a real number. A whole number, such as `cycle: 1` in a file of parameters, is accepted,
/// too. Other values give NaN.
template <class Node>
double declare_number(Node& node, const std::string& name, double usual,
                      ::rcl_interfaces::msg::ParameterDescriptor descriptor) {
    descriptor.dynamic_typing = true;
    const ::rclcpp::ParameterValue value = node.declare_parameter(name, ::rclcpp::ParameterValue(usual), descriptor);
    switch (value.get_type()) {
        case ::rclcpp::ParameterType::PARAMETER_DOUBLE:
            return value.get<double>();
        case ::rclcpp::ParameterType::PARAMETER_INTEGER:
            return static_cast<double>(value.get<std::int64_t>());
        default:
            return std::numeric_limits<double>::quiet_NaN();
    }
}

/// The quality of service of a topic. Parameters may override it (qos_overrides.TOPIC). They are declared when the node
/// is configured for the first time. Afterwards the quality does not change.
class Quality {
public:
    explicit Quality(const ::rclcpp::QoS& usual) : quality_(usual) {}

    [[nodiscard]] const ::rclcpp::QoS& value() const { return quality_; }
    template <class Options>
    [[nodiscard]] Options options() const {
        Options options;
        if (!settled_)
            options.qos_overriding_options = ::rclcpp::QosOverridingOptions{
                ::rclcpp::QosPolicyKind::Depth, ::rclcpp::QosPolicyKind::Durability, ::rclcpp::QosPolicyKind::History,
                ::rclcpp::QosPolicyKind::Reliability};
        return options;
    }
    /// Stores the actual quality of the publisher or subscription.
    void settle(const ::rclcpp::QoS& actual) {
        quality_ = actual;
        settled_ = true;
    }

private:
    ::rclcpp::QoS quality_;
    bool settled_ = false;
};

}  // namespace robochart::ros2
