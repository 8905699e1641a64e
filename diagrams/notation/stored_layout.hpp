// Where a person put the elements of a component, by their declarations. diagrams/stored reads it from files of
// RoboTool.
#pragma once

#include <unordered_map>

#include "diagrams/layout/drawn_level.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// Where the nodes of a machine or state are, or the parts of a component.
struct StoredArea {
    layout::Size size;            ///< 0: automatic
    std::optional<double> above;  ///< height of what is above it in the diagram, its title too
};

/// The layout of one component; its maps are asked only, never walked. Places are within the area that an element is
/// in.
struct StoredLayout {
    std::unordered_map<const frontend::Declaration*, layout::DrawnBox> boxes;   ///< nodes, parts, the component itself
    std::unordered_map<const frontend::Declaration*, StoredArea> areas;         ///< of components, machines, states
    std::unordered_map<const frontend::Declaration*, layout::DrawnEdge> lines;  ///< transitions, connections
    /// Events on the border of a component or part.
    std::unordered_map<const frontend::Declaration*,
                       std::unordered_map<const frontend::Declaration*, layout::DrawnPort>>
        squares;

    [[nodiscard]] std::optional<layout::DrawnBox> box(const frontend::Declaration* of) const;
    [[nodiscard]] StoredArea area(const frontend::Declaration* of) const;
    [[nodiscard]] std::optional<layout::DrawnEdge> line(const frontend::Declaration* of) const;
    [[nodiscard]] std::optional<layout::DrawnPort> square(const frontend::Declaration* owner,
                                                          const frontend::Declaration* event) const;
    /// The size that a component or part has in the diagram, as far as it is known.
    [[nodiscard]] layout::Size size(const frontend::Declaration* of) const;
};

}  // namespace robochart::diagrams
