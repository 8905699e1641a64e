// How components were laid out before an edit, so that an edit moves little.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "diagnostics/budget.hpp"
#include "diagrams/layout/level.hpp"

namespace robochart::diagrams {

/// A level of a component: its nodes and edges by their names.
struct LevelMemory {
    layout::Direction direction = layout::Direction::down;
    std::map<std::string, layout::Rank> boxes;
    std::map<std::string, std::vector<std::size_t>> edges;
};

/// The levels of all diagrams by their paths.
struct Memory {
    std::map<std::string, LevelMemory> levels;
};

/// The names of the boxes and edges of a level, made different by numbers.
struct LevelNames {
    std::string path;
    std::vector<std::string> boxes, edges;
};

/// Lays a level out as far as possible as it was before, and remembers how.
[[nodiscard]] layout::Placement arrange_again(layout::Level& level, LevelNames names, Memory* memory,
                                              diagnostics::Budget* budget);

}  // namespace robochart::diagrams
