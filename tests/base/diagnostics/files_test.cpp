// SPDX-License-Identifier: Apache-2.0
// Tests that files are written completely or not at all, at the requested place and nowhere else.
#include "base/diagnostics/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <thread>

#include "base/diagnostics/fixes.hpp"
#include "tests/contents.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::diagnostics {
namespace {

using tests::read_contents;

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

class Files : public ::testing::Test {
protected:
    [[nodiscard]] std::string in(const std::string& name) const { return folder_.in(name); }
    void put(const std::string& name, const std::string& text) const { folder_.write(name, text); }
    /// Returns the number of files in a folder, including hidden ones.
    static std::size_t count(const std::string& path) {
        return static_cast<std::size_t>(std::distance(fs::directory_iterator(path), fs::directory_iterator()));
    }

    tests::TemporaryFolder folder_;
};

TEST_F(Files, AreWrittenWithTheFoldersAboveThem) {
    EXPECT_EQ(write_below(in("out"), "a/b/c.txt", "text"), "");
    EXPECT_EQ(read_contents(in("out/a/b/c.txt")), "text");
    EXPECT_EQ(write_below(in("out"), "a/b/c.txt", "other"), "");
    EXPECT_EQ(read_contents(in("out/a/b/c.txt")), "other");
    EXPECT_EQ(count(in("out/a/b")), 1U);
}

TEST_F(Files, StayBelowTheirFolder) {
    for (const char* path : {"../x", "a/../../x", "/etc/x", "..", ".", "", "a/", "a/./x"})
        EXPECT_THAT(write_below(in("out"), path, "text"), HasSubstr("refusing")) << path;
    EXPECT_EQ(count(folder_.path()), 0U);
}

TEST_F(Files, DoNotFollowLinksBelowTheirFolder) {
    fs::create_directories(in("out"));
    fs::create_directories(in("elsewhere"));
    put("precious", "mine");
    fs::create_symlink(in("elsewhere"), in("out/sub"));
    EXPECT_THAT(write_below(in("out"), "sub/x", "text"), AllOf(HasSubstr("refusing"), HasSubstr("symbolic link")));
    EXPECT_EQ(count(in("elsewhere")), 0U);
    // A symbolic link in place of the file is replaced, but its target stays unchanged.
    fs::create_symlink(in("precious"), in("out/file"));
    EXPECT_EQ(write_below(in("out"), "file", "text"), "");
    EXPECT_EQ(read_contents(in("precious")), "mine");
    EXPECT_EQ(read_contents(in("out/file")), "text");
    EXPECT_FALSE(fs::is_symlink(in("out/file")));
    // The requested folder itself may be a symbolic link, because the user chose it.
    fs::create_symlink(in("elsewhere"), in("named"));
    EXPECT_EQ(write_below(in("named"), "x", "text"), "");
    EXPECT_EQ(read_contents(in("elsewhere/x")), "text");
}

TEST_F(Files, ThatCannotBePutInTheirPlaceLeaveNothing) {
    fs::create_directories(in("out/x"));
    EXPECT_THAT(write_below(in("out"), "x", "text"), HasSubstr("cannot write"));
    EXPECT_EQ(count(in("out")), 1U);
    put("file", "text");
    EXPECT_THAT(write_below(in("file"), "x", "text"), HasSubstr("cannot create the folder"));
    EXPECT_THAT(write_below("/dev/null/out", "x", "text"), HasSubstr("/dev/null/out"));
}

TEST_F(Files, ThatDoNotFitLeaveTheOldOne) {
    put("old", "old text");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const auto handler = signal(SIGXFSZ, SIG_IGN);
    const rlimit small{1000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string below = write_below(folder_.path(), "new", std::string(10'000, 'x'));
    const std::string replaced = replace_file(in("old"), std::string(10'000, 'x'));
    setrlimit(RLIMIT_FSIZE, &before);
    signal(SIGXFSZ, handler);
    EXPECT_THAT(below, HasSubstr("File too large"));
    EXPECT_THAT(replaced, HasSubstr("File too large"));
    EXPECT_EQ(read_contents(in("old")), "old text");
    EXPECT_EQ(count(folder_.path()), 1U);
}

TEST_F(Files, ReplacedTextsKeepTheirByteOrderMark) {
    put("marked", "\xEF\xBB\xBFold");
    put("plain", "old");
    put("short", "\xEF");
    for (const char* name : {"marked", "plain", "short", "new"}) EXPECT_EQ(replace_text(in(name), "text"), "") << name;
    EXPECT_EQ(read_contents(in("marked")), "\xEF\xBB\xBFtext");
    for (const char* name : {"plain", "short", "new"}) EXPECT_EQ(read_contents(in(name)), "text") << name;
}

TEST_F(Files, ReplacedInPlaceKeepTheirModeAndTheLinkToThem) {
    put("source", "old");
    chmod(in("source").c_str(), 0640);
    fs::create_symlink("source", in("link"));
    EXPECT_EQ(replace_file(in("link"), "new"), "");
    EXPECT_TRUE(fs::is_symlink(in("link")));
    EXPECT_EQ(read_contents(in("source")), "new");
    struct stat status {};
    ASSERT_EQ(stat(in("source").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
    EXPECT_EQ(count(folder_.path()), 2U);
}

TEST_F(Files, ReplacedAreRegularOnes) {
    ASSERT_EQ(mkfifo(in("pipe").c_str(), 0600), 0);
    EXPECT_THAT(replace_file(in("pipe"), "text"), HasSubstr("not a regular file"));
    EXPECT_THAT(replace_file(folder_.path(), "text"), HasSubstr("not a regular file"));
    fs::create_symlink("nowhere", in("dangling"));
    EXPECT_THAT(replace_file(in("dangling"), "text"), HasSubstr("cannot write"));
    EXPECT_EQ(replace_file(in("fresh/new"), "text"), "");
    EXPECT_EQ(read_contents(in("fresh/new")), "text");
}

TEST_F(Files, WrittenAtTheSameTimeAreEachWhole) {
    const std::string a(200'000, 'a');
    const std::string b(300'000, 'b');
    const auto write = [&](const std::string& text) {
        for (int i = 0; i < 50; ++i) EXPECT_EQ(write_below(in("out"), "sub/same", text), "");
    };
    std::thread first([&] { write(a); });
    std::thread second([&] { write(b); });
    first.join();
    second.join();
    const std::string left = read_contents(in("out/sub/same"));
    EXPECT_TRUE(left == a || left == b);
    EXPECT_EQ(count(in("out/sub")), 1U);
}

TEST_F(Files, ThatGrowStandInTheirPlaceWhenTheyAreFinished) {
    {
        GrowingFile left(in("out"), "sub/left", nullptr);
        EXPECT_EQ(left.append("one"), "");
    }
    EXPECT_EQ(count(in("out/sub")), 0U);
    GrowingFile file(in("out"), "sub/file", nullptr);
    EXPECT_EQ(file.append("one "), "");
    EXPECT_FALSE(fs::exists(in("out/sub/file")));
    EXPECT_EQ(file.append("two"), "");
    EXPECT_EQ(file.finish(), "");
    EXPECT_EQ(read_contents(in("out/sub/file")), "one two");
    EXPECT_EQ(count(in("out/sub")), 1U);
}

TEST_F(Files, TemporaryFoldersAreOnesOwnAndGo) {
    std::string error;
    std::string path;
    {
        const TemporaryFolder one(folder_.path(), error);
        path = one.path();
        struct stat status {};
        ASSERT_EQ(stat(path.c_str(), &status), 0) << error;
        EXPECT_EQ(status.st_mode & 07777U, 0700U);
        std::ofstream(path + "/x") << "text";
    }
    EXPECT_FALSE(fs::exists(path));
    const TemporaryFolder none(in("nowhere"), error);
    EXPECT_EQ(none.path(), "");
    EXPECT_THAT(error, HasSubstr("cannot make a folder"));
}

}  // namespace
}  // namespace robochart::diagnostics
