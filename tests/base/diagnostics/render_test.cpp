// SPDX-License-Identifier: Apache-2.0
// Tests the output of diagnostics, as exact text and exact JSON.
#include "base/diagnostics/render.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "base/diagnostics/json.hpp"

namespace robochart::diagnostics {
namespace {

const Rule junction_rule{"J1", Severity::error, "junction `{}` has no transition"};
const Rule odd_rule{"W9", Severity::warning, "odd"};

TEST(RenderText, ShowsExcerptCaretNotesAndFix) {
    SourceManager sources;
    const SourceId id = sources.add("m.rct", "stm S {\n\tjunction j\n}\n");
    Diagnostics out;
    Diagnostic& finding = out.report(junction_rule, {id, 18, 19}, {"j"});
    finding.notes.push_back({{id, 4, 5}, "declared in this machine"});
    finding.notes.push_back({{}, "junctions pass control on"});
    finding.fixes.push_back({{id, 18, 19}, "k", "rename it"});
    EXPECT_EQ(render_text(sources, out),
              "error[J1]: junction `j` has no transition\n"
              "  --> m.rct:2:11\n"
              "   |\n"
              " 2 |     junction j\n"
              "   |              ^\n"
              "   = note: junctions pass control on\n"
              "   = help: rename it: `k`\n"
              "   |\n"
              " 2 |     junction k\n"
              "   |              +\n"
              "note: declared in this machine\n"
              "  --> m.rct:1:5\n"
              "   |\n"
              " 1 | stm S {\n"
              "   |     ^\n"
              "\n"
              "1 error, 0 warnings\n");
}

TEST(RenderText, SortsByPlaceAndCounts) {
    SourceManager sources;
    const SourceId id = sources.add("m.rct", "one\ntwo\n");
    Diagnostics out;
    out.report(odd_rule, {id, 4, 7});
    out.report(junction_rule, {id, 0, 3}, {"a"});
    const std::string text = render_text(sources, out);
    EXPECT_LT(text.find("error[J1]"), text.find("warning[W9]"));
    EXPECT_NE(text.find("^~~"), std::string::npos);
    EXPECT_NE(text.find("1 error, 1 warning\n"), std::string::npos);
    EXPECT_EQ(render_text(sources, Diagnostics{}), "");
}

TEST(RenderText, CutsLongLinesAroundTheCaret) {
    SourceManager sources;
    std::string line(10'000'000, 'x');
    line[5'000'000] = '!';
    const SourceId id = sources.add("long.rct", line);
    Diagnostics out;
    out.report(odd_rule, {id, 5'000'000, 5'000'001});
    const std::string text = render_text(sources, out);
    EXPECT_LT(text.size(), 1000U);
    // The caret is below the exclamation mark.
    const std::size_t excerpt = text.find(" 1 | ") + 5;
    const std::size_t mark = text.find("   | ...", 0);
    EXPECT_EQ(mark, std::string::npos);
    const std::size_t caret_line = text.find("   | ", text.find('\n', excerpt)) + 5;
    EXPECT_EQ(text.find('!', excerpt) - excerpt, text.find('^', caret_line) - caret_line);
}

TEST(RenderText, ShowsOtherAlphabetsAndBrokenBytes) {
    SourceManager sources;
    const SourceId id = sources.add("u.rct", "\xC3\xA5\xC3\xB8 ! \xFF\x01");
    Diagnostics out;
    out.report(odd_rule, {id, 5, 6});
    const std::string text = render_text(sources, out);
    EXPECT_NE(text.find(" 1 | \xC3\xA5\xC3\xB8 ! \xEF\xBF\xBD\n   |    ^\n"), std::string::npos) << text;
}

TEST(RenderText, AnUnknownPlaceHasNoExcerpt) {
    Diagnostics out;
    out.report(odd_rule, {});
    EXPECT_EQ(render_text(SourceManager{}, out), "warning[W9]: odd\n\n0 errors, 1 warning\n");
}

TEST(RenderJson, EscapesAndPlaces) {
    SourceManager sources;
    const SourceId id = sources.add("a\"b.rct", "x\ny");
    Diagnostics out;
    out.report(junction_rule, {id, 2, 3}, {"q\"\n"}).notes.push_back({{id, 0, 1}, "here"});
    EXPECT_EQ(
        render_json(sources, out),
        R"({"schema":"robochart-verify/diagnostics/1","errors":1,"warnings":0,"dropped":0,"diagnostics":[)"
        R"({"code":"J1","severity":"error","message":"junction `q\"\n` has no transition","file":"a\"b.rct",)"
        R"("line":2,"column":1,"endLine":2,"endColumn":2,)"
        R"("notes":[{"message":"here","file":"a\"b.rct","line":1,"column":1,"endLine":1,"endColumn":2}],"fixes":[]}]})"
        "\n");
}

