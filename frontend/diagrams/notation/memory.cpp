// SPDX-License-Identifier: Apache-2.0
// See memory.hpp.
#include "frontend/diagrams/notation/memory.hpp"

#include <fmt/format.h>

#include "frontend/diagrams/layout/arrange.hpp"

namespace robochart::diagrams {
namespace {

void number_equal_names(std::vector<std::string>& names) {
    std::map<std::string, std::size_t> seen;
    for (std::string& name : names) {
        const std::size_t before = seen[name]++;
        if (before > 0) name += fmt::format("#{}", before);
    }
}

void recall_placement(layout::Level& level, const LevelNames& names, const LevelMemory& memory) {
    level.previous = memory.direction;
    for (std::size_t b = 0; b < level.boxes.size(); ++b)
        if (const auto at = memory.boxes.find(names.boxes[b]); at != memory.boxes.end())
            level.boxes[b].previous = at->second;
    for (std::size_t e = 0; e < level.edges.size(); ++e)
        if (const auto at = memory.edges.find(names.edges[e]); at != memory.edges.end())
            level.edges[e].previous = at->second;
}

void remember_placement(const layout::Placement& placement, const LevelNames& names, LevelMemory& memory) {
    memory = {};
    memory.direction = placement.direction;
    for (std::size_t b = 0; b < names.boxes.size(); ++b) memory.boxes[names.boxes[b]] = placement.boxes[b].rank;
    for (std::size_t e = 0; e < names.edges.size(); ++e) memory.edges[names.edges[e]] = placement.edges[e].ranks;
}

}  // namespace

layout::Placement arrange_again(layout::Level& level, LevelNames names, Memory* memory, diagnostics::Budget* budget) {
    if (memory == nullptr) return layout::arrange_level(level, budget);
    number_equal_names(names.boxes);
    number_equal_names(names.edges);
    if (const auto at = memory->levels.find(names.path); at != memory->levels.end())
        recall_placement(level, names, at->second);
    layout::Placement placement = layout::arrange_level(level, budget);
    remember_placement(placement, names, memory->levels[names.path]);
    return placement;
}

}  // namespace robochart::diagrams
