// SPDX-License-Identifier: Apache-2.0
// Draws what all kinds of diagrams contain: titles, labels and squares of events.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/text_width.hpp"
#include "frontend/diagrams/notation/elements.hpp"
#include "frontend/diagrams/notation/memory.hpp"
#include "frontend/diagrams/notation/picture.hpp"
#include "frontend/diagrams/notation/rows.hpp"
#include "frontend/diagrams/notation/stored_layout.hpp"

namespace robochart::diagrams {

/// The input of drawing.
struct Drawing {
    const Elements& elements;
    Memory* memory = nullptr;
    diagnostics::Budget* budget = nullptr;
    const StoredLayout* stored = nullptr;  ///< the stored layout of the drawn component
};

/// A title of a box: an icon and text.
struct Title {
    Icon icon = Icon::no_icon;
    std::string text;
    bool italic = false, bold = false, underlined = false;
    bool reference = false;

    [[nodiscard]] double width() const;
    /// Returns the place of the text in the first `height` pixels of a box, relative to the middle of its upper side.
    [[nodiscard]] layout::Rectangle text_place(double height) const;
    /// Writes the title, centred, into the first `height` pixels of a box.
    void write(PictureBox& box, double height) const;
};

/// Returns the size of lines of text, one below the other.
[[nodiscard]] layout::Size size_of(const layout::Lines& lines);
/// Writes the lines below a point.
void write_lines(const layout::Lines& lines, const layout::Point& corner, std::vector<Text>& texts);

/// An event on the border of a component.
struct EventSquare {
    std::string label;
    std::size_t element = none;
    bool broadcast = false;
    std::string whole;  ///< the complete label if it is elided
};
/// Returns the square of an event with its label.
[[nodiscard]] EventSquare square_of(const std::string& label, std::size_t element, bool broadcast);
/// Returns the events of a component: those that it declares and those of the interfaces that it uses.
[[nodiscard]] std::vector<const frontend::Event*> events_of(const frontend::Context& context);
[[nodiscard]] EventSquare square_of(const frontend::Event& event, const Elements& elements);
[[nodiscard]] double label_width(const EventSquare& square);
/// Returns the size of the label.
[[nodiscard]] layout::Size label_size(const EventSquare& square);
/// Returns the square with its label to the left or right.
[[nodiscard]] PictureBox draw_square(const EventSquare& square, const layout::Point& centre, std::size_t owner,
                                     bool label_left);
/// Returns the square at a port. Its label is at the place that the port contains or, if there is none, to the left or
/// right.
[[nodiscard]] PictureBox draw_square(const EventSquare& square, const layout::PlacedPort& port,
                                     const layout::Point& corner, std::size_t owner, bool label_left);

/// Moves a picture so that everything is inside its size, with a margin.
void crop_picture(Picture& picture);

}  // namespace robochart::diagrams
