// SPDX-License-Identifier: Apache-2.0
// Remembers how components were laid out before an edit, so that an edit moves few elements.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "frontend/diagrams/layout/level.hpp"

namespace robochart::diagrams {

/// The layout of one level: its nodes and edges by name.
struct LevelMemory {
    layout::Direction direction = layout::Direction::down;
    std::map<std::string, layout::Rank> boxes;
    std::map<std::string, std::vector<std::size_t>> edges;
};

/// The levels of all diagrams, by path.
struct Memory {
    std::map<std::string, LevelMemory> levels;
};

/// The names of the boxes and edges of a level. Equal names are numbered.
struct LevelNames {
    std::string path;
    std::vector<std::string> boxes, edges;
};

/// Lays out a level as similarly as possible to the remembered layout, and remembers the result.
[[nodiscard]] layout::Placement arrange_again(layout::Level& level, LevelNames names, Memory* memory,
                                              diagnostics::Budget* budget);

}  // namespace robochart::diagrams
