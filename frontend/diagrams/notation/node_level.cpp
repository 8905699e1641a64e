// SPDX-License-Identifier: Apache-2.0
// See node_level.hpp.
#include "frontend/diagrams/notation/node_level.hpp"

#include <algorithm>
#include <utility>

#include "frontend/diagrams/layout/drawn.hpp"
#include "frontend/diagrams/notation/labels.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::diagrams {

using namespace frontend;
using layout::Point;
using layout::Rectangle;
using layout::Size;

namespace {

constexpr double circle = 24;
constexpr double inset = 12;  ///< distance between the border of a composite state and its nodes
constexpr layout::LineLimits label_limits{34, 6};
constexpr layout::LineLimits action_limits{44, 6};

Look look_of(const State& state) {
    if (state.kind == DeclKind::initial) return Look::initial;
    if (state.kind == DeclKind::junction) return Look::junction;
    if (state.kind == DeclKind::probabilistic) return Look::probabilistic;
    return state.kind == DeclKind::final ? Look::final : Look::plain;
}

std::string join_pieces(const std::vector<std::string>& pieces) {
    std::string result;
    for (const std::string& piece : pieces) result += piece;
    return result;
}

/// True if `target` is the node or inside it.
bool contains_node(const State& node, const State* target) {
    if (&node == target) return true;
    return std::ranges::any_of(node.nodes, [&](const auto& child) { return contains_node(*child, target); });
}

}  // namespace

NodeLevel::NodeLevel(const Machine& machine, std::string path, const Drawing& drawing)
    : owner_(&machine), path_(std::move(path)), drawing_(drawing) {
    add_contents(machine);
}

NodeLevel::NodeLevel(const State& state, std::string path, const Drawing& drawing)
    : owner_(&state), path_(std::move(path)), drawing_(drawing) {
    add_contents(state);
}

void NodeLevel::add_contents(const NodeContainer& container) {
    for (const auto& node : container.nodes) add_node(*node);
    for (const auto& transition : container.transitions) add_arrow(*transition);
    lay_out();
}

void NodeLevel::add_node(const State& state) {
    if (drawing_.budget != nullptr) drawing_.budget->poll();
    Shape shape;
    shape.state = &state;
    shape.look = look_of(state);
    shape.name = shown_name(state.name);
    shape.title.text = shape.name;
    layout::Box box;
    box.entry = state.kind == DeclKind::initial;
    box.round = is_round(shape.look);
    if (box.round) {
        shape.size = {circle, circle};
    } else {
        add_actions(shape);
        if (!state.nodes.empty() || !state.transitions.empty()) {
            shape.inner = std::make_unique<NodeLevel>(state, path_ + "::" + state.name, drawing_);
            const double around = 2 * shape.inner->margin(inset);
            shape.size.width = std::max(shape.size.width, shape.inner->size().width + around);
            shape.size.height += shape.inner->size().height + around;
        }
    }
    box.size = shape.size;
    level_.boxes.push_back(box);
    nodes_.push_back(std::move(shape));
}

/// Returns the number of characters per line, which is larger if a person drew the state wide.
std::size_t NodeLevel::columns_of(const State& state) const {
    constexpr double widest = 2000;
    const auto drawn = drawing_.stored->box_of(&state);
    const double space = std::min(drawn ? drawn->width.value_or(0) : 0, widest) - 2 * measure::padding;
    return space <= 0 ? 0 : static_cast<std::size_t>(space / layout::text_width("n", measure::row_font));
}

/// Adds the title, and a paragraph for each action.
void NodeLevel::add_actions(Shape& shape) {
    double width = std::max(shape.title.width(), 60.0);
    layout::LineLimits limits = action_limits;
    if (drawing_.stored != nullptr) limits.columns = std::max(limits.columns, columns_of(*shape.state));
    for (const Action& action : shape.state->actions) {
        const std::string text =
            std::string(to_text(action.kind)) + " " + (action.statement ? text_of(*action.statement) : "");
        shape.actions.push_back(layout::break_lines({text}, limits));
        if (shape.actions.back().elided) shape.whole += text + "\n";
        const Size size = size_of(shape.actions.back());
        width = std::max(width, size.width + 2 * measure::padding);
        shape.actions_height += size.height;
    }
    if (shape.actions_height > 0) shape.actions_height += measure::padding + 1;
    shape.size = {width, measure::state_title + shape.actions_height};
}

void NodeLevel::add_arrow(const Transition& transition) {
    if (transition.source == nullptr && transition.from.empty()) return;
    if (transition.target == nullptr && transition.to.empty()) return;
    layout::Edge edge;
    edge.from = end_of(transition.source, transition.from);
    edge.to = end_of(transition.target, transition.to);
    const std::vector<std::string> pieces = label_of(transition);
    Arrow arrow{&transition, layout::break_lines(pieces, label_limits), ""};
    if (arrow.label.elided) arrow.whole = join_pieces(pieces);
    edge.label = size_of(arrow.label);
    level_.edges.push_back(std::move(edge));
    arrows_.push_back(std::move(arrow));
}

