// SPDX-License-Identifier: Apache-2.0
// Tests levels in files, and their checkpoints. Another process reads the contents of the newest complete checkpoint,
// even if the writer was killed at any time. Damaged files are rejected.
#include "checker/storage/level_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <random>
#include <thread>

#include "base/diagnostics/files.hpp"
#include "tests/file_limit.hpp"
#include "tests/open_files_limit.hpp"

namespace robochart::storage {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// Returns the rows of a level in these tests. Some levels have several blocks, and some have no rows.
std::vector<Word> rows_of(std::uint32_t level, Word salt = 0) {
    const std::size_t counts[] = {1, 0, 17, RowFile::rows_of_block + 3, 400, 2 * RowFile::rows_of_block};
    std::vector<Word> rows;
    for (Word i = 0; i < counts[level % 6]; ++i) rows.insert(rows.end(), {salt + level, 3 * i, i % 11});
    return rows;
}

class Levels : public testing::Test {
protected:
    static constexpr std::size_t width = 3;
    [[nodiscard]] FolderOf folder_of(const Place& place = {}) const {
        FolderOf where{folder_.path(), {width, {}}, place};
        where.kind.search.fill(9);
        return where;
    }
    static std::vector<Word> all_rows(LevelFiles& files, std::uint32_t level) {
        std::vector<Word> rows;
        files.each_block(level,
                         [&](std::span<const Word> block) { rows.insert(rows.end(), block.begin(), block.end()); });
        return rows;
    }
    /// Checks that the files contain the levels of `rows_of`, read in both ways.
    static void expect_levels(LevelFiles& files, Word salt = 0, std::uint32_t salted_from = 0) {
        std::uint64_t sum = 0;
        for (std::uint32_t level = 0; level < files.levels(); ++level) {
            const std::vector<Word> expected = rows_of(level, level >= salted_from ? salt : 0);
            ASSERT_EQ(all_rows(files, level), expected) << level;
            ASSERT_EQ(files.rows(level) * width, expected.size());
            std::vector<Word> pieces;
            for (std::uint64_t at = 0; files.read(level, at, 1000, pieces) > 0;) at = pieces.size() / width;
            ASSERT_EQ(pieces, expected) << level;
            sum += files.rows(level);
        }
        ASSERT_EQ(files.rows(), sum);
    }
    [[nodiscard]] std::vector<Checkpoint> newest_checkpoints() const {
        return read(folder_.path(), folder_of().kind, newest_in(folder_.path()));
    }
    LevelFiles open_checkpoint(const Checkpoint& checkpoint) const {
        LevelFiles files(folder_of(checkpoint.place));
        files.adopt(checkpoint, diagnostics::unlimited);
        return files;
    }
    [[nodiscard]] std::size_t files_there() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()));
    }

    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
};

TEST_F(Levels, AreReadAgainAfterACheckpoint) {
    LevelFiles files(folder_of());
    for (std::uint32_t level = 0; level < 13; ++level) files.add_level(rows_of(level));
    expect_levels(files);
    const std::vector<std::vector<Word>> unsure{{7, 7, 7, 4}, {}, {1, 0, 0, 6, 2, 0, 0, 6, 7, 7, 7, 4}};
    files.checkpoint(
        {{1, 2, 3, 4, 5, 6}, [&](const TakeRows& take) { std::ranges::for_each(unsure, take); }, {{10, 0}, {20, 5}}});
    for (std::uint32_t level = 13; level < 20; ++level) files.add_level(rows_of(level));

    const std::vector<Checkpoint> found = newest_checkpoints();
    ASSERT_EQ(found.size(), 1U);
    LevelFiles again = open_checkpoint(found[0]);
    EXPECT_EQ(again.levels(), 13U);
    expect_levels(again);
    ASSERT_EQ(found[0].expanded.size(), 2U);
    EXPECT_EQ(found[0].expanded[1].transitions, 20U);
    EXPECT_EQ(found[0].expanded[1].chased, 5U);
    std::vector<std::vector<Word>> beside;
    const auto take = [&](std::span<const Word> rows) { beside.emplace_back(rows.begin(), rows.end()); };
    LevelFiles::read_beside(folder_of(), found[0].unsure, true, diagnostics::unlimited, take);
    EXPECT_EQ(beside, (std::vector<std::vector<Word>>{unsure[0], unsure[2]}));
    beside.clear();
    LevelFiles::read_beside(folder_of(), found[0].marks, false, diagnostics::unlimited, take);
    EXPECT_EQ(beside, (std::vector<std::vector<Word>>{{1, 2, 3, 4, 5, 6}}));
    // The search continues, and files that are no longer needed are removed.
    for (std::uint32_t level = 13; level < 25; ++level) again.add_level(rows_of(level));
    again.checkpoint({});
    const std::vector<Checkpoint> later = newest_checkpoints();
    ASSERT_EQ(later.size(), 1U);
    EXPECT_EQ(later[0].number, found[0].number + 1);
    LevelFiles last = open_checkpoint(later[0]);
    EXPECT_EQ(last.levels(), 25U);
    expect_levels(last);
    EXPECT_EQ(files_there(), 3U) << "a checkpoint and the files of two runs";
}

