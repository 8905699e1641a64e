// SPDX-License-Identifier: Apache-2.0
// Assigns layers. Each box is placed as high as the boxes above it allow (longest path). Then each box moves to the
// layer in which its edges are shortest, so boxes with more successors than predecessors move down.
#include <algorithm>
#include <numeric>

#include "base/diagnostics/containers.hpp"
#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

/// The boxes above and below each box, one entry per edge.
struct Neighbours {
    std::vector<std::vector<std::size_t>> up, down;
};

Neighbours find_neighbours(const Graph& graph) {
    const Level& level = *graph.level;
    Neighbours result{std::vector<std::vector<std::size_t>>(level.boxes.size()),
                      std::vector<std::vector<std::size_t>>(level.boxes.size())};
    for (std::size_t e = 0; e < level.edges.size(); ++e) {
        std::size_t from = level.edges[e].from;
        std::size_t to = level.edges[e].to;
        if (graph.reversed[e]) std::swap(from, to);
        if (from == to || level.boxes[from].pin == Pin::last || level.boxes[to].pin == Pin::first) continue;
        result.down[from].push_back(to);
        result.up[to].push_back(from);
    }
    return result;
}

/// Returns an order in which every box comes after the boxes above it.
std::vector<std::size_t> topological_order(const Neighbours& near) {
    std::vector<std::size_t> waiting(near.up.size());
    std::vector<std::size_t> order;
    for (std::size_t b = 0; b < near.up.size(); ++b)
        if ((waiting[b] = near.up[b].size()) == 0) order.push_back(b);
    for (std::size_t i = 0; i < order.size(); ++i)
        for (const std::size_t below : near.down[order[i]])
            if (--waiting[below] == 0) order.push_back(below);
    return order;
}

/// Returns the first layer in which a box may be, without regard to its neighbours: after boxes pinned to the first
/// layer, and not above its own layer before an edit.
std::size_t first_layer(const Level& level, std::size_t box, bool some_first) {
    const Box& it = level.boxes[box];
    const std::size_t lowest = some_first && it.pin != Pin::first ? 1 : 0;
    return std::max(lowest, it.previous && it.pin == Pin::none ? it.previous->layer : 0);
}

/// Moves each box to that end of its free layers at which its edges are shorter. Returns true if a box moved.
bool shorten_edges(const Graph& graph, const Neighbours& near, const std::vector<std::size_t>& order,
                   std::vector<std::size_t>& layers) {
    bool moved = false;
    for (auto at = order.rbegin(); at != order.rend(); ++at) {
        const std::size_t box = *at;
        const Box& it = graph.level->boxes[box];
        if (it.pin != Pin::none || it.previous || near.down[box].size() <= near.up[box].size()) continue;
        std::size_t lowest = layers[near.down[box].front()];
        for (const std::size_t below : near.down[box]) lowest = std::min(lowest, layers[below]);
        if (lowest - 1 <= layers[box]) continue;
        layers[box] = lowest - 1;
        moved = true;
    }
    return moved;
}

/// Moves boxes pinned to the end to the last layer, and removes empty layers.
void finish_layers(const Level& level, std::vector<std::size_t>& layers) {
    std::size_t end = 0;
    for (std::size_t b = 0; b < layers.size(); ++b)
        if (level.boxes[b].pin != Pin::last) end = std::max(end, layers[b] + 1);
    for (std::size_t b = 0; b < layers.size(); ++b)
        if (level.boxes[b].pin == Pin::last) layers[b] = end;
    std::vector<std::size_t> used = layers;
    diagnostics::sort_unique(used);
    for (std::size_t& layer : layers)
        layer = static_cast<std::size_t>(std::ranges::lower_bound(used, layer) - used.begin());
}

}  // namespace

void assign_layers(Graph& graph) {
    const Level& level = *graph.level;
    const Neighbours near = find_neighbours(graph);
    const std::vector<std::size_t> order = topological_order(near);
    const bool some_first = std::ranges::any_of(level.boxes, [](const Box& box) { return box.pin == Pin::first; });
    std::vector<std::size_t>& layers = graph.layer_of_box;
    layers.resize(level.boxes.size());
    for (const std::size_t box : order) {
        graph.poll();
        std::size_t layer = first_layer(level, box, some_first);
        for (const std::size_t above : near.up[box]) layer = std::max(layer, layers[above] + 1);
        layers[box] = level.boxes[box].pin == Pin::first ? 0 : layer;
    }
    for (int round = 0; round < 8 && shorten_edges(graph, near, order, layers); ++round) graph.poll();
    finish_layers(level, layers);
}

}  // namespace robochart::diagrams::layout
