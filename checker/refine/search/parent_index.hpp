// SPDX-License-Identifier: Apache-2.0
// Stores the BFS parents of states as a succinct bit vector (rank/select), with two bits for each state. States are
// numbered in the order of discovery and expanded in the same order. So it is enough to store how many states each
// state has found. The vector contains a one for each state found. After the ones of the states that an expanded state
// has found, it contains a zero. So the parent of a state is the number of zeros before the one of this state.
#pragma once

#include <cstdint>
#include <vector>

#include "checker/lts/index_table.hpp"

namespace robochart::refine {

class ParentIndex {
public:
    /// Records that the next state has been expanded and has found this many new states.
    void add_expanded_state(std::uint32_t found);
    /// Appends the records of another index, which must describe the states that follow.
    void append(const ParentIndex& next);
    void clear();
    /// Returns the parent of a state, which must not be state 0.
    [[nodiscard]] lts::StateIndex parent(lts::StateIndex state) const;

private:
    void append(std::uint64_t bits, std::uint32_t count);
    void begin_word();

    std::vector<std::uint64_t> words_;
    std::vector<std::uint64_t> ones_before_;  // by block of words: the number of ones before it
    std::uint64_t size_ = 0;
    std::uint64_t ones_ = 0;
};

}  // namespace robochart::refine