// Only the selected blocks of a level of four blocks are read. To select a block, the test uses its first row and that
// of the next block.
TEST_F(Levels, AreReadBlockByBlock) {
    LevelFiles files(folder_of());
    std::vector<Word> rows;
    const Word count = 3 * RowFile::rows_of_block + 5;
    for (Word i = 0; i < count; ++i) rows.insert(rows.end(), {2 * i, 0, 1});
    files.add_level(rows_of(0));
    files.add_level(rows);
    const Word last = 3 * RowFile::rows_of_block;
    const std::pair<Word, std::vector<Word>> expected[] = {
        {0, {0}},                                                // the first row
        {2 * RowFile::rows_of_block, {RowFile::rows_of_block}},  // the first row of a block
        {2 * RowFile::rows_of_block - 1, {0}},                   // a gap between blocks
        {2 * RowFile::rows_of_block + 7, {RowFile::rows_of_block}},
        {2 * count - 2, {last}},  // the last row
        {2 * count, {last}},      // after all rows
    };
    for (const auto& [row, blocks] : expected) {
        std::vector<Word> given;
        const auto wants = [&row = row](std::span<const Word> first, std::span<const Word> next) {
            return first[0] <= row && (next.empty() || row < next[0]);
        };
        files.each_block_if(1, wants, [&](std::span<const Word> block) {
            given.push_back(block[0] / 2);
            const std::size_t whole = block[0] / 2 == last ? 5 : RowFile::rows_of_block;
            EXPECT_EQ(block.size(), whole * width);
        });
        EXPECT_EQ(given, blocks) << row;
    }
}

// Levels that a rollback discarded occupy no space. Later levels can be given up, but not those of the last checkpoint.
TEST_F(Levels, CanBeGivenUpToTheLastCheckpoint) {
    LevelFiles files(folder_of());
    for (std::uint32_t level = 0; level < 4; ++level) files.add_level(rows_of(level));
    files.checkpoint({});
    for (std::uint32_t level = 4; level < 12; ++level) files.add_level(rows_of(level));
    files.forget_from(9);
    expect_levels(files);
    EXPECT_EQ(files.give_up(2), 2U);
    EXPECT_EQ(files.levels(), 7U);
    EXPECT_EQ(files.give_up(100), 3U);
    EXPECT_EQ(files.give_up(1), 0U);
    EXPECT_EQ(files.levels(), 4U);
    EXPECT_EQ(files_there(), 2U) << "the checkpoint and the file of its levels";
    for (std::uint32_t level = 4; level < 10; ++level) files.add_level(rows_of(level));
    files.forget_from(2);
    EXPECT_EQ(files.give_up(1), 0U) << "the last checkpoint has more";
    files.add_level(rows_of(2));
    expect_levels(files);
}

// The previous checkpoint still has the discarded levels.
TEST_F(Levels, CanBeDiscardedAndRewritten) {
    LevelFiles files(folder_of());
    for (std::uint32_t level = 0; level < 10; ++level) files.add_level(rows_of(level));
    files.checkpoint({});
    for (std::uint32_t level = 10; level < 15; ++level) files.add_level(rows_of(level));
    files.forget_from(13);
    files.forget_from(4);
    for (std::uint32_t level = 4; level < 12; ++level) files.add_level(rows_of(level, 100));
    expect_levels(files, 100, 4);
    LevelFiles before = open_checkpoint(newest_checkpoints().at(0));
    EXPECT_EQ(before.levels(), 10U);
    expect_levels(before);
    files.checkpoint({});
    LevelFiles after = open_checkpoint(newest_checkpoints().at(0));
    EXPECT_EQ(after.levels(), 12U);
    expect_levels(after, 100, 4);
}

// With several ranks, a checkpoint is complete when all ranks have written their parts.
TEST_F(Levels, GoBackToTheCheckpointThatAllRanksHave) {
    LevelFiles first(folder_of({0, 2}));
    LevelFiles second(folder_of({1, 2}));
    for (std::uint32_t level = 0; level < 5; ++level) {
        first.add_level(rows_of(level));
        second.add_level(rows_of(level, 50));
    }
    first.checkpoint({});
    EXPECT_TRUE(newest_checkpoints().empty());
    second.checkpoint({});
    first.add_level(rows_of(5));
    second.add_level(rows_of(5, 50));
    first.checkpoint({});
    const std::vector<Checkpoint> found = newest_checkpoints();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].number, 1U);
    for (const Checkpoint& checkpoint : found) {
        LevelFiles files = open_checkpoint(checkpoint);
        EXPECT_EQ(files.levels(), 5U);
        expect_levels(files, checkpoint.place.rank * 50);
    }
    second.checkpoint({});
    EXPECT_EQ(newest_checkpoints().at(1).number, 2U);
}

// If one rank continues to write checkpoints but another cannot, the newest checkpoint that all ranks have is not
// removed.
TEST_F(Levels, KeepTheCheckpointThatAllRanksHave) {
    LevelFiles first(folder_of({0, 2}));
    LevelFiles second(folder_of({1, 2}));
    first.add_level(rows_of(0));
    second.add_level(rows_of(0, 50));
    first.checkpoint({});
    second.checkpoint({});
    for (std::uint32_t level = 1; level < 5; ++level) {
        first.add_level(rows_of(level));
        first.checkpoint({});
    }
    const std::vector<Checkpoint> found = newest_checkpoints();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].number, 1U);
    for (const Checkpoint& checkpoint : found) {
        LevelFiles files = open_checkpoint(checkpoint);
        EXPECT_EQ(files.levels(), 1U);
        expect_levels(files, checkpoint.place.rank * 50);
    }
    EXPECT_EQ(newest_in(folder_.path()).greatest, 5U);
}

// Parts with the same number belong together, even if one of them has more levels. The reader uses the levels that all
// parts have.
TEST_F(Levels, AreInCheckpointsOfMoreLevelsAndOfFewer) {
    LevelFiles first(folder_of({0, 2}));
    LevelFiles second(folder_of({1, 2}));
    first.add_level(rows_of(0));
    second.add_level(rows_of(0, 50));
    first.checkpoint({});
    second.checkpoint({});
    first.add_level(rows_of(1));
    first.add_level(rows_of(2));
    second.add_level(rows_of(1, 50));
    first.checkpoint({});
    second.checkpoint({});
    const std::vector<Checkpoint> found = newest_checkpoints();
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].number, 2U);
    EXPECT_EQ(open_checkpoint(found[0]).levels(), 3U);
    EXPECT_EQ(open_checkpoint(found[1]).levels(), 2U);
}

// A position in a level identifies a row, so a short block before others would make all later positions wrong.
TEST_F(Levels, AreRefusedWithAShortBlockBeforeOthers) {
    RowFile file = RowFile::create(folder_.path() + "/rows-0-of-1-0", folder_of().kind);
    file.append(0, std::vector<Word>{1, 1, 1});
    file.append(0, std::vector<Word>{2, 2, 2});
    file.finish();
    Checkpoint made;
    made.number = 1;
    made.levels = 1;
    made.files.push_back({"rows-0-of-1-0", 2, file.check()});
    EXPECT_THROW((void)open_checkpoint(made), BadFile);
    made.files[0].blocks = 1;
    EXPECT_EQ(open_checkpoint(made).rows(), 1U);
}

