// SPDX-License-Identifier: Apache-2.0
// Tests files of rows. Written rows are read back. Damaged files are rejected with the file, the position and the
// cause.
#include "checker/storage/row_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <random>
#include <set>

#include "base/diagnostics/files.hpp"
#include "tests/file_limit.hpp"
#include "tests/open_files_limit.hpp"

namespace robochart::storage {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Returns random rows of a width, ascending and without duplicates. If `near`, they are close to each other.
std::vector<Word> random_rows(std::mt19937& random, std::size_t width, std::size_t count, bool near) {
    std::set<std::vector<Word>> rows;
    for (std::size_t tries = 0; rows.size() < count && tries < 10 * count; ++tries) {
        std::vector<Word> row(width);
        for (Word& word : row) word = static_cast<Word>(near ? random() % 5 : random());
        rows.insert(row);
    }
    std::vector<Word> words;
    for (const std::vector<Word>& row : rows) words.insert(words.end(), row.begin(), row.end());
    return words;
}

TEST(RowCodec, GivesBackWhatItWasGiven) {
    std::mt19937 random(1);
    for (int round = 0; round < 500; ++round) {
        const std::size_t width = 1 + random() % 6;
        const std::vector<Word> rows = random_rows(random, width, random() % 100, round % 2 == 0);
        std::string code;
        encode_rows(rows, width, code);
        std::vector<Word> again;
        ASSERT_TRUE(decode_rows(code, width, rows.size() / width, again));
        ASSERT_EQ(again, rows);
    }
}

TEST(RowCodec, HoldsTheLeastAndTheGreatestRow) {
    constexpr Word most = std::numeric_limits<Word>::max();
    const std::vector<Word> rows{0, 0, 0, 0, 0, most, most, 0, 0, most, most, most};
    std::string code;
    encode_rows(rows, 3, code);
    std::vector<Word> again;
    ASSERT_TRUE(decode_rows(code, 3, 4, again));
    EXPECT_EQ(again, rows);
}

// Consecutive rows need one byte each.
TEST(RowCodec, IsShortForNeighbours) {
    std::vector<Word> rows;
    for (Word i = 0; i < 1000; ++i) rows.insert(rows.end(), {7, 1'000'000 + i});
    std::string code;
    encode_rows(rows, 2, code);
    EXPECT_LE(code.size(), 1000U + 8);
}

// For all bytes, the decoded rows are ascending.
TEST(RowCodec, TakesAnyBytes) {
    std::mt19937 random(2);
    int taken = 0;
    for (int round = 0; round < 20'000; ++round) {
        std::string bytes(random() % 12, '\0');
        for (char& byte : bytes) byte = static_cast<char>(random() % 3 == 0 ? random() : random() % 4);
        const std::size_t width = 1 + random() % 3;
        const std::size_t count = random() % 6;
        std::vector<Word> rows;
        if (!decode_rows(bytes, width, count, rows)) continue;
        ++taken;
        ASSERT_EQ(rows.size(), count * width);
        for (std::size_t i = width; i < rows.size(); i += width) {
            const auto row = rows.begin() + static_cast<std::ptrdiff_t>(i);
            const auto words = static_cast<std::ptrdiff_t>(width);
            ASSERT_TRUE(std::lexicographical_compare(row - words, row, row, row + words));
        }
    }
    EXPECT_GT(taken, 500);
}

class RowFiles : public testing::Test {
protected:
    [[nodiscard]] std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
    static RowKind kind(std::size_t width, std::uint8_t mark = 1) {
        RowKind kind{width, {}};
        kind.search.fill(mark);
        return kind;
    }
    /// Writes two levels, the second of which has three blocks.
    std::string written(const std::string& name) {
        RowFile file = RowFile::create(path(name), kind(2));
        file.append(3, std::vector<Word>{1, 2, 1, 3, 4, 0});
        std::vector<Word> many;
        for (Word i = 0; i < 2 * RowFile::rows_of_block + 5; ++i) many.insert(many.end(), {i / 7, i});
        file.append(4, many);
        file.finish();
        return path(name);
    }
    static std::string read_contents(const std::string& path) {
        std::ifstream in(path, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    static void put(const std::string& path, const std::string& bytes) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    }
    /// Returns the distance to the next position to test. The test damages every byte of the header, the first level
    /// and the end, and samples in between.
    static std::size_t step(std::size_t at, const std::string& whole) {
        return at < 200 || at + 200 > whole.size() ? 1U : 499U;
    }
    /// Returns the message with which a file of these bytes is rejected, or "" if the file is accepted.
    std::string refused(const std::string& bytes) {
        put(path("given"), bytes);
        try {
            (void)RowFile::open(path("given"), kind(2), diagnostics::unlimited);
        } catch (const BadFile& error) {
            return error.what();
        }
        return "";
    }

    std::string error_;
    diagnostics::TemporaryFolder folder_{"", error_};
};

TEST_F(RowFiles, GiveBackTheirBlocksInAnyOrder) {
    const RowFile file = RowFile::open(written("a"), kind(2), diagnostics::unlimited);
    ASSERT_EQ(file.blocks().size(), 4U);
    EXPECT_EQ(file.rows(), 3 + 2 * RowFile::rows_of_block + 5);
    EXPECT_EQ(file.size(), std::filesystem::file_size(path("a")));
    std::vector<Word> rows;
    file.read(3, rows);
    EXPECT_EQ(rows.size(), 10U);
    EXPECT_EQ(rows[1], 2 * RowFile::rows_of_block);
    rows.clear();
    file.read(0, rows);
    EXPECT_EQ(rows, (std::vector<Word>{1, 2, 1, 3, 4, 0}));
    EXPECT_EQ(file.blocks()[0].level, 3U);
    EXPECT_EQ(file.blocks()[3].level, 4U);
}

TEST_F(RowFiles, CanBeReadWhileTheyGrow) {
    RowFile file = RowFile::create(path("a"), kind(1));
    file.append(0, std::vector<Word>{5, 6});
    std::vector<Word> rows;
    file.read(0, rows);
    file.append(1, std::vector<Word>{1});
    file.read(1, rows);
    EXPECT_EQ(rows, (std::vector<Word>{5, 6, 1}));
}

TEST_F(RowFiles, AreRefusedWhereAnyByteDiffers) {
    const std::string whole = read_contents(written("a"));
    for (std::size_t at = 0; at < whole.size(); at += step(at, whole)) {
        for (const int bit : {0, 3, 7}) {
            std::string damaged = whole;
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << bit));
            ASSERT_THAT(refused(damaged), AllOf(HasSubstr("given: byte "))) << at;
        }
    }
}

