// A diagram as data: boxes, lines and text with their places, and the elements of the model that they show. Formats are
// written from this alone (diagrams/svg).
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "diagrams/layout/geometry.hpp"

namespace robochart::diagrams {

/// No element, no box.
inline constexpr std::size_t none = static_cast<std::size_t>(-1);

/// What stands in front of titles and rows.
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

/// Which point of a text its place is.
enum class Anchor { start, middle, end };

/// Text on one line.
struct Text {
    layout::Point at;  ///< on the base line
    std::string text;
    double size = 11;
    Anchor anchor = Anchor::start;
    bool bold = false, italic = false, underlined = false;
    bool flows = false;          ///< right behind the text before it, wherever that ends
    std::size_t element = none;  ///< where it shows another element than its box
};

/// A small sign.
struct Sign {
    Icon icon = Icon::no_icon;
    layout::Point centre;
    bool reference = false;  ///< of a reference: in the colour of references
};

/// How a box is drawn.
enum class Look {
    plain,
    frame,              ///< the component that the diagram shows
    reference,          ///< to a declaration elsewhere
    machine_reference,  ///< with a dashed border
    missing,            ///< a name that means nothing
    event,              ///< the square of an event
    broadcast,
    initial,
    junction,
    probabilistic,
    final,
};
/// Nodes that are drawn as circles.
[[nodiscard]] inline bool is_round(Look look) {
    return look >= Look::initial;
}

/// A box with what is written in it.
struct PictureBox {
    Look look = Look::plain;
    std::size_t element = none;
    std::size_t parent = none;    ///< box that it is in
    std::size_t event_of = none;  ///< of the square of an event, the box on whose border it is
    layout::Rectangle place;
    std::vector<double> rules;  ///< y of the lines that divide it
    std::vector<Sign> signs;
    std::vector<Text> texts;
    std::string whole;  ///< what was elided in it
};

/// A transition or a connection.
struct PictureLine {
    std::size_t element = none;
    std::size_t from = none, to = none;  ///< boxes
    std::vector<layout::Point> points;
    bool both_ways = false;  ///< an arrow at its beginning too
    layout::Rectangle label;
    std::vector<Text> texts;
    std::string whole;  ///< its label where that is elided or left out
};

/// A diagram.
struct Picture {
    std::string title;        ///< "state machine Movement"
    std::string description;  ///< what is in it, in a sentence
    layout::Size size;
    std::vector<PictureBox> boxes;  ///< each behind the one that it is in
    std::vector<PictureLine> lines;
};

}  // namespace robochart::diagrams
