// SPDX-License-Identifier: Apache-2.0
// Compares parents that are stored in two bits per state with a plain list of parents.
#include "checker/refine/search/parent_index.hpp"

#include <gtest/gtest.h>

#include <random>

namespace robochart::refine {
namespace {

TEST(ParentIndex, RemembersTheParentOfEveryState) {
    std::mt19937 random(11);
    ParentIndex index;
    std::vector<lts::StateIndex> parents{lts::no_state};
    for (lts::StateIndex state = 0; state < 40000; ++state) {
        // Some long stretches of states have no children, and other states have many. A state is always left to expand.
        std::uint32_t found = state % 1000 < 700 ? 0 : static_cast<std::uint32_t>(random() % 8);
        if (state + 1 == parents.size()) found += 150;
        index.add_expanded_state(found);
        parents.insert(parents.end(), found, state);
    }
    ASSERT_GT(parents.size(), 40000U);
    for (lts::StateIndex state = 1; state < parents.size(); ++state) ASSERT_EQ(index.parent(state), parents[state]);
}

TEST(ParentIndex, IsTheSameNotedInStretches) {
    std::mt19937 random(12);
    ParentIndex whole;
    ParentIndex together;
    ParentIndex stretch;
    std::uint32_t states = 1;
    for (int i = 0; i < 3000; ++i) {
        const auto found = static_cast<std::uint32_t>(random() % 10 == 0 ? random() % 100 : random() % 3);
        states += found;
        whole.add_expanded_state(found);
        stretch.add_expanded_state(found);
        if (random() % 20 != 0 && i + 1 != 3000) continue;
        together.append(stretch);
        stretch.clear();
    }
    for (lts::StateIndex state = 1; state < states; ++state) ASSERT_EQ(together.parent(state), whole.parent(state));
}

}  // namespace
}  // namespace robochart::refine
