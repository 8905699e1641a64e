// SPDX-License-Identifier: Apache-2.0
// Tests the inferred types of names, in FDR's notation (FDR manual, chapter CSPM, "Type system").
#include <gtest/gtest.h>
#include <algorithm>

#include <string>
#include <vector>

#include "checker/cspm/types/type_check.hpp"
#include "tests/checker/cspm/support.hpp"

namespace robochart::cspm::test {
namespace {

struct Typed {
    const char* script;  ///< after the common declarations
    const char* type;    ///< of the name `v`
};

void PrintTo(const Typed& typed, std::ostream* out) {
    *out << ::testing::PrintToString(typed.script);
}

// Declarations that all scripts of this file may use.
constexpr const char* common = R"(
datatype T = Leaf | Node.T.Int.T
datatype D = A.{0..2}.Bool | B
datatype H = Hold.Proc
channel none
channel c : {0..2}.Bool
channel d : D
)";

class TypeOf : public ::testing::TestWithParam<Typed> {};

TEST_P(TypeOf, IsInferred) {
    Reading reading(std::string(common) + GetParam().script + "\n");
    ASSERT_TRUE(reading.ok()) << reading.report();
    const std::vector<NamedType> types = check_types(reading.script, reading.diagnostics);
    ASSERT_TRUE(reading.ok()) << GetParam().script << "\n" << reading.report();
    const auto found = std::ranges::find_if(types, [](const NamedType& named) { return named.name == "v"; });
    ASSERT_NE(found, types.end()) << GetParam().script;
    EXPECT_EQ(found->type, GetParam().type) << GetParam().script;
}

INSTANTIATE_TEST_SUITE_P(
    Values, TypeOf,
    ::testing::Values(
        Typed{"v = 1 + 2 * -3", "Int"}, Typed{"v = not (1 < 2) or 'a' < 'b'", "Bool"}, Typed{"v = \"text\"", "<Char>"},
        Typed{"v = (1, true, 'x')", "(Int, Bool, Char)"}, Typed{"v = <1, 2> ^ <3>", "<Int>"}, Typed{"v = #<1>", "Int"},
        Typed{"v = <>", "<a>"}, Typed{"v = {}", "Set a => {a}"}, Typed{"v = {1..}", "{Int}"},
        Typed{"v = <1..3>", "<Int>"}, Typed{"v = { (x, y) | x <- {1..3}, y <- {true}, x > 1 }", "{(Int, Bool)}"},
        Typed{"v = < x + 1 | x <- <1..3> >", "<Int>"}, Typed{"v = (| 1 => true |)", "(| Int => Bool |)"},
        Typed{"v = mapUpdate(emptyMap, 'a', <1>)", "(| Char => <Int> |)"},
        Typed{"v = if true then <1> else <>", "<Int>"}, Typed{"v = let x = 1 within (x, x)", "(Int, Int)"},
        Typed{"(v, w) = (1, true)", "Int"}, Typed{"v ^ <w> = <1, 2>", "<Int>"}, Typed{"v = error(\"no\")", "a"},
        Typed{"v = show(none)", "<Char>"}, Typed{"nametype v = ({0..1}, Bool)", "{(Int, Bool)}"},
        Typed{"subtype v = A.{0}", "{D}"}, Typed{"v = Set({1})", "{{Int}}"}, Typed{"v = Events", "{Event}"}));

INSTANTIATE_TEST_SUITE_P(
    Functions, TypeOf,
    ::testing::Values(
        Typed{"v(x) = x", "(a) -> a"}, Typed{"v(x)(y) = x + y", "(Int) -> (Int) -> Int"}, Typed{"v() = 1", "() -> Int"},
        Typed{"v = \\ x, y @ x and y", "(Bool, Bool) -> Bool"}, Typed{"v(x, y) = x == y", "Eq a => (a, a) -> Bool"},
        Typed{"v(x, y) = x < y", "Ord a => (a, a) -> Bool"}, Typed{"v(x) = {x}", "Set a => (a) -> {a}"},
        Typed{"v({x}) = x", "Eq a => ({a}) -> a"}, Typed{"v(<x>^xs) = v(xs)", "(<a>) -> b"},
        Typed{"v(f, <>) = <>\nv(f, <x>^xs) = <f(x)> ^ v(f, xs)", "((a) -> b, <a>) -> <b>"},
        Typed{"v(x @@ y) = (x, y)", "(a) -> (a, a)"}, Typed{"v(\"ab\") = 1\nv(_) = 2", "(<Char>) -> Int"},
        Typed{"v(Leaf) = 0\nv(Node.l.x.r) = v(l) + x + v(r)", "(T) -> Int"},
        Typed{"v = union", "Set a => ({a}, {a}) -> {a}"}, Typed{"v = member", "Eq a => (a, {a}) -> Bool"},
        Typed{"v :: (Eq a) => (a) -> Bool\nv(x) = true", "Eq a => (a) -> Bool"},
        Typed{
            "v(n) = let even(0) = true\n even(k) = odd(k - 1)\n odd(0) = false\n odd(k) = even(k - 1)\n within even(n)",
            "(Int) -> Bool"}));

INSTANTIATE_TEST_SUITE_P(
    Dots, TypeOf,
    ::testing::Values(Typed{"v = none", "Event"}, Typed{"v = c", "Int => Bool => Event"},
                      Typed{"v = c.1", "Bool => Event"}, Typed{"v = c.1.true", "Event"}, Typed{"v = A.1", "Bool => D"},
                      Typed{"v = d.A", "Int => Bool => Event"}, Typed{"v = d.A.1.true", "Event"},
                      Typed{"v = d.B", "Event"}, Typed{"v = 1.true", "Int.Bool"},
                      Typed{"v(x) = c.x", "(Int.Bool) -> Event"}, Typed{"v(x) = c.x.true", "(Int) -> Event"},
                      Typed{"v = {| c, none, d.A |}", "{Event}"}, Typed{"v = {| A |}", "{D}"},
                      Typed{"v(x) = {| x |}", "Yieldable b => (a =>* b) -> {b}"},
                      Typed{"v(x) = {| x.1 |}", "Yieldable b => (Int => a =>* b) -> {b}"},
                      Typed{"v = extensions(c.1)", "{Bool}"}, Typed{"v = productions(c.1)", "{Event}"},
                      Typed{"v(A.n.b) = n\nv(B) = 0", "(D) -> Int"}, Typed{"v(A.x) = x", "(D) -> Int.Bool"},
                      Typed{"v = { x | c.x.y <- {| c |} }", "{Int}"},
                      Typed{"v(x, y) = x.y -> STOP", "(a => Event, a) -> Proc"},
                      Typed{"v(x) = x?y -> v(x)", "Complete a => (a => Event) -> Proc"},
                      Typed{"v :: (a =>* Event) -> Int\nv(x) = 1", "(a =>* Event) -> Int"}));

INSTANTIATE_TEST_SUITE_P(
    Processes, TypeOf,
    ::testing::Values(
        Typed{"v = c?x?y -> if y then c!x!y -> v else STOP", "Proc"}, Typed{"v = c$x?y:{true} -> SKIP", "Proc"},
        Typed{"v = d?A.x.y -> d.B -> v", "Proc"}, Typed{"v = STOP [] SKIP |~| DIV ; RUN({none})", "Proc"},
        Typed{"v = (STOP [| {none} |] SKIP) \\ {| c |}", "Proc"}, Typed{"v = STOP [ {none} || {| c |} ] SKIP", "Proc"},
        Typed{"v = STOP [[ c <- c, none <- d.B ]]", "Proc"},
        Typed{"v = STOP [[ c.x <- c.y | x <- {0..2}, y <- {0} ]]", "Proc"},
        Typed{"v = STOP [ none <-> d.B ] SKIP", "Proc"}, Typed{"v = [ c <-> c ] i : <1..3> @ STOP", "Proc"},
        Typed{"v = || x : {1..3} @ [ {none} ] STOP", "Proc"}, Typed{"v = ; x : <1..3> @ SKIP", "Proc"},
        Typed{"v = STOP [| {none} |> SKIP /\\ STOP", "Proc"}, Typed{"v = STOP [+ {none} +] SKIP", "Proc"},
        Typed{"v = STOP /+ {none} +\\ SKIP", "Proc"}, Typed{"v = {STOP, SKIP}", "{Proc}"},
        Typed{"v(n) = n > 0 & none -> v(n - 1)", "(Int) -> Proc"}, Typed{"v = Hold.STOP", "H"},
        Typed{"transparent normal\nv = normal", "(Proc) -> Proc"},
        Typed{"external prioritise\nv = prioritise(STOP, <{none}>)", "Proc"},
        Typed{"channel tock\nOne(_) = 1\nTimed(One) {\n v = WAIT(1) ; timed_priority(STOP)\n}", "Proc"}));

INSTANTIATE_TEST_SUITE_P(
    Modules, TypeOf,
    ::testing::Values(
        Typed{"module M\n h = 1\nexports\n x = (h, true)\nendmodule\nv = M::x", "(Int, Bool)"},
        Typed{"module M(n)\nexports\n f(x) = (x, n)\nendmodule\ninstance I = M('c')\nv = I::f", "(a) -> (a, Char)"},
        Typed{"module M(n)\nexports\n datatype E = F.{0..n}\nendmodule\ninstance I = M(1)\ninstance J = M(2)\nv = "
              "(I::F.1, J::F)",
              "(I::E, Int => J::E)"},
        Typed{"module M\nexports\n module N(k)\n exports\n  y = <k>\n endmodule\nendmodule\ninstance I = M::N(true)\nv "
              "= I::y",
              "<Bool>"},
        Typed{"module M(n)\nexports\n module N(k)\n exports\n  y = (n, k)\n endmodule\nendmodule\ninstance I = M(1)\n"
              "instance J = I::N(true)\nv = J::y",
              "(Int, Bool)"}));

// The type checker generalises all top-level definitions, but in a let only annotated names (FDR's rule).
TEST(TypeCheck, LetsGeneraliseAnnotatedNamesOnly) {
    Reading bare("f(y) = let id(x) = x within (id(1), id(true))\n");
    check_types(bare.script, bare.diagnostics);
    EXPECT_EQ(bare.code(), "CSPM-T08");
    Reading annotated("f(y) = let id :: (a) -> a\n           id(x) = x\n       within (id(1), id(true))\n");
    check_types(annotated.script, annotated.diagnostics);
    EXPECT_TRUE(annotated.ok()) << annotated.report();
}

TEST(TypeCheck, OneFaultOneFinding) {
    Reading reading("x = 1 + true\ny = x + 1\nz = y + x\nw = nowhere + z\n");
    check_types(reading.script, reading.diagnostics);
    EXPECT_EQ(reading.diagnostics.error_count(), 2U) << reading.report();
}

TEST(TypeCheck, NamesOfAScriptCanMeanDifferentThings) {
    // FDR allows a script to hide built-in names.
    Reading reading("union(x) = x\nInt = 3\nv = union(Int) + 1\n");
    check_types(reading.script, reading.diagnostics);
    EXPECT_TRUE(reading.ok()) << reading.report();
}

}  // namespace
}  // namespace robochart::cspm::test
