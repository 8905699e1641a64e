// A mapping: which messages carry the operations, events and shared variables of one component, and on which topics
// (docs/ros2.md). As it is written; node_plan.hpp compares it with the component.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/escape.hpp"
#include "frontend/syntax/word_reader.hpp"

namespace robochart::cpp_emit::ros2 {

using frontend::Word;

enum class ElementKind { operation, event, variable };

/// "operation", "event", "variable".
[[nodiscard]] std::string_view described(ElementKind);

/// `geometry_msgs/Twist`.
struct MessageName {
    std::string package;
    std::string type;
    diagnostics::Span span;

    [[nodiscard]] std::string text() const { return package + "/" + type; }
    friend bool operator==(const MessageName& a, const MessageName& b) {
        return a.package == b.package && a.type == b.type;
    }
};

/// `a.b.c`.
struct Path {
    std::vector<Word> words;

    [[nodiscard]] std::string text() const;
    [[nodiscard]] diagnostics::Span span() const;
};

/// What stands behind `=`.
struct Source {
    enum class Kind { path, whole, decimal, truth, text };
    Kind kind = Kind::path;
    Path path;                      ///< of the model, or of the message; `true`, `false`, `now` too
    std::string number;             ///< as C++ text, with its sign
    diagnostics::ForeignText text;  ///< characters
    diagnostics::Span span;
};

/// `linear.x = speed`, `value = range`.
struct Assignment {
    Path target;
    Source source;
};

/// How messages are delivered; what is not said has the default of its kind.
struct Delivery {
    std::optional<bool> reliable;
    std::optional<bool> latched;  ///< transient_local: who comes late gets the last messages
    std::optional<std::uint32_t> depth;
};

/// `publish operation move as geometry_msgs/Twist on "cmd_vel" with reliable { linear.x = speed }`.
struct Item {
    bool published = false;
    ElementKind kind = ElementKind::operation;
    Word element;
    MessageName message;
    Word topic;
    Delivery delivery;
    std::vector<Assignment> assignments;
};

struct Mapping {
    Word component;
    std::vector<Item> items;
};

}  // namespace robochart::cpp_emit::ros2
