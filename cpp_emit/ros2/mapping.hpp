// SPDX-License-Identifier: Apache-2.0
// Declares a mapping as the user writes it: which messages carry the operations, events and shared variables of one
// component, and on which topics (docs/ros2.md). node_plan.hpp compares the mapping with the component.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/escape.hpp"
#include "frontend/syntax/word_reader.hpp"

namespace robochart::cpp_emit::ros2 {

using frontend::Word;

enum class ElementKind { operation, event, variable };

/// Returns "operation", "event" or "variable".
[[nodiscard]] std::string_view describe_kind(ElementKind);

/// The name of a message: `geometry_msgs/Twist`.
struct MessageName {
    std::string package;
    std::string type;
    diagnostics::Span span;

    [[nodiscard]] std::string full_name() const { return package + "/" + type; }
    friend bool operator==(const MessageName& a, const MessageName& b) {
        return a.package == b.package && a.type == b.type;
    }
};

/// A path of names: `a.b.c`.
struct Path {
    std::vector<Word> words;

    [[nodiscard]] std::string path_text() const;
    [[nodiscard]] diagnostics::Span span() const;
};

/// The text after `=`.
struct Source {
    enum class Kind { path, whole, decimal, truth, text };
    Kind kind = Kind::path;
    Path path;                      ///< a name in the model or in the message; also `true`, `false`, `now`
    std::string number;             ///< as C++ text, including its sign
    diagnostics::ForeignText text;  ///< characters
    diagnostics::Span span;
};

/// `capacity 360` after the name of an array: the greatest number of items of the list that receives the array.
struct ListCapacity {
    std::size_t items = 0;
    diagnostics::Span span;
};

/// An assignment to a field or value: `linear.x = speed`, `value = range`, `value = ranges capacity 360`.
struct Assignment {
    Path target;
    Source source;
    std::optional<ListCapacity> capacity;  ///< for received arrays only
};

enum class Comparison { equal, not_equal, less, less_equal, greater, greater_equal };

/// `when percentage < 0.2`: the element receives only messages whose field satisfies this condition.
struct Condition {
    Path field;
    Comparison comparison = Comparison::equal;
    Source value;  ///< a number, a truth value or a text
};

/// The quality of service of messages. Options that are not given have the default of their kind.
struct Delivery {
    std::optional<bool> reliable;
    std::optional<bool> latched;  ///< transient_local: late subscribers get the last messages
    std::optional<std::uint32_t> depth;
};

/// How the values of an element are transported. The comments show examples.
enum class Transport {
    topic,
    service,  ///< `call operation dock as std_srvs/Trigger on "dock"`
    action,   ///< `call operation goTo as action nav2_msgs/NavigateToPose on "navigate_to_pose" { ... }`
    reply,    ///< `receive event docked as answer of dock when success == true`
    cancel,   ///< `call operation stop as cancel of goTo`
};

/// What a called service or action sends back.
enum class Reply {
    answer,  ///< the answer of a service
    accepted,
    rejected,
    feedback,
    succeeded,
    aborted,
    canceled,
};

/// Returns "answer", "accepted" or another word of the notation.
[[nodiscard]] std::string_view describe_reply(Reply);
/// Returns whether a call has ended with this reply.
[[nodiscard]] bool ends_call(Reply);

/// An item, such as `publish operation move as geometry_msgs/Twist on "cmd_vel" with reliable { linear.x = speed }`.
struct Item {
    bool published = false;
    Transport transport = Transport::topic;
    Reply reply = Reply::answer;
    ElementKind kind = ElementKind::operation;
    Word element;
    MessageName message;  ///< message, service or action; none for replies and cancellations
    Word topic;  ///< or name of the service or action; for replies and cancellations, the operation that calls it
    Delivery delivery;
    std::vector<Condition> conditions;  ///< only for received elements; all must be true
    std::vector<Assignment> assignments;
};

/// The item `receive event lost as deadline 0.5 on "scan"`: the event is raised if no message arrives on the topic for
/// this time. With `receive event lost as deadline 5 of dock`, the event is raised if the service or action that the
/// operation `dock` calls does not answer within this time.
struct Deadline {
    Word event;
    std::string seconds;  ///< as C++ text
    Transport transport = Transport::topic;
    Word topic;  ///< or the operation, for `of`
};

/// The item `parameter SPEED as "max_speed"`: the name of the ROS parameter of a constant.
struct ParameterName {
    Word constant;  ///< `SPEED` or `P::M::SPEED`
    Word parameter;
};

struct Mapping {
    Word component;
    std::vector<Item> items;
    std::vector<Deadline> deadlines;
    std::vector<ParameterName> parameters;
    /// The items `on deactivate publish geometry_msgs/Twist on "cmd_vel" { ... }`. Their elements have no names.
    std::vector<Item> farewells;
};

}  // namespace robochart::cpp_emit::ros2
