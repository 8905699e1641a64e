// SPDX-License-Identifier: Apache-2.0
// Represents the layout in which a person drew a component, keyed by declarations. frontend/diagrams/stored reads it
// from RoboTool's files.
#pragma once

#include <unordered_map>

#include "frontend/diagrams/layout/drawn_level.hpp"
#include "frontend/syntax/ast.hpp"

namespace robochart::diagrams {

/// The area of the nodes of a machine or state, or of the components of a module or controller.
struct StoredArea {
    layout::Size size;            ///< 0: automatic
    std::optional<double> above;  ///< height of the part of the diagram above the area, including the title
};

/// The layout of one component. Its maps are used for lookup only. Positions are relative to the enclosing area.
struct StoredLayout {
    std::unordered_map<const frontend::Declaration*, layout::DrawnBox> boxes;  ///< nodes, components, the component
                                                                               ///< itself
    std::unordered_map<const frontend::Declaration*, StoredArea> areas;  ///< areas in components, machines and states
    std::unordered_map<const frontend::Declaration*, layout::DrawnEdge> lines;  ///< transitions, connections
    /// Events on the border of the component or of its components.
    std::unordered_map<const frontend::Declaration*,
                       std::unordered_map<const frontend::Declaration*, layout::DrawnPort>>
        squares;

    [[nodiscard]] std::optional<layout::DrawnBox> box_of(const frontend::Declaration* of) const;
    [[nodiscard]] StoredArea area_of(const frontend::Declaration* of) const;
    [[nodiscard]] std::optional<layout::DrawnEdge> line_of(const frontend::Declaration* of) const;
    [[nodiscard]] std::optional<layout::DrawnPort> port_of(const frontend::Declaration* owner,
                                                           const frontend::Declaration* event) const;
    /// Returns the size of a component in the diagram, if known.
    [[nodiscard]] layout::Size size(const frontend::Declaration* of) const;
};

}  // namespace robochart::diagrams
