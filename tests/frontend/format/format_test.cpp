// SPDX-License-Identifier: Apache-2.0
// Tests the standard layout (docs/format.md).
#include <gtest/gtest.h>

#include <sstream>

#include "formatting.hpp"
#include "frontend/format/format.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/source_folder.hpp"

namespace robochart::frontend {
namespace {

namespace fs = std::filesystem;
using testing::formatted;

void expect_format(const std::string& text, const std::string& expected, bool is_assertions = false) {
    EXPECT_EQ(formatted(text, is_assertions), expected);
    EXPECT_EQ(formatted(expected, is_assertions), expected) << "not stable";
}

TEST(Format, TheExampleOfTheDocumentationIsInTheStyle) {
    const std::string page = testing::read_contents(tests::source_folder() / "docs/format.md");
    const std::string fence = "```robochart\n";
    const std::size_t begin = page.find(fence) + fence.size();
    const std::string example = page.substr(begin, page.find("```", begin) - begin);
    EXPECT_GT(example.size(), 300U);
    EXPECT_EQ(formatted(example), example);
}

/// Returns the body of a machine `stm S { … }`, without its indentation.
std::string in_machine(const std::string& body) {
    const std::string text = formatted("stm S {" + body + "}");
    std::istringstream lines(text.substr(0, text.size() - 2));
    std::string out;
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "stm S {");
    while (std::getline(lines, line)) out += line.substr(std::min<std::size_t>(1, line.size())) + "\n";
    return out;
}

TEST(Format, ShortBodiesStandOnOneLine) {
    EXPECT_EQ(in_machine("state a{ }state b{entry x=1 }initial i transition t{from i to a\n trigger e ? x\n}"),
              "state a {}\nstate b { entry x = 1 }\ninitial i\ntransition t { from i to a trigger e?x }\n");
    EXPECT_EQ(formatted("enumeration E{A\nB(nat,int)}"), "enumeration E { A B(nat, int) }\n");
}

TEST(Format, StatesWithSeveralPartsHaveOneALine) {
    EXPECT_EQ(in_machine("state a{initial i state b{} }"), "state a {\n\tinitial i\n\tstate b {}\n}\n");
}

TEST(Format, LongTransitionsHaveAClauseALine) {
    EXPECT_EQ(in_machine("transition t { from Somewhere to SomewhereElse trigger e?value #T #U <{3} condition "
                         "value > 3 action x = 1; y = 2 }"),
              "transition t {\n\tfrom Somewhere to SomewhereElse\n\ttrigger e?value #T #U <{ 3 }\n"
              "\tcondition value > 3\n\taction x = 1; y = 2\n}\n");
}

TEST(Format, ColumnsDecide) {
    // A body that ends in column 80 (a tab counts as 4 columns) stays on one line. A body that ends in column 81 does
    // not.
    const std::string fits = "\ttransition t { from i to a condition " + std::string(37, 'x') + " }\n";
    expect_format("stm S {\n" + fits + "}\n", "stm S {\n" + fits + "}\n");
    expect_format("stm S { transition t { from i to a condition " + std::string(38, 'x') + " } }",
                  "stm S {\n\ttransition t {\n\t\tfrom i to a\n\t\tcondition " + std::string(38, 'x') + "\n\t}\n}\n");
    // A line that ends in column 120 stays. A line that ends in column 121 is broken. An umlaut in a string takes one
    // column.
    const std::string line = "var v : nat = \"ä\" + " + std::string(92, 'y');
    EXPECT_EQ(in_machine(line + " + 1"), line + " + 1\n");
    EXPECT_EQ(in_machine(line + " + 12"), "var v : nat = \"ä\"\n\t+ " + std::string(92, 'y') + "\n\t+ 12\n");
}

TEST(Format, LongExpressionsBreakWhereTheyBindWeakest) {
    const std::string a(30, 'a');
    EXPECT_EQ(in_machine("var v : boolean = " + a + "+1 == " + a + " /\\ " + a + " > 2*" + a + "/\\ b"),
              "var v : boolean = " + a + " + 1 == " + a + "\n\t/\\ " + a + " > 2 * " + a + "\n\t/\\ b\n");
    EXPECT_EQ(in_machine("var v : nat = f(" + a + "," + a + "," + a + "," + a + ")"),
              "var v : nat = f(\n\t" + a + ",\n\t" + a + ",\n\t" + a + ",\n\t" + a + "\n)\n");
}

TEST(Format, LongActionsHaveAStatementALine) {
    const std::string a(50, 'a');
    EXPECT_EQ(in_machine("state s { entry " + a + "(1); " + a + "(2); x = 1 }"),
              "state s {\n\tentry\n\t\t" + a + "(1);\n\t\t" + a + "(2);\n\t\tx = 1\n}\n");
    EXPECT_EQ(in_machine("state s { entry if b then " + a + "(1) else " + a + "(2) end }"),
              "state s {\n\tentry\n\t\tif b then\n\t\t\t" + a + "(1)\n\t\telse\n\t\t\t" + a + "(2)\n\t\tend\n}\n");
}

TEST(Format, EmptyLinesAreKeptOnceAndSetComponentsOff) {
    expect_format("\n\npackage p\n\n\n\nimport q::*\ninterface I {\n\n event e\n\n\n event f\n\n}\ntype T\ntype U\n",
                  "package p\n\nimport q::*\n\ninterface I {\n\tevent e\n\n\tevent f\n}\n\ntype T\ntype U\n");
}

TEST(Format, SpellingIsKept) {
    EXPECT_EQ(in_machine("var ^end : Seq(nat) = ((<007,1.50>))cat<>  var s : Seq(nat) = a ^ b ^c\n var t : nat = - -1"),
              "var ^end : Seq(nat) = ((<007, 1.50>)) cat <>\nvar s : Seq(nat) = a ^ b ^c\nvar t : nat = --1\n");
    expect_format("record R { } datatype D { }", "record R {}\ndatatype D {}\n");
}

TEST(Format, WordsThatWouldMergeStayApart) {
    EXPECT_EQ(
        in_machine("var a : boolean = Set (x) var b : Seq(Set(nat)) = < {1} > var c : Seq(Set(nat)) = <{1},{2 to 3}>"),
        "var a : boolean = Set (x)\nvar b : Seq(Set(nat)) = < {1}>\nvar c : Seq(Set(nat)) = <{1}, {2 to 3}>\n");
}

TEST(Format, CommentsStayAtTheirPlaces) {
    expect_format(
        "// head\nstm S{// opens\n//first\n\n\n/* of\n   two */ initial i //behind\n"
        "transition t{from i/* a */to/* b */x//c\n// own\ncondition f(/* d */1)}\n// last\n}//closes\n// end",
        "// head\nstm S { // opens\n\t//first\n\n\t/* of\n\t   two */ initial i //behind\n"
        "\ttransition t {\n\t\tfrom i /* a */ to /* b */ x //c\n\t\t// own\n\t\tcondition f(/* d */ 1)\n\t}\n\t// "
        "last\n"
        "} //closes\n// end\n");
    expect_format("// alone", "// alone\n");
}

TEST(Format, BlockCommentsMoveAsAWhole) {
    expect_format("stm S {\n      /* a\n         b\n      c */\n      initial i\n}\n",
                  "stm S {\n\t/* a\n\t   b\n\tc */\n\tinitial i\n}\n");
    expect_format("stm S {\n      /* a\n  b */\n      initial i\n}\n", "stm S {\n\t/* a\n  b */\n\tinitial i\n}\n");
}

TEST(Format, AssertionFiles) {
    expect_format("assertion  A:X is deadlock-free .timed assertion B : X refines Y in the tick-tock model",
                  "assertion A : X is deadlock-free.\ntimed assertion B : X refines Y in the tick-tock model\n", true);
}

TEST(Format, VerbatimPartsStayToTheByte) {
    expect_format(
        "csp   P  csp-begin\r\n  P =  a ->  P  \n\n\n csp-end\n  label   \"l\" =  x \n  >  3;\nassertion A:X "
        "terminates",
        "csp P csp-begin\r\n  P =  a ->  P  \n\n\n csp-end\nlabel   \"l\" =  x \n  >  3;\nassertion A : X terminates\n",
        true);
}

TEST(Format, LineEndsAndByteOrderMarks) {
    expect_format("type A\r\n\r\n/* x\r\n y */\r\ntype B", "type A\r\n\r\n/* x\r\n y */\r\ntype B\r\n");
    expect_format("type A\r\ntype B\n", "type A\ntype B\n");
    expect_format("type A\rtype B\r", "type A\ntype B\n");
    // The byte order mark belongs to the file (Files.ReplacedTextsKeepTheirByteOrderMark), so the text has none.
    expect_format("\xEF\xBB\xBFtype A", "type A\n");
    expect_format("", "");
    expect_format(" \n\n", "");
}

TEST(Format, TextsWithSyntaxErrorsAreLeftAlone) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add("t.rct", "stm S { state }");
    EXPECT_FALSE(format(sources, source, false, findings).has_value());
    EXPECT_EQ(findings.error_count(), 1U);
}

TEST(Format, SameWordsSeesEveryDifference) {
    const std::string text = "type A // c\ntype B";
    EXPECT_TRUE(same_words(text, "type A   // c  \n\n type\nB", false));
    for (const char* other :
         {"type A // c", "type A // d\ntype B", "type A type B", "type A type ^B // c", "// c\ntype A type BB"})
        EXPECT_FALSE(same_words(text, other, false)) << other;
    EXPECT_TRUE(same_words("/* a\n  b */", "/* a\n\t b */", false));
    EXPECT_FALSE(same_words("/* a b */", "/* a\n b */", false));
    EXPECT_FALSE(same_words("// a  b", "// a b", false));
}

}  // namespace
}  // namespace robochart::frontend
