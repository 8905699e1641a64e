// Files `representations.aird`, in which RoboTool keeps diagrams (XMI of Sirius and GMF), as plain data: what is drawn,
// and where. What the data refer to is looked for elsewhere (fragments.hpp): reading opens nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "diagnostics/budget.hpp"
#include "diagrams/layout/drawn_level.hpp"

namespace robochart::diagrams {

/// No shape.
inline constexpr std::size_t no_shape = static_cast<std::size_t>(-1);

/// What a shape or line stands for.
struct AirdElement {
    std::string name;            ///< the text shown
    std::string href;            ///< "FILE.rct#//@machines.0/@nodes.1"
    std::string mapping;         ///< "StateID"
    std::string source, target;  ///< of a line: ids of elements
};

/// A rectangle, or a label or compartment in or beside one.
struct AirdShape {
    int type = 0;         ///< 2001 to 3012: shapes; 5001 to 6003: labels; 7001 to 7004: compartments
    std::string element;  ///< an id
    std::size_t parent = no_shape;
    bool visible = true;
    std::optional<double> x, y, width, height;
};

/// A line.
struct AirdLine {
    std::string element;  ///< an id
    layout::DrawnEdge route;
    bool visible = true;
};

/// A diagram: elements by id, shapes with each before what is in it.
struct AirdDiagram {
    std::map<std::string, AirdElement, std::less<>> elements;
    std::vector<AirdShape> shapes;
    std::vector<AirdLine> lines;
};

/// A file, or why it cannot be read and where.
struct Aird {
    std::vector<AirdDiagram> diagrams;
    std::string error;         ///< "" where it was read
    std::uint32_t offset = 0;  ///< of the error
};

/// The longest text that is read.
inline constexpr std::size_t longest_aird = std::size_t{64} << 20U;

/// XML in UTF-8 without a document type: entities of its own, which could grow without bounds or name other files, are
/// refused, as are elements nested too deeply and numbers out of range.
[[nodiscard]] Aird read_aird(std::string_view text, diagnostics::Budget* budget = nullptr);

}  // namespace robochart::diagrams
