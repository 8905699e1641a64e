// SPDX-License-Identifier: Apache-2.0
// See part_level.hpp.
#include "frontend/diagrams/notation/part_level.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "frontend/diagrams/layout/drawn.hpp"
#include "frontend/diagrams/notation/labels.hpp"

namespace robochart::diagrams {

using namespace frontend;
using layout::Pin;
using layout::Point;
using layout::Rectangle;
using layout::Size;

namespace {

constexpr double component_inset = 22;  ///< distance between the border of the component and its contents

Icon icon_of(DeclKind kind) {
    if (kind == DeclKind::platform) return Icon::platform;
    if (kind == DeclKind::controller) return Icon::controller;
    return kind == DeclKind::operation ? Icon::operation : Icon::machine;
}

/// Returns the label of a connection: `async`, or none.
layout::Lines connection_label(const Connection& connection) {
    return connection.async ? layout::Lines{{"async"}, false} : layout::Lines{};
}

}  // namespace

PartLevel::PartLevel(const Component& component, const Size& header, const Rectangle& title, const Drawing& drawing)
    : component_(component), header_(header), title_(title), drawing_(drawing) {
    for (const Declaration* part : component.order) add_part(*part);
    for (const Event* event : events_of(component)) {
        Part part;
        part.name = shown_name(event->name);
        part.on_border = true;
        part.events = {event};
        part.squares = {square_of(*event, drawing.elements)};
        parts_.push_back(std::move(part));
        pins_.push_back(Pin::none);  // its first connection decides the end
    }
    for (const auto& connection : component.connections) add_connection(*connection);
    lay_out();
}

void PartLevel::add_part(const Declaration& declaration) {
    if (drawing_.budget != nullptr) drawing_.budget->poll();
    Part part;
    part.declaration = &declaration;
    part.name = shown_name(declaration.name);
    const auto* reference = dynamic_cast<const Reference*>(&declaration);
    const DeclKind kind = reference != nullptr ? reference->refers_to : declaration.kind;
    if (reference != nullptr)
        describe_reference(part, *reference);
    else
        describe_part(part);
    part.title.icon = icon_of(kind);
    parts_.push_back(std::move(part));
    pins_.push_back(kind == DeclKind::platform ? Pin::first : Pin::none);
}

/// Fills in a component that is declared inline. Its contents are in its own diagram, unless a person drew them here.
void PartLevel::describe_part(Part& part) const {
    part.title.text = part.name;
    if (const auto* operation = dynamic_cast<const Machine*>(part.declaration);
        operation != nullptr && operation->kind == DeclKind::operation)
        part.title.text = title_of(*operation);
    const auto* context = dynamic_cast<const Context*>(part.declaration);
    if (context == nullptr) return;
    part.rows = rows_of(*context, drawing_.elements, false);
    part.events = events_of(*context);
    for (const Event* event : part.events) part.squares.push_back(square_of(*event, drawing_.elements));
    add_inner_level(part);
}

void PartLevel::add_inner_level(Part& part) const {
    const auto* machine = dynamic_cast<const Machine*>(part.declaration);
    if (drawing_.stored == nullptr || machine == nullptr) return;
    const bool drawn = std::ranges::any_of(
        machine->nodes, [&](const auto& node) { return drawing_.stored->box_of(node.get()).has_value(); });
    if (drawn) part.inner = std::make_unique<NodeLevel>(*machine, component_.name + "::" + machine->name, drawing_);
}

void PartLevel::describe_reference(Part& part, const Reference& reference) const {
    const std::string target = shown_name(reference.target_name.text());
    const auto* context = dynamic_cast<const Context*>(reference.target);
    const auto* machine = dynamic_cast<const Machine*>(reference.target);
    part.look = reference.refers_to == DeclKind::state_machine ? Look::machine_reference : Look::reference;
    part.title.italic = true;
    part.title.reference = true;
    if (reference.refers_to == DeclKind::operation)
        part.title.text = machine != nullptr ? title_of(*machine) : target;
    else if (reference.refers_to == DeclKind::state_machine)
        part.title.text = "ref " + part.name + " = " + target;
    else
        part.title.text = "ref " + target;
    if (context == nullptr || reference.refers_to == DeclKind::operation) return;
    part.events = events_of(*context);
    for (const Event* event : part.events) part.squares.push_back(square_of(*event, drawing_.elements));
}

void PartLevel::add_connection(const Connection& connection) {
    if (connection.from.node.empty() || connection.to.node.empty()) return;
    const End from = end_of(connection.from, true);
    const End to = end_of(connection.to, false);
    if (from.part == to.part && from.square == to.square) {
        left_out_ += "connection of " + parts_[from.part].name + " to itself\n";
        return;
    }
    layout::Edge edge;
    edge.from = from.part;
    edge.to = to.part;
    edge.from_port = from.square;
    edge.to_port = to.square;
    edge.label = size_of(connection_label(connection));
    level_.edges.push_back(std::move(edge));
    connections_.push_back(&connection);
    ends_.emplace_back(from, to);
}

PartLevel::End PartLevel::end_of(const Connection::End& end, bool source) {
    const bool own = end.node_target != nullptr ? end.node_target == &component_
                                                : shown_name(end.node.text()) == shown_name(component_.name);
    if (own) return {own_event(end, source), 0};
    const std::size_t part = part_of(end);
    return {part, square_in(parts_[part], end)};
}

/// Returns the square of an event of the module or controller itself. The square is on the left if its connection leads
/// inwards, and on the right if it leads outwards.
std::size_t PartLevel::own_event(const Connection::End& end, bool source) {
    const std::string name = shown_name(end.event.text());
    std::size_t found = parts_.size();
    for (std::size_t p = 0; p < parts_.size(); ++p)
        if (parts_[p].on_border &&
            (end.event_target != nullptr ? parts_[p].events[0] == end.event_target : parts_[p].name == name)) {
            found = p;
            break;
        }
    if (found == parts_.size()) {
        Part part;
        part.name = name;
        part.on_border = true;
        part.events = {nullptr};
        part.squares = {square_of(name, none, false)};
        parts_.push_back(std::move(part));
        pins_.push_back(Pin::none);
    }
    if (pins_[found] == Pin::none) pins_[found] = source ? Pin::first : Pin::last;
    return found;
}

/// Returns the component at the end of a connection. If there is none, a box with the name is added.
std::size_t PartLevel::part_of(const Connection::End& end) {
    const std::string name = shown_name(end.node.text());
    for (std::size_t p = 0; p < parts_.size(); ++p)
        if (!parts_[p].on_border && end.node_target != nullptr && parts_[p].declaration == end.node_target) return p;
    for (std::size_t p = 0; p < parts_.size(); ++p)
        if (!parts_[p].on_border && parts_[p].name == name) return p;
    Part part;
    part.name = name;
    part.look = Look::missing;
    part.title.text = name;
    part.title.italic = true;
    parts_.push_back(std::move(part));
    pins_.push_back(Pin::none);
    return parts_.size() - 1;
}

std::size_t PartLevel::square_in(Part& part, const Connection::End& end) const {
    const EventSquare named = square_of(shown_name(end.event.text()), none, false);
    const auto is_meant = [&](std::size_t s) {
        const Event* event = part.events[s];
        if (event == nullptr) return part.squares[s].label == named.label && part.squares[s].whole == named.whole;
        return end.event_target != nullptr ? event == end.event_target : event->name == end.event.text();
    };
    for (std::size_t s = 0; s < part.events.size(); ++s)
        if (is_meant(s)) return s;
    part.events.push_back(nullptr);
    part.squares.push_back(named);
    return part.squares.size() - 1;
}

void PartLevel::lay_out() {
    LevelNames names;
    names.path = shown_name(component_.name);
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        Part& part = parts_[p];
        layout::Box box;
        box.pin = pins_[p];
        names.boxes.push_back((part.on_border ? "event " : "") + part.name);
        if (part.on_border) {
            if (box.pin == Pin::none) box.pin = pins_[p] = Pin::first;
            box.size = {0, layout::port_size};
            box.on_border = true;
            box.ports.resize(1);
        } else {
            set_size(part);
            box.size = part.size;
            box.port_start = part.header;
            for (const EventSquare& square : part.squares) box.ports.push_back({label_width(square)});
        }
        level_.boxes.push_back(std::move(box));
    }
    for (std::size_t c = 0; c < connections_.size(); ++c)
        names.edges.push_back(names.boxes[ends_[c].first.part] + " " + names.boxes[ends_[c].second.part]);
    level_.direction = layout::Direction::right;
    if (const auto drawn = drawn_level()) {
        as_drawn_ = true;
        placement_ = layout::arrange_as_drawn(level_, *drawn, drawing_.budget);
        return;
    }
    placement_ = arrange_again(level_, std::move(names), drawing_.memory, drawing_.budget);
}

void PartLevel::set_size(Part& part) const {
    const Size rows = part.rows.size();
    part.header = measure::title + rows.height;
    part.size = {std::max({part.title.width(), rows.width, 80.0}), std::max(part.header, 40.0)};
    if (part.inner == nullptr) return;
    part.size.width = std::max(part.size.width, part.inner->size().width);
    part.size.height = part.header + part.inner->size().height;
}

/// Returns no value if the drawing contains none of the components.
std::optional<layout::DrawnLevel> PartLevel::drawn_level() const {
    if (drawing_.stored == nullptr) return std::nullopt;
    layout::DrawnLevel drawn;
    drawn.header = header_.height;
    drawn.size = drawing_.stored->area_of(&component_).size;
    drawn.size.width = std::max(drawn.size.width, header_.width);
    bool any = false;
    for (const Part& part : parts_) {
        drawn.boxes.push_back(drawing_.stored->box_of(part.declaration));
        any = any || drawn.boxes.back();
        drawn.ports.push_back(drawn_ports(part));
    }
    for (const Connection* connection : connections_) drawn.edges.push_back(drawing_.stored->line_of(connection));
    return any ? std::optional(std::move(drawn)) : std::nullopt;
}

layout::DrawnPorts PartLevel::drawn_ports(const Part& part) const {
    const Declaration* owner = part.on_border ? &component_ : part.declaration;
    layout::DrawnPorts drawn;
    drawn.title = part.on_border ? title_ : part.title.text_place(measure::title);
    drawn.owner = drawing_.stored->size(owner);
    drawn.header = drawing_.stored->area_of(owner).above.value_or(part.on_border ? header_.height : part.header);
    drawn.full = part.inner != nullptr;
    for (std::size_t s = 0; s < part.squares.size(); ++s) {
        drawn.ports.push_back(drawing_.stored->port_of(owner, part.events[s]));
        drawn.labels.push_back(label_size(part.squares[s]));
    }
    return drawn;
}

