// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/mapping_draft.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "cpp_emit/ros2/elements.hpp"
#include "cpp_emit/ros2/messages.hpp"
#include "cpp_emit/ros2/ros_names.hpp"

namespace robochart::cpp_emit::ros2 {

namespace {

/// A proposal for an element: a message, with the assignments that fill it or take its values.
struct Proposal {
    std::string message;
    std::string topic;
    std::vector<std::string> assignments;
    std::string reason;  ///< why this message was chosen, for a comment
};

/// A sensor whose readings have common names.
struct SensorName {
    std::string_view word;  ///< a word in the name of the element
    bool list = false;      ///< the value is a sequence
    std::string_view message, field, topic;
};

constexpr SensorName sensors[] = {
    {"scan", true, "sensor_msgs/LaserScan", "ranges", "scan"},
    {"laser", true, "sensor_msgs/LaserScan", "ranges", "scan"},
    {"distance", false, "sensor_msgs/Range", "range", "range"},
    {"range", false, "sensor_msgs/Range", "range", "range"},
    {"battery", false, "sensor_msgs/BatteryState", "percentage", "battery_state"},
    {"temperature", false, "sensor_msgs/Temperature", "temperature", "temperature"},
    {"humidity", false, "sensor_msgs/RelativeHumidity", "relative_humidity", "humidity"},
    {"pressure", false, "sensor_msgs/FluidPressure", "fluid_pressure", "pressure"},
};

constexpr std::string_view forward_names[] = {"lv", "v", "vx", "lin", "linear", "speed", "velocity", "forward"};
constexpr std::string_view turn_names[] = {"av", "w", "wz", "ang", "angular", "omega", "turn", "rotation"};

std::string lower_case(std::string_view text) {
    std::string result(text);
    std::ranges::transform(result, result.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return result;
}

bool is_one_of(const std::string& name, std::span<const std::string_view> names) {
    return std::ranges::find(names, lower_case(name)) != names.end();
}

class DraftWriter {
public:
    DraftWriter(const Generation& generation, const ClassApi& api) : generation_(generation), api_(api) {}

    std::string write() {
        text_ = fmt::format(
            "// A first mapping of {0} to ROS 2. Compare each message, topic and field with the nodes of your robot.\n"
            "ros2 for {0} {{\n",
            generation_.component.name);
        for (const Element& element : elements_of(generation_, api_)) write_element(element);
        return text_ + "}\n";
    }

private:
    void write_element(const Element& element);
    [[nodiscard]] std::optional<Proposal> proposal_for(const Element& element) const;
    [[nodiscard]] std::optional<Proposal> velocity(const Element& element) const;
    [[nodiscard]] std::optional<Proposal> shape(const Element& element, const ModelValue& value) const;
    [[nodiscard]] std::optional<Proposal> sensor(const Element& element, const Scalar& scalar) const;
    [[nodiscard]] static Proposal plain(const Element& element, const std::vector<Scalar>& scalars);
    [[nodiscard]] std::string free_topic(const Element& element, const Proposal& proposal);
    [[nodiscard]] static std::string assignment(const Element& element, const std::string& field,
                                                const std::string& reading) {
        return element.published ? fmt::format("{} = {}", field, reading) : fmt::format("{} = {}", reading, field);
    }

    const Generation& generation_;
    const ClassApi& api_;
    std::string text_;
    std::map<std::string, std::string> topics_;  ///< by topic: the published message; "" if the node receives
};

/// Returns the message for `move(lv, av)`: at most one number for each of the two velocities of a robot on wheels.
std::optional<Proposal> DraftWriter::velocity(const Element& element) const {
    Proposal result{"geometry_msgs/Twist", "cmd_vel", {}, "by the names of the parameters"};
    bool forward = false, turn = false;
    for (const ModelValue& value : values_of(element)) {
        if (generation_.system.type(value.type).kind != ir::TypeKind::real) return std::nullopt;
        const bool turns = is_one_of(value.name, turn_names);
        bool& given = turns ? turn : forward;
        if (given || (!turns && !is_one_of(value.name, forward_names))) return std::nullopt;
        given = true;
        result.assignments.push_back(assignment(element, turns ? "angular.z" : "linear.x", value.name));
    }
    return forward || turn ? std::optional(result) : std::nullopt;
}

/// Returns a message with the fields of a record: all of them or, if message and record have the same name, those that
/// the record has.
std::optional<Proposal> DraftWriter::shape(const Element& element, const ModelValue& value) const {
    const ir::Type& type = generation_.system.type(value.type);
    std::vector<Scalar> scalars;
    if (type.kind != ir::TypeKind::record || !scalars_of(generation_.system, value, scalars)) return std::nullopt;
    std::optional<Proposal> best;
    for (const std::string& message : known_messages()) {
        const std::vector<Leaf> leaves = leaves_of(message);
        const bool same_name = lower_case(message.substr(message.find('/') + 1)) == lower_case(type.name);
        if (!same_name && leaves.size() != scalars.size()) continue;
        Proposal proposal{message, topic_part(element.name, NameStyle::snake), {}, "same fields"};
        for (const Scalar& scalar : scalars) {
            const std::string path = scalar.reading.substr(value.name.size() + 1);
            const auto leaf = std::ranges::find(leaves, path, &Leaf::path);
            if (leaf == leaves.end() || !fits_field(leaf->type, scalar, element.published)) break;
            proposal.assignments.push_back(assignment(element, path, scalar.reading));
        }
        if (proposal.assignments.size() < scalars.size()) continue;
        if (message == "geometry_msgs/Twist") proposal.topic = "cmd_vel";
        if (same_name) return proposal;
        const bool preferred = message == "geometry_msgs/Twist";  // and not Accel, which has the same fields
        if (!best || preferred) best = std::move(proposal);
    }
    return best;
}

std::optional<Proposal> DraftWriter::sensor(const Element& element, const Scalar& scalar) const {
    const std::string name = lower_case(element.name);
    for (const SensorName& known : sensors) {
        if (known.list != scalar.list || name.find(known.word) == std::string::npos) continue;
        const auto leaves = leaves_of(known.message);
        const auto leaf = std::ranges::find(leaves, known.field, &Leaf::path);
        if (leaf == leaves.end() || !fits_field(leaf->type, scalar, false)) continue;
        return Proposal{std::string(known.message),
                        std::string(known.topic),
                        {assignment(element, std::string(known.field), scalar.reading)},
                        "by the name"};
    }
    return std::nullopt;
}

/// Returns a message of std_msgs with one number, truth value or list, or without a value.
Proposal DraftWriter::plain(const Element& element, const std::vector<Scalar>& scalars) {
    Proposal result{"std_msgs/Empty", topic_part(element.name, NameStyle::snake), {}, ""};
    if (scalars.empty()) return result;
    const Scalar& scalar = scalars.front();
    result.message = "std_msgs/" + (scalar.list ? "Float64MultiArray" : message_of(scalar.kind));
    result.assignments.push_back(assignment(element, "data", scalar.reading));
    return result;
}

/// Returns the proposal for an element, or no value if no message of the table carries the element's values.
std::optional<Proposal> DraftWriter::proposal_for(const Element& element) const {
    const std::vector<ModelValue> values = values_of(element);
    if (element.published && element.kind == ElementKind::operation)
        if (const auto found = velocity(element)) return found;
    if (values.size() == 1)
        if (const auto found = shape(element, values.front())) return found;
    std::vector<Scalar> scalars;
    for (const ModelValue& value : values)
        if (!scalars_of(generation_.system, value, scalars)) return std::nullopt;
    if (scalars.size() == 1 && !element.published)
        if (const auto found = sensor(element, scalars.front())) return found;
    const bool record = std::ranges::any_of(
        scalars, [](const Scalar& scalar) { return scalar.reading.find('.') != std::string::npos; });
    if (scalars.size() > 1 || record) return std::nullopt;
    const bool carried =
        scalars.empty() || !scalars.front().list || (!element.published && scalars.front().kind == ScalarKind::real);
    return carried ? std::optional(plain(element, scalars)) : std::nullopt;
}

/// Returns the topic of the proposal, or another one if another element has it. Published elements with the same
/// message share a topic.
std::string DraftWriter::free_topic(const Element& element, const Proposal& proposal) {
    const auto is_taken = [&](const std::string& topic) {
        const auto known = topics_.find(topic);
        return known != topics_.end() && !(element.published && known->second == proposal.message);
    };
    const std::string own = topic_part(element.name, NameStyle::snake);
    std::string topic = proposal.topic;
    for (int i = 1; is_taken(topic); ++i) topic = i == 1 ? own : fmt::format("{}_{}", own, i);
    topics_.emplace(topic, element.published ? proposal.message : "");
    return topic;
}

void DraftWriter::write_element(const Element& element) {
    const std::string item =
        fmt::format("{} {} {}", element.published ? "publish" : "receive", describe_kind(element.kind), element.name);
    const auto proposal = proposal_for(element);
    if (!proposal) {
        text_ += fmt::format("\t// {} as PACKAGE/TYPE on \"{}\": no known message has its values\n", item,
                             topic_part(element.name, NameStyle::snake));
        return;
    }
    text_ += fmt::format("\t{} as {} on \"{}\"", item, proposal->message, free_topic(element, *proposal));
    if (!proposal->assignments.empty()) text_ += fmt::format(" {{ {} }}", fmt::join(proposal->assignments, " "));
    if (!proposal->reason.empty()) text_ += "  // " + proposal->reason;
    text_ += "\n";
}

}  // namespace

std::string mapping_draft(const Generation& generation, const ClassApi& api) {
    return DraftWriter(generation, api).write();
}

}  // namespace robochart::cpp_emit::ros2
