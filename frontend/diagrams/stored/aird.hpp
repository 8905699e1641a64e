// SPDX-License-Identifier: Apache-2.0
// Reads the files `representations.aird` into plain data: the drawn elements and their places. RoboTool stores diagrams
// in these files (XMI of Sirius and GMF). References are resolved in fragments.hpp, so reading opens no other file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/drawn_level.hpp"

namespace robochart::diagrams {

/// The index that means no shape.
inline constexpr std::size_t no_shape = static_cast<std::size_t>(-1);

/// The element that a shape or line represents.
struct AirdElement {
    std::string name;            ///< the displayed text
    std::string href;            ///< "FILE.rct#//@machines.0/@nodes.1"
    std::string mapping;         ///< "StateID"
    std::string source, target;  ///< ids of the elements at the ends of a line
};

/// A rectangle, or a label or compartment of one.
struct AirdShape {
    int type = 0;         ///< 2001 to 3012: shapes; 5001 to 6003: labels; 7001 to 7004: compartments
    std::string element;  ///< an id of an element
    std::size_t parent = no_shape;
    bool visible = true;
    std::optional<double> x, y, width, height;
};

/// A line.
struct AirdLine {
    std::string element;  ///< an id of an element
    layout::DrawnEdge route;
    bool visible = true;
};

/// A diagram: its elements by id. A shape comes before the shapes inside it.
struct AirdDiagram {
    std::map<std::string, AirdElement, std::less<>> elements;
    std::vector<AirdShape> shapes;
    std::vector<AirdLine> lines;
};

/// The contents of a file, or the error and its place.
struct Aird {
    std::vector<AirdDiagram> diagrams;
    std::string error;         ///< "" if it was read
    std::uint32_t offset = 0;  ///< the place of the error
};

/// The length of the longest accepted text, in bytes.
inline constexpr std::size_t longest_aird = std::size_t{64} << 20U;

/// Reads XML in UTF-8 without a document type. Rejects entity definitions, because they could grow without bound or
/// name other files. Also rejects elements that are nested too deeply, and numbers out of range.
[[nodiscard]] Aird read_aird(std::string_view text, diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams
