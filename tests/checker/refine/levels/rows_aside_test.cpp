// SPDX-License-Identifier: Apache-2.0
// Tests rows that are set aside. Each row is returned once with its lowest level, for any number of rows. No row is
// lost if the disk is full.
#include "checker/refine/levels/rows_aside.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>

#include "base/diagnostics/files.hpp"
#include "tests/file_limit.hpp"

namespace robochart::refine {
namespace {

using lts::Word;
using Row = std::vector<Word>;

class AsideRows : public testing::Test {
protected:
    /// Adds a random row. Levels ascend, so the first level of a repeated row is its lowest one.
    void add(Level level) {
        const Row row{static_cast<Word>(random_() % 20), static_cast<Word>(random_() % 50)};
        aside_.add(row, lts::StateStore::hash(row), level);
        added_.emplace(row, level);
    }
    /// Returns the rows of all pieces. Checks the order of each piece.
    [[nodiscard]] std::map<Row, Level> rows_of_pieces() const {
        std::map<Row, Level> all;
        aside_.each_piece([&](const std::vector<Word>& rows) {
            EXPECT_EQ(rows.size() % 3, 0U);
            for (std::size_t at = 0; at < rows.size(); at += 3) {
                const Row row{rows[at], rows[at + 1]};
                if (at > 0) {
                    EXPECT_LT((Row{rows[at - 3], rows[at - 2]}), row);
                }
                all.emplace(row, rows[at + 2]);
            }
        });
        return all;
    }

    std::mt19937 random_{3};
    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
    RowsAside aside_{folder_.path() + "/aside", {2, {}}, 0};
    std::map<Row, Level> added_;
};

TEST_F(AsideRows, AreGivenWithTheLeastOfTheirLevels) {
    for (Level level = 0; level < 30; ++level) {
        for (std::size_t i = 0, count = random_() % 100; i < count; ++i) add(level);
        ASSERT_EQ(rows_of_pieces(), added_) << level;
    }
    EXPECT_TRUE(aside_.on_disk());
    EXPECT_GE(aside_.rows(), added_.size());
    aside_.clear();
    EXPECT_TRUE(aside_.empty());
    EXPECT_TRUE(rows_of_pieces().empty());
    added_.clear();
    add(7);
    EXPECT_EQ(rows_of_pieces(), added_);
}

TEST_F(AsideRows, AreAllThereWhereTheDiskIsFull) {
    int full = 0;
    for (Level level = 0; level < 30; ++level) {
        const tests::FileLimit limit(level % 3 == 0 ? 1'000'000 : 100 + random_() % 300);
        for (unsigned i = 0; i < 100; ++i) try {
                add(level);
            } catch (const storage::CannotWrite&) {
                ++full;
            }
        ASSERT_EQ(rows_of_pieces(), added_) << level;
    }
    EXPECT_GT(full, 5);
}

}  // namespace
}  // namespace robochart::refine
