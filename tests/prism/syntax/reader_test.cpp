// SPDX-License-Identifier: Apache-2.0
// Tests the parser: precedence, recovery, rejected and malicious texts.
#include "prism/syntax/reader.hpp"

#include <gtest/gtest.h>

#include <string>

#include "prism/syntax/printer.hpp"
#include "tests/prism/support.hpp"

namespace robochart::prism {
namespace {

using testing::Read;

/// Returns the tree with every operation in parentheses.
std::string shape(const ExprPtr& expr) {
    if (!expr) return "?";
    if (expr->parts.empty()) return expr->text;
    std::string text = "(" + std::to_string(static_cast<int>(expr->op));
    for (const ExprPtr& part : expr->parts) text += " " + shape(part);
    return text + ")";
}

ExprPtr expression(const std::string& text) {
    Read read;
    const ExprPtr result = read_expression(read.sources, read.add(text), read.diagnostics);
    EXPECT_TRUE(read.diagnostics.ok()) << read.report();
    return result;
}

std::string findings(const std::string& model) {
    Read read;
    (void)read_model(read.sources, read.add(model), read.diagnostics);
    return read.findings();
}

std::string property_findings(const std::string& text) {
    Read read;
    (void)read_properties(read.sources, read.add(text), read.diagnostics);
    return read.findings();
}

/// By the grammar, unary minus binds tighter than power. Power and implication are right-associative, other operators
/// left-associative. Negation binds tighter than & and looser than =.
TEST(PrismReader, BindsAsTheGrammarSays) {
    const std::pair<const char*, const char*> same[] = {
        {"!x=1", "!(x=1)"},
        {"-2^2", "(-2)^2"},
        {"a=b=c", "(a=b)=c"},
        {"2^3^2", "2^(3^2)"},
        {"a=>b=>c", "a=>(b=>c)"},
        {"a|b&c", "a|(b&c)"},
        {"a<=>b|c", "a<=>(b|c)"},
        {"a=>b<=>c", "a=>(b<=>c)"},
        {"a-b-c", "(a-b)-c"},
        {"a/b*c", "(a/b)*c"},
        {"a?b:c?d:e", "a?b:(c?d:e)"},
        {"a<b=c<d", "(a<b)=(c<d)"},
        {"x<-1", "x<(-1)"},
        {"1+2<3&!a", "((1+2)<3)&(!a)"},
        {"func(max,1,2)", "max(1,2)"},
        {"P=? [ F a U b ]", "P=? [ (F a) U b ]"},
        {"P=? [ !a & b U c | d ]", "P=? [ ((!a) & b) U (c | d) ]"},
        {"P>0.5 [ X a ]|b", "(P>0.5 [ X a ])|b"},
        {"P=? [ F<=2 x=1 ]", "P=? [ F<=2 (x=1) ]"},
        {"P=? [ G F a ]", "P=? [ G (F a) ]"},
    };
    for (const auto& [text, meant] : same)
        EXPECT_TRUE(same_expr(expression(text), expression(meant))) << text << ": " << shape(expression(text));
    EXPECT_FALSE(same_expr(expression("a-b-c"), expression("a-(b-c)")));
    EXPECT_FALSE(same_expr(expression("-2^2"), expression("-(2^2)")));
}

TEST(PrismReader, NumbersAreAsPrismReadsThem) {
    EXPECT_EQ(expression("0")->op, Op::integer);
    EXPECT_EQ(expression("10")->op, Op::integer);
    for (const char* text : {"01", ".5", "1.5", "1e-3", "1E+3"}) EXPECT_EQ(expression(text)->op, Op::real) << text;
}

TEST(PrismReader, RangesAreNoDecimalNumbers) {
    Read read;
    const ModelFile file = read_model(read.sources, read.add("module M x:[0..3] init 1; endmodule"), read.diagnostics);
    ASSERT_TRUE(read.diagnostics.ok()) << read.report();
    EXPECT_EQ(file.modules.at(0).variables.at(0).high->text, "3");
}

TEST(PrismReader, GoesOnBehindAMistake) {
    EXPECT_EQ(findings("dtmc\n"
                       "const int = 3;\n"
                       "module M\n"
                       "  x : [0..1;\n"
                       "  [] x=0 - > true;\n"
                       "  [] x=1 -> true;\n"
                       "endmodule\n"
                       "label b = x=1;\n"),
              "PRISM-P01:2 PRISM-P01:4 PRISM-P01:5 PRISM-P01:8");
}

TEST(PrismReader, SaysWhichKindsAreNotRead) {
    EXPECT_EQ(findings("ctmc"), "PRISM-P06:1");
    EXPECT_EQ(findings("pta"), "PRISM-P06:1");
    EXPECT_EQ(findings("pomdp\nobservables x endobservables"), "PRISM-P06:1 PRISM-P06:2");
    EXPECT_EQ(findings("mdp module M x : clock; endmodule"), "PRISM-P06:1");
    EXPECT_EQ(findings("mdp module M x : bool; [] x -> [0.1,0.2]:(x'=false) + 0.8:true; endmodule"), "PRISM-P06:1");
    EXPECT_EQ(findings("mdp\nformula f = #CALLFUNC!f$x#;"), "PRISM-P06:2 PRISM-P01:2");
    EXPECT_EQ(property_findings("multi(Pmax=? [ F a ], P>=0.5 [ F b ]);"), "PRISM-P06:1");
    EXPECT_EQ(property_findings("<<1>> Pmax=? [ F a ];"), "PRISM-P06:1");
    EXPECT_EQ(property_findings("P=? [ F^{rew{\"r\"}<=3} a ];"), "PRISM-P06:1");
    EXPECT_EQ(property_findings("T=? [ F a ];"), "PRISM-P06:1");
    EXPECT_EQ(property_findings("Pmaxmin=? [ F a ];"), "PRISM-P06:1");
}

TEST(PrismReader, WordsOfTheLanguageNameNothing) {
    EXPECT_EQ(findings("const int F = 1;"), "PRISM-P01:1");
    EXPECT_EQ(findings("dtmc mdp"), "PRISM-P07:1");
}

TEST(PrismReader, SemicolonsBetweenPropertiesMayBeLeftOut) {
    Read read;
    const PropertyFile file =
        read_properties(read.sources, read.add("\"a\": P=? [ F x=1 ]\nP>=1 [ F \"l\" ]\n\n// end\n"), read.diagnostics);
    EXPECT_TRUE(read.diagnostics.ok()) << read.report();
    EXPECT_EQ(file.properties.size(), 2U);
    EXPECT_EQ(property_findings("P=? [ F a ] P=? [ F b ]"), "PRISM-P01:1");
}

TEST(PrismReader, OutsideOfBracketsRBeginsTheNextProperty) {
    Read read;
    const PropertyFile file = read_properties(
        read.sources, read.add("P=? [ F x=1 ]\nR=? [ F x=1 ]\n(x=1)\nR{\"r\"}=? [ C ]\nP=? [ x=1\nR x=2 ]"),
        read.diagnostics);
    EXPECT_EQ(read.findings(), "");
    ASSERT_EQ(file.properties.size(), 5U);
    EXPECT_EQ(file.properties[1].expression->op, Op::reward);
    EXPECT_EQ(file.properties[4].expression->parts[0]->op, Op::release);
}

TEST(PrismReader, PathOperatorsMayBeOperandsWhereTheirOwnOperandEndsClearly) {
    const auto printed = [](const std::string& property) {
        Read read;
        const PropertyFile file = read_properties(read.sources, read.add(property), read.diagnostics);
        return read.diagnostics.ok() ? print(file.properties[0].expression) : read.findings();
    };
    EXPECT_EQ(printed("P=? [ (a & F b) ]"), "P=? [ a & (F b) ]");
    EXPECT_EQ(printed("P=? [ F (a => F b) ]"), "P=? [ F a => (F b) ]");
    EXPECT_EQ(printed("P=? [ G !F a ]"), "P=? [ G !(F a) ]");
    EXPECT_EQ(printed("P=? [ a | b & X !c ]"), "P=? [ a | b & (X !c) ]");
    EXPECT_EQ(printed("P=? [ F a & b ]"), "P=? [ F a & b ]");  // as in PRISM: F (a & b)
    for (const char* unclear : {"P=? [ F a & F b ]", "P=? [ a & F b & c ]", "P=? [ a => F b | c ]", "P=? [ !F a & b ]",
                                "P=? [ a & F b U c ]", "P=? [ a U b & F c ]", "P=? [ G a => F b ]"})
        EXPECT_EQ(printed(unclear), "PRISM-P09:1") << unclear;
}

TEST(PrismReader, DeepTextIsRefusedAndNothingBreaks) {
    const std::string many(100'000, '(');
    EXPECT_EQ(findings("formula f = " + many), "PRISM-P05:1");
    EXPECT_EQ(findings("formula f = " + std::string(100'000, '!') + "a;"), "PRISM-P05:1");
    EXPECT_EQ(findings("formula f = " + std::string(100'000, '-') + "a;"), "PRISM-P05:1");
    std::string chain = "formula f = a";
    for (int i = 0; i < 100'000; ++i) chain += "&a";
    EXPECT_EQ(findings(chain + ";"), "PRISM-P05:1");
    std::string conditionals = "formula f = ";
    for (int i = 0; i < 100'000; ++i) conditionals += "a?b:";
    EXPECT_EQ(findings(conditionals), "PRISM-P05:1");
    EXPECT_EQ(findings("system " + many), "PRISM-P05:1");
}

TEST(PrismReader, TakesAnyBytes) {
    std::string bytes;
    for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
    EXPECT_NE(findings(bytes), "");
    EXPECT_NE(findings("formula f = \"\n\";"), "");
    EXPECT_EQ(findings("const double x = 1e9999;"), "PRISM-P04:1");
    EXPECT_NE(findings("module"), "");
    EXPECT_NE(findings("module M"), "");
    EXPECT_NE(findings("rewards \"a\" [x"), "");
}

}  // namespace
}  // namespace robochart::prism
