// SPDX-License-Identifier: Apache-2.0
// Tests that each language's parser inverts the escaping. The expected texts were written by hand from the languages'
// standards.
#include "base/diagnostics/escape.hpp"

#include <gtest/gtest.h>

#include <type_traits>

#include "base/diagnostics/json.hpp"

namespace robochart::diagnostics {
namespace {

TEST(Escape, StringsOfCpp) {
    EXPECT_EQ(cpp_string("near"), R"("near")");
    EXPECT_EQ(cpp_string("a\"b\\c"), R"("a\042b\134c")");
    EXPECT_EQ(cpp_string("line\nend\ttab"), R"("line\012end\011tab")");
    // A digit after an octal escape of three digits is a separate character.
    EXPECT_EQ(cpp_string("\n7"), R"("\0127")");
    EXPECT_EQ(cpp_string("\?\?/"), R"("\077\077/")");
    EXPECT_EQ(cpp_string(std::string("a\0b", 3)), R"("a\000b")");
    EXPECT_EQ(cpp_string("\xc3\xa9\xff"), R"("\303\251\377")");
    EXPECT_EQ(cpp_string(")\"; system(\"x"), R"(")\042; system(\042x")");
}

TEST(Escape, StringsAndCharactersOfCspm) {
    EXPECT_EQ(cspm_string("near"), R"("near")");
    EXPECT_EQ(cspm_string("a\"b\\c'd"), R"("a\"b\\c'd")");
    EXPECT_EQ(cspm_string("a\nb\tc\rd"), R"("a\nb\tc\rd")");
    EXPECT_EQ(cspm_character('\''), R"('\'')");
    EXPECT_EQ(cspm_character('"'), R"('"')");
    EXPECT_EQ(cspm_character('\\'), R"('\\')");
}

TEST(Escape, CommentsStayOnTheirLine) {
    EXPECT_EQ(comment_text("S (m.rct:3)"), "S (m.rct:3)");
    EXPECT_EQ(comment_text("a\n#define B"), "a\\n#define B");
    EXPECT_EQ(comment_text("ends with \\"), "ends with \\x5c");
    EXPECT_EQ(comment_text("blank behind \\ "), "blank behind \\x5c ");
    EXPECT_EQ(comment_text("\?\?/"), "?\\x3f/");
    EXPECT_EQ(comment_text("\r\x0b\x0c"), "\\r\\x0b\\x0c");
    // Line separators and direction marks can make code look like a comment.
    EXPECT_EQ(comment_text("\xe2\x80\xa8\xe2\x80\xae"), "\\u2028\\u202e");
    EXPECT_EQ(comment_text("caf\xc3\xa9"), "caf\xc3\xa9");
}

TEST(Escape, Xml) {
    EXPECT_EQ(xml_text("a<b>&\"'"), "a&lt;b&gt;&amp;&quot;&#39;");
    EXPECT_EQ(xml_text("--><x/>"), "-&#45;&gt;&lt;x/&gt;");
    EXPECT_EQ(xml_text("---"), "-&#45;-");
    EXPECT_EQ(xml_text("\x1b\x01"), "\\x1b\\x01");
}

TEST(Escape, LabelsOfGraphs) {
    EXPECT_EQ(label_text("e.\"a\\b\""), R"(e.\"a\\b\")");
    EXPECT_EQ(label_text("a\nb"), "a\\nb");
}

TEST(Escape, WhatPeopleSeeMovesNoCursor) {
    EXPECT_EQ(escape_for_display("plain"), "plain");
    EXPECT_EQ(escape_for_display("\x1b[31mred\x07"), "\\x1b[31mred\\x07");
    EXPECT_EQ(escape_for_display("a\nb\tc\x7f"), "a\\nb\\tc\\x7f");
    EXPECT_EQ(escape_for_display("\xc2\x9b"), "\\u009b");  // a control sequence in one character
    EXPECT_EQ(escape_for_display("\xff"), "\\xff");
    EXPECT_EQ(escape_for_display("gr\xc3\xbc\xc3\x9f"), "gr\xc3\xbc\xc3\x9f");
    EXPECT_EQ(shown_lines("a\nb\tc\x1b"), "a\nb\tc\\x1b");
}

TEST(Escape, Uris) {
    EXPECT_EQ(uri_of_path("/a b/c#?%.rct"), "file:///a%20b/c%23%3F%25.rct");
    EXPECT_EQ(uri_of_path("a\nb"), "a%0Ab");
}

TEST(Escape, ForeignTextStaysForeignWhereItIsJoined) {
    const ForeignText name = "file \"x\".rct";
    const ForeignText place = "S (" + name + ")";
    EXPECT_EQ(cpp_string(place), R"-("S (file \042x\042.rct)")-");
    constexpr bool lets_itself_out =
        std::is_convertible_v<ForeignText, std::string> || std::is_convertible_v<ForeignText, std::string_view>;
    static_assert(!lets_itself_out);
}

}  // namespace
}  // namespace robochart::diagnostics
