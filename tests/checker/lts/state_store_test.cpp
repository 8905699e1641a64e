// The visited set against std::map, over widths and sizes that make every segment grow.
#include "checker/lts/state_store.hpp"

#include <gtest/gtest.h>

#include <map>
#include <random>

namespace robochart::lts {
namespace {

class StateStores : public testing::TestWithParam<std::size_t> {};

TEST_P(StateStores, NumberStatesInOrderOfInsertion) {
    const std::size_t width = GetParam();
    StateStore store(width);
    std::map<std::vector<Word>, StateIndex> expected;
    std::mt19937 random(7);
    for (int i = 0; i < 60000; ++i) {
        std::vector<Word> state(width);
        for (Word& word : state) word = static_cast<Word>(random() % 40000) << (random() % 2 == 0 ? 0 : 12);
        ASSERT_EQ(store.find(state) != no_state, expected.contains(state));
        const auto [entry, fresh] = expected.emplace(state, static_cast<StateIndex>(expected.size()));
        const StateStore::Insertion insertion = store.insert(state);
        ASSERT_EQ(insertion.index, entry->second);
        ASSERT_EQ(insertion.fresh, fresh);
    }
    ASSERT_EQ(store.size(), expected.size());
    for (const auto& [state, index] : expected) {
        ASSERT_TRUE(std::equal(state.begin(), state.end(), store[index].begin()));
        ASSERT_EQ(store.find(state), index);
    }
}

INSTANTIATE_TEST_SUITE_P(Widths, StateStores, testing::Values(1, 2, 3, 9));

TEST(StateStore, ViewsStayWhereTheyAre) {
    StateStore store(1);
    const Word first = 42;
    const StateView kept = store[store.insert(StateView(&first, 1)).index];
    for (Word i = 0; i < 100000; ++i) store.insert(StateView(&i, 1));
    EXPECT_EQ(kept[0], 42U);
    EXPECT_EQ(store.size(), 100000U);
}

TEST(StateStore, OfNoWordsHoldsOneState) {
    StateStore store(0);
    EXPECT_TRUE(store.insert({}).fresh);
    EXPECT_FALSE(store.insert({}).fresh);
    EXPECT_EQ(store.size(), 1U);
}

}  // namespace
}  // namespace robochart::lts
