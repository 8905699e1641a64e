// SPDX-License-Identifier: Apache-2.0
// Computes the y of every layer and the tracks of horizontal edge segments between two layers. The vertical order of
// two segments decides whether they cross, and whether their vertical neighbours overlap. An insertion search orders
// all segments of a gap.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "frontend/diagrams/layout/graph.hpp"

namespace robochart::diagrams::layout {
namespace {

/// A horizontal segment with the vertical segments at its ends.
struct Piece {
    std::size_t link = nothing;
    std::size_t part = 0;          ///< index in its link, from the upper end
    std::vector<double> up, down;  ///< x of the segments that lead up and down from it
    double low = 0, high = 0;      ///< the range of x
    double to = 0;                 ///< x at which it continues
    std::size_t track = 0;
};

void set_extent(Piece& piece) {
    piece.low = std::numeric_limits<double>::infinity();
    piece.high = -piece.low;
    for (const auto* ends : {&piece.up, &piece.down})
        for (const double x : *ends) {
            piece.low = std::min(piece.low, x);
            piece.high = std::max(piece.high, x);
        }
}

constexpr std::size_t on_each_other = 1000;   ///< cost of overlapping lines
constexpr std::size_t largest_search = 1200;  ///< order is optimised only for gaps with at most this many segments

/// Returns the cost of placing `a` above `b`.
std::size_t cost_above(const Piece& a, const Piece& b) {
    if (a.link == b.link) return a.part < b.part ? 0 : on_each_other * on_each_other;
    std::size_t cost = 0;
    for (const double x : a.down) {
        if (x > b.low && x < b.high) ++cost;
        for (const double y : b.up)
            if (std::abs(x - y) < distance::pieces) cost += on_each_other;
    }
    for (const double x : b.up)
        if (x > a.low && x < a.high) ++cost;
    return cost;
}

bool segments_meet(const Piece& a, const Piece& b) {
    return a.low - distance::pieces < b.high && b.low - distance::pieces < a.high;
}

/// The segments between two layers.
class Gap {
public:
    explicit Gap(Graph& graph) : graph_(graph) {}

    void add(std::size_t l) {
        const Link& link = graph_.links[l];
        Piece piece;
        piece.link = l;
        piece.to = link.lower_x;
        straight_.push_back(link.upper_x);
        straight_.push_back(link.lower_x);
        if (link.turn == Link::Turn::none) {
            if (std::abs(link.upper_x - link.lower_x) < 0.01) return;
            piece.up = {link.upper_x};
            piece.down = {link.lower_x};
        } else {
            (link.turn == Link::Turn::under ? piece.up : piece.down) = {link.upper_x, link.lower_x};
        }
        set_extent(piece);
        pieces_.push_back(std::move(piece));
    }

    /// Orders the segments and assigns tracks. Returns the number of tracks.
    std::size_t assign_tracks() {
        order_segments();
        for (int i = 0; i < 32 && split_one(); ++i) order_segments();
        std::size_t count = 0;
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            graph_.poll();
            for (std::size_t j = 0; j < i; ++j)
                if (segments_meet(pieces_[i], pieces_[j]))
                    pieces_[i].track = std::max(pieces_[i].track, pieces_[j].track + 1);
            count = std::max(count, pieces_[i].track + 1);
        }
        return count;
    }

    /// Sets the positions. The first track is at `y`.
    void set_positions(double y) {
        std::ranges::stable_sort(pieces_, [](const Piece& a, const Piece& b) { return a.part < b.part; });
        for (const Piece& piece : pieces_)
            graph_.links[piece.link].tracks.push_back(
                {y + static_cast<double>(piece.track) * distance::tracks, piece.to});
    }

private:
    /// Inserts the segments one at a time, longest first, at the cheapest position. Then moves every segment again
    /// until the cost no longer improves.
    void order_segments() {
        for (Piece& piece : pieces_) piece.track = 0;
        std::ranges::stable_sort(pieces_,
                                 [](const Piece& a, const Piece& b) { return a.high - a.low > b.high - b.low; });
        if (pieces_.size() > largest_search) return;
        compute_costs();
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < pieces_.size(); ++i) insert_cheapest(order, i);
        for (int round = 0; round < 12 && improve_order(order); ++round) graph_.poll();
        std::vector<Piece> sorted;
        for (const std::size_t i : order) sorted.push_back(std::move(pieces_[i]));
        pieces_ = std::move(sorted);
    }

