// SPDX-License-Identifier: Apache-2.0
// Lays out the nodes and transitions of a machine or a composite state. Inner states are laid out before outer states.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "frontend/diagrams/notation/painter.hpp"

namespace robochart::diagrams {

/// One level and the levels inside it.
class NodeLevel {
public:
    NodeLevel(const frontend::Machine& machine, std::string path, const Drawing& drawing);
    NodeLevel(const frontend::State& state, std::string path, const Drawing& drawing);

    [[nodiscard]] const layout::Size& size() const { return placement_.size; }
    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    /// Returns the distance between the level and the enclosing border: `own`, or 0 if a person drew the layout.
    [[nodiscard]] double margin(double own) const { return as_drawn_ ? 0 : own; }
    /// Returns the position of the level's corner in the available space. The level is centred, or placed as a person
    /// drew it.
    [[nodiscard]] layout::Point corner_in(const layout::Rectangle& space) const;
    /// Adds the boxes and lines of the level to a picture.
    void paint(Picture& picture, const layout::Point& corner, std::size_t parent) const;

private:
    /// The drawing of a node.
    struct Shape {
        const frontend::State* state = nullptr;  ///< null for an unresolved name
        Look look = Look::plain;
        Title title;
        std::string name;
        std::vector<layout::Lines> actions;
        std::string whole;
        double actions_height = 0;
        std::unique_ptr<NodeLevel> inner;
        layout::Size size;
    };
    /// A transition with its label.
    struct Arrow {
        const frontend::Transition* transition = nullptr;
        layout::Lines label;
        std::string whole;
    };

    void add_contents(const frontend::NodeContainer& container);
    void add_node(const frontend::State& state);
    void add_actions(Shape& shape);
    [[nodiscard]] std::size_t columns_of(const frontend::State& state) const;
    void add_arrow(const frontend::Transition& transition);
    [[nodiscard]] std::size_t end_of(const frontend::State* target, const frontend::QualifiedName& name);
    void lay_out();
    [[nodiscard]] std::optional<layout::DrawnLevel> drawn_level() const;
    void paint_node(Picture& picture, std::size_t node, const layout::Point& corner, std::size_t parent) const;
    void paint_arrow(Picture& picture, std::size_t arrow, const layout::Point& corner, std::size_t first_box) const;

    const frontend::Declaration* owner_;  ///< the machine or state
    std::string path_;
    const Drawing& drawing_;
    std::vector<Shape> nodes_;
    std::vector<Arrow> arrows_;
    layout::Level level_;
    layout::Placement placement_;
    bool as_drawn_ = false;
};

}  // namespace robochart::diagrams
