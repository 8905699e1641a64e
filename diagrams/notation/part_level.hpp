// The parts of a module or a controller with the squares of their events, and the connections between them.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagrams/notation/node_level.hpp"
#include "diagrams/notation/painter.hpp"

namespace robochart::diagrams {

/// The inside of a module or controller. The component's own events are on its border.
class PartLevel {
public:
    /// `header`: the size of what is above the parts.
    PartLevel(const frontend::Component& component, const layout::Size& header, const Drawing& drawing);

    /// Adds the parts and connections to a picture whose first box is the frame, and gives that its place.
    void paint(Picture& picture);

private:
    /// A part, or an event of the component itself.
    struct Part {
        const frontend::Declaration* declaration = nullptr;  ///< null for a name that means nothing
        std::string name;
        Look look = Look::plain;
        Title title;
        Rows rows;
        std::vector<const frontend::Event*> events;  ///< null for one that is only named
        std::vector<EventSquare> squares;            ///< of these
        bool on_border = false;                      ///< an event of the component itself
        std::unique_ptr<NodeLevel> inner;            ///< of a machine that a person drew with its nodes
        double header = 0;
        layout::Size size;
    };
    /// An end of a connection.
    struct End {
        std::size_t part = 0;
        std::size_t square = 0;
    };

    /// x of the borders of the component.
    struct Borders {
        double left = 0, right = 0;
        bool events_left = false, events_right = false;
        double missing = 0;  ///< what they have to be further apart
    };

    void add_part(const frontend::Declaration& declaration);
    void describe(Part& part) const;
    void open(Part& part) const;
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
    [[nodiscard]] Borders borders() const;
    [[nodiscard]] bool is_first(std::size_t part) const { return pins_[part] == layout::Pin::first; }
    /// An event on the right border.
    [[nodiscard]] bool is_last(std::size_t part) const { return parts_[part].on_border && !is_first(part); }

    const frontend::Component& component_;
    layout::Size header_;
    const Drawing& drawing_;
    std::vector<Part> parts_;
    std::vector<layout::Pin> pins_;  ///< of the parts
    std::vector<const frontend::Connection*> connections_;
    std::vector<std::pair<End, End>> ends_;  ///< of the connections
    std::string left_out_;                   ///< connections from an event to itself
    layout::Level level_;
    layout::Placement placement_;
    bool as_drawn_ = false;
    std::vector<std::vector<std::size_t>> squares_;  ///< of the parts, as boxes of the picture
};

}  // namespace robochart::diagrams
