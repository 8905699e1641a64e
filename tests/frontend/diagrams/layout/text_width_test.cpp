// SPDX-License-Identifier: Apache-2.0
// Tests widths of text and line breaking.
#include "frontend/diagrams/layout/text_width.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace robochart::diagrams::layout {
namespace {

using ::testing::ElementsAre;

/// In DejaVu Sans 2.37, A is 1401 of 2048 units wide, and i is 569. In bold they are 1585 and 702 (fonttools prints its
/// table hmtx).
TEST(TextWidth, IsTheSumOfTheAdvances) {
    EXPECT_DOUBLE_EQ(text_width("A", 2048), 1401 * font_slack);
    EXPECT_DOUBLE_EQ(text_width("Ai", 2048), (1401 + 569) * font_slack);
    EXPECT_DOUBLE_EQ(text_width("Ai", 2048, true), (1585 + 702) * font_slack);
    EXPECT_DOUBLE_EQ(text_width("", 12), 0);
}

TEST(TextWidth, UnknownCharactersAreAnEmWide) {
    EXPECT_DOUBLE_EQ(text_width("\xE6\xBC\xA2", 10), 10 * font_slack);
    EXPECT_DOUBLE_EQ(text_width("\xFF", 10), 10 * font_slack);
}

TEST(Broken, PiecesStayTogetherWhereTheyFit) {
    EXPECT_THAT(break_lines({"e?x", "[x > 1]", "/stop()"}, {34, 6}).lines, ElementsAre("e?x[x > 1]/stop()"));
    EXPECT_THAT(break_lines({"e?x", "[x > 1]", "/stop()"}, {12, 6}).lines, ElementsAre("e?x[x > 1]", "/stop()"));
}

TEST(Broken, LinesEndAtBlanksOrAnywhere) {
    EXPECT_THAT(break_lines({"one two three"}, {8, 6}).lines, ElementsAre("one two", "three"));
    EXPECT_THAT(break_lines({"abcdefghij"}, {4, 6}).lines, ElementsAre("abcd", "efgh", "ij"));
    EXPECT_THAT(break_lines({"event!value_of_it"}, {12, 6}).lines, ElementsAre("event!value_", "of_it"));
    EXPECT_THAT(break_lines({"a!bcdefghijkl"}, {6, 6}).lines, ElementsAre("a!bcde", "fghijk", "l"));
    EXPECT_THAT(break_lines({""}, {4, 6}).lines, ElementsAre());
}

TEST(Broken, WhatIsTooLongIsElided) {
    const Lines lines = break_lines({"aa bb cc dd ee"}, {5, 2});
    EXPECT_TRUE(lines.elided);
    EXPECT_THAT(lines.lines, ElementsAre("aa bb", "cc \xE2\x80\xA6"));
    EXPECT_EQ(elide_text("abcdef", 4), "abc\xE2\x80\xA6");
    EXPECT_EQ(elide_text("abcd", 4), "abcd");
}

}  // namespace
}  // namespace robochart::diagrams::layout