TEST(RenderJson, SaysWhyItIsNotAll) {
    EXPECT_EQ(
        render_json({}, {}, "the time limit was reached"),
        R"({"schema":"robochart-verify/diagnostics/1","errors":0,"warnings":0,"dropped":0,"limit":"the time limit was reached","diagnostics":[]})"
        "\n");
}

// RFC 8259, 7: quotes, backslashes and the characters below U+0020 must be escaped. Unicode 15, 3.9: invalid UTF-8 may
// be replaced.
TEST(JsonText, EscapesControlCharactersAndReplacesBrokenBytes) {
    EXPECT_EQ(json_text(Json("\"a\\\t\x01")), R"("\"a\\\t\u0001")");
    EXPECT_EQ(json_text(Json("\xC3\xA9\xC3")), "\"\xC3\xA9\xEF\xBF\xBD\"");
    const std::string surrogate = json_text(Json("\xED\xA0\x80"));  // not a character
    EXPECT_NE(surrogate.find("\xEF\xBF\xBD"), std::string::npos);
    EXPECT_EQ(surrogate.find('\xED'), std::string::npos);
}

TEST(Diagnostics, ShowTheBeginningOfLongArguments) {
    static const Rule rule{"T1", Severity::error, "no `{}`"};
    Diagnostics diagnostics;
    EXPECT_EQ(diagnostics.report(rule, {}, {std::string(1000, 'x')}).message(), "no `" + std::string(1000, 'x') + "`");
    // An e with an acute accent consists of two bytes, which must stay together.
    const std::string letters = std::string(999, 'x') + "\xC3\xA9" + std::string(5'000'000, 'y');
    EXPECT_EQ(diagnostics.report(rule, {}, {letters}).message(), "no `" + std::string(999, 'x') + "...`");
}

TEST(Diagnostics, KeepsTheFirstTwoHundredOfEachSeverityAndCountsTheRest) {
    Diagnostics out;
    for (int i = 0; i < 250; ++i) out.report(odd_rule, {});
    EXPECT_EQ(out.sorted_findings().size(), Diagnostics::max_kept);
    EXPECT_EQ(out.dropped_count(), 50U);
    EXPECT_EQ(out.warning_count(), 250U);
    EXPECT_TRUE(out.ok());
    out.report(junction_rule, {}, {"late"});
    EXPECT_FALSE(out.ok());
    EXPECT_EQ(out.sorted_findings().size(), Diagnostics::max_kept + 1);  // warnings never hide an error
}

TEST(Diagnostics, AreTakenTogetherAndApart) {
    Diagnostics a, b;
    for (std::uint32_t i = 0; i < Diagnostics::max_kept + 3; ++i) a.report(odd_rule, {SourceId{0}, i, i + 1});
    b.report(junction_rule, {SourceId{1}, 0, 1}, {"j"}).notes.push_back({{}, "why"});
    Diagnostics both;
    both.add(a);
    both.add(b);
    EXPECT_EQ(both.warning_count(), Diagnostics::max_kept + 3);
    EXPECT_EQ(both.error_count(), 1U);
    EXPECT_EQ(both.dropped_count(), 3U);
    EXPECT_TRUE(both.has_errors_in(SourceId{1}));
    const Diagnostics second = both.findings_in_texts({SourceId{1}});
    ASSERT_EQ(second.sorted_findings().size(), 1U);
    EXPECT_EQ(second.sorted_findings().front().notes.size(), 1U);
    EXPECT_FALSE(second.ok());
    EXPECT_TRUE(both.findings_in_texts({SourceId{0}}).ok());
}

}  // namespace
}  // namespace robochart::diagnostics
