// What the node of a component publishes and receives: the mapping bound to the class, and topics of std_msgs for what
// it leaves out.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cpp_emit/api/class_api.hpp"
#include "cpp_emit/ros2/mapping.hpp"
#include "diagnostics/diagnostic.hpp"

namespace robochart::cpp_emit::ros2 {

struct QualityOfService {
    bool reliable = true;
    bool latched = false;  ///< transient_local
    std::uint32_t depth = 10;
    friend bool operator==(const QualityOfService&, const QualityOfService&) = default;
};

/// A publisher or subscription. What shares a topic shares it, so that the order of its messages is kept.
struct Topic {
    std::string name;
    MessageName message;
    QualityOfService quality;
    bool published = false;
    std::string member;  ///< of the node and of the messages kept in a cycle
    std::string user;    ///< the first element on it, for messages to people
};

/// How a scalar of the model reaches a field or comes from it.
enum class ScalarKind { truth, nat, integer, real, enumeration };

/// A part of a value of the model that a message carries: "a0.x", "value.position.x".
struct Scalar {
    ScalarKind kind = ScalarKind::real;
    ir::TypeId type;
    std::string place;    ///< C++, from the value's root on
    std::string reading;  ///< for people: "speed", "value.x"
};

/// A field that is filled: with a scalar or with a literal.
struct Filled {
    std::string field;  ///< C++, below the message: "linear.x"
    std::optional<Scalar> scalar;
    std::string literal;  ///< C++
    bool now = false;     ///< the time of the cycle
};

/// What is published: an operation, a sent event or a shared variable.
struct Outgoing {
    ElementKind kind = ElementKind::operation;
    std::string name;  ///< in the model
    const ApiOperation* operation = nullptr;
    const ApiEvent* event = nullptr;
    const ApiVariable* variable = nullptr;
    std::size_t topic = 0;
    std::vector<Filled> fields;
    bool array = false;   ///< several numbers in the `data` of a Float64MultiArray
    bool mapped = false;  ///< by the mapping, else on a topic of its own
};

struct Taken {
    std::string field;
    Scalar scalar;
};

/// What is received: an event or a shared variable.
struct Incoming {
    std::string name;
    const ApiEvent* event = nullptr;
    const ApiVariable* variable = nullptr;
    std::optional<ir::TypeId> type;
    std::size_t topic = 0;
    std::vector<Taken> fields;
};

/// The topic of the state of a machine.
struct StateTopic {
    const ApiMachine* machine = nullptr;
    std::size_t topic = 0;
};

struct NodePlan {
    std::string node;  ///< name of the node
    std::vector<Topic> topics;
    std::vector<Outgoing> outgoing;
    std::vector<Incoming> incoming;
    std::vector<StateTopic> states;
    std::vector<std::string> packages;  ///< of messages, parameters' too, sorted

    [[nodiscard]] bool stamped() const;  ///< some field has the time of the cycle
};

/// Binds Options::mapping, if there is one; what does not fit is reported, and what has no message.
[[nodiscard]] NodePlan plan_node(const Generation&, const ClassApi&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit::ros2
