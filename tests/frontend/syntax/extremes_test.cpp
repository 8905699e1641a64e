// SPDX-License-Identifier: Apache-2.0
// Tests extreme texts: nesting a hundred thousand deep, lines of megabytes, very long names and numbers. Each gives a
// finding or a tree in linear time, without a crash and without a report as long as the text.
#include <gtest/gtest.h>

#include "base/diagnostics/json.hpp"
#include "tests/frontend/fixture.hpp"
#include "tests/rounds.hpp"

namespace robochart::frontend {
namespace {

using testing::read;
using testing::resolved;

constexpr std::size_t deep = tests::size_of_input(100'000);
constexpr std::size_t megabytes = tests::size_of_input(4'000'000);

std::string times(std::size_t n, const std::string& text) {
    std::string out;
    out.reserve(n * text.size());
    for (std::size_t i = 0; i < n; ++i) out += text;
    return out;
}

std::string nested(const std::string& open, const std::string& close) {
    return times(deep, open) + times(deep, close);
}

std::string in_guard(const std::string& text) {
    return "stm S {\ntransition t { from a to b condition " + text + " } }";
}
std::string in_entry(const std::string& text) {
    return "stm S {\nstate s { entry " + text + " } }";
}
std::string in_type(const std::string& text) {
    return "interface I {\nvar x:" + text + "\n}";
}
std::string in_claim(const std::string& text) {
    return "assertion A: X terminates with constant c of X set to\n" + text;
}

/// Parses and resolves the text. The report must stay short. With quadratic time the test would not end.
std::unique_ptr<testing::Reading> judged(const std::string& text, bool is_assertions = false) {
    auto reading = resolved(text, is_assertions);
    EXPECT_LT(reading->report().size(), 100'000U) << text.substr(0, 60);
    return reading;
}

TEST(Extremes, NestedExpressionsAreOneMistake) {
    for (const std::string& text : {nested("(", "x)"),
                                    times(deep, "("),
                                    times(deep, "-") + "x",
                                    times(deep, "not ") + "x",
                                    nested("<{", "}>"),
                                    nested("{v:nat @ ", "}"),
                                    nested("let x == ", "@ x"),
                                    times(deep, "let x == 1 @ ") + "x",
                                    nested("if a then b else ", " end"),
                                    nested("if ", " then b else c end"),
                                    times(deep, "forall v:nat @ ") + "x",
                                    times(deep, "lambda v:nat | ") + "x",
                                    nested("f(", ")"),
                                    nested("a[", "]"),
                                    nested("(|", "|)"),
                                    nested("[|", "|]"),
                                    nested("R(|f = ", "|)"),
                                    nested("inverse(", ")"),
                                    times(deep, "[0, ") + "x",
                                    times(deep, "a => (") + "x",
                                    "x" + times(deep, " + (x"),
                                    times(deep, "{1 to ") + "x"}) {
        EXPECT_EQ(judged(in_guard(text))->codes(), "RC-P02@2") << text.substr(0, 40);
        EXPECT_EQ(judged(in_claim(text), true)->codes(), "RC-P02@2") << text.substr(0, 40);
    }
}

TEST(Extremes, ChainsOfOperatorsAreOneMistake) {
    for (const char* link : {" + 1", " /\\ x", " => x", " == x", ".a", " cat x", " * x", " in x", " iff x", " ^ (x)"}) {
        const std::string text = "x" + times(deep, link);
        const std::string codes = judged(in_guard(text))->codes();
        EXPECT_EQ(codes, "RC-P02@2") << link;
        EXPECT_EQ(judged(in_claim(text), true)->codes(), "RC-P02@2") << link;
    }
}

TEST(Extremes, NestedTypesAreOneMistake) {
    for (const std::string& text :
         {nested("Seq(", ")"), nested("Set(", ")"), nested("(", ")"), times(deep, "("), "A" + times(deep, " -> A"),
          "A" + times(deep, " <-> A"), times(deep, "vector(") + "A", times(deep, "(A * ") + "A",
          "vector(A, " + nested("(", "1)"), "A -> " + times(deep, "(A -> ")}) {
        EXPECT_EQ(judged(in_type(text))->codes(), "RC-P02@2") << text.substr(0, 40);
        EXPECT_EQ(judged(in_guard("x is " + text))->codes(), "RC-P02@2") << text.substr(0, 40);
    }
}

TEST(Extremes, NestedStatementsAreOneMistake) {
    for (const std::string& text :
         {nested("if a then ", " end"), nested("if a then skip else ", " end"), nested("(", "skip)"), times(deep, "("),
          "wait(" + nested("(", ")") + ")", "e!" + nested("(", ")"), "a" + nested("[", "]") + " = 1",
          "skip <{" + nested("(", ")") + "}", "op(" + nested("(", ")") + ")", "wait([" + nested("(", ")") + ", 1])"})
        EXPECT_EQ(judged(in_entry(text))->codes(), "RC-P02@2") << text.substr(0, 40);
    EXPECT_EQ(judged("stm S { transition t { from a to b action\n" + nested("if a then ", " end") + " } }")->codes(),
              "RC-P02@2");
}

TEST(Extremes, NestedStatesAreOneMistake) {
    EXPECT_EQ(judged("stm S {\n" + nested("state s {", "}") + " }")->codes(), "RC-P02@2");
    EXPECT_EQ(judged("operation O() {\n" + nested("state s { initial i ", "}") + " }")->codes(), "RC-P02@2");
    EXPECT_EQ(judged("stm S {\n" + times(deep, "state s { entry skip "))->codes(), "RC-P02@2");
}

TEST(Extremes, NestedPackagesAreOneMistake) {
    EXPECT_EQ(judged("package\n" + times(deep, "a::") + "a stm S { initial i }")->codes(), "RC-P02@2");
    EXPECT_EQ(judged("package\n" + times(deep, "a::") + "a assertion A: X terminates", true)->codes(), "RC-P02@2");
}

/// Constructs outside machines cannot be nested, so every brace is another mistake here, up to the limit.
TEST(Extremes, NestedBracesAreAFewMistakes) {
    for (const char* around : {"", "interface I { ", "module M { ", "controller C { ", "robotic platform R { ",
                               "datatype D { ", "enumeration E { ", "function f():nat { "})
        for (const std::string& text : {nested("{", "}"), times(deep, "{"), times(deep, "}"), nested("module M {", "}"),
                                        nested("controller C {", "}")}) {
            const auto reading = judged(around + text);
            EXPECT_FALSE(reading->findings.ok()) << around << text.substr(0, 20);
            EXPECT_LE(reading->findings.error_count(), 101U) << around << text.substr(0, 20);
        }
}

TEST(Extremes, NestedBracesInAssertionsAreAFewMistakes) {
    for (const char* open : {"{", "(", "assertion A: ", "csp ", "rewards r = [", "label l = (", "formula f = (",
                             "with constant ", "const c : Seq("}) {
        const auto reading = judged("package P " + times(deep, open), true);
        EXPECT_LE(reading->findings.error_count(), 101U) << open;
        EXPECT_LE(judged(times(deep, open) + times(deep, ")"), true)->findings.error_count(), 101U) << open;
    }
}

// ---------------------------------------------------------------- long, not deep

TEST(Extremes, ALineOfMegabytesIsReadToTheEnd) {
    for (const std::string& text :
         {"type " + std::string(megabytes, 'x') + " )", std::string(megabytes, '9'), std::string(megabytes, '{'),
          std::string(megabytes, 'a') + ":", std::string(megabytes, '^'), "type A " + std::string(megabytes, ' ') + ")",
          "// " + std::string(megabytes, 'c') + "\n)", "'" + std::string(megabytes, 's'),
          "type " + times(megabytes / 4, "A::") + "A", times(megabytes / 20, "type A ") + ")"}) {
        const auto reading = judged(text);
        EXPECT_FALSE(reading->findings.ok()) << text.substr(0, 20);
        EXPECT_LT(diagnostics::render_json(reading->sources, reading->findings).size(), 1'000'000U);
    }
}

/// The parser searches for the braces of a body by the indentation of their lines.
TEST(Extremes, AHundredThousandBodiesOnOneLine) {
    std::string bodies;
    for (std::size_t i = 0; i < deep; ++i) bodies += "interface I" + std::to_string(i) + " { } ";
    EXPECT_EQ(judged(bodies)->codes(), "");
}

TEST(Extremes, ALongLineOfAssertionsIsReadToTheEnd) {
    for (const std::string& text :
         {"assertion A: " + std::string(megabytes, 'x') + " is", "csp P csp-begin " + std::string(megabytes, '-'),
          "csp P csp-begin " + std::string(megabytes, 'x') + " csp-end )",
          "assertion A: " + times(megabytes / 4, "A::") + "A terminates )"})
        EXPECT_FALSE(judged(text, true)->findings.ok()) << text.substr(0, 20);
}

TEST(Extremes, ANumberOfAMillionDigitsIsTooLarge) {
    const std::string digits(1'000'000, '7');
    EXPECT_EQ(judged("interface I { const c:nat = " + digits + " }")->codes(), "RC-P06@1");
    EXPECT_EQ(judged("assertion A: X terminates with constant c of X set to\n" + digits, true)->codes(),
              "RC-Q01@1 RC-Q01@1 RC-P06@2");
    EXPECT_EQ(judged("interface I { const c:nat = " + std::string(1'000'000, '0') + "7 }")->codes(), "");
    // Parsing continues: the text is still checked.
    EXPECT_EQ(judged("interface I { const c:boolean = " + digits + " }")->codes(), "RC-P06@1 RC-T01@1");
    for (const std::string& text :
         {"interface I { const c:real = " + digits + "." + digits + " }",
          "interface I { var v:vector(nat, " + digits + ") const c:nat = v[" + digits + "] + true }",
          "interface I { const t:nat * nat const c:nat = t[" + digits + "] }",
          "stm S { clock C initial i state s { entry wait(" + digits +
              ") <{1} } transition t { from i to s } transition "
              "u { from s to s condition since(C) > " +
              digits + " /\\ x } }"})
        EXPECT_FALSE(judged(text)->findings.ok()) << text.substr(0, 40);
}

TEST(Extremes, AHundredThousandNamesInOneDeclaration) {
    std::string variables = "interface I { var v0:nat";
    std::string literals = "enumeration E {";
    std::string fields = "datatype D {";
    std::string parameters = "function f(p0:nat";
    std::string let = "interface I { const c:nat = let x0 == 0";
    std::string set = "interface I { const c:Set(nat) = {0";
    for (std::size_t i = 1; i < deep; ++i) {
        const std::string n = std::to_string(i);
        variables += ", v" + n + ":nat";
        literals += " L" + n;
        fields += " f" + n + ":nat";
        parameters += ", p" + n + ":nat";
        let += ", x" + n + " == x" + std::to_string(i - 1);
        set += ", " + n;
    }
    EXPECT_EQ(judged(variables + " }")->codes(), "");
    EXPECT_EQ(judged(literals + " }")->codes(), "");
    EXPECT_EQ(judged(fields + " }")->codes(), "");
    EXPECT_EQ(judged(parameters + "):nat { }")->codes(), "");
    EXPECT_EQ(judged(set + "} }")->codes(), "");
    EXPECT_EQ(judged(variables + ", w:Nat }")->codes(), "RC-N01@1");
    EXPECT_FALSE(judged(let + " @ y }")->findings.ok());
    EXPECT_EQ(judged("interface I { var v:nat" + times(deep, ", v:nat") + " }")->codes(), "RC-N03@1");
    EXPECT_EQ(judged("interface I { var v:A" + times(deep, " * A") + " }")->findings.error_count(), 1U);
    EXPECT_FALSE(judged("stm S { initial i state s { entry skip" + times(deep, "; skip") + " ; } }")->findings.ok());
}

TEST(Extremes, ManyUnknownImportsStayCheap) {
    std::string text;
    for (std::size_t i = 0; i < deep; ++i) text += "import p" + std::to_string(i) + "::q\n";
    const auto reading = judged(text + "type A");
    EXPECT_EQ(reading->findings.warning_count(), deep);
}

TEST(Extremes, ManyLinesOfGarbageCostNoMoreThanOne) {
    EXPECT_FALSE(judged("stm S {\n" + times(tests::size_of_input(500'000), "entyx\n"))->findings.ok());
}

}  // namespace
}  // namespace robochart::frontend
