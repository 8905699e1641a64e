// SPDX-License-Identifier: Apache-2.0
// Explores the states of a model in breadth-first order and fills a state space. See "Semantics" in
// docs/probability.md.
#pragma once

#include <utility>
#include <vector>

#include "prism/explore/commands.hpp"
#include "prism/explore/state_space.hpp"

namespace robochart::prism {

class Explorer {
public:
    Explorer(StateSpace& space, Code& code);
    void operator()();

private:
    using Distribution = std::vector<std::pair<markov::State, NumberTable::Id>>;

    void initial_states();
    void expand(markov::State state);
    void explore_act(const CommandTable::Act& act);
    void combine(const CommandTable::Act& act, std::size_t part, Distribution& distribution);
    void branch(const CommandTable::Act& act, std::size_t part, NumberTable::Id probability,
                Distribution& distribution);
    void merge_branches(Distribution& distribution);
    void push_choice(std::uint32_t action, const Distribution& distribution);
    NumberTable::Id number_of(std::uint64_t count);
    void finish_state(markov::State state);
    markov::State insert(const lts::Word* words);
    void finish_model();

    StateSpace& space_;
    Code& code_;
    NumberTable numbers_;
    CommandTable commands_;
    std::vector<std::int32_t> values_;
    std::vector<std::vector<lts::Word>> partial_;  ///< by number of parts: the packed successor after these parts
    std::vector<std::uint32_t> chosen_;            ///< the chosen command of each part
    Distribution all_;                             ///< the single choice of a dtmc
    std::vector<NumberTable::Id> counts_;          ///< the numbers 0, 1, 2, ...
    std::uint64_t combinations_ = 0;               ///< number of combinations in this state
    LeftOut left_out_;
};

}  // namespace robochart::prism
