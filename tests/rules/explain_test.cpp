// SPDX-License-Identifier: Apache-2.0
// Tests pages of rules that are formatted for a terminal.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/rule_pages/rule_pages.hpp"

namespace robochart::diagnostics {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

const std::string page =
    "# X1: a `thing` is wrong\n\n*error · names · here*\n\nSee [X2](X2.md), 2 * 3 * 4.\n\n## Wrong\n\n"
    "```robochart file=a.rct\nstm S  // expect: X1\n```\n\n## Right\n\n```robochart\nstm S\n```\n";

TEST(PageText, IsReadIntoItsParts) {
    const RulePage read = read_page(page);
    EXPECT_TRUE(read.faults.empty());
    EXPECT_EQ(read.code, "X1");
    EXPECT_EQ(read.title, "a `thing` is wrong");
    EXPECT_EQ(read.severity, "error");
    EXPECT_EQ(read.area, "names");
    EXPECT_EQ(read.source, "here");
    ASSERT_EQ(read.wrong.size(), 1U);
    EXPECT_EQ(read.wrong[0].file, "a.rct");
    EXPECT_EQ(read.wrong[0].text, "stm S  // expect: X1\n");
    EXPECT_EQ(read.right.size(), 1U);
}

TEST(PageText, SaysWhatDepartsFromTheForm) {
    EXPECT_EQ(read_page("X1\n").faults.size(), 5U);
    EXPECT_THAT(read_page("# X1: a\n\n*error · b*\n\nWhy.\n\n## Wrong\n\n```robochart\nstm").faults,
                ::testing::ElementsAre("a fence is not closed", "there is no example under `## Right`"));
}

TEST(PageText, IsPlainWithoutColours) {
    const std::string drawn = render_page(page, false);
    EXPECT_THAT(drawn, HasSubstr("X1: a `thing` is wrong\n\nerror · names · here\n"));
    EXPECT_THAT(drawn, HasSubstr("See X2, 2 * 3 * 4."));
    EXPECT_THAT(drawn, HasSubstr("Wrong\n\n    stm S  // <-- X1\n"));
    EXPECT_THAT(drawn, Not(HasSubstr("```")));
    EXPECT_THAT(drawn, Not(HasSubstr("\x1b")));
}

TEST(PageText, HasBoldHeadingsWithColours) {
    const std::string drawn = render_page(page, true);
    EXPECT_THAT(drawn, HasSubstr("\x1b[1mWrong\x1b[0m"));
    EXPECT_THAT(drawn, HasSubstr("\x1b[36mX2\x1b[0m"));
    EXPECT_THAT(drawn, HasSubstr("    stm S"));
}

TEST(PageText, GivesTheReasonForARuleInParagraphs) {
    const std::string reason = reason_for({"RC-W21", Severity::warning, ""});
    EXPECT_TRUE(reason.starts_with("Every assignment changes the variable")) << reason;
    EXPECT_THAT(reason, HasSubstr("keeps that value (docs/cpp.md)."));
    EXPECT_THAT(reason, Not(HasSubstr("\n")));
    EXPECT_EQ(reason_for({"NOSUCHRULE", Severity::warning, ""}), "");
}

TEST(PageText, IsFoundWhateverTheCase) {
    EXPECT_EQ(page_text("stm6"), page_text("STM6"));
    EXPECT_TRUE(page_text("NOSUCHRULE").empty());
}

}  // namespace
}  // namespace robochart::diagnostics
