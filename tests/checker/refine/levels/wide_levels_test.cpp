// SPDX-License-Identifier: Apache-2.0
// Tests levels of several blocks: rows that are reached again are found in each block.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/diagnostics/files.hpp"
#include "checker/refine/levels/disk_row_store.hpp"

namespace robochart::refine {
namespace {

using lts::Word;
using Row = std::vector<Word>;

void enter(RowStore& store, const Row& row) {
    store.enter_row(row, lts::StateStore::hash(row));
}

// The next level reaches many rows of all blocks of the previous level again. None of them is new, and none causes a
// rollback.
TEST(WideLevels, HaveRowsInAllTheirBlocks) {
    for (const std::size_t width : {2U, 3U, 5U}) {
        std::string error;
        const diagnostics::TemporaryFolder folder("", error);
        KeptWhere where;
        where.folder = folder.path();
        where.kind.width = width;
        where.kind.search.fill(1);
        DiskRowStore::Figures figures;
        DiskRowStore::Bounds bounds;
        bounds.most_bytes = 1U << 21U;
        bounds.report = [&figures](const DiskRowStore::Figures& all) { figures = all; };
        constexpr Word rows = 30'000;
        const auto row_of = [width](Word level, Word i) {
            Row row(width, i / 5000);
            row[width - 2] = 3 * (i / 100);
            row[width - 1] = 1000 * level + i % 100;
            return row;
        };
        {
            DiskRowStore store(where, bounds);
            for (Word level = 0; level < 2; ++level) {
                for (Word i = 0; i < rows; ++i) enter(store, row_of(level, i));
                store.record().expanded.resize(level);
                store.close_level();
            }
            for (Word i = 0; i < rows; i += 7) enter(store, row_of(i % 2, i));
            EXPECT_FALSE(store.settle_unsure_rows());
            EXPECT_EQ(store.rows(2), 0U);
            EXPECT_EQ(store.size(), 2 * rows);
            std::vector<Word> read;
            EXPECT_EQ(store.read(1, 20'000, 1, read), 1U);
            EXPECT_EQ(read, row_of(1, 20'000));
        }
        EXPECT_GT(figures.put_aside, rows / 14);
        EXPECT_EQ(figures.in_error, 0U) << "width " << width;
        EXPECT_EQ(figures.rolled_back, 0U);
    }
}

}  // namespace
}  // namespace robochart::refine
