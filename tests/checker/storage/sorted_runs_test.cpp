// SPDX-License-Identifier: Apache-2.0
// Tests that rows in sorted runs are returned in order and without duplicates, for any distribution over runs. A run
// that cannot be written does not exist.
#include "checker/storage/sorted_runs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <set>

#include "base/diagnostics/files.hpp"
#include "tests/file_limit.hpp"

namespace robochart::storage {
namespace {

using Row = std::vector<Word>;

class Runs : public testing::Test {
protected:
    static constexpr std::size_t width = 2;
    static std::vector<Word> words(const std::set<Row>& rows) {
        std::vector<Word> all;
        for (const Row& row : rows) all.insert(all.end(), row.begin(), row.end());
        return all;
    }
    static std::vector<Word> merge_runs(const SortedRuns& runs) {
        std::vector<Word> all;
        bool last = false;
        runs.merge([&](std::span<const Word> rows) {
            EXPECT_FALSE(last) << "only the last piece is smaller";
            last = rows.size() < RowFile::rows_of_block * width;
            all.insert(all.end(), rows.begin(), rows.end());
        });
        return all;
    }
    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
    SortedRuns runs_{folder_.path() + "/runs", {width, {}}};
};

// There are more runs than one merge can process. Some runs have several blocks, and some rows are in several runs.
TEST_F(Runs, GiveEachRowOnceInOrder) {
    std::mt19937 random(1);
    std::set<Row> all;
    for (int run = 0; run < 150; ++run) {
        std::set<Row> rows;
        for (std::size_t i = 0, count = run % 70 == 3 ? 20'000 : random() % 300; i < count; ++i)
            rows.insert({static_cast<Word>(random() % 50), static_cast<Word>(random() % 2000)});
        runs_.add(words(rows));
        all.insert(rows.begin(), rows.end());
        EXPECT_GE(all.size(), runs_.longest_run());
        EXPECT_LE(rows.size(), runs_.longest_run());
    }
    EXPECT_EQ(merge_runs(runs_), words(all));
    EXPECT_TRUE(std::filesystem::is_empty(folder_.path())) << "the file has no name";
    runs_.clear();
    EXPECT_TRUE(runs_.empty());
    EXPECT_EQ(merge_runs(runs_), std::vector<Word>{});
    runs_.add(words({{1, 2}}));
    EXPECT_EQ(merge_runs(runs_), (std::vector<Word>{1, 2}));
}

TEST_F(Runs, AreAsBeforeWhereTheDiskIsFull) {
    std::set<Row> large;
    for (Word i = 0; i < 20'000; ++i) large.insert({i * 7919, i * 104'729});
    runs_.add(words({{1, 2}, {3, 4}}));
    {
        const tests::FileLimit limit(2000);
        EXPECT_THROW(runs_.add(words(large)), CannotWrite);
    }
    runs_.add(words({{1, 5}, {3, 4}}));
    EXPECT_EQ(merge_runs(runs_), (std::vector<Word>{1, 2, 1, 5, 3, 4}));
}

}  // namespace
}  // namespace robochart::storage
