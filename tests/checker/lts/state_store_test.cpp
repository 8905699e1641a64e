// SPDX-License-Identifier: Apache-2.0
// Compares the set of visited states with std::map, for widths and sizes that make it grow. Also tests states that
// several threads claim at the same time.
#include "checker/lts/state_store.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <thread>

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
    const StateView stored = store[store.insert(StateView(&first, 1)).index];
    for (Word i = 0; i < 100000; ++i) store.insert(StateView(&i, 1));
    EXPECT_EQ(stored[0], 42U);
    EXPECT_EQ(store.size(), 100000U);
}

TEST(StateStore, OfNoWordsHoldsOneState) {
    StateStore store(0);
    EXPECT_TRUE(store.insert({}).fresh);
    EXPECT_FALSE(store.insert({}).fresh);
    EXPECT_EQ(store.size(), 1U);
}

/// Collects the states that one of several threads claims. Each thread has its own numbers.
class OwnClaims {
public:
    OwnClaims(std::vector<OwnClaims>& all, std::size_t number) : all_(all), number_(number) { rows_.reserve(most); }
    [[nodiscard]] StateIndex next() const {
        return StateStore::first_claim + static_cast<StateIndex>(number_ * most + rows_.size());
    }
    [[nodiscard]] const Word* row(StateIndex claim) const {
        const std::size_t place = claim - StateStore::first_claim;
        return &all_[place / most].kept_[place % most];
    }
    void keep_state(StateView state) { kept_[rows_.size()] = state[0]; }
    void lose_claim(StateIndex /*claim*/) { ++lost; }
    void work(StateStore& store, unsigned seed) {
        std::mt19937 random(seed);
        for (int i = 0; i < 8000; ++i) {
            const Word word = static_cast<Word>(random() % 4000);
            const StateView state(&word, 1);
            const StateStore::Claim claim = store.claim(state, StateStore::hash(state), next(), *this);
            EXPECT_NE(claim.index, no_state);
            if (claim.index == next()) rows_.push_back({word, claim});
        }
    }
    struct Row {
        Word word;
        StateStore::Claim claim;
    };
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    std::size_t lost = 0;

private:
    static constexpr std::size_t most = 8192;
    std::vector<OwnClaims>& all_;
    std::size_t number_;
    std::vector<Row> rows_;
    std::vector<Word> kept_ = std::vector<Word>(most);
};

/// Four threads find the same few states. The lowest claim of each state remains, and a state that is already in the
/// store is not claimed.
TEST(StateStore, OfEqualClaimsKeepsTheLowest) {
    StateStore store(1);
    for (Word word = 0; word < 1000; ++word) store.insert(StateView(&word, 1));
    store.reserve(8000, {});
    std::vector<OwnClaims> all;
    for (std::size_t i = 0; i < 4; ++i) all.emplace_back(all, i);
    {
        std::vector<std::thread> threads;
        for (unsigned i = 0; i < 4; ++i) threads.emplace_back([&all, &store, i] { all[i].work(store, 5 + i); });
        for (std::thread& thread : threads) thread.join();
    }
    std::map<Word, StateIndex> lowest;
    std::size_t claims = 0;
    for (const OwnClaims& own : all)
        for (const OwnClaims::Row& row : own.rows()) {
            ASSERT_GE(row.word, 1000U);
            lowest.emplace(row.word, row.claim.index);  // threads and their claims come in ascending order
            ++claims;
        }
    std::size_t lost = 0;
    for (const OwnClaims& own : all) lost += own.lost;
    EXPECT_EQ(claims - lost, lowest.size());
    EXPECT_GT(lowest.size(), 2900U);

    store.make_space(1000 + lowest.size());
    StateIndex number = 1000;
    for (const OwnClaims& own : all)
        for (const OwnClaims::Row& row : own.rows()) {
            ASSERT_EQ(row.claim.slot.get() == row.claim.index, lowest.at(row.word) == row.claim.index);
            if (row.claim.slot.get() != row.claim.index) continue;
            store.publish_state(row.claim.slot, number, StateView(&row.word, 1));
            EXPECT_EQ(store.find(StateView(&row.word, 1)), number);
            ++number;
        }
    EXPECT_EQ(number, 1000 + lowest.size());
}

TEST(StateStore, ForgetsClaimsGivenUp) {
    StateStore store(1);
    std::vector<OwnClaims> all;
    all.emplace_back(all, 0);
    store.reserve(5000, {});
    all[0].work(store, 3);
    for (const OwnClaims::Row& row : all[0].rows()) StateStore::give_up(row.claim.slot);
    for (const OwnClaims::Row& row : all[0].rows()) EXPECT_EQ(store.find(StateView(&row.word, 1)), no_state);
    for (Word word = 0; word < 20000; ++word) EXPECT_TRUE(store.insert(StateView(&word, 1)).fresh);
    for (Word word = 0; word < 20000; ++word) EXPECT_EQ(store.insert(StateView(&word, 1)).index, word);
}

TEST(StateStore, IsMadeAnewByParts) {
    StateStore store(1);
    for (Word word = 0; word < 300000; ++word) store.insert(StateView(&word, 1));
    std::size_t pieces = 0;
    store.reserve(store.size() + store.free_state_count() + 1,
                  [&pieces](std::size_t count, const std::function<void(std::size_t)>& piece) {
                      for (pieces = 0; pieces < count; ++pieces) piece(count - pieces - 1);
                  });
    EXPECT_GT(pieces, 1U);
    EXPECT_GT(store.free_state_count(), 0U);
    for (Word word = 0; word < 300000; ++word) ASSERT_EQ(store.find(StateView(&word, 1)), word);
}

}  // namespace
}  // namespace robochart::lts