    void compute_costs() {
        costs_.assign(pieces_.size(), std::vector<std::size_t>(pieces_.size()));
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            graph_.poll();
            for (std::size_t j = 0; j < pieces_.size(); ++j)
                if (i != j) costs_[i][j] = cost_above(pieces_[i], pieces_[j]);
        }
    }

    /// Inserts the segment at the cheapest position. Returns the cost.
    std::size_t insert_cheapest(std::vector<std::size_t>& order, std::size_t piece) const {
        std::size_t cost = 0;
        for (const std::size_t other : order) cost += costs_[piece][other];
        std::size_t least = cost;
        std::size_t place = 0;
        for (std::size_t i = 0; i < order.size(); ++i) {
            cost = cost - costs_[piece][order[i]] + costs_[order[i]][piece];
            if (cost >= least) continue;
            least = cost;
            place = i + 1;
        }
        order.insert(order.begin() + static_cast<std::ptrdiff_t>(place), piece);
        return least;
    }

    bool improve_order(std::vector<std::size_t>& order) const {
        bool better = false;
        for (std::size_t piece = 0; piece < pieces_.size(); ++piece) {
            const auto at = std::ranges::find(order, piece);
            const auto place = static_cast<std::size_t>(at - order.begin());
            std::size_t now = 0;
            for (std::size_t i = 0; i < order.size(); ++i)
                if (i != place) now += i < place ? costs_[order[i]][piece] : costs_[piece][order[i]];
            if (now == 0) continue;
            std::vector<std::size_t> rest = order;
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
            if (insert_cheapest(rest, piece) >= now) continue;
            order = std::move(rest);
            better = true;
        }
        return better;
    }

    /// Splits one segment over two tracks, if two segments would overlap in either order. Returns true if there was
    /// such a pair.
    bool split_one() {
        for (std::size_t i = 0; i < pieces_.size() && pieces_.size() <= largest_search; ++i)
            for (std::size_t j = i + 1; j < pieces_.size(); ++j) {
                if (pieces_[i].link == pieces_[j].link || cost_above(pieces_[i], pieces_[j]) < on_each_other) continue;
                if (split_segment(i) || split_segment(j)) return true;
            }
        return false;
    }

    bool split_segment(std::size_t i) {
        Piece& piece = pieces_[i];
        if (piece.up.size() != 1 || piece.down.size() != 1) return false;
        const double x = free_x((piece.up[0] + piece.down[0]) / 2);
        Piece rest = piece;
        rest.part = piece.part + 1;
        rest.up = {x};
        for (Piece& other : pieces_)
            if (other.link == piece.link && other.part > piece.part) ++other.part;
        piece.down = {x};
        piece.to = x;
        set_extent(piece);
        set_extent(rest);
        straight_.push_back(x);
        pieces_.push_back(std::move(rest));
        return true;
    }

    /// Returns the nearest x without a vertical line.
    [[nodiscard]] double free_x(double middle) const {
        for (double away = 0;; away += 1)
            for (const double x : {middle + away, middle - away}) {
                const auto near = [&](double other) { return std::abs(other - x) < distance::pieces; };
                if (std::ranges::none_of(straight_, near)) return x;
            }
    }

    Graph& graph_;
    std::vector<Piece> pieces_;
    std::vector<double> straight_;  ///< x of all vertical lines
    std::vector<std::vector<std::size_t>> costs_;
};

/// Returns the gap above a layer (0 for the first layer) that contains a link.
std::size_t gap_of(const Graph& graph, const Link& link) {
    const std::size_t layer = graph.nodes[link.upper].layer;
    return link.turn == Link::Turn::over ? layer : layer + 1;
}

/// Returns the distance between the tracks and an adjacent layer.
double track_margin(const Graph& graph, std::size_t layer) {
    if (layer % 2 == 0) return distance::at_boxes;
    for (const std::size_t n : graph.layers[layer])
        if (graph.nodes[n].kind == Node::Kind::label) return distance::at_labels;
    return distance::at_lines;
}

struct Reach {
    double above = 0, below = 0;
};
Reach reach_of(const Graph& graph, const std::vector<std::size_t>& layer) {
    Reach reach;
    for (const std::size_t n : layer) {
        reach.above = std::max(reach.above, graph.nodes[n].above);
        reach.below = std::max(reach.below, graph.nodes[n].below);
    }
    return reach;
}

}  // namespace

void place_tracks(Graph& graph) {
    const std::size_t count = graph.layers.size();
    std::vector<Gap> gaps(count + 1, Gap(graph));
    for (std::size_t l = 0; l < graph.links.size(); ++l) gaps[gap_of(graph, graph.links[l])].add(l);
    graph.layer_y.resize(count);
    double y = 0;
    for (std::size_t i = 0; i <= count; ++i) {
        const std::size_t tracks = gaps[i].assign_tracks();
        if (i > 0 && (tracks > 0 || i < count)) y += track_margin(graph, i - 1);
        gaps[i].set_positions(y);
        if (tracks > 1) y += static_cast<double>(tracks - 1) * distance::tracks;
        if (i == count) break;
        if (i > 0 || tracks > 0) y += track_margin(graph, i);
        const Reach reach = reach_of(graph, graph.layers[i]);
        graph.layer_y[i] = y + reach.above;
        y += reach.above + reach.below;
    }
}

}  // namespace robochart::diagrams::layout