PartLevel::Borders PartLevel::find_borders() const {
    Borders result{std::numeric_limits<double>::infinity(), 0, false, false, 0};
    double rightmost = 0;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
        const Rectangle& place = placement_.boxes[p].place;
        if (!parts_[p].on_border) {
            rightmost = std::max(rightmost, place.right() + component_inset);
        } else if (is_first(p)) {
            result.events_left = true;
            result.left = std::min(result.left, place.x);
        } else {
            result.events_right = true;
            result.right = std::max(result.right, place.x);
        }
    }
    if (!result.events_left) result.left = -component_inset;
    if (!result.events_right) result.right = placement_.size.width + component_inset;
    // Components without connections may extend beyond the events on the right border, so the border must be moved
    // outwards.
    result.missing = std::max({0.0, header_.width - (result.right - result.left), rightmost - result.right});
    return result;
}

/// Adds the components and connections. If the frame is wider than the components need, they are centred. If there are
/// events on the right border, the border is moved instead.
void PartLevel::paint(Picture& picture) {
    if (as_drawn_) {
        paint_as_drawn(picture);
        return;
    }
    const Borders at = find_borders();
    const Point corner{at.events_right ? 0 : at.missing / 2, header_.height + component_inset};
    const double moved = at.events_right ? at.missing : 0;
    PictureBox& frame = picture.boxes.front();
    frame.place = {at.events_left ? at.left + corner.x : at.left, 0, at.right - at.left + at.missing,
                   header_.height + placement_.size.height + 2 * component_inset};
    frame.whole += left_out_;
    squares_.assign(parts_.size(), {});
    for (std::size_t p = 0; p < parts_.size(); ++p)
        paint_part(picture, p, {is_last(p) ? corner.x + moved : corner.x, corner.y});
    for (std::size_t c = 0; c < connections_.size(); ++c) {
        paint_connection(picture, c, corner);
        PictureLine& line = picture.lines.back();
        if (is_last(ends_[c].first.part)) line.points.front().x += moved;
        if (is_last(ends_[c].second.part)) line.points.back().x += moved;
    }
}

