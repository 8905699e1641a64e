// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/ros2/messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <span>

namespace robochart::cpp_emit::ros2 {

namespace {

struct FieldRow {
    std::string_view message;
    std::string_view fields;  ///< "x y z : float64, header : std_msgs/Header"
};

// The messages, with the types of their fields as in .msg files. Every type that is a message includes its package.
constexpr FieldRow rows[] = {
    {"builtin_interfaces/Time", "sec : int32, nanosec : uint32"},
    {"builtin_interfaces/Duration", "sec : int32, nanosec : uint32"},
    {"std_msgs/Bool", "data : bool"},
    {"std_msgs/Byte", "data : byte"},
    {"std_msgs/Char", "data : char"},
    {"std_msgs/ColorRGBA", "r g b a : float32"},
    {"std_msgs/Empty", ""},
    {"std_msgs/Float32", "data : float32"},
    {"std_msgs/Float64", "data : float64"},
    {"std_msgs/Float64MultiArray", "layout : std_msgs/MultiArrayLayout, data : float64[]"},
    {"std_msgs/Header", "stamp : builtin_interfaces/Time, frame_id : string"},
    {"std_msgs/Int8", "data : int8"},
    {"std_msgs/Int16", "data : int16"},
    {"std_msgs/Int32", "data : int32"},
    {"std_msgs/Int64", "data : int64"},
    {"std_msgs/String", "data : string"},
    {"std_msgs/UInt8", "data : uint8"},
    {"std_msgs/UInt16", "data : uint16"},
    {"std_msgs/UInt32", "data : uint32"},
    {"std_msgs/UInt64", "data : uint64"},
    {"std_srvs/Empty_Request", ""},
    {"std_srvs/Empty_Response", ""},
    {"std_srvs/SetBool_Request", "data : bool"},
    {"std_srvs/SetBool_Response", "success : bool, message : string"},
    {"std_srvs/Trigger_Request", ""},
    {"std_srvs/Trigger_Response", "success : bool, message : string"},
    {"geometry_msgs/Accel", "linear angular : geometry_msgs/Vector3"},
    {"geometry_msgs/AccelStamped", "header : std_msgs/Header, accel : geometry_msgs/Accel"},
    {"geometry_msgs/Point", "x y z : float64"},
    {"geometry_msgs/Point32", "x y z : float32"},
    {"geometry_msgs/PointStamped", "header : std_msgs/Header, point : geometry_msgs/Point"},
    {"geometry_msgs/Pose", "position : geometry_msgs/Point, orientation : geometry_msgs/Quaternion"},
    {"geometry_msgs/Pose2D", "x y theta : float64"},
    {"geometry_msgs/PoseStamped", "header : std_msgs/Header, pose : geometry_msgs/Pose"},
    {"geometry_msgs/PoseWithCovariance", "pose : geometry_msgs/Pose, covariance : float64[36]"},
    {"geometry_msgs/PoseWithCovarianceStamped", "header : std_msgs/Header, pose : geometry_msgs/PoseWithCovariance"},
    {"geometry_msgs/Quaternion", "x y z w : float64"},
    {"geometry_msgs/QuaternionStamped", "header : std_msgs/Header, quaternion : geometry_msgs/Quaternion"},
    {"geometry_msgs/Transform", "translation : geometry_msgs/Vector3, rotation : geometry_msgs/Quaternion"},
    {"geometry_msgs/TransformStamped",
     "header : std_msgs/Header, child_frame_id : string, transform : geometry_msgs/Transform"},
    {"geometry_msgs/Twist", "linear angular : geometry_msgs/Vector3"},
    {"geometry_msgs/TwistStamped", "header : std_msgs/Header, twist : geometry_msgs/Twist"},
    {"geometry_msgs/TwistWithCovariance", "twist : geometry_msgs/Twist, covariance : float64[36]"},
    {"geometry_msgs/TwistWithCovarianceStamped", "header : std_msgs/Header, twist : geometry_msgs/TwistWithCovariance"},
    {"geometry_msgs/Vector3", "x y z : float64"},
    {"geometry_msgs/Vector3Stamped", "header : std_msgs/Header, vector : geometry_msgs/Vector3"},
    {"geometry_msgs/Wrench", "force torque : geometry_msgs/Vector3"},
    {"geometry_msgs/WrenchStamped", "header : std_msgs/Header, wrench : geometry_msgs/Wrench"},
    {"sensor_msgs/BatteryState",
     "header : std_msgs/Header, voltage temperature current charge capacity design_capacity percentage : float32, "
     "power_supply_status power_supply_health power_supply_technology : uint8, present : bool, "
     "cell_voltage cell_temperature : float32[], location serial_number : string"},
    {"sensor_msgs/FluidPressure", "header : std_msgs/Header, fluid_pressure variance : float64"},
    {"sensor_msgs/Illuminance", "header : std_msgs/Header, illuminance variance : float64"},
    {"sensor_msgs/Imu",
     "header : std_msgs/Header, orientation : geometry_msgs/Quaternion, "
     "angular_velocity linear_acceleration : geometry_msgs/Vector3, "
     "orientation_covariance angular_velocity_covariance linear_acceleration_covariance : float64[9]"},
    {"sensor_msgs/JointState", "header : std_msgs/Header, name : string[], position velocity effort : float64[]"},
    {"sensor_msgs/Joy", "header : std_msgs/Header, axes : float32[], buttons : int32[]"},
    {"sensor_msgs/LaserScan",
     "header : std_msgs/Header, angle_min angle_max angle_increment time_increment scan_time range_min range_max : "
     "float32, ranges intensities : float32[]"},
    {"sensor_msgs/MagneticField",
     "header : std_msgs/Header, magnetic_field : geometry_msgs/Vector3, magnetic_field_covariance : float64[9]"},
    {"sensor_msgs/NavSatFix",
     "header : std_msgs/Header, status : sensor_msgs/NavSatStatus, latitude longitude altitude : float64, "
     "position_covariance : float64[9], position_covariance_type : uint8"},
    {"sensor_msgs/NavSatStatus", "status : int8, service : uint16"},
    {"sensor_msgs/Range",
     "header : std_msgs/Header, radiation_type : uint8, field_of_view min_range max_range range : float32"},
    {"sensor_msgs/RelativeHumidity", "header : std_msgs/Header, relative_humidity variance : float64"},
    {"sensor_msgs/Temperature", "header : std_msgs/Header, temperature variance : float64"},
    {"nav_msgs/Odometry",
     "header : std_msgs/Header, child_frame_id : string, pose : geometry_msgs/PoseWithCovariance, "
     "twist : geometry_msgs/TwistWithCovariance"},
    {"nav2_msgs/NavigateToPose_Feedback",
     "current_pose : geometry_msgs/PoseStamped, navigation_time estimated_time_remaining : "
     "builtin_interfaces/Duration, number_of_recoveries : int16, distance_remaining : float32"},
    {"nav2_msgs/NavigateToPose_Goal", "pose : geometry_msgs/PoseStamped, behavior_tree : string"},
    {"ackermann_msgs/AckermannDrive", "steering_angle steering_angle_velocity speed acceleration jerk : float32"},
    {"ackermann_msgs/AckermannDriveStamped", "header : std_msgs/Header, drive : ackermann_msgs/AckermannDrive"},
};

const FieldRow* row_of(std::string_view message) {
    const auto row = std::find_if(std::begin(rows), std::end(rows),
                                  [&](const FieldRow& candidate) { return candidate.message == message; });
    return row == std::end(rows) ? nullptr : row;
}

/// Returns the text before the separator, and removes it together with the separator. Returns the whole text if there
/// is no separator.
std::string_view take_until(std::string_view& text, std::string_view separator) {
    const std::size_t at = text.find(separator);
    const std::string_view head = text.substr(0, at);
    text.remove_prefix(at == std::string_view::npos ? text.size() : at + separator.size());
    return head;
}

template <class Visit>
void each_field(const FieldRow& row, const Visit& visit) {
    std::string_view rest = row.fields;
    while (!rest.empty()) {
        std::string_view group = take_until(rest, ", ");
        std::string_view names = take_until(group, " : ");
        while (!names.empty()) visit(take_until(names, " "), group);
    }
}

FieldType type_of(std::string_view written) {
    if (written.ends_with(']')) return {FieldKind::several, written};
    if (written == "bool") return {FieldKind::truth, written};
    if (written == "string") return {FieldKind::text, written};
    if (written == "builtin_interfaces/Time") return {FieldKind::time, written};
    if (written.starts_with("float")) return {FieldKind::real, written};
    if (written.find('/') != std::string_view::npos) return {FieldKind::message, written};
    return {FieldKind::whole, written};
}

}  // namespace

bool is_known(const MessageName& name) {
    return row_of(name.full_name()) != nullptr;
}

std::vector<std::string> known_messages(std::string_view package) {
    std::vector<std::string> result;
    for (const FieldRow& row : rows)
        if (row.message.substr(0, row.message.find('/')) == package)
            result.emplace_back(row.message.substr(row.message.find('/') + 1));
    return result;
}

std::vector<std::string> fields_of(std::string_view message) {
    std::vector<std::string> names;
    if (const FieldRow* const row = row_of(message))
        each_field(*row, [&](std::string_view name, std::string_view) { names.emplace_back(name); });
    return names;
}

std::vector<std::string> known_messages() {
    std::vector<std::string> result;
    for (const FieldRow& row : rows)
        if (row.message.find('_', row.message.find('/')) == std::string_view::npos) result.emplace_back(row.message);
    return result;
}

std::vector<Leaf> leaves_of(std::string_view message) {
    std::vector<Leaf> result;
    const FieldRow* const row = row_of(message);
    if (row == nullptr) return result;
    each_field(*row, [&](std::string_view name, std::string_view written) {
        if (written == "std_msgs/Header") return;
        const FieldType type = type_of(written);
        if (type.kind != FieldKind::message) {
            result.push_back({std::string(name), type});
            return;
        }
        for (const Leaf& leaf : leaves_of(written)) result.push_back({std::string(name) + "." + leaf.path, leaf.type});
    });
    return result;
}

FoundField find_field(const MessageName& message, const Path& path) {
    const FieldRow* row = row_of(message.full_name());
    FoundField found{{}, path.words.size(), row == nullptr ? "" : row->message};
    for (std::size_t i = 0; i < path.words.size(); ++i) {
        if (row == nullptr) return {{}, path.words.size(), ""};
        std::string_view written;
        each_field(*row, [&](std::string_view name, std::string_view type) {
            if (name == path.words[i].text) written = type;
        });
        found.in = row->message;
        if (written.empty()) {
            found.missing = i;
            return found;
        }
        found.type = type_of(written);
        const bool inside = found.type.kind == FieldKind::message || found.type.kind == FieldKind::time;
        row = inside ? row_of(written) : nullptr;
        if (!inside && i + 1 < path.words.size()) {
            found.missing = i + 1;
            found.in = written;
            return found;
        }
    }
    return found;
}

FieldType item_type(const FieldType& array) {
    return type_of(array.written.substr(0, array.written.find('[')));
}

std::string describe_field(const FieldType& type) {
    switch (type.kind) {
        case FieldKind::truth:
        case FieldKind::whole:
        case FieldKind::real:
        case FieldKind::text:
            return fmt::format("a {}", type.written);
        case FieldKind::time:
        case FieldKind::message:
            return fmt::format("a message {}", type.written);
        case FieldKind::several:
            return fmt::format("an array {}", type.written);
        case FieldKind::unknown:
            break;
    }
    return "of an unknown type";
}

bool holds_number(const FieldType& type, const std::string& whole) {
    if (type.kind != FieldKind::whole) return true;
    const bool is_unsigned = type.written.starts_with('u') || type.written == "byte" || type.written == "char";
    const std::size_t digits = std::min(type.written.find_first_of("0123456789"), type.written.size());
    const int bits = digits == type.written.size() ? 8 : std::atoi(std::string(type.written.substr(digits)).c_str());
    std::int64_t value = 0;
    const auto [end, code] = std::from_chars(whole.data(), whole.data() + whole.size(), value);
    if (code != std::errc()) return false;
    if (bits == 64) return !is_unsigned || value >= 0;
    const std::int64_t high = (std::int64_t{1} << (is_unsigned ? bits : bits - 1)) - 1;
    return value <= high && value >= (is_unsigned ? 0 : -high - 1);
}

}  // namespace robochart::cpp_emit::ros2