TEST_F(RowFiles, AreRefusedWhereverTheyEnd) {
    const std::string whole = read_contents(written("a"));
    for (std::size_t size = 0; size < whole.size(); size += step(size, whole))
        ASSERT_THAT(refused(whole.substr(0, size)), HasSubstr("given: byte ")) << size;
    EXPECT_THAT(refused(whole.substr(0, whole.size() - 1)), HasSubstr("the file ends here; it was cut off"));
    EXPECT_THAT(refused(whole + "x"), HasSubstr("more follows the end"));
    EXPECT_EQ(refused(whole), "");
}

TEST_F(RowFiles, AreRefusedForAnotherSearch) {
    const std::string a = written("a");
    const auto why = [&](const RowKind& other) {
        try {
            (void)RowFile::open(a, other, diagnostics::unlimited);
        } catch (const BadFile& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_THAT(why(kind(2, 7)), HasSubstr("belongs to another search"));
    EXPECT_THAT(why(kind(3)), HasSubstr("belongs to another search"));
    EXPECT_THAT(refused("assert STOP :[deadlock free]\n" + std::string(100, ' ')), HasSubstr("no file of rows"));
    std::string newer = read_contents(a);
    newer[8] = 9;
    EXPECT_THAT(refused(newer), HasSubstr("has format 9, this program reads 1"));
}

TEST_F(RowFiles, AreRefusedWithBlocksThatChangedPlaces) {
    const RowFile file = RowFile::open(written("a"), kind(2), diagnostics::unlimited);
    const std::string whole = read_contents(path("a"));
    const auto part = [&](std::size_t block) {
        const std::size_t end = block + 1 < file.blocks().size() ? file.blocks()[block + 1].offset : 0;
        return whole.substr(file.blocks()[block].offset, end - file.blocks()[block].offset);
    };
    std::string exchanged = whole;
    exchanged.replace(file.blocks()[1].offset, part(1).size() + part(2).size(), part(2) + part(1));
    EXPECT_THAT(refused(exchanged), HasSubstr("is damaged"));
    std::string missing = whole;
    missing.erase(file.blocks()[1].offset, part(1).size());
    EXPECT_THAT(refused(missing), HasSubstr("is damaged"));
}

TEST_F(RowFiles, AreFilesAndNothingElse) {
    const auto open = [&](const std::string& name) {
        (void)RowFile::open(path(name), kind(2), diagnostics::unlimited);
    };
    EXPECT_THROW(open("absent"), BadFile);
    std::filesystem::create_directory(path("folder"));
    EXPECT_THROW(open("folder"), BadFile);
    std::filesystem::create_symlink(written("a"), path("link"));
    EXPECT_THROW(open("link"), BadFile);
    EXPECT_THROW((void)RowFile::create(path("a"), kind(2)), CannotWrite) << "it is there";
}

TEST_F(RowFiles, SayThatTheDiskIsFull) {
    std::string why;
    try {
        const tests::FileLimit limit(100);
        written("a");
    } catch (const CannotWrite& error) {
        why = error.what();
    }
    EXPECT_THAT(why, AllOf(HasSubstr("cannot write"), HasSubstr("/a: File too large")));
}

TEST_F(RowFiles, CanBeFinishedWhenThereIsSpaceAgain) {
    RowFile file = RowFile::create(path("a"), kind(1));
    file.append(0, std::vector<Word>{5, 6});
    const std::uint64_t size = file.size();
    {
        const tests::FileLimit limit(size + 10);  // the limit leaves no space for the end of the file
        EXPECT_THROW(file.finish(), CannotWrite);
    }
    EXPECT_EQ(std::filesystem::file_size(path("a")), size);
    EXPECT_EQ(file.size(), size);
    EXPECT_FALSE(file.finished());
    file.append(1, std::vector<Word>{1});
    file.finish();
    const RowFile again = RowFile::open(path("a"), kind(1), diagnostics::unlimited);
    std::vector<Word> rows;
    again.read(0, rows);
    again.read(1, rows);
    EXPECT_EQ(rows, (std::vector<Word>{5, 6, 1}));
}

// If too many files are open, the error does not say that the file is damaged.
TEST_F(RowFiles, AreNotDamagedWhereTooManyAreOpen) {
    (void)written("many");
    const tests::OpenFilesLimit limit(0);
    try {
        (void)RowFile::open(path("many"), kind(2), diagnostics::unlimited);
        ADD_FAILURE() << "it is opened";
    } catch (const diagnostics::LimitReached& reached) {
        EXPECT_THAT(reached.what(), AllOf(HasSubstr(path("many")), HasSubstr("Too many open files")));
    }
}

}  // namespace
}  // namespace robochart::storage
