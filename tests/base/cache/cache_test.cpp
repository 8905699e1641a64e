// SPDX-License-Identifier: Apache-2.0
// Tests that cache entries are found complete or not at all, and only by the program version that stored them. Tests
// also that the folder stays small.
#include "base/cache/cache.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "base/diagnostics/files.hpp"

namespace robochart::diagnostics {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t mebibyte = std::uint64_t{1} << 20U;

class CacheTest : public ::testing::Test {
protected:
    [[nodiscard]] std::string folder() const { return temporary_.path() + "/cache"; }
    [[nodiscard]] Cache cache(std::uint64_t most_bytes = mebibyte, const std::string& program = "one") const {
        return {folder(), program, most_bytes};
    }
    [[nodiscard]] std::vector<fs::path> entries() const {
        std::vector<fs::path> result;
        for (const std::string& file : files_below(folder(), true).files) result.emplace_back(file);
        return result;
    }

private:
    std::string error_;
    TemporaryFolder temporary_{"", error_};
};

Digest key(std::uint64_t number) {
    Hasher hasher;
    hasher.add(number);
    return hasher.finish();
}

TEST(HasherTest, PartsDoNotRunTogether) {
    const auto of = [](std::string_view first, std::string_view second) {
        Hasher hasher;
        hasher.add(first);
        hasher.add(second);
        return hasher.finish();
    };
    EXPECT_EQ(of("ab", "c"), of("ab", "c"));
    EXPECT_NE(of("ab", "c"), of("a", "bc"));
    EXPECT_NE(of("ab", ""), of("", "ab"));
}

TEST_F(CacheTest, FindsWhatWasKept) {
    cache().store_entry(key(1), std::string("a\0b", 3));
    EXPECT_EQ(cache().find(key(1)), std::string("a\0b", 3));
    EXPECT_EQ(cache().find(key(2)), std::nullopt);
}

TEST_F(CacheTest, AnotherProgramFindsNothing) {
    cache(mebibyte, "one").store_entry(key(1), "a");
    EXPECT_EQ(cache(mebibyte, "two").find(key(1)), std::nullopt);
    EXPECT_EQ(cache(mebibyte, "").find(key(1)), std::nullopt);
    EXPECT_EQ(cache(mebibyte, "one").find(key(1)), "a");
}

TEST_F(CacheTest, ADamagedEntryIsRemovedAndNotFound) {
    for (const std::size_t length : {0U, 10U, 32U, 35U}) {
        cache().store_entry(key(1), "content");
        ASSERT_EQ(entries().size(), 1U);
        fs::resize_file(entries().front(), length);
        EXPECT_EQ(cache().find(key(1)), std::nullopt) << length;
        EXPECT_TRUE(entries().empty()) << length;
    }
    cache().store_entry(key(1), "content");
    std::fstream(entries().front(), std::ios::in | std::ios::out).seekp(35).put('X');
    EXPECT_EQ(cache().find(key(1)), std::nullopt);
}

TEST_F(CacheTest, AnEntryOfAnotherKeyIsNotFound) {
    cache().store_entry(key(1), "content");
    const fs::path first = entries().front();
    const std::string text = [&] {
        std::ifstream in(first, std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    }();
    cache().store_entry(key(2), "other");
    for (const fs::path& path : entries())
        if (path != first) std::ofstream(path, std::ios::binary) << text;
    EXPECT_EQ(cache().find(key(2)), std::nullopt);
}

TEST_F(CacheTest, NeitherFollowsALinkNorReadsAFolder) {
    cache().store_entry(key(1), "content");
    const fs::path entry = entries().front();
    fs::rename(entry, folder() + "/elsewhere");
    fs::create_symlink(folder() + "/elsewhere", entry);
    EXPECT_EQ(cache().find(key(1)), std::nullopt);
    fs::remove(entry);
    fs::create_directory(entry);
    EXPECT_EQ(cache().find(key(1)), std::nullopt);
}

TEST_F(CacheTest, AFolderThatOthersMayWriteToIsNotUsed) {
    cache().store_entry(key(1), "a");
    ASSERT_EQ(chmod(folder().c_str(), 0777), 0);
    EXPECT_EQ(cache().find(key(1)), std::nullopt);
    ASSERT_EQ(chmod(folder().c_str(), 0700), 0);
    EXPECT_EQ(cache().find(key(1)), "a");
}

TEST_F(CacheTest, WhereThereIsNoFolderNothingIsKept) {
    (void)cache();
    for (const std::string& nowhere : {std::string(), std::string("/proc/none/here"), folder() + "/file/below"}) {
        std::ofstream(folder() + "/file");
        Cache none(nowhere, "one", mebibyte);
        none.store_entry(key(1), "a");
        EXPECT_EQ(none.find(key(1)), std::nullopt);
    }
}

TEST_F(CacheTest, StaysBelowItsBound) {
    Cache small = cache(mebibyte);
    const std::string content(10'000, 'x');
    for (std::uint64_t i = 0; i < 500; ++i) small.store_entry(key(i), content);
    std::uint64_t bytes = 0;
    for (const fs::path& path : entries()) bytes += fs::file_size(path);
    EXPECT_LE(bytes, mebibyte);
    EXPECT_GE(bytes, mebibyte / 4);
}

TEST_F(CacheTest, WhatWasUsedLastStays) {
    Cache small = cache(mebibyte);
    const std::string content(10'000, 'x');
    small.store_entry(key(0), content);
    for (std::uint64_t i = 1; i < 500; ++i) {
        for (const fs::path& path : entries())
            fs::last_write_time(path, fs::file_time_type::clock::now() - std::chrono::hours(2));
        ASSERT_TRUE(small.find(key(0))) << i;
        small.store_entry(key(i), content);
    }
}

TEST_F(CacheTest, AnEntryThatIsTooLargeIsNotKept) {
    Cache small = cache(mebibyte);
    small.store_entry(key(1), std::string(mebibyte / 16, 'x'));
    EXPECT_TRUE(entries().empty());
}

TEST_F(CacheTest, AFileThatIsLargerThanAnEntryIsNotRead) {
    const std::string content(mebibyte / 64, 'x');
    cache(8 * mebibyte).store_entry(key(1), content);
    EXPECT_EQ(cache(8 * mebibyte).find(key(1)), content);
    EXPECT_EQ(cache(mebibyte).find(key(1)), content) << "as large as an entry may be";
    EXPECT_EQ(cache(mebibyte - 64).find(key(1)), std::nullopt);
}

TEST_F(CacheTest, LeftoversOfAKilledProcessAreRemoved) {
    cache().store_entry(key(1), "a");
    const fs::path left = entries().front().parent_path() / ".robochart-0123456789abcdef";
    std::ofstream(left) << "half";
    cache().store_entry(key(1), "b");
    EXPECT_TRUE(fs::exists(left)) << "another process may be writing it";
    fs::last_write_time(left, fs::file_time_type::clock::now() - std::chrono::hours(2));
    cache().store_entry(key(1), "c");
    EXPECT_FALSE(fs::exists(left));
}

TEST_F(CacheTest, SeveralMayUseItAtOnce) {
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (int thread = 0; thread < 4; ++thread)
        threads.emplace_back([&] {
            Cache own = cache(mebibyte / 4);
            for (std::uint64_t i = 0; i < 200; ++i) {
                const std::string content(1000 + i % 7, static_cast<char>('a' + i % 7));
                own.store_entry(key(i % 7), content);
                const auto found = own.find(key(i % 7));
                if (found && *found != content) ++wrong;
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST(ProgramIdentityTest, TheLinkerGaveOne) {
    EXPECT_EQ(program_identity().size(), 20U) << "SHA-1, as CMakeLists.txt asks for";
}

}  // namespace
}  // namespace robochart::diagnostics
