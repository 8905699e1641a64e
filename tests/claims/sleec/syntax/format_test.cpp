// SPDX-License-Identifier: Apache-2.0
// Tests the standard layout: words and comments are kept, lines follow docs/format.md, and formatting is idempotent.
#include "claims/sleec/syntax/format.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "tests/claims/sleec/support.hpp"
#include "tests/claims/sleec/syntax/same_file.hpp"
#include "tests/contents.hpp"
#include "tests/shared_folder.hpp"

namespace robochart::sleec {
namespace {

std::string formatted(const std::string& text) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const auto result = format(sources, sources.add("rules.sleec", text), diagnostics);
    return result ? *result : "refused: " + diagnostics::render_text(sources, diagnostics);
}

TEST(SleecFormat, OneItemALine) {
    EXPECT_EQ(
        formatted("def_start event Go\n\n\nevent   Stop measure near:boolean measure load : scale ( low,mid ,high )"
                  "constant MAX=5 map Go to M :: go def_end rule_start R1 when Go and(load>=mid)then not Stop "
                  "within MAX seconds assume R2 when Stop then Go within 3 minutes unless near rule_end"),
        "def_start\n"
        "    event Go\n"
        "\n"
        "    event Stop\n"
        "    measure near : boolean\n"
        "    measure load : scale(low, mid, high)\n"
        "    constant MAX = 5\n"
        "    map Go to M::go\n"
        "def_end\n"
        "rule_start\n"
        "    R1 when Go and (load >= mid) then not Stop within MAX seconds\n"
        "    assume R2 when Stop then Go within 3 minutes unless near\n"
        "rule_end\n");
}

TEST(SleecFormat, ArgumentsAndStates) {
    EXPECT_EQ(
        formatted("def_start event go event halt def_end rule_start R when go (1 ,_)and in A :: B then not halt( - 2 )"
                  "within (3+2) seconds unless(in C) R2 halt (3) at least (1+1) seconds after go(0,0) rule_end"),
        "def_start\n"
        "    event go\n"
        "    event halt\n"
        "def_end\n"
        "rule_start\n"
        "    R when go(1, _) and in A::B then not halt(-2) within (3 + 2) seconds unless (in C)\n"
        "    R2 halt(3) at least (1 + 1) seconds after go(0, 0)\n"
        "rule_end\n");
}

TEST(SleecFormat, LongRulesBreakAtTheirBranches) {
    EXPECT_EQ(
        formatted("def_start event AVeryLongNameOfAnEvent event AnotherLongNameOfAnEvent measure near : boolean "
                  "def_end rule_start R when AVeryLongNameOfAnEvent and near then AnotherLongNameOfAnEvent within 5 "
                  "seconds otherwise AVeryLongNameOfAnEvent unless near then {AnotherLongNameOfAnEvent unless near} "
                  "rule_end"),
        "def_start\n"
        "    event AVeryLongNameOfAnEvent\n"
        "    event AnotherLongNameOfAnEvent\n"
        "    measure near : boolean\n"
        "def_end\n"
        "rule_start\n"
        "    R when AVeryLongNameOfAnEvent and near then AnotherLongNameOfAnEvent within 5 seconds\n"
        "        otherwise AVeryLongNameOfAnEvent\n"
        "        unless near then {AnotherLongNameOfAnEvent unless near}\n"
        "rule_end\n");
}

TEST(SleecFormat, CommentsStayWhereTheyAre) {
    EXPECT_EQ(
        formatted(
            "// rules of the ward\n\n/* two\n   lines */\ndef_start // the names\n  event Go // starts\n"
            "// of the end\nevent Stop\n// no more\ndef_end\nrule_start\nR when Go // quick\nthen Stop /* soon */ "
            "within 2 seconds\n// last\nrule_end\n// end  \n"),
        "// rules of the ward\n"
        "\n"
        "/* two\n"
        "   lines */\n"
        "def_start // the names\n"
        "    event Go // starts\n"
        "    // of the end\n"
        "    event Stop\n"
        "    // no more\n"
        "def_end\n"
        "rule_start\n"
        "    R when Go // quick\n"
        "        then Stop /* soon */ within 2 seconds\n"
        "    // last\n"
        "rule_end\n"
        "// end\n");
}

TEST(SleecFormat, BrokenTextsAreLeft) {
    EXPECT_TRUE(formatted("def_start event def_end rule_start rule_end").starts_with("refused: "));
    EXPECT_TRUE(
        formatted("def_start event Go def_end rule_start R when Go then Go /* rule_end").starts_with("refused: "));
}

TEST(SleecFormat, ASecondTimeNothingChanges) {
    const std::filesystem::path suite = tests::shared_folder() / "suite/sleec";
    if (tests::shared_folder().empty() || !std::filesystem::exists(suite))
        GTEST_SKIP() << "the published files are not there";
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(suite)) {
        if (entry.path().extension() != ".sleec") continue;
        SCOPED_TRACE(entry.path());
        const std::string once = formatted(tests::read_contents(entry.path()));
        if (once.starts_with("refused: ")) continue;
        ++files;
        EXPECT_EQ(formatted(once), once);
        testing::Read before(tests::read_contents(entry.path())), after(once);
        EXPECT_TRUE(testing::same_file(before.file, after.file));
    }
    EXPECT_GT(files, 30U);
}

}  // namespace
}  // namespace robochart::sleec
