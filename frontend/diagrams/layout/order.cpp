// SPDX-License-Identifier: Apache-2.0
// Orders the nodes of each layer. Sweeps sort each layer by the mean position of the neighbours in the adjacent layer
// (barycentres), and adjacent nodes are exchanged. Several initial orders are tried. The first result with the fewest
// crossings is used. The first initial order is that of the text (Domroes, von Hanxleden: Preserving order during
// crossing minimization in Sugiyama layouts, 2022), or the order before an edit.
#include <algorithm>
#include <cstdint>

#include "base/diagnostics/splitmix64.hpp"
#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

using Layers = std::vector<std::vector<std::size_t>>;

/// The number of attempts, which is smaller for large graphs.
struct Effort {
    std::size_t starts = 40, sweeps = 16, exchanges = 8;
};
Effort effort_for(std::size_t nodes) {
    if (nodes > 20'000) return {1, 2, 0};
    if (nodes > 3'000) return {1, 6, 1};
    if (nodes > 800) return {3, 10, 4};
    if (nodes > 250) return {8, 16, 8};
    return {};
}

class Ordering {
public:
    explicit Ordering(Graph& graph) : graph_(graph), nodes_(graph.nodes), neighbours_(nodes_.size()) {
        for (const Link& link : graph.links) {
            if (link.turn != Link::Turn::none) continue;
            neighbours_[link.upper].down.push_back(link.lower);
            neighbours_[link.lower].up.push_back(link.upper);
        }
    }

    Ordered run() {
        const Effort effort = effort_for(nodes_.size());
        Layers best;
        std::size_t fewest = SIZE_MAX;
        const bool known = keep_order();
        if (known) {
            const std::size_t crossing = count_crossings();
            // The order before an edit is used even if it is slightly worse.
            fewest = crossing - std::min(crossing, 2 + crossing / 4);
            best = graph_.layers;
        }
        const Layers before = known ? best : Layers();
        for (std::size_t start = 0; start < effort.starts && fewest > 0; ++start) {
            begin(start);
            improve_order(effort, best, fewest);
        }
        graph_.layers = best;
        number_positions();
        return {count_crossings(), !known || best == before};
    }

private:
    struct Near {
        std::vector<std::size_t> up, down;
    };

    void number_positions() {
        for (const auto& layer : graph_.layers) number_positions(layer);
    }
    void number_positions(const std::vector<std::size_t>& layer) {
        for (std::size_t i = 0; i < layer.size(); ++i) nodes_[layer[i]].position = i;
    }

    /// Sorts each layer by keys. The sort is stable.
    void sort_layers(const std::vector<double>& keys) {
        for (auto& layer : graph_.layers) {
            std::ranges::sort(layer);
            std::ranges::stable_sort(layer, [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
        }
        number_positions();
    }

    /// Restores the order before an edit, and inserts new nodes at the positions with the fewest crossings. Returns
    /// false if there was no previous order.
    bool keep_order() {
        std::vector<std::size_t> places(nodes_.size(), nothing);
        bool known = false;
        for (std::size_t b = 0; b < graph_.level->boxes.size(); ++b)
            if (const auto& previous = graph_.level->boxes[b].previous) {
                places[b] = previous->position;
                known = true;
            }
        for (std::size_t e = 0; e < graph_.chains.size(); ++e) keep_order_of(e, places);
        if (!known) return false;
        std::vector<std::size_t> added;
        for (auto& layer : graph_.layers) {
            for (const std::size_t n : layer)
                if (places[n] == nothing) added.push_back(n);
            std::erase_if(layer, [&](std::size_t n) { return places[n] == nothing; });
            std::ranges::stable_sort(layer, [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
            number_positions(layer);
        }
        for (int round = 0; round < 3; ++round)
            for (const std::size_t n : added) insert_best(n);
        return true;
    }

    /// Restores the positions of an edge that passes the same number of layers as before.
    void keep_order_of(std::size_t e, std::vector<std::size_t>& places) const {
        std::vector<std::size_t> passed;
        for (const std::size_t l : graph_.chains[e])
            if (!nodes_[graph_.links[l].lower].is_box()) passed.push_back(graph_.links[l].lower);
        const auto& before = graph_.level->edges[e].previous;
        if (passed.size() != before.size()) return;
        for (std::size_t i = 0; i < passed.size(); ++i) places[passed[i]] = before[i];
    }

    /// Moves a node to the position at which its edges have the fewest crossings.
    void insert_best(std::size_t n) {
        graph_.poll();
        auto& layer = graph_.layers[nodes_[n].layer];
        std::erase(layer, n);
        number_positions(layer);
        std::size_t least = SIZE_MAX;
        std::size_t place = 0;
        const Near& own = neighbours_[n];
        std::size_t cost = 0;
        for (const std::size_t other : layer) cost += crossings_between(own, neighbours_[other]);
        for (std::size_t i = 0; i <= layer.size(); ++i) {
            if (cost < least) {
                least = cost;
                place = i;
            }
            if (i == layer.size()) break;
            const Near& other = neighbours_[layer[i]];
            cost = cost - crossings_between(own, other) + crossings_between(other, own);
        }
        layer.insert(layer.begin() + static_cast<std::ptrdiff_t>(place), n);
        number_positions(layer);
    }

    void begin(std::size_t start) {
        std::vector<double> keys = text_keys();
        if (start == 1)
            for (double& key : keys) key = -key;
        if (start == 2) keys = depth_keys();
        std::uint64_t state = start;
        if (start > 2)
            for (double& key : keys) key = static_cast<double>(diagnostics::splitmix64(state) >> 11U);
        sort_layers(keys);
    }

    /// Returns keys from the textual order of boxes. Edges that pass a layer get keys from their ends.
    [[nodiscard]] std::vector<double> text_keys() const {
        const Level& level = *graph_.level;
        std::vector<double> keys(nodes_.size());
        const auto key_of = [](std::size_t box) { return static_cast<double>(box); };
        for (std::size_t n = 0; n < nodes_.size(); ++n) {
            const Node& node = nodes_[n];
            keys[n] = node.is_box() ? key_of(node.box)
                                    : (key_of(level.edges[node.edge].from) + key_of(level.edges[node.edge].to)) / 2;
        }
        return keys;
    }

    /// Returns the order in which a depth-first search visits the nodes.
    [[nodiscard]] std::vector<double> depth_keys() const {
        std::vector<double> keys(nodes_.size(), -1);
        double next = 0;
        std::vector<std::size_t> open;
        for (const auto& layer : graph_.layers)
            for (const std::size_t root : layer) {
                open.push_back(root);
                while (!open.empty()) {
                    const std::size_t node = open.back();
                    open.pop_back();
                    if (keys[node] >= 0) continue;
                    keys[node] = next++;
                    const auto& down = neighbours_[node].down;
                    open.insert(open.end(), down.rbegin(), down.rend());
                }
            }
        return keys;
    }

    void improve_order(const Effort& effort, Layers& best, std::size_t& fewest) {
        std::size_t without_gain = 0;
        for (std::size_t sweep = 0; sweep <= effort.sweeps && without_gain < 5 && fewest > 0; ++sweep, ++without_gain) {
            if (sweep > 0) this->sweep_layers(sweep % 2 == 1);
            for (std::size_t i = 0; i < effort.exchanges && exchange_neighbours(); ++i) graph_.poll();
            const std::size_t now = count_crossings();
            if (now >= fewest) continue;
            fewest = now;
            best = graph_.layers;
            without_gain = 0;
        }
    }

    void sweep_layers(bool downwards) {
        const std::size_t count = graph_.layers.size();
        for (std::size_t i = 1; i < count; ++i) {
            graph_.poll();
            sort_by_barycentre(graph_.layers[downwards ? i : count - 1 - i], downwards);
        }
    }

    void sort_by_barycentre(std::vector<std::size_t>& layer, bool from_above) {
        std::vector<std::pair<double, std::size_t>> keyed;
        for (const std::size_t n : layer) {
            const auto& near = from_above ? neighbours_[n].up : neighbours_[n].down;
            double sum = 0;
            for (const std::size_t other : near) sum += static_cast<double>(nodes_[other].position);
            const double own = static_cast<double>(nodes_[n].position);
            keyed.emplace_back(near.empty() ? own : sum / static_cast<double>(near.size()), n);
        }
        std::ranges::stable_sort(keyed, [](const auto& a, const auto& b) { return a.first < b.first; });
        std::ranges::transform(keyed, layer.begin(), [](const auto& entry) { return entry.second; });
        number_positions(layer);
    }

    /// Returns the number of crossings, on one side, between the edges of two nodes if `a` is left of `b`.
    [[nodiscard]] std::size_t crossings_of(const std::vector<std::size_t>& a, const std::vector<std::size_t>& b) const {
        std::size_t count = 0;
        for (const std::size_t x : a)
            for (const std::size_t y : b)
                if (nodes_[x].position > nodes_[y].position) ++count;
        return count;
    }

    [[nodiscard]] std::size_t crossings_between(const Near& left, const Near& right) const {
        return crossings_of(left.up, right.up) + crossings_of(left.down, right.down);
    }

    /// Exchanges adjacent nodes if that reduces the number of crossings.
    bool exchange_neighbours() {
        bool changed = false;
        for (auto& layer : graph_.layers)
            for (std::size_t i = 0; i + 1 < layer.size(); ++i) {
                const Near& a = neighbours_[layer[i]];
                const Near& b = neighbours_[layer[i + 1]];
                const std::size_t now = crossings_between(a, b);
                if (now == 0 || now <= crossings_between(b, a)) continue;
                std::swap(layer[i], layer[i + 1]);
                nodes_[layer[i]].position = i;
                nodes_[layer[i + 1]].position = i + 1;
                changed = true;
            }
        return changed;
    }

    [[nodiscard]] std::size_t count_crossings() const {
        std::size_t count = 0;
        for (std::size_t i = 0; i + 1 < graph_.layers.size(); ++i) count += crossings_below(i);
        return count;
    }

    /// Returns the number of pairs of links in different order at both ends, counted with a tree of sums (Barth,
    /// Mutzel, Juenger: Simple and efficient bilayer cross counting, 2004).
    [[nodiscard]] std::size_t crossings_below(std::size_t upper) const {
        std::vector<std::size_t> sums(graph_.layers[upper + 1].size() + 1);
        std::size_t seen = 0;
        std::size_t count = 0;
        for (const std::size_t n : graph_.layers[upper]) {
            const auto& down = neighbours_[n].down;
            for (const std::size_t other : down) {
                std::size_t not_right = 0;
                for (std::size_t i = nodes_[other].position + 1; i > 0; i &= i - 1) not_right += sums[i];
                count += seen - not_right;
            }
            for (const std::size_t other : down)
                for (std::size_t i = nodes_[other].position + 1; i < sums.size(); i += i & (~i + 1)) ++sums[i];
            seen += down.size();
        }
        return count;
    }

    Graph& graph_;
    std::vector<Node>& nodes_;
    std::vector<Near> neighbours_;
};

}  // namespace

Ordered order_layers(Graph& graph) {
    return Ordering(graph).run();
}

}  // namespace robochart::diagrams::layout
