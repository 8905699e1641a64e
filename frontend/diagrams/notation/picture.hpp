// SPDX-License-Identifier: Apache-2.0
// Represents a diagram as data: boxes, lines and text with their places, and the elements of the model that they show.
// All output formats use this data (frontend/diagrams/svg).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/diagrams/layout/geometry.hpp"

namespace robochart::diagrams {

/// The index that means no element or no box.
inline constexpr std::size_t none = static_cast<std::size_t>(-1);

/// The icon before a title or row.
enum class Icon {
    no_icon,
    module,
    platform,
    controller,
    machine,
    operation,
    enumeration,
    record,
    function,
    event,
    constant,
    variable,
    clock,
    provides,
    requires_,
    uses,
    precondition,
    postcondition,
};

/// The point of a text that is at the text's position.
enum class Anchor { start, middle, end };

/// Text on one line.
struct Text {
    layout::Point at;  ///< the position on the base line
    std::string text;
    double size = 11;
    Anchor anchor = Anchor::start;
    bool bold = false, italic = false, underlined = false;
    bool flows = false;          ///< directly after the text before it
    std::size_t element = none;  ///< set if the text shows another element than its box
};

/// An icon in a picture.
struct Sign {
    Icon icon = Icon::no_icon;
    layout::Point centre;
    bool reference = false;  ///< the icon of a reference, drawn in the colour of references
};

/// The style of a box.
enum class Look {
    plain,
    frame,              ///< the component shown by the diagram
    reference,          ///< refers to a declaration elsewhere
    machine_reference,  ///< a reference to a machine, drawn with a dashed border
    missing,            ///< an unresolved name
    event,              ///< the square of an event
    broadcast,
    initial,
    junction,
    probabilistic,
    final,
};
/// True for nodes that are drawn as circles.
[[nodiscard]] inline bool is_round(Look look) {
    return look >= Look::initial;
}
/// Returns the letter in the circle of a node, or "" if it has none.
[[nodiscard]] inline std::string_view letter_of(Look look) {
    if (look == Look::initial) return "i";
    if (look == Look::probabilistic) return "P";
    return look == Look::final ? "F" : "";
}

/// A box with its text.
struct PictureBox {
    Look look = Look::plain;
    std::size_t element = none;
    std::size_t parent = none;    ///< the box that contains it
    std::size_t event_of = none;  ///< the box on whose border the square of an event is
    layout::Rectangle place;
    std::vector<double> rules;  ///< y of the lines that divide it
    std::vector<Sign> signs;
    std::vector<Text> texts;
    std::string whole;  ///< the complete text of elided parts
};

/// A transition or a connection.
struct PictureLine {
    std::size_t element = none;
    std::size_t from = none, to = none;  ///< boxes
    std::vector<layout::Point> points;
    bool both_ways = false;  ///< also has an arrow at its beginning
    layout::Rectangle label;
    std::vector<Text> texts;
    std::string whole;  ///< its complete label if it is elided or omitted
};

/// A diagram.
struct Picture {
    std::string title;        ///< "state machine Movement"
    std::string description;  ///< the contents in one sentence
    layout::Size size;
    std::vector<PictureBox> boxes;  ///< each after the box that contains it
    std::vector<PictureLine> lines;
};

}  // namespace robochart::diagrams
