// SPDX-License-Identifier: Apache-2.0
// Tests rows that are sent to other ranks, and the filter of rows that need not be sent again.
#include "checker/refine/levels/row_batches.hpp"

#include <gtest/gtest.h>
#include <algorithm>

#include "checker/refine/levels/sent_rows.hpp"
#include "checker/refine/levels/thread_exchange.hpp"

namespace robochart::refine {
namespace {

/// The rows exceed the initial capacity of a message. There are two rounds, and only one rank sends in the second one.
TEST(RowBatches, BringEveryRowWithWhetherATauLedToIt) {
    constexpr lts::Word count = 1000;
    as_ranks(3, [](Exchange& exchange) {
        const lts::Word rank = exchange.rank();
        RowBatches batches(3, 2);
        const auto received = [&] {
            std::vector<std::array<lts::Word, 3>> rows;
            batches.receive([](std::uint64_t) {},
                            [&](lts::StateView row, std::uint64_t hash, bool by_tau) {
                                EXPECT_EQ(hash, lts::StateStore::hash(row));
                                rows.push_back({row[0], row[1], by_tau ? 1U : 0U});
                            });
            std::ranges::sort(rows);
            return rows;
        };
        for (lts::Word i = 0; i < count; ++i)
            for (unsigned to = 0; to < 3; ++to)
                if (to != rank) batches.add(to, Words{10 * rank + to, i}, i % 3 == 0);
        EXPECT_EQ(batches.rows(), 2 * count);
        EXPECT_TRUE(batches.is_full(2 * count * 8));
        EXPECT_FALSE(batches.is_full(2 * count * 8 + 1));
        batches.exchange(exchange);
        EXPECT_FALSE(batches.is_full(1));
        std::vector<std::array<lts::Word, 3>> expected;
        for (lts::Word from = 0; from < 3; ++from)
            for (lts::Word i = 0; i < count; ++i)
                if (from != rank) expected.push_back({10 * from + rank, i, i % 3 == 0 ? 1U : 0U});
        EXPECT_EQ(received(), expected);
        if (rank == 1) batches.add(2, Words{7, 8}, true);
        batches.exchange(exchange);
        EXPECT_EQ(received().size(), rank == 2 ? 1U : 0U);
    });
}

/// The filter does not confuse two rows with the same hash.
TEST(SentRows, CompareRowsAsAWhole) {
    SentRows sent(2);
    constexpr std::uint64_t hash = 12345;
    EXPECT_FALSE(sent.sent_recently(Words{1, 2}, hash));
    EXPECT_FALSE(sent.sent_recently(Words{1, 2}, hash)) << "it has no memory yet";
    sent.resize_to_fit(1000);
    EXPECT_LE(sent.bytes(), 1000U);
    EXPECT_FALSE(sent.sent_recently(Words{0, 0}, 0)) << "an empty place is no row";
    EXPECT_FALSE(sent.sent_recently(Words{1, 2}, hash));
    EXPECT_TRUE(sent.sent_recently(Words{1, 2}, hash));
    EXPECT_FALSE(sent.sent_recently(Words{1, 3}, hash));
    EXPECT_TRUE(sent.sent_recently(Words{1, 3}, hash));
    EXPECT_FALSE(sent.sent_recently(Words{1, 2}, hash)) << "another has taken its place";
    sent.clear();
    EXPECT_FALSE(sent.sent_recently(Words{1, 2}, hash));
}

}  // namespace
}  // namespace robochart::refine