TEST_F(Levels, AreThereAfterAKillAtAnyMoment) {
    std::mt19937 random(4);
    for (int round = 0; round < 10; ++round) {
        const pid_t child = fork();
        ASSERT_GE(child, 0);
        if (child == 0) {
            const std::vector<Checkpoint> found = newest_checkpoints();
            LevelFiles files(folder_of());
            if (!found.empty()) files.adopt(found[0], diagnostics::unlimited);
            for (;;) {
                for (int i = 0; i < 3; ++i) files.add_level(rows_of(files.levels()));
                if (files.levels() > 30) files.forget_from(5);
                files.checkpoint({{files.levels(), 0, 0}, {}, {}});
            }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20 + random() % 100));
        kill(child, SIGKILL);
        waitpid(child, nullptr, 0);
        const std::vector<Checkpoint> found = newest_checkpoints();
        if (found.empty()) continue;
        LevelFiles files = open_checkpoint(found[0]);
        expect_levels(files);
        LevelFiles::read_beside(folder_of(), found[0].marks, false, diagnostics::unlimited,
                                [&](std::span<const Word> rows) { EXPECT_EQ(rows[0], files.levels()); });
    }
    EXPECT_FALSE(newest_checkpoints().empty());
}

TEST_F(Levels, KeepTheLastCheckpointWhereTheDiskIsFull) {
    LevelFiles files(folder_of());
    for (std::uint32_t level = 0; level < 8; ++level) files.add_level(rows_of(level));
    files.checkpoint({});
    std::string why;
    std::uint32_t reached = 0;
    try {
        const tests::FileLimit limit(3000);
        for (std::uint32_t level = 8; level < 100; ++level) files.add_level(rows_of(level));
    } catch (const CannotWrite& error) {
        why = error.what();
        reached = files.levels();
    }
    EXPECT_THAT(why, HasSubstr("cannot write"));
    EXPECT_EQ(newest_checkpoints().at(0).levels, 8U);
    expect_levels(files);
    files.checkpoint({});  // there is space again
    EXPECT_EQ(newest_checkpoints().at(0).levels, reached);
    LevelFiles again = open_checkpoint(newest_checkpoints().at(0));
    expect_levels(again);
}

TEST_F(Levels, AreRefusedWhereACheckpointIsDamaged) {
    LevelFiles files(folder_of());
    for (std::uint32_t level = 0; level < 3; ++level) files.add_level(rows_of(level));
    files.checkpoint({{1, 2, 3}, {}, {{1, 2}}});
    const std::string path = folder_.path() + "/" + name_of(1, {});
    std::ifstream in(path, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    const auto refused = [&](const std::string& text) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << text;
        try {
            for (const Checkpoint& checkpoint : newest_checkpoints()) (void)open_checkpoint(checkpoint);
        } catch (const BadFile& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 1);
        ASSERT_THAT(refused(damaged), HasSubstr(path)) << at;
        ASSERT_THAT(refused(whole.substr(0, at)), HasSubstr(path)) << at;
    }
    // A damaged text is rejected even with a correct checksum.
    const std::string text = whole.substr(0, whole.find("check "));
    std::mt19937 random(3);
    int tried = 0;
    for (std::size_t at = 0; at < text.size(); ++at) {
        std::string other = text;
        other[at] = "0 \n-9x"[random() % 6];
        if (other == text) continue;
        ++tried;
        diagnostics::Hasher hasher;
        hasher.add(std::string_view(other));
        std::string check;
        for (const std::uint8_t byte : hasher.finish()) {
            check += "0123456789abcdef"[byte / 16];
            check += "0123456789abcdef"[byte % 16];
        }
        (void)refused(other + "check " + check + "\n");  // rejected or read; no crash
    }
    EXPECT_GT(tried, 100);
    EXPECT_EQ(refused(whole), "");
    fs::remove(folder_.path() + "/rows-0-of-1-0");
    EXPECT_THAT(refused(whole), HasSubstr("rows-0-of-1-0: cannot be read"));
}

// There is one file per checkpoint, and almost none of them is open.
TEST_F(Levels, NeedFewOpenFiles) {
    constexpr std::uint32_t levels = 30;
    const tests::OpenFilesLimit limit(6);
    LevelFiles files(folder_of());
    for (std::uint32_t level = 0; level < levels; ++level) {
        files.add_level(rows_of(level));
        files.checkpoint({});
    }
    expect_levels(files);
    LevelFiles again(folder_of());
    again.adopt(read(folder_.path(), folder_of().kind, newest_in(folder_.path())).at(0), diagnostics::unlimited);
    ASSERT_EQ(again.levels(), levels);
    expect_levels(again);
}

}  // namespace
}  // namespace robochart::storage
