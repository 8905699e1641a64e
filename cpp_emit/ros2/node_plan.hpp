// SPDX-License-Identifier: Apache-2.0
// Plans the messages that the node of a component publishes and receives: binds the mapping to the class, and adds
// topics of std_msgs for elements that the mapping omits.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/ros2/mapping.hpp"
#include "cpp_emit/ros2/model_values.hpp"

namespace robochart::cpp_emit::ros2 {

struct QualityOfService {
    bool reliable = true;
    bool latched = false;  ///< transient_local
    std::uint32_t depth = 10;
    friend bool operator==(const QualityOfService&, const QualityOfService&) = default;
};

/// A publisher or subscription. All elements with the same topic share it, which preserves the order of the topic's
/// messages.
struct Topic {
    std::string name;
    MessageName message;
    QualityOfService quality;
    bool published = false;
    std::string member;  ///< member of the node and of the class that sends messages
    std::string user;    ///< the first element on the topic, for messages to the user
    /// A topic, a service or an action. An operation calls a service or an action. The requests and goals are treated
    /// as published messages.
    Transport transport = Transport::topic;

    [[nodiscard]] bool is_called() const { return transport != Transport::topic; }
};

/// A field that is filled with a scalar or a literal.
struct Filled {
    std::string field;  ///< C++ path in the message: "linear.x"
    std::optional<Scalar> scalar;
    std::string literal;  ///< C++ text
    bool now = false;     ///< filled with the time of the cycle
};

/// A published element: an operation, a sent event or a shared variable.
struct Outgoing {
    ElementKind kind = ElementKind::operation;
    std::string name;  ///< name in the model
    const ApiOperation* operation = nullptr;
    const ApiEvent* event = nullptr;
    const ApiVariable* variable = nullptr;
    std::size_t topic = 0;
    std::vector<Filled> fields;
    bool array = false;    ///< true: several numbers in the `data` of a Float64MultiArray
    bool cancels = false;  ///< cancels the goal of the action instead of sending one
    bool mapped = false;   ///< true if the mapping contains the element; otherwise it has a separate topic
};

struct Taken {
    std::string field;
    Scalar scalar;
};

/// A condition on a field of a received message.
struct Test {
    std::string field;  ///< C++ path in the message
    Comparison comparison = Comparison::equal;
    std::string value;  ///< C++ text
};

/// A received element: an event or a shared variable.
struct Incoming {
    std::string name;
    const ApiEvent* event = nullptr;
    const ApiVariable* variable = nullptr;
    std::optional<ir::TypeId> type;
    std::size_t topic = 0;
    std::vector<Taken> fields;
    std::vector<Test> tests = {};
    Reply reply = Reply::answer;  ///< for a called service or action
};

/// An event that is raised if no message arrives on a topic.
struct Silence {
    const ApiEvent* event = nullptr;
    std::string seconds;  ///< C++ text
    std::size_t topic = 0;
    std::string member;  ///< member of the node: "watch_lost"
};

/// The topic on which the state of a machine is published.
struct StateTopic {
    const ApiMachine* machine = nullptr;
    std::size_t topic = 0;
};

struct NodePlan {
    std::string package;  ///< name of the package
    std::string node;     ///< name of the node
    std::string files;    ///< name of the launch file and the parameter file
    std::vector<Topic> topics;
    std::vector<Outgoing> outgoing;
    std::vector<Incoming> incoming;
    std::vector<Silence> silences;
    std::vector<Outgoing> farewells;  ///< published when the node stops
    std::vector<StateTopic> states;
    std::vector<std::string> packages;  ///< packages of messages, including those of parameters, sorted

    [[nodiscard]] bool calls(Transport) const;  ///< Whether operations call services or actions.
    [[nodiscard]] bool is_stamped() const;      ///< Whether some field contains the time of the cycle.
};

/// Makes the plan. Binds Options::mapping, if there is one. Reports items that do not fit, and elements without a
/// message.
[[nodiscard]] NodePlan plan_node(const Generation&, const ClassApi&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit::ros2
