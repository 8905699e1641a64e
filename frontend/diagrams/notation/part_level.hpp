// SPDX-License-Identifier: Apache-2.0
// Lays out and draws the components of a module or controller, the squares of their events, and the connections between
// them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontend/diagrams/notation/node_level.hpp"
#include "frontend/diagrams/notation/painter.hpp"

namespace robochart::diagrams {

/// The inside of a module or controller. Its own events are on its border.
class PartLevel {
public:
    /// `header` is the size of the part of the frame above the components. `title` is the rectangle of the title's
    /// text, relative to the middle of the upper side.
    PartLevel(const frontend::Component& component, const layout::Size& header, const layout::Rectangle& title,
              const Drawing& drawing);

    /// Adds the components and connections to a picture whose first box is the frame, and sets the place of the frame.
    void paint(Picture& picture);

private:
    /// A component, or an own event of the module or controller.
    struct Part {
        const frontend::Declaration* declaration = nullptr;  ///< null for an unresolved name
        std::string name;
        Look look = Look::plain;
        Title title;
        Rows rows;
        std::vector<const frontend::Event*> events;  ///< null if only its name is known
        std::vector<EventSquare> squares;            ///< one per event
        bool on_border = false;                      ///< an own event of the module or controller
        std::unique_ptr<NodeLevel> inner;            ///< the nodes of a machine, if a person drew them here
        double header = 0;
        layout::Size size;
    };
    /// An end of a connection.
    struct End {
        std::size_t part = 0;
        std::size_t square = 0;
    };

    /// The x of the borders of the module or controller.
    struct Borders {
        double left = 0, right = 0;
        bool events_left = false, events_right = false;
        double missing = 0;  ///< the distance by which the borders must move apart
    };

    void add_part(const frontend::Declaration& declaration);
    void describe_part(Part& part) const;
    void add_inner_level(Part& part) const;
    void describe_reference(Part& part, const frontend::Reference& reference) const;
    void add_connection(const frontend::Connection& connection);
    [[nodiscard]] End end_of(const frontend::Connection::End& end, bool source);
    [[nodiscard]] std::size_t own_event(const frontend::Connection::End& end, bool source);
    [[nodiscard]] std::size_t part_of(const frontend::Connection::End& end);
    [[nodiscard]] std::size_t square_in(Part& part, const frontend::Connection::End& end) const;
    void lay_out();
    void set_size(Part& part) const;
    [[nodiscard]] std::optional<layout::DrawnLevel> drawn_level() const;
    [[nodiscard]] layout::DrawnPorts drawn_ports(const Part& part) const;
    void paint_as_drawn(Picture& picture);
    void paint_part(Picture& picture, std::size_t part, const layout::Point& corner);
    void paint_connection(Picture& picture, std::size_t connection, const layout::Point& corner) const;
    [[nodiscard]] Borders find_borders() const;
    [[nodiscard]] bool is_first(std::size_t part) const { return pins_[part] == layout::Pin::first; }
    /// True for an event on the right border.
    [[nodiscard]] bool is_last(std::size_t part) const { return parts_[part].on_border && !is_first(part); }

    const frontend::Component& component_;
    layout::Size header_;
    layout::Rectangle title_;  ///< the text of the title of the component, as in layout::DrawnPorts
    const Drawing& drawing_;
    std::vector<Part> parts_;
    std::vector<layout::Pin> pins_;  ///< one per part
    std::vector<const frontend::Connection*> connections_;
    std::vector<std::pair<End, End>> ends_;  ///< one per connection
    std::string left_out_;                   ///< connections from an event to itself, which are not drawn
    layout::Level level_;
    layout::Placement placement_;
    bool as_drawn_ = false;
    std::vector<std::vector<std::size_t>> squares_;  ///< for each part, the indices of its squares in the picture
};

}  // namespace robochart::diagrams
