// SPDX-License-Identifier: Apache-2.0
// Tests the verb `format`: files that are written, files that stay unchanged, exit codes, and diffs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "app/report/diff.hpp"
#include "tests/app/command.hpp"
#include "tests/contents.hpp"

namespace robochart::app::testing::format_test {
namespace {

using tests::read_contents;

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const char* const untidy = "stm  S{initial i // first\n  state a{ }transition t{from i to a}}";
const char* const tidy = "stm S {\n\tinitial i // first\n\tstate a {}\n\ttransition t { from i to a }\n}\n";

TEST(FormatVerb, WritesInPlaceWhatChanges) {
    const TemporaryFile file("model.rct", untidy);
    const Ran ran = run({"format", file.path()});
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(ran.out, file.path() + "\n");
    EXPECT_EQ(ran.err, "1 of 1 file changed\n");
    EXPECT_EQ(read_contents(file.path()), tidy);
    const Ran again = run({"format", file.path()});
    EXPECT_EQ(again.out, "");
    EXPECT_EQ(again.err, "1 file in the standard layout\n");
}

TEST(FormatVerb, KeepsPermissionsAndLinksAndLeavesNoOtherFile) {
    const TemporaryFile file("model.rct", untidy);
    ASSERT_EQ(chmod(file.path().c_str(), 0640), 0);
    const fs::path folder = fs::path(file.path()).parent_path();
    fs::create_symlink("model.rct", folder / "link.rct");
    EXPECT_EQ(run({"format", "-q", (folder / "link.rct").string()}).exit, 0);
    EXPECT_TRUE(fs::is_symlink(folder / "link.rct"));
    EXPECT_EQ(read_contents(file.path()), tidy);
    struct stat status {};
    ASSERT_EQ(stat(file.path().c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 07777U, 0640U);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
}

TEST(FormatVerb, DoesNotTouchWhatIsInTheStyle) {
    const TemporaryFile file("model.rct", tidy);
    const auto old = fs::last_write_time(file.path()) - std::chrono::hours(1);
    fs::last_write_time(file.path(), old);
    EXPECT_EQ(run({"format", file.path()}).exit, 0);
    EXPECT_EQ(fs::last_write_time(file.path()), old);
}

TEST(FormatVerb, CheckListsAndWritesNothing) {
    const TemporaryFile file("model.rct", untidy);
    const TemporaryFile good("good.rct", tidy);
    const Ran ran = run({"format", "--check", file.path(), good.path()});
    EXPECT_EQ(ran.exit, 1);
    EXPECT_EQ(ran.out, file.path() + "\n");
    EXPECT_EQ(ran.err, "1 of 2 files would change\n");
    EXPECT_EQ(read_contents(file.path()), untidy);
    EXPECT_EQ(run({"format", "--check", good.path()}).exit, 0);
}

TEST(FormatVerb, DiffShowsAndWritesNothing) {
    const TemporaryFile file("model.rct", "type  A\ntype B\n");
    const Ran ran = run({"format", "--diff", file.path()});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_EQ(ran.out,
              "--- " + file.path() + "\n+++ " + file.path() + "\n@@ -1,2 +1,2 @@\n-type  A\n+type A\n type B\n");
    EXPECT_EQ(read_contents(file.path()), "type  A\ntype B\n");
    EXPECT_EQ(run({"format", "--diff", "--check", file.path()}).exit, 1);
}

TEST(FormatVerb, ReadsFolders) {
    const TemporaryFile file("model.rct", untidy);
    const fs::path folder = fs::path(file.path()).parent_path();
    fs::create_directories(folder / "below");
    fs::create_directories(folder / ".hidden");
    std::ofstream(folder / "below" / "claims.assertions") << "assertion A:S terminates";
    std::ofstream(folder / "below" / "notes.txt") << "type  A";
    std::ofstream(folder / ".hidden" / "old.rct") << "type  A";
    const Ran ran = run({"format", folder.string(), file.path()});
    EXPECT_EQ(ran.exit, 0);
    EXPECT_EQ(ran.err, "2 of 2 files changed\n");
    EXPECT_EQ(read_contents(folder / "below" / "claims.assertions"), "assertion A : S terminates\n");
    EXPECT_EQ(read_contents(folder / "below" / "notes.txt"), "type  A");
    EXPECT_EQ(read_contents(folder / ".hidden" / "old.rct"), "type  A");
}

TEST(FormatVerb, FiltersStandardInput) {
    EXPECT_EQ(run({"format", "-"}, untidy).out, tidy);
    EXPECT_EQ(run({"format", "-"}, untidy).err, "");
    EXPECT_EQ(run({"format", "--assertions", "-"}, "assertion A:S terminates").out, "assertion A : S terminates\n");
    const Ran wrong = run({"format", "-"}, "stm S { state }");
    EXPECT_EQ(wrong.exit, 2);
    EXPECT_EQ(wrong.out, "");
    EXPECT_THAT(wrong.err, HasSubstr("<stdin>:1"));
    EXPECT_EQ(run({"format", "--check", "-"}, untidy).exit, 1);
    EXPECT_EQ(run({"format", "--check", "-"}, tidy).exit, 0);
}

TEST(FormatVerb, LeavesTextsWithMistakesAlone) {
    const TemporaryFile bad("bad.rct", "stm  S { state }");
    const TemporaryFile good("good.rct", untidy);
    const Ran ran = run({"format", bad.path(), good.path()});
    EXPECT_EQ(ran.exit, 2);
    EXPECT_THAT(ran.err, HasSubstr("RC-P01"));
    EXPECT_EQ(read_contents(bad.path()), "stm  S { state }");
    EXPECT_EQ(read_contents(good.path()), tidy);
}

TEST(FormatVerb, SaysWhatCannotBeReadOrWritten) {
    const Ran missing = run({"format", "no/such.rct"});
    EXPECT_EQ(missing.exit, 2);
    EXPECT_THAT(missing.err, HasSubstr("RC-F01"));
    const TemporaryFile note("note.txt", "");
    const Ran empty = run({"format", fs::path(note.path()).parent_path().string()});
    EXPECT_EQ(empty.exit, 2);
    EXPECT_THAT(empty.err, HasSubstr("RC-F03"));
    EXPECT_EQ(run({"format"}).exit, 4);
    if (geteuid() == 0) return;  // root may write any file
    const TemporaryFile read_only("kept.rct", untidy);
    ASSERT_EQ(chmod(read_only.path().c_str(), 0440), 0);
    const Ran refused = run({"format", read_only.path()});
    EXPECT_EQ(refused.exit, 2);
    EXPECT_THAT(refused.err, HasSubstr("RC-A03"));
    EXPECT_EQ(read_contents(read_only.path()), untidy);
}

TEST(FormatVerb, TheModelsOfTheRepositoryAreInTheStyle) {
    const Ran ran = run({"format", "--check", repository("corpus"), repository("frontend/toolkits/library")});
    EXPECT_EQ(ran.exit, 0) << "run robochart-verify format on:\n" << ran.out;
}

// ---------------------------------------------------------------- diffs

TEST(UnifiedDiff, EqualTextsHaveNone) {
    EXPECT_EQ(unified_diff("f", "a\nb\n", "a\nb\n"), "");
    EXPECT_EQ(unified_diff("f", "", ""), "");
}

TEST(UnifiedDiff, ShowsThreeLinesAroundChanges) {
    EXPECT_EQ(unified_diff("f", "1\n2\n3\n4\n5\n6\n7\n8\n9\n", "1\n2\n3\n4\nx\n6\n7\n8\n9\n"),
              "--- f\n+++ f\n@@ -2,7 +2,7 @@\n 2\n 3\n 4\n-5\n+x\n 6\n 7\n 8\n");
    EXPECT_EQ(unified_diff("f", "", "a\n"), "--- f\n+++ f\n@@ -0,0 +1 @@\n+a\n");
    EXPECT_EQ(unified_diff("f", "a", "a\n"), "--- f\n+++ f\n@@ -1 +1 @@\n-a\n\\ No newline at end of file\n+a\n");
}

TEST(UnifiedDiff, JoinsNearChangesAndSeparatesFarOnes) {
    const std::string before = "a\n1\n2\n3\n4\n5\n6\nb\n1\n2\n3\n4\n5\n6\n7\nc\n";
    const std::string after = "A\n1\n2\n3\n4\n5\n6\nB\n1\n2\n3\n4\n5\n6\n7\nC\n";
    EXPECT_EQ(unified_diff("f", before, after),
              "--- f\n+++ f\n@@ -1,11 +1,11 @@\n-a\n+A\n 1\n 2\n 3\n 4\n 5\n 6\n-b\n+B\n 1\n 2\n 3\n@@ -13,4 +13,4 "
              "@@\n 5\n 6\n 7\n-c\n+C\n");
}

/// Applies the diff to the old text and returns the new text, as `patch` does.
std::string patched(const std::string& before, const std::string& diff) {
    std::vector<std::string> old_lines;
    std::istringstream text(before);
    for (std::string line; std::getline(text, line);) old_lines.push_back(line);
    std::istringstream lines(diff);
    std::string out;
    std::size_t at = 0;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("---") || line.starts_with("+++")) continue;
        if (line.starts_with("@@")) {
            const auto begin = static_cast<std::size_t>(std::stoul(line.substr(4)));
            const bool none = line.substr(4, line.find(' ', 4) - 4).ends_with(",0");
            for (const std::size_t first = none ? begin : begin - 1; at < first; ++at) out += old_lines[at] + "\n";
            continue;
        }
        if (line[0] != '+') {
            EXPECT_EQ(old_lines.at(at), line.substr(1));
            ++at;
        }
        if (line[0] != '-') out += line.substr(1) + "\n";
    }
    for (; at < old_lines.size(); ++at) out += old_lines[at] + "\n";
    return out;
}

TEST(UnifiedDiff, PatchesRandomTexts) {
    std::mt19937 random(3);
    const auto text = [&] {
        std::string result;
        for (std::size_t i = random() % 40; i > 0; --i)
            result += std::string(1, static_cast<char>('a' + random() % 4)) + "\n";
        return result;
    };
    for (int round = 0; round < 2000; ++round) {
        const std::string before = text();
        const std::string after = text();
        ASSERT_EQ(patched(before, unified_diff("f", before, after)), after) << before << "\n" << after;
    }
}

TEST(UnifiedDiff, LargeChangesAreReplacedAsAWhole) {
    std::string before;
    std::string after;
    for (int i = 0; i < 20'000; ++i) {
        before += "a" + std::to_string(i) + "\n";
        after += "b" + std::to_string(i) + "\n";
    }
    EXPECT_EQ(patched(before, unified_diff("f", before, after)), after);
}

}  // namespace
}  // namespace robochart::app::testing::format_test