/// Returns the node of this level that is the target or contains it. If there is none, adds a box with the target's
/// name.
std::size_t NodeLevel::end_of(const State* target, const QualifiedName& name) {
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (target != nullptr && nodes_[n].state != nullptr && contains_node(*nodes_[n].state, target)) return n;
    const std::string text = shown_name(name.empty() && target != nullptr ? target->name : name.text());
    for (std::size_t n = 0; n < nodes_.size(); ++n)
        if (nodes_[n].name == text && (target == nullptr || nodes_[n].state == nullptr)) return n;
    Shape shape;
    shape.look = Look::missing;
    shape.name = text;
    shape.title = {Icon::no_icon, text, true, false, false, false};
    shape.size = {std::max(shape.title.width(), 60.0), measure::state_title};
    level_.boxes.emplace_back().size = shape.size;
    nodes_.push_back(std::move(shape));
    return nodes_.size() - 1;
}

void NodeLevel::lay_out() {
    if (const auto drawn = drawn_level()) {
        as_drawn_ = true;
        placement_ = layout::arrange_as_drawn(level_, *drawn, drawing_.budget);
        return;
    }
    LevelNames names;
    names.path = path_;
    for (const Shape& shape : nodes_) names.boxes.push_back(shape.name);
    for (std::size_t a = 0; a < arrows_.size(); ++a) {
        const layout::Edge& edge = level_.edges[a];
        names.edges.push_back(arrows_[a].transition->name + " " + nodes_[edge.from].name + " " + nodes_[edge.to].name);
    }
    placement_ = arrange_again(level_, std::move(names), drawing_.memory, drawing_.budget);
}

/// Returns no value if the drawing contains no node of the level.
std::optional<layout::DrawnLevel> NodeLevel::drawn_level() const {
    if (drawing_.stored == nullptr) return std::nullopt;
    layout::DrawnLevel drawn;
    drawn.size = drawing_.stored->area_of(owner_).size;
    drawn.ports.resize(nodes_.size());
    bool any = false;
    for (const Shape& shape : nodes_) {
        drawn.boxes.push_back(drawing_.stored->box_of(shape.state));
        any = any || drawn.boxes.back();
    }
    for (const Arrow& arrow : arrows_) drawn.edges.push_back(drawing_.stored->line_of(arrow.transition));
    return any ? std::optional(std::move(drawn)) : std::nullopt;
}

Point NodeLevel::corner_in(const Rectangle& space) const {
    if (as_drawn_) return {space.x, space.y};
    return {space.x + (space.width - placement_.size.width) / 2, space.y + (space.height - placement_.size.height) / 2};
}

void NodeLevel::paint(Picture& picture, const Point& corner, std::size_t parent) const {
    const std::size_t first_box = picture.boxes.size();
    // The boxes of this level come before the boxes inside them.
    for (std::size_t n = 0; n < nodes_.size(); ++n) paint_node(picture, n, corner, parent);
    for (std::size_t a = 0; a < arrows_.size(); ++a) paint_arrow(picture, a, corner, first_box);
    for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (nodes_[n].inner == nullptr) continue;
        const Rectangle place = picture.boxes[first_box + n].place;
        const double above = measure::state_title + nodes_[n].actions_height;
        const NodeLevel& inner = *nodes_[n].inner;
        inner.paint(picture, inner.corner_in({place.x, place.y + above, place.width, place.height - above}),
                    first_box + n);
    }
}

void NodeLevel::paint_node(Picture& picture, std::size_t node, const Point& corner, std::size_t parent) const {
    const Shape& shape = nodes_[node];
    PictureBox box;
    box.look = shape.look;
    box.element = shape.state == nullptr ? none : drawing_.elements.find(shape.state);
    box.parent = parent;
    box.place = placement_.boxes[node].place;
    box.place.x += corner.x;
    box.place.y += corner.y;
    if (!is_round(shape.look)) {
        shape.title.write(box, measure::state_title);
        double y = box.place.y + measure::state_title;
        if (box.place.height > measure::state_title + measure::padding) box.rules.push_back(y);
        for (std::size_t i = 0; i < shape.actions.size(); ++i) {
            const std::size_t before = box.texts.size();
            write_lines(shape.actions[i], {box.place.x + measure::padding, y + 3}, box.texts);
            for (std::size_t t = before; t < box.texts.size(); ++t)
                box.texts[t].element = drawing_.elements.find(&shape.state->actions[i]);
            y += size_of(shape.actions[i]).height;
        }
        if (!shape.actions.empty() && shape.inner != nullptr)
            box.rules.push_back(box.place.y + measure::state_title + shape.actions_height);
        box.whole += shape.whole;
    }
    picture.boxes.push_back(std::move(box));
}

void NodeLevel::paint_arrow(Picture& picture, std::size_t arrow, const Point& corner, std::size_t first_box) const {
    const layout::PlacedEdge& placed = placement_.edges[arrow];
    PictureLine line;
    line.element = drawing_.elements.find(arrows_[arrow].transition);
    line.from = first_box + level_.edges[arrow].from;
    line.to = first_box + level_.edges[arrow].to;
    for (const Point& point : placed.points) line.points.push_back({point.x + corner.x, point.y + corner.y});
    line.whole = arrows_[arrow].whole;
    if (!placed.label.empty()) {
        line.label = placed.label;
        line.label.x += corner.x;
        line.label.y += corner.y;
        write_lines(arrows_[arrow].label, {line.label.x, line.label.y}, line.texts);
    }
    picture.lines.push_back(std::move(line));
}

}  // namespace robochart::diagrams
