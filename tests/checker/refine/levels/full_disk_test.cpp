// SPDX-License-Identifier: Apache-2.0
// Tests that on a full disk, as much of the search as fits is saved. This holds for each write that may fail: rows, the
// other data of a checkpoint, or the text of the checkpoint.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "base/diagnostics/files.hpp"
#include "checker/refine/levels/disk_row_store.hpp"
#include "checker/refine/levels/saved_row_store.hpp"
#include "tests/small_disk.hpp"

namespace robochart::refine {
namespace {

namespace fs = std::filesystem;
using lts::Word;

KeptWhere where_in(const std::string& folder) {
    KeptWhere where;
    where.folder = folder;
    where.kind.width = 2;
    where.kind.search.fill(1);
    return where;
}

/// Adds levels of new rows until the disk is full, or there are 1500 levels.
void fill(RowStore& store, unsigned rows) {
    std::mt19937 random(rows);
    for (Word level = 0; level < 1500; ++level) {
        for (unsigned i = 0; i < rows; ++i) {
            const Word row[] = {level, static_cast<Word>(random())};
            store.enter_row(row, lts::StateStore::hash(row));
        }
        store.record().expanded.resize(level);
        store.close_level();
    }
}

/// Returns the number of levels in the newest checkpoint, or 0 if there is none. All of its files must be readable.
std::uint32_t levels_kept(const KeptWhere& where) {
    std::uint64_t newest = 0;
    for (const auto& entry : fs::directory_iterator(where.folder)) {
        const std::string name = entry.path().filename().string();
        if (name.starts_with("checkpoint-")) newest = std::max<std::uint64_t>(newest, std::stoull(name.substr(11)));
    }
    if (newest == 0) return 0;
    const storage::Checkpoint found = storage::read(where.folder, where.kind, storage::name_of(newest, where.place));
    storage::LevelFiles files({where.folder, where.kind, where.place});
    files.adopt(found, diagnostics::unlimited);
    return files.levels();
}

/// Returns the percentage of written levels that the checkpoint contains. 99 means all or nearly all levels.
int kept_of_hundred(const KeptWhere& where, RowStore& store, unsigned rows) {
    try {
        fill(store, rows);
    } catch (const storage::CannotWrite&) {
    }
    const Level levels = store.levels();
    try {
        store.checkpoint();
    } catch (const storage::CannotWrite&) {
    }
    return static_cast<int>(std::min(99U, levels_kept(where) * 100 / levels));
}

class FullDisks : public testing::Test {
protected:
    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
};

// A checkpoint needs at least one page for its text. To make space, levels are given up. Each level frees one or two
// pages. At most half of all levels are lost, if the number of levels to give up is doubled once too often.
TEST_F(FullDisks, KeepLevelsOfAnySize) {
    for (const unsigned rows : {20U, 200U, 3000U})
        for (const unsigned kibibytes : {100U, 200U}) {
            const int percentage = tests::on_small_disk(folder_.path(), kibibytes, [&] {
                const KeptWhere where = where_in(folder_.path());
                DiskRowStore::Bounds bounds;
                bounds.most_bytes = 1U << 24U;
                DiskRowStore store(where, bounds);
                return kept_of_hundred(where, store, rows);
            });
            if (percentage == 100) GTEST_SKIP() << "no disk can be mounted";
            EXPECT_GE(percentage, 40) << rows << " rows a level, " << kibibytes << " KiB";
            EXPECT_LT(percentage, 100) << rows << " rows a level, " << kibibytes << " KiB";
        }
}

// Some closed levels are only in memory. The checkpoint contains the levels that are written.
TEST_F(FullDisks, KeepWhatWasWrittenOfLevelsInMemory) {
    for (const unsigned kibibytes : {100U, 200U}) {
        const int percentage = tests::on_small_disk(folder_.path(), kibibytes, [&] {
            const KeptWhere where = where_in(folder_.path());
            SavedRowStore store(where);
            (void)kept_of_hundred(where, store, 20);
            return static_cast<int>(std::min(99U, levels_kept(where)));
        });
        if (percentage == 100) GTEST_SKIP() << "no disk can be mounted";
        EXPECT_GE(percentage, 50) << kibibytes << " KiB";
        EXPECT_LT(percentage, 100) << kibibytes << " KiB";
    }
}

// Failed attempts remove the data that they wrote next to the levels. So a checkpoint of fewer levels fits.
TEST_F(FullDisks, AreNotFilledByAttemptsThatFail) {
    const int percentage = tests::on_small_disk(folder_.path(), 600, [&] {
        std::mt19937 random(3);
        const KeptWhere where = where_in(folder_.path());
        KeptLevels levels(where);
        SearchRecord record(2);
        record.expanded.resize(1000);
        for (int i = 0; i < 15'000; ++i) {
            const Word row[] = {static_cast<Word>(random()), static_cast<Word>(random())};
            record.marks.insert(row);
        }
        std::vector<Word> unsure;
        for (Word i = 0; i < 20'000; ++i) unsure.insert(unsure.end(), {i, 7 * i, 0});
        try {
            for (Word level = 0; level < 1000; ++level) {
                std::vector<Word> rows;
                for (Word i = 0; i < 1000; ++i) rows.insert(rows.end(), {1000 * level + i, level});
                levels.files().add_level(rows);
            }
        } catch (const storage::CannotWrite&) {
        }
        const std::uint32_t written = levels.files().levels();
        levels.checkpoint_of_fewer(record, [&](const storage::TakeRows& take) { take(unsure); });
        const auto there = std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator());
        if (there != 4) return 0;  // rows, marks, unsure rows, and the checkpoint
        return static_cast<int>(std::min(99U, levels_kept(where) * 100 / written));
    });
    if (percentage == 100) GTEST_SKIP() << "no disk can be mounted";
    EXPECT_GE(percentage, 25);
    EXPECT_LT(percentage, 99) << "the disk was not full";
}

}  // namespace
}  // namespace robochart::refine
