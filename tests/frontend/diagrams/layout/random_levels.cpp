// SPDX-License-Identifier: Apache-2.0
#include "tests/frontend/diagrams/layout/random_levels.hpp"

#include "base/diagnostics/splitmix64.hpp"

namespace robochart::diagrams {
namespace {

/// Draws random numbers below a bound.
class Dice {
public:
    explicit Dice(std::uint64_t seed) : state_(seed * 7919 + 1) {}
    std::size_t below(std::size_t bound) { return diagnostics::splitmix64(state_) % bound; }
    double size(double least, double most) {
        return least + (most - least) * static_cast<double>(below(1000)) / 1000.0;
    }
    bool one_in(std::size_t count) { return below(count) == 0; }

private:
    std::uint64_t state_;
};

}  // namespace

layout::Level random_machine(std::uint64_t seed, std::size_t most_boxes) {
    Dice dice(seed);
    layout::Level level;
    const std::size_t boxes = 1 + dice.below(most_boxes);
    for (std::size_t b = 0; b < boxes; ++b) {
        layout::Box box;
        box.entry = b == 0;
        box.round = box.entry || dice.one_in(6);
        box.size = box.round ? layout::Size{24, 24} : layout::Size{dice.size(40, 250), dice.size(24, 200)};
        level.boxes.push_back(box);
    }
    const std::size_t edges = dice.below(2 * boxes + 1);
    for (std::size_t e = 0; e < edges; ++e) {
        layout::Edge edge;
        edge.from = dice.below(boxes);
        edge.to = dice.below(boxes);
        if (edge.from == edge.to && level.boxes[edge.from].round) continue;  // the rules forbid such edges
        if (!dice.one_in(3)) edge.label = {dice.size(8, 240), static_cast<double>(14 * (1 + dice.below(5)))};
        level.edges.push_back(edge);
    }
    return level;
}

layout::Level random_components(std::uint64_t seed, std::size_t most_boxes) {
    Dice dice(seed);
    layout::Level level;
    const std::size_t boxes = 1 + dice.below(most_boxes);
    for (std::size_t b = 0; b < boxes; ++b) {
        layout::Box box;
        box.size = {dice.size(60, 220), dice.size(40, 120)};
        box.port_start = dice.size(24, 80);
        box.ports.resize(dice.below(6), {dice.size(10, 90)});
        if (b == 0 && dice.one_in(2)) box.pin = layout::Pin::first;
        level.boxes.push_back(box);
    }
    const std::size_t borders = dice.below(4);
    for (std::size_t i = 0; i < borders; ++i) {
        layout::Box box;
        box.size = {0, layout::port_size};
        box.pin = dice.one_in(2) ? layout::Pin::first : layout::Pin::last;
        box.on_border = true;
        box.ports.resize(1);
        level.boxes.push_back(box);
    }
    const std::size_t edges = dice.below(3 * level.boxes.size());
    for (std::size_t e = 0; e < edges; ++e) {
        layout::Edge edge;
        edge.from = dice.below(level.boxes.size());
        edge.to = dice.below(level.boxes.size());
        const auto& from = level.boxes[edge.from];
        const auto& to = level.boxes[edge.to];
        if (edge.from == edge.to || from.ports.empty() || to.ports.empty()) continue;
        edge.from_port = dice.below(from.ports.size());
        edge.to_port = dice.below(to.ports.size());
        if (dice.one_in(2)) edge.label = {36, 14};
        level.edges.push_back(edge);
    }
    return level;
}

}  // namespace robochart::diagrams
