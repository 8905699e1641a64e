// SPDX-License-Identifier: Apache-2.0
// Measures the time to solve Markov models: benchmark_markov [SIDE]. The model is a random walk on a torus of SIDE x
// SIDE cells (default 1,000), which is one strongly connected component. Each step may end the walk in one of two ways.
// In the decision process the scheduler also chooses whether to move along rows or along columns.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "benchmarks/cpu_time.hpp"
#include "prism/markov/operators/bounded.hpp"
#include "prism/markov/operators/unbounded.hpp"

namespace {

using namespace robochart;
using markov::State;

class Walk {
public:
    Walk(markov::Kind kind, State side) : side_(side) {
        model_.kind = kind;
        model_.initial = {0};
        model_.numbers = {{1, 1},
                          {0.25, 0.25},
                          {0.5, 0.5},
                          {0x1p-8, 0x1p-8},
                          {0.25 - 0x1p-9, 0.25 - 0x1p-9},
                          {0.5 - 0x1p-9, 0.5 - 0x1p-9}};
        model_.first_choice = {0};
        model_.first_branch = {0};
        for (State row = 0; row < side; ++row)
            for (State column = 0; column < side; ++column) add_cell(row, column);
        for (const State end : {won(), lost()}) {
            add_choice({{end, 0}});
            finish_state();
        }
    }

    [[nodiscard]] const markov::Model& model() const { return model_; }
    [[nodiscard]] State won() const { return side_ * side_; }

private:
    struct Branch {
        State target;
        std::uint32_t number;
    };

    [[nodiscard]] State lost() const { return won() + 1; }
    [[nodiscard]] State cell(State row, State column) const { return row % side_ * side_ + column % side_; }

    void add_cell(State row, State column) {
        // The walk ends with probability 2^-8: with a win in the first half of the rows, with a loss in the others.
        const Branch end{row < side_ / 2 ? won() : lost(), 3};
        const State left = cell(row, column + side_ - 1);
        const State right = cell(row, column + 1);
        const State up = cell(row + side_ - 1, column);
        const State down = cell(row + 1, column);
        if (model_.kind == markov::Kind::dtmc) {
            add_choice({{left, 1}, {right, 1}, {up, 4}, {down, 4}, end});
        } else {
            add_choice({{left, 5}, {right, 5}, end});
            add_choice({{up, 5}, {down, 5}, end});
        }
        finish_state();
    }

    void add_choice(std::vector<Branch> branches) {
        std::ranges::sort(branches, {}, &Branch::target);
        for (const Branch& branch : branches) {
            model_.target.push_back(branch.target);
            model_.number.push_back(branch.number);
        }
        model_.first_branch.push_back(model_.target.size());
    }

    void finish_state() { model_.first_choice.push_back(static_cast<std::uint32_t>(model_.choices())); }

    const State side_;
    markov::Model model_;
};

void measure(const std::string& name, const Walk& walk) {
    const markov::Model& model = walk.model();
    const markov::StateSet all(model.states(), true);
    markov::StateSet goal(model.states(), false);
    goal[walk.won()] = true;
    fmt::print("{}: {} states, {} transitions\n", name, model.states(), model.target.size());

    constexpr std::uint64_t steps = 20;
    double begin = thread_cpu_seconds();
    const markov::Solution bounded = markov::bounded_until(model, all, goal, 0, steps, markov::Direction::maximum);
    double seconds = thread_cpu_seconds() - begin;
    fmt::print("  F<={}: {:.2f} s, {:.0f} million transition visits/s\n", steps, seconds,
               static_cast<double>(steps * model.target.size()) / seconds / 1e6);

    begin = thread_cpu_seconds();
    const markov::Solution solution = markov::until(model, all, goal, markov::Direction::maximum);
    seconds = thread_cpu_seconds() - begin;
    double width = 0;
    for (const markov::Enclosure& value : solution.values) width = std::max(width, value.relative_width());
    fmt::print("  F: {:.2f} s, widest enclosure {:.1e}{}\n", seconds, width,
               solution.shortfall.empty() ? "" : " (" + solution.shortfall + ")");
}

}  // namespace

int main(int argc, char** argv) {
    const State side = argc > 1 ? static_cast<State>(std::stoul(argv[1])) : 1'000;
    measure("chain", Walk(markov::Kind::dtmc, side));
    measure("decision process", Walk(markov::Kind::mdp, side));
    fmt::print(
        "recorded of others: PRISM 4.6, hybrid engine, one sweep a second over 9.6 million transitions of the UVC case "
        "study, one bound;\nguards compiled to C++, the same model, 70 million transition visits/s, both bounds\n");
}
