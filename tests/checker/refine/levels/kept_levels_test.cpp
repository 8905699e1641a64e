// SPDX-License-Identifier: Apache-2.0
// Tests a search that is resumed with another number of ranks. It has each row once, and rejects parts with a duplicate
// row.
#include "checker/refine/levels/kept_levels.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/diagnostics/files.hpp"

namespace robochart::refine {
namespace {

using lts::Word;

/// Stores these rows at two ranks, and resumes with one rank. Returns the rows of level 0 in `rows`, or the reason for
/// a rejection.
std::string gone_on_from(const std::vector<Word>& first, const std::vector<Word>& second, std::vector<Word>& rows) {
    std::string error;
    const diagnostics::TemporaryFolder folder("", error);
    KeptWhere where;
    where.folder = folder.path();
    where.kind.width = 1;
    where.kind.search.fill(1);
    for (std::uint32_t rank = 0; rank < 2; ++rank) {
        storage::LevelFiles files({where.folder, where.kind, {rank, 2}});
        files.add_level(rank == 0 ? first : second);
        files.checkpoint({});
    }
    where.from = storage::newest_in(where.folder);
    KeptLevels levels(where);
    SearchRecord record(1);
    try {
        levels.load_checkpoint(record, [](Level, lts::StateView) {});
    } catch (const storage::BadFile& refused) {
        return refused.what();
    }
    levels.files().read(0, 0, 100, rows);
    return "";
}

TEST(KeptLevels, HaveTheRowsOfAllRanks) {
    std::vector<Word> rows;
    EXPECT_EQ(gone_on_from({1, 4, 9}, {2, 5}, rows), "");
    EXPECT_EQ(rows, (std::vector<Word>{1, 2, 4, 5, 9}));
}

TEST(KeptLevels, AreRefusedWhereARowIsInTwoParts) {
    std::vector<Word> rows;
    EXPECT_NE(gone_on_from({1, 4, 9}, {2, 4}, rows)
                  .find("/checkpoint-1-0-of-2: a row of level 0 is also in the part of another thread"),
              std::string::npos);
}

}  // namespace
}  // namespace robochart::refine