void PartLevel::paint_as_drawn(Picture& picture) {
    const Point corner{0, header_.height};
    PictureBox& frame = picture.boxes.front();
    frame.place = {0, 0, placement_.size.width, header_.height + placement_.size.height};
    frame.whole += left_out_;
    squares_.assign(parts_.size(), {});
    for (std::size_t p = 0; p < parts_.size(); ++p) paint_part(picture, p, corner);
    for (std::size_t c = 0; c < connections_.size(); ++c) paint_connection(picture, c, corner);
}

void PartLevel::paint_part(Picture& picture, std::size_t p, const Point& corner) {
    const Part& part = parts_[p];
    const layout::PlacedBox& placed = placement_.boxes[p];
    std::size_t owner = 0;
    if (!part.on_border) {
        PictureBox box;
        box.look = part.look;
        box.element = part.declaration == nullptr ? none : drawing_.elements.find(part.declaration);
        box.parent = 0;
        box.place = placed.place;
        box.place.x += corner.x;
        box.place.y += corner.y;
        part.title.write(box, measure::title);
        if (!part.rows.empty()) {
            box.rules.push_back(box.place.y + measure::title);
            part.rows.write({box.place.x, box.place.y + measure::title}, box);
            if (!part.squares.empty() || part.inner != nullptr) box.rules.push_back(box.place.y + part.header);
        }
        owner = picture.boxes.size();
        const Rectangle inside{box.place.x, box.place.y + part.header, box.place.width, box.place.height - part.header};
        picture.boxes.push_back(std::move(box));
        if (part.inner != nullptr) part.inner->paint(picture, part.inner->corner_in(inside), owner);
    }
    for (std::size_t s = 0; s < part.squares.size(); ++s) {
        const layout::PlacedPort& port = placed.ports[s];
        // The label of a component's event is inside the component. The label of an event on the frame is outside the
        // frame.
        const bool label_left = part.on_border ? is_first(p) : !port.left;
        squares_[p].push_back(picture.boxes.size());
        picture.boxes.push_back(draw_square(part.squares[s], port, corner, owner, label_left));
    }
}

void PartLevel::paint_connection(Picture& picture, std::size_t c, const Point& corner) const {
    const layout::PlacedEdge& placed = placement_.edges[c];
    PictureLine line;
    line.element = drawing_.elements.find(connections_[c]);
    line.from = squares_[ends_[c].first.part][ends_[c].first.square];
    line.to = squares_[ends_[c].second.part][ends_[c].second.square];
    line.both_ways = connections_[c]->multiple;
    for (const Point& point : placed.points) line.points.push_back({point.x + corner.x, point.y + corner.y});
    const layout::Lines label = connection_label(*connections_[c]);
    if (!placed.label.empty()) {
        line.label = placed.label;
        line.label.x += corner.x;
        line.label.y += corner.y;
        write_lines(label, {line.label.x, line.label.y}, line.texts);
        for (Text& text : line.texts) text.italic = true;
    } else if (!label.lines.empty()) {
        line.whole = "async";
    }
    picture.lines.push_back(std::move(line));
}

}  // namespace robochart::diagrams
