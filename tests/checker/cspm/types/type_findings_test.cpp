// SPDX-License-Identifier: Apache-2.0
// Tests ill-typed scripts, each with its finding and the line. Most of them are next to a similar well-typed script.
// Tests also large malicious inputs.
#include <gtest/gtest.h>

#include <string>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"
#include "tests/temporary_folder.hpp"

namespace robochart::cspm::test {
namespace {

struct Wrong {
    const char* at;  ///< "CODE@LINE" of the only finding, "" for none
    const char* script;
};

void PrintTo(const Wrong& wrong, std::ostream* out) {
    *out << ::testing::PrintToString(wrong.script);
}

std::string findings(Reading& reading) {
    check_types(reading.script, reading.diagnostics);
    std::string result;
    for (const diagnostics::Diagnostic& finding : reading.diagnostics.sorted_findings()) {
        if (!result.empty()) result += ' ';
        result += std::string(finding.rule->code) + "@" +
                  std::to_string(reading.sources.position(finding.span.source, finding.span.begin).line);
    }
    return result;
}

class Finding : public ::testing::TestWithParam<Wrong> {};

TEST_P(Finding, IsTheOnlyOne) {
    Reading reading(std::string(GetParam().script) + "\n");
    ASSERT_TRUE(reading.ok()) << GetParam().script << "\n" << reading.report();
    EXPECT_EQ(findings(reading), GetParam().at) << GetParam().script << "\n" << reading.report();
}

// All clauses of a function must be in one file: clauses in an included file define the name again.
TEST(Findings, ClausesDoNotJoinAcrossAnInclude) {
    const tests::TemporaryFolder folder;
    folder.write("clauses.csp", "f(x) = 1\n");
    folder.write("other.csp", "g(x) = 2\n");
    const auto found = [](const std::string& path) {
        diagnostics::SourceManager sources;
        diagnostics::Diagnostics diagnostics;
        const Script script = read_file(sources, path, diagnostics);
        if (diagnostics.ok()) check_types(script, diagnostics);
        return diagnostics.ok() ? "" : std::string(diagnostics.sorted_findings().front().rule->code);
    };
    EXPECT_EQ(found(folder.write("before.csp", "f(0) = 5\ninclude \"clauses.csp\"\n")), "CSPM-T02");
    EXPECT_EQ(found(folder.write("after.csp", "include \"clauses.csp\"\nf(0) = 5\n")), "CSPM-T02");
    EXPECT_EQ(found(folder.write("alone.csp", "include \"clauses.csp\"\nv = f(0)\n")), "");
    EXPECT_EQ(found(folder.write("beside.csp", "f(0) = 5\nf(x) = 1\ninclude \"other.csp\"\nv = f(g(1))\n")), "");
}

INSTANTIATE_TEST_SUITE_P(
    Forms, Finding,
    ::testing::Values(Wrong{"CSPM-T22@1", "f(xs ^ ys) = xs"}, Wrong{"CSPM-T22@1", "f(<x> ^ (xs ^ <_> ^ ys)) = xs"},
                      Wrong{"CSPM-T22@1", "v = let f(xs ^ ys) = 1 within f(<>)"},
                      Wrong{"CSPM-T22@1", "(xs ^ ys) = <1>"}, Wrong{"", "f(<x> ^ xs ^ \"ab\" ^ <_>) = xs"},
                      Wrong{"CSPM-T22@1", "f({x, y}) = x"}, Wrong{"", "f({x}) = x"},
                      Wrong{"CSPM-T22@2", "channel c : {0..1}\nP = c?(x @@ y) -> STOP"},
                      Wrong{"CSPM-T22@2", "channel c : {0..1}.{0..1}\nP = c?x.(y @@ z) -> STOP"},
                      Wrong{"", "channel c : {(0, 1)}\nP = c?(x, y @@ z) -> STOP"},
                      Wrong{"CSPM-T23@4", "channel tock\nchannel c : {0..1}\nTimed(\\_ @ 1) {\n P = c$x -> STOP\n}"},
                      Wrong{"CSPM-T23@3", "channel tock, a, b\nTimed(\\_ @ 1) {\n P = STOP [a <-> b] STOP\n}"},
                      Wrong{"CSPM-T23@3", "channel tock, a, b\nTimed(\\_ @ 1) {\n P = [a <-> b] i : <> @ STOP\n}"},
                      Wrong{"", "channel tock, a, b\nTimed(\\_ @ 1) {\n P = STOP\n}\nQ = P [a <-> b] P"},
                      // A variable cannot split an event, in any position.
                      Wrong{"CSPM-T08@2", "channel c : {0..1}\nv = let d.x = head(seq({| c |})) within x"},
                      Wrong{"CSPM-T08@2", "channel c : {0..1}\nd.x = c.0"},
                      Wrong{"", "channel c : {0..1}\nv = let c.x = c.0 within x"}, Wrong{"", "a.b = 1.2"}));

// A name with :: is one name. A variable, or another module, with the name of its first part does not hide it.
INSTANTIATE_TEST_SUITE_P(
    QualifiedNames, Finding,
    ::testing::Values(
        Wrong{"", "module M\nexports\n k = 1\nendmodule\nf(M) = M + M::k\nv = let M = 5 within M + M::k"},
        Wrong{"", "module M\nexports\n channel e\nendmodule\nchannel c : {0..1}\nP = c?M -> M::e -> STOP"},
        Wrong{"", "module M\nexports\n datatype D = A\nendmodule\nf(M, M::A) = M\ng :: (M::D) -> Int\ng(M) = 1"},
        Wrong{"",
              "module M\nexports\n k = 1\nendmodule\nmodule N\nexports\n module M\n exports\n  j = 1\n endmodule\n "
              "v = M::j + M::k\nendmodule"},
        Wrong{"CSPM-T01@12",
              "module M\nexports\n k = 1\nendmodule\nmodule N\n module M\n  k = 2\n exports\n  v = 1\n "
              "endmodule\nexports\n w = M::k\nendmodule"},
        Wrong{"CSPM-T01@5", "module M(n)\nexports\n k = n\nendmodule\nf(M) = M::k"}));

// The body combines variables of a type annotation with dots.
INSTANTIATE_TEST_SUITE_P(AnnotatedDots, Finding,
                         ::testing::Values(Wrong{"", "f :: (b => a, c => b, c) -> a\nf(x, y, z) = x.y.z"},
                                           Wrong{"", "f :: (b => a, b) -> <a>\nf(x, y) = <x.y>"},
                                           Wrong{"CSPM-T08@2", "f :: (b => a, c) -> a\nf(x, z) = x.z"},
                                           Wrong{"CSPM-T08@2", "f :: (b => a, c => b, c) -> b\nf(x, y, z) = x.y.z"}));

INSTANTIATE_TEST_SUITE_P(
    Names, Finding,
    ::testing::Values(
        Wrong{"CSPM-T01@1", "v = x"}, Wrong{"CSPM-T01@1", "P = normal(STOP)"}, Wrong{"CSPM-T01@1", "P = WAIT(1)"},
        Wrong{"CSPM-T01@5", "module M\n x = 1\nexports\nendmodule\nv = M::x"},
        Wrong{"CSPM-T01@5", "module M(n)\nexports\n x = n\nendmodule\nv = M::x"},
        Wrong{"CSPM-T01@1", "instance I = M(1)\nmodule M(n)\nexports\nendmodule"},
        Wrong{"CSPM-T01@2", "One(_) = 1\nTimed(One) {\n P = STOP\n}"}, Wrong{"", "f(n) = g(n)\ng(n) = f(n)"},
        Wrong{"CSPM-T02@3", "f(x) = 1\ng = 2\nf(y) = 3"}, Wrong{"CSPM-T02@1", "f(x, x) = 1"},
        Wrong{"CSPM-T02@2", "channel c : Int.Int\nP = c?x?x -> STOP"},
        Wrong{"CSPM-T02@1", "v = { x | x <- {1}, x <- {2} }"},
        Wrong{"CSPM-T02@2", "transparent normal\ntransparent normal"}, Wrong{"", "f(x) = let x = 1 within x"},
        Wrong{"CSPM-T03@1", "transparent prioritise"}, Wrong{"CSPM-T03@1", "external normal"},
        Wrong{"", "external chase, prioritise"}, Wrong{"CSPM-T04@4", "module M\nexports\nendmodule\nv = M"},
        Wrong{"CSPM-T04@3", "module M(n)\nexports\n instance I = n\nendmodule"},
        Wrong{"CSPM-T04@2", "A = 1\nsubtype S = A"},
        Wrong{"CSPM-T05@5", "module M\nexports\n x = 1\nendmodule\nf(M::x) = 1"},
        Wrong{"", "module M\nexports\n datatype D = A | B\nendmodule\nf(M::A) = 1\nf(_) = 2"},
        Wrong{"CSPM-T06@2", "channel c : Int.Int\nP = c?x$y -> STOP"},
        Wrong{"", "channel c : Int.Int\nP = c$y?x -> STOP"}, Wrong{"CSPM-T07@1", "f :: Eq b => (a) -> a\nf(x) = x"},
        Wrong{"CSPM-T07@1", "f :: (Int =>* Event) -> Int\nf(x) = 1"}));

INSTANTIATE_TEST_SUITE_P(
    Types, Finding,
    ::testing::Values(
        Wrong{"CSPM-T08@1", "v = 1 + true"}, Wrong{"CSPM-T08@1", "P = STOP [] 1"},
        Wrong{"CSPM-T08@2", "f(x) = x + 1\nv = f(true)"}, Wrong{"CSPM-T08@2", "f(0) = 1\nf(true) = 2"},
        Wrong{"CSPM-T08@1", "v = { x | x <- <1> }"}, Wrong{"CSPM-T08@1", "v = < x | x <- {1} >"},
        Wrong{"CSPM-T08@1", "channel c : 1"}, Wrong{"CSPM-T08@2", "channel c\nP = c -> 1"},
        Wrong{"CSPM-T08@1", "c = 1\nchannel c : {0..2}"}, Wrong{"CSPM-T08@2", "channel c : {0..2}\nc = 1"},
        Wrong{"CSPM-T08@2", "channel c : Int\nP = c!true -> STOP"},
        Wrong{"CSPM-T08@2", "channel c : Int\nP = c?x:1 -> STOP"}, Wrong{"CSPM-T08@1", "P = if 1 then STOP else SKIP"},
        Wrong{"CSPM-T08@2", "f :: (a) -> b\nf(x) = x"},
        Wrong{"CSPM-T08@2", "channel c, d : Int\nR = [ c <-> d ] i : {1} @ STOP"},
        Wrong{"CSPM-T08@1", "assert 1 [T= SKIP"}, Wrong{"CSPM-T08@1", "assert STOP :[has trace]: <1>"},
        Wrong{"CSPM-T08@2", "datatype D = A\nassert STOP [T= SKIP :[tau priority]: {A}"},
        Wrong{"CSPM-T08@2", "channel tock\nTimed(1) {\n P = STOP\n}"},
        Wrong{"CSPM-T09@2", "f(x)(y) = x + y\nv = f(1, 2)"}, Wrong{"", "f(x)(y) = x + y\nv = f(1)(2)"},
        Wrong{"CSPM-T09@1", "v = union({1})"}, Wrong{"CSPM-T10@2", "channel c : Int\nP = c(1) -> STOP"},
        Wrong{"CSPM-T10@2", "x = 1\nv = x(2)"}, Wrong{"CSPM-T11@1", "v = STOP == SKIP"},
        Wrong{"CSPM-T11@1", "v = true < false"}, Wrong{"CSPM-T11@1", "v = card({STOP})"},
        Wrong{"", "v = union({STOP}, {SKIP})"}, Wrong{"CSPM-T11@1", "v = { \\ x @ x }"},
        Wrong{"CSPM-T11@2", "datatype D = A.Proc\nchannel c : D"}, Wrong{"", "datatype D = A.Proc\nv = A.STOP"},
        Wrong{"CSPM-T11@1", "channel c : Proc"}, Wrong{"CSPM-T11@2", "f :: (a) -> Bool\nf(x) = x == x"},
        Wrong{"CSPM-T11@2", "datatype D = A | B\nv = A < B"}, Wrong{"CSPM-T12@1", "v = <v>"},
        Wrong{"CSPM-T12@1", "f(x) = x(x)"}, Wrong{"CSPM-T12@1", "f(x) = f"}, Wrong{"CSPM-T12@1", "v = head(v)"}));

INSTANTIATE_TEST_SUITE_P(Dots, Finding,
                         ::testing::Values(Wrong{"CSPM-T13@2", "channel c : Int\nP = c.1.2 -> STOP"},
                                           Wrong{"CSPM-T13@2", "channel c\nP = c?x -> STOP"},
                                           Wrong{"CSPM-T14@2", "channel c : Int.Bool\nP = c.1 -> STOP"},
                                           Wrong{"CSPM-T14@2", "channel c : Int\nP = STOP \\ {c}"},
                                           Wrong{"", "channel c : Int\nP = STOP \\ {| c |}"},
                                           Wrong{"CSPM-T14@3", "f(x) = x -> STOP\nchannel c : Int\nP = f(c)"},
                                           Wrong{"CSPM-T14@2", "channel tock : Int\nTimed {\n P = STOP\n}"},
                                           Wrong{"CSPM-T15@1", "channel c : {}"},
                                           Wrong{"CSPM-T15@1", "datatype D = A.{<>}"},
                                           Wrong{"", "channel c : {}\nP = c!1 -> STOP\nc :: Int => Event"},
                                           Wrong{"CSPM-T16@2", "datatype D = A.{0..1}\nsubtype S = A.{0}.{0}"},
                                           Wrong{"", "datatype D = A.{0..1}.Bool\nsubtype S = A.{0}"},
                                           Wrong{"CSPM-T12@1", "f(y) = {| y, y.y.y |}"},
                                           Wrong{"CSPM-T17@2", "f :: (a =>* Event) -> {Event}\nf(c) = {| c.1 |}"}));

INSTANTIATE_TEST_SUITE_P(
    Modules, Finding,
    ::testing::Values(Wrong{"CSPM-T18@4", "module M(n)\nexports\nendmodule\ninstance I = M(1, 2)"},
                      Wrong{"CSPM-T08@5", "module M(n)\nexports\n x = n + 1\nendmodule\ninstance I = M(true)"},
                      Wrong{"CSPM-T19@3", "module M(n)\nexports\n instance I = M(n)\nendmodule"},
                      Wrong{"CSPM-T19@5", "module M(n)\nexports\n x = J::x\nendmodule\ninstance J = M(1)"},
                      Wrong{
                          "CSPM-T08@8",
                          "module M(n)\nexports\n datatype E = F.{0..n}\n channel c : E\nendmodule\ninstance I = M(1)\n"
                          "instance J = M(2)\nP = I::c.(J::F.1) -> STOP"}));

INSTANTIATE_TEST_SUITE_P(Print, Finding,
                         ::testing::Values(Wrong{"CSPM-T21@1", "print 1 + true"}, Wrong{"CSPM-T21@1", "print nowhere"},
                                           Wrong{"", "print 1 + 2"}));

// A script with a warning is still accepted.
TEST(TypeFindings, PrintIsAWarning) {
    Reading reading("print 1 + true\n");
    check_types(reading.script, reading.diagnostics);
    EXPECT_TRUE(reading.ok());
}

TEST(TypeFindings, SayWhatIsExpectedAndWhy) {
    Reading reading("channel c : Int\nP = c?x -> (if x then STOP else SKIP)\n");
    check_types(reading.script, reading.diagnostics);
    const auto all = reading.diagnostics.sorted_findings();
    ASSERT_EQ(all.size(), 1U);
    EXPECT_EQ(all[0].message(), "expected Bool, found Int");
    ASSERT_EQ(all[0].notes.size(), 1U);
    EXPECT_EQ(all[0].notes[0].message, "the condition of an `if` is a Bool");
    EXPECT_EQ(
        reading.sources.source_text(all[0].span.source).substr(all[0].span.begin, all[0].span.end - all[0].span.begin),
        "x");
}

TEST(TypeFindings, SuggestNearNames) {
    Reading reading("Process = STOP\nQ = Proces\n");
    check_types(reading.script, reading.diagnostics);
    EXPECT_NE(reading.report().find("did you mean 'Process'?"), std::string::npos) << reading.report();
}

// The text x1 = (x0, x0), x2 = (x1, x1), ... doubles the size of the type with every line.
TEST(TypeFindings, EnormousTypesAreRefused) {
    std::string script = "x0 = 1\n";
    for (int i = 1; i <= 60; ++i) {
        const std::string before = "x" + std::to_string(i - 1);
        script += "x" + std::to_string(i) + "(y) = (y, x" + (i == 1 ? "0" : std::to_string(i - 1) + "(y)") + ")\n";
    }
    Reading small(script);
    check_types(small.script, small.diagnostics);
    EXPECT_TRUE(small.ok()) << small.report();
    std::string doubling = "f0(x) = x\n";
    for (int i = 1; i <= 60; ++i) {
        const std::string before = "f" + std::to_string(i - 1);
        doubling += "f" + std::to_string(i) + " = \\ x @ (" + before + "(x), " + before + "((x, x)))\n";
    }
    Reading large(doubling);
    check_types(large.script, large.diagnostics);
    EXPECT_EQ(large.code(), "CSPM-T20");
}

// The type checker accepts sequences of sequences of sequences and so on until it must compare two such types level by
// level.
TEST(TypeFindings, DeepTypesAreRefused) {
    std::string script = "x0 = 1\ny0 = 1\n";
    for (int i = 1; i <= 20'000; ++i) {
        const std::string before = std::to_string(i - 1);
        script += "x" + std::to_string(i) + " = <x" + before + ">\ny" + std::to_string(i) + " = <y" + before + ">\n";
    }
    script += "same = x20000 == y20000\n";
    Reading reading(script);
    EXPECT_EQ(findings(reading), "CSPM-T20@40003");
}

TEST(TypeFindings, DeepExpressionsAreTyped) {
    std::string sum = "1";
    for (int i = 0; i < 3'000; ++i) sum += " + 1";
    Reading reading("v = " + sum + "\n");
    ASSERT_TRUE(reading.ok()) << reading.report();
    check_types(reading.script, reading.diagnostics);
    EXPECT_TRUE(reading.ok()) << reading.report();
}

TEST(TypeFindings, ExpressionsTooDeepForAnyStackAreRefused) {
    ExprPtr expr = build::number(1);
    for (int i = 0; i < 20'000; ++i) expr = build::negate(expr);
    Script script;
    script.decls.push_back(build::value("v", expr));
    diagnostics::Diagnostics found;
    check_types(script, found);
    ASSERT_FALSE(found.ok());
    EXPECT_EQ(found.sorted_findings().front().rule->code, "CSPM-T20");
    // Trees of this height cannot be destroyed recursively either, so the test destroys this one here.
    script.decls.clear();
    while (expr->args.size() == 1) expr = ExprPtr(expr->args[0]);
}

}  // namespace
}  // namespace robochart::cspm::test
