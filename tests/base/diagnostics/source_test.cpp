// SPDX-License-Identifier: Apache-2.0
// Tests positions in source texts.
#include "base/diagnostics/source.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdio>

#include "tests/temporary_folder.hpp"

namespace robochart::diagnostics {
namespace {

TEST(SourceManager, CountsLinesFromOneAndColumnsInCodePoints) {
    SourceManager sources;
    const SourceId id = sources.add("a.rct", "ab\n\xC3\xA9x\r\nlast");
    EXPECT_EQ(sources.position(id, 0).line, 1U);
    EXPECT_EQ(sources.position(id, 3).line, 2U);
    EXPECT_EQ(sources.position(id, 3).column, 1U);
    EXPECT_EQ(sources.position(id, 5).column, 2U);  // the x after a two-byte letter
    EXPECT_EQ(sources.position(id, 8).line, 3U);
    EXPECT_EQ(sources.position(id, 1000).column, 5U);  // clamped to the end
    EXPECT_EQ(sources.line_text(id, 2), "\xC3\xA9x");
    EXPECT_EQ(sources.line_text(id, 3), "last");
    EXPECT_EQ(sources.line_text(id, 4), "");
    EXPECT_EQ(sources.path_and_line({id, 8, 9}), "a.rct:3");
    EXPECT_EQ(sources.path_and_line({}), "");
}

/// The byte order mark belongs to the file, but positions are counted as if it were absent.
TEST(SourceManager, LeavesOutAByteOrderMark) {
    SourceManager sources;
    const SourceId id = sources.add("a.rct",
                                    "\xEF\xBB\xBF"
                                    "ab\ncd");
    EXPECT_EQ(sources.source_text(id), "ab\ncd");
    EXPECT_EQ(sources.position(id, 1).column, 2U);
    sources.replace(id, "\xEF\xBB\xBFx");
    EXPECT_EQ(sources.source_text(id), "x");
    sources.replace(id, "x\xEF\xBB\xBF");
    EXPECT_EQ(sources.source_text(id), "x\xEF\xBB\xBF");
}

TEST(SourceManager, KeepsViewsValidWhileGrowing) {
    SourceManager sources;
    const SourceId first = sources.add("first", "x");
    const std::string_view view = sources.source_text(first);
    for (int i = 0; i < 1000; ++i) sources.add("more", std::string(100, 'y'));
    EXPECT_EQ(view, "x");
    EXPECT_EQ(sources.size(), 1001U);
}

TEST(SourceManager, SaysWhyAFileCannotBeRead) {
    SourceManager sources;
    std::string error;
    EXPECT_FALSE(sources.load_file("/nowhere/at/all.rct", error).has_value());
    EXPECT_EQ(error, "no such file");
    const tests::TemporaryFolder folder;
    EXPECT_FALSE(sources.load_file(folder.path(), error).has_value());
    EXPECT_EQ(error, "is a folder, not a file");
    EXPECT_FALSE(sources.load_file("/dev/zero", error).has_value());
    EXPECT_EQ(error, "is a device, not a regular file");
    const std::string pipe = folder.in("pipe");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    EXPECT_FALSE(sources.load_file(pipe, error).has_value());  // without waiting for a writer
    EXPECT_EQ(error, "is a pipe, not a regular file");
}

TEST(SourceManager, LoadsBytesAsTheyAre) {
    const tests::TemporaryFolder folder;
    const std::string bytes("a\0\xFF\nb", 5);
    const std::string path = folder.write("bytes.rct", bytes);
    SourceManager sources;
    std::string error;
    const auto id = sources.load_file(path, error);
    ASSERT_TRUE(id.has_value()) << error;
    EXPECT_EQ(sources.source_text(*id), bytes);
}

TEST(Span, JoinCoversBoth) {
    const auto id = static_cast<SourceId>(0);
    EXPECT_EQ(join_spans({id, 5, 7}, {id, 1, 2}), (Span{id, 1, 7}));
    EXPECT_EQ(join_spans({}, {id, 1, 2}), (Span{id, 1, 2}));
    EXPECT_EQ(join_spans({id, 1, 2}, {}), (Span{id, 1, 2}));
}

}  // namespace
}  // namespace robochart::diagnostics
