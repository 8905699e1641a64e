// The nodes and transitions of a machine or a composite state, laid out from the inside to the outside.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "diagrams/notation/painter.hpp"

namespace robochart::diagrams {

/// One level with those inside of it.
class NodeLevel {
public:
    NodeLevel(const frontend::NodeContainer& container, std::string path, const Drawing& drawing);

    [[nodiscard]] const layout::Size& size() const { return placement_.size; }
    [[nodiscard]] bool empty() const { return nodes_.empty(); }
    /// Adds its boxes and lines to a picture.
    void paint(Picture& picture, const layout::Point& corner, std::size_t parent) const;

private:
    /// What is drawn for a node.
    struct Shape {
        const frontend::State* state = nullptr;  ///< null for a name that means nothing
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

    void add_node(const frontend::State& state);
    void add_actions(Shape& shape);
    void add_arrow(const frontend::Transition& transition);
    [[nodiscard]] std::size_t end_of(const frontend::State* target, const frontend::QualifiedName& name);
    void lay_out();
    void paint_node(Picture& picture, std::size_t node, const layout::Point& corner, std::size_t parent) const;
    void paint_arrow(Picture& picture, std::size_t arrow, const layout::Point& corner, std::size_t first_box) const;

    std::string path_;
    const Drawing& drawing_;
    std::vector<Shape> nodes_;
    std::vector<Arrow> arrows_;
    layout::Level level_;
    layout::Placement placement_;
};

}  // namespace robochart::diagrams
