// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/ros_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "cpp_emit/plan/names.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

bool is_small(char c) {
    return c >= 'a' && c <= 'z';
}
bool is_large(char c) {
    return c >= 'A' && c <= 'Z';
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

/// Rejects names that do not consist of a letter followed by letters, digits and single underscores, and names with an
/// underscore at the end (REP 149, rosidl).
std::string wrong_small_name(std::string_view name) {
    if (name.empty() || !is_small(name.front())) return "it must begin with a small letter";
    for (const char c : name)
        if (!is_small(c) && !is_digit(c) && c != '_')
            return "it may contain only small letters, digits and underscores";
    if (name.find("__") != std::string_view::npos || name.back() == '_')
        return "it must not contain a double underscore or end with an underscore";
    return "";
}

/// Returns whether the topic belongs to ROS itself, so that a node must not publish on it.
bool is_ros_topic(std::string_view topic) {
    static constexpr std::array names = {"rosout", "parameter_events", "clock", "diagnostics", "~/transition_event"};
    if (topic.starts_with('/')) topic.remove_prefix(1);
    return std::ranges::find(names, topic) != names.end();
}

constexpr std::size_t longest_name = 200;  // RMW allows 247 for the whole topic, including the namespace

}  // namespace

std::string wrong_package(std::string_view name) {
    if (name.size() > longest_name) return "it is too long";
    if (const std::string wrong = wrong_small_name(name); !wrong.empty()) return wrong;
    return reserved_in_cpp(name) ? "it is reserved in C++" : "";
}

std::string wrong_message(std::string_view name) {
    if (name.size() > longest_name) return "it is too long";
    if (name.empty() || !is_large(name.front())) return "it must begin with a capital letter";
    for (const char c : name)
        if (!is_small(c) && !is_large(c) && !is_digit(c)) return "it may contain only letters and digits";
    return reserved_in_cpp(name) ? "it is reserved in C++" : "";
}

std::string wrong_field(std::string_view name) {
    if (name.size() > longest_name) return "it is too long";
    if (const std::string wrong = wrong_small_name(name); !wrong.empty()) return wrong;
    return reserved_in_cpp(name) ? "it is reserved in C++" : "";
}

std::string wrong_topic(std::string_view name) {
    if (name.empty()) return "it is empty";
    if (name.size() > longest_name) return "it is too long";
    if (is_ros_topic(name)) return "it is a topic of ROS itself";
    std::string_view rest = name;
    if (rest.starts_with("~/"))
        rest.remove_prefix(2);
    else if (rest.starts_with('/'))
        rest.remove_prefix(1);
    if (rest.empty() || rest.back() == '/') return "it must end with a name";
    bool fresh = true;
    for (const char c : rest) {
        if (fresh && is_digit(c)) return "no part may begin with a digit";
        if (fresh && c == '/') return "it must not contain an empty part";
        if (!is_small(c) && !is_large(c) && !is_digit(c) && c != '_' && c != '/')
            return "it may contain only letters, digits, underscores and /, and ~/ at the beginning";
        fresh = c == '/';
    }
    return rest.find("__") != std::string_view::npos ? "it must not contain a double underscore" : "";
}

std::string wrong_parameter(std::string_view name) {
    static constexpr std::array names = {"cycle", "cycle_scale", "log", "use_sim_time"};
    if (name.size() > longest_name) return "it is too long";
    if (std::ranges::find(names, name) != names.end() || name.starts_with("qos_overrides."))
        return "it is a parameter of the node itself";
    bool fresh = true;
    for (const char c : name) {
        if (fresh && !is_small(c) && !is_large(c)) return "each part must begin with a letter";
        if (!is_small(c) && !is_large(c) && !is_digit(c) && c != '_' && c != '.')
            return "it may contain only letters, digits, underscores, and dots between its parts";
        fresh = c == '.';
    }
    return fresh ? "it must end with a name" : "";
}

std::string topic_part(std::string_view name, NameStyle style) {
    std::string result;
    const std::string identifier = to_identifier(name);
    for (const char c : style == NameStyle::snake ? header_of_message(identifier) : identifier)
        if (c != '_' || (!result.empty() && result.back() != '_')) result += c;
    while (!result.empty() && result.back() == '_') result.pop_back();
    return result.empty() || is_digit(result.front()) ? "x" + result : result;
}

std::string header_of_message(std::string_view type) {
    // The name is split before a capital letter followed by a small letter, and between a small letter or digit
    // and a capital letter. This is the rule of rosidl, and snake_case for all names here.
    std::string result;
    for (std::size_t i = 0; i < type.size(); ++i) {
        const bool word = is_large(type[i]) && i > 0 && i + 1 < type.size() && is_small(type[i + 1]);
        const bool behind = is_large(type[i]) && i > 0 && !is_large(type[i - 1]);
        if (word || behind) result += '_';
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(type[i])));
    }
    return result;
}

std::string package_name(std::string_view component, const std::set<std::string>& others) {
    std::string result;
    for (std::size_t i = 0; i < component.size(); ++i) {
        const bool word = is_large(component[i]) && i > 0 && is_small(component[i - 1]);
        if (word && result.back() != '_') result += '_';
        if (component[i] == '_' && (result.empty() || result.back() == '_')) continue;
        result += static_cast<char>(std::tolower(static_cast<unsigned char>(component[i])));
    }
    while (!result.empty() && result.back() == '_') result.pop_back();
    if (result.size() < 2 || !is_small(result.front())) result = "robot_" + result;
    while (result.back() == '_') result.pop_back();
    return others.contains(result) ? result + "_controller" : result;
}

}  // namespace robochart::cpp_emit::ros2
