// SPDX-License-Identifier: Apache-2.0
// Tests every construct of the grammar, mistakes and recovery, and input that is not a model.
#include <gtest/gtest.h>

#include <algorithm>

#include "frontend/syntax/lexer.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "tests/frontend/fixture.hpp"

namespace robochart::frontend {
namespace {

using testing::read;

/// Returns the guard of the only transition in a machine with this text.
std::string guard(const std::string& text) {
    const auto reading = read("stm S { transition t { from a to b condition " + text + " } }");
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
    const auto* machine = dynamic_cast<const Machine*>(reading->file().declarations.at(0).get());
    return to_text(*machine->transitions.at(0)->condition);
}

/// Returns the guard with every operator in parentheses, which shows the shape of the tree.
std::string shape(const Expr& expr) {
    if (expr.kind == ExprKind::binary)
        return "(" + shape(*expr.args[0]) + std::string(to_text(*expr.binary)) + shape(*expr.args[1]) + ")";
    if (expr.kind == ExprKind::unary)
        return (expr.unary == UnaryOp::negate ? "(-" : "(not ") + shape(*expr.args[0]) + ")";
    if (expr.kind == ExprKind::cast) return "(" + shape(*expr.args[0]) + " as " + to_text(*expr.type_expr) + ")";
    return to_text(expr);
}

std::string guard_shape(const std::string& text) {
    const auto reading = read("stm S { transition t { from a to b condition " + text + " } }");
    EXPECT_TRUE(reading->findings.ok()) << reading->report();
    const auto* machine = dynamic_cast<const Machine*>(reading->file().declarations.at(0).get());
    return shape(*machine->transitions.at(0)->condition);
}

TEST(Lexer, ReservedWordsAreSorted) {
    EXPECT_TRUE(std::ranges::is_sorted(reserved_words()));
    EXPECT_TRUE(is_reserved("sinceEntry"));
    EXPECT_FALSE(is_reserved("sinceentry"));
}

TEST(Lexer, RefusesFilesOfTooManyWords) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const auto source = sources.add("t.rct", std::string(max_tokens + 1, ';'));
    EXPECT_LE(tokenize(sources, source, false, findings).tokens.size(), max_tokens + 1);  // one more: the end
    ASSERT_EQ(findings.error_count(), 1U);
    EXPECT_EQ(findings.sorted_findings().front().rule->code, "RC-P23");
}

TEST(Lexer, KeepsPlacesOfComments) {
    const auto reading = read("// one\ntype A /* two\n lines */ type B\n");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    ASSERT_EQ(reading->file().comments.size(), 2U);
    EXPECT_EQ(reading->file().comments[1].begin, 14U);
    EXPECT_EQ(reading->file().declarations.size(), 2U);
}

// The precedence is listed in the language reference 1.1, from lowest to highest.
TEST(Parser, OperatorsBindAsTheGrammarSays) {
    EXPECT_EQ(guard_shape("a iff b => c \\/ d /\\ e"), "(aiff(b=>(c\\/(d/\\e))))");
    EXPECT_EQ(guard_shape("a => b => c"), "((a=>b)=>c)");
    EXPECT_EQ(guard_shape("not a == b /\\ c"), "((not (a==b))/\\c)");
    EXPECT_EQ(guard_shape("not not a"), "(not (not a))");
    EXPECT_EQ(guard_shape("a - b - c * d"), "((a-b)-(c*d))");
    EXPECT_EQ(guard_shape("-a * b cat c"), "((-a)*(bcatc))");
    EXPECT_EQ(guard_shape("a ^b"), "(acatb)");
    EXPECT_EQ(guard_shape("a ^ b"), "(acatb)");
    EXPECT_EQ(guard_shape("x + 1 as nat == y"), "(((x+1) as nat)==y)");
    EXPECT_EQ(guard_shape("a < b"), "(a<b)");
    EXPECT_EQ(guard_shape("x<-1"), "(x<(-1))");
    EXPECT_EQ(guard_shape("x in {1, 2} /\\ y"), "((xin{1, 2})/\\y)");
    EXPECT_EQ(guard_shape("- x.f + y[1]"), "((-x.f)+y[1])");
}

// The printed text of atoms and binders equals the input.
TEST(Parser, ReadsEveryFormOfExpression) {
    for (const char* text : {"true",
                             "1",
                             "1.5",
                             "\"s\"",
                             "E::L",
                             "result",
                             "from",
                             "to",
                             "R(|f = 1, g = 2|)",
                             "<1, 2 + 3>",
                             "<>",
                             "{}",
                             "{1, 2}",
                             "{1 to 3}",
                             "{v:nat | v > 1 @ v}",
                             "{v:nat}",
                             "(|1, a|)",
                             "[|1, 2; 3, 4|]",
                             "[|1, 2|]",
                             "[1, 2]",
                             "[1, 2)",
                             "(1, 2]",
                             "(1, 2)",
                             "inverse(m)",
                             "transpose(m)",
                             "since(C)",
                             "sinceEntry(A::B)",
                             "(a)",
                             "f(1, g(2))",
                             "(f)(1)",
                             "f()",
                             "a.b.c",
                             "a[1, 2]",
                             "if a then b else c end",
                             "x is nat",
                             "forall v:nat, w:Seq(int) | v > 1 @ w == <>",
                             "exists v:nat @ v > 1",
                             "exists1 v:nat @ v > 1",
                             "(lambda v:nat @ v)(1)",
                             "(the v:nat | v > 1 @ v)",
                             "let x == 1, y == x @ x + y",
                             "< {1}, {2}>",
                             "a % b"})
        EXPECT_EQ(guard(text), text);
    EXPECT_EQ(guard("<{1}, {2}>"), "< {1}, {2}>");  // `<{` is one token, which the parser splits here
    EXPECT_EQ(guard("^end + ^end::x"), "^end + ^end::x");
}

TEST(Parser, ReadsAnAssignmentBehindAnyIndex) {
    for (const char* action : {"a[{1}] = 2", "a[[| 1; 2 |]] = 2", "a[(1, 2]].f[x as Set(nat)] = 2"})
        EXPECT_EQ(read(std::string("operation O() { initial i transition t { from i to i action ") + action + " } }")
                      ->codes(),
                  "")
            << action;
}

TEST(Parser, ReadsEveryFormOfType) {
    for (const char* text :
         {"nat", "P::T", "Seq(nat)", "Set(Seq(real))", "A * B * C", "A -> B -> C", "A <-> B", "(A -> B) -> C",
          "(A * B) * C", "vector(real, 3)", "matrix(int, 2, n)", "?X", "A * B -> C"}) {
        const auto reading = read("interface I { var v:" + std::string(text) + " }");
        EXPECT_TRUE(reading->findings.empty()) << reading->report();
        const auto* interface = dynamic_cast<const Context*>(reading->file().declarations.at(0).get());
        EXPECT_EQ(to_text(*interface->variables.at(0)->type_expr), text);
    }
}

TEST(Parser, ReadsEveryFormOfStatement) {
    for (const char* text : {"skip",
                             "a = 1",
                             "a.f = 1",
                             "a[1] = 2",
                             "a.f[1].g = 3",
                             "op()",
                             "op(1, x)",
                             "e",
                             "e?x",
                             "e!1",
                             "e!f(x)",
                             "e!(x + 1)",
                             "e.1",
                             "e.x",
                             "e.(x + 1)",
                             "send e",
                             "send e!1",
                             "wait(2)",
                             "wait([1, 2])",
                             "wait({1, 2})",
                             "#C",
                             "(skip; e)",
                             "e <{3}",
                             "e; op(); skip",
                             "if a then e end",
                             "if a then e; e else skip end",
                             "e[|x = from|]?y",
                             "e[|x = from | x > 1|]",
                             "e[|a|]!1"}) {
        const auto reading = read("stm S { state s { entry " + std::string(text) + " } }");
        EXPECT_TRUE(reading->findings.empty()) << text << "\n" << reading->report();
        const auto* machine = dynamic_cast<const Machine*>(reading->file().declarations.at(0).get());
        EXPECT_EQ(to_text(*machine->nodes.at(0)->actions.at(0).statement), text);
    }
}

constexpr const char* whole = R"(package A::B
diagram D
import P::Q
import R::*
type G
datatype Pos { x:real y:real }
record Box { p:Pos }
enumeration E { L1 L2(nat, G) ^end }
function f(a:nat, b:E):nat { precondition a > 0 postcondition result == a }
function g():G {}
interface I { op(p:nat)[terminates] op2() event e:nat _broadcast event b var v:nat = 1, w:int const c:real clock C }
robotic platform R { uses I provides I requires I var v:nat opr() event e }
stm S {
  uses I requires I const k:nat event e clock C
  initial i
  state s { entry skip during e exit skip state inner { } initial j transition t { from j to inner } }
  junction q
  probabilistic p
  final f
  transition t1 { from i to s }
  transition t2 { from s to q trigger e?v #C #C <{ 3 } condition v > 1 action skip }
  transition t3 { from q to p condition else }
  transition t4 { from p to f probability 0.5 }
}
operation O(p:nat) { terminates precondition p > 0 postcondition true initial i }
operation P() { }
controller K {
  uses I event e sref s = S opref o = O operation Inner() { }
  stm T { initial i }
  connection K on e to s on e [mult]
}
module M {
  robotic platform RP { event e }
  controller C2 { stm T { initial i } }
  rref r = R cref c = K
  connection r on e to c on e (_async)
}
)";

TEST(Parser, ReadsAWholeFile) {
    const auto reading = read(whole);
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    EXPECT_EQ(reading->file().package.text(), "A::B");
    EXPECT_EQ(reading->file().imports.size(), 2U);
    EXPECT_EQ(reading->file().declarations.size(), 13U);
    EXPECT_NE(reading->dumped().find("transition t2: s -> q"), std::string::npos);
    EXPECT_EQ(reading->dumped(), read(whole)->dumped());
}

constexpr const char* assertion_text = R"(package X
import P::*
assertion A1: M is deadlock-free.
timed assertion A2: M::c::s is not timelock-free
untimed assertion A3: S refines T in the traces model
assertion A4: S does not refine T in the failures model with constant k of S set to 1
assertion A5: S equals T in the failures divergences model with constant k of S assigned 1, and parameter p of O with value 2
assertion A6: S is not equal to T in the tick-tock model
assertion A7: S terminates  assertion A8: S does not terminate
assertion A9: S::s is reachable in S
assertion A10: clock C is not initialised
assertion A11: S is deterministic assertion A12: S is divergence-free
timed csp Spec associated to S, M csp-begin
Spec = a -> { x csp- end
csp-end
prob property Q: Prob>0.5 of [Finally $x /\ #l]
  with constants foo
label l = 1
rewards r = [e.in] true : 1; endrewards
assertion A13: S terminates with constant k of S set to E::a . assertion A14: S terminates with constant k of S set to E::a.
)";

TEST(Parser, ReadsAssertions) {
    const auto reading = read(assertion_text, true);
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const File& file = reading->file();
    ASSERT_EQ(file.assertions.size(), 14U);
    EXPECT_EQ(file.assertions[1].subject.text(), "M::c::s");
    EXPECT_TRUE(file.assertions[1].negated);
    EXPECT_EQ(file.assertions[3].model, AssertionModel::failures);
    ASSERT_EQ(file.assertions[4].parameters.size(), 2U);
    EXPECT_EQ(file.assertions[4].parameters[1].kind, ParameterKind::parameter);
    EXPECT_EQ(file.assertions[8].subject.text(), "S");
    EXPECT_EQ(file.assertions[8].other.text(), "S::s");
    EXPECT_EQ(file.assertions[9].kind, AssertionKind::clock_initialised);
    ASSERT_EQ(file.csp_blocks.size(), 1U);
    EXPECT_EQ(file.csp_blocks[0].text, "\nSpec = a -> { x csp- end\n");
    EXPECT_EQ(file.csp_blocks[0].associated.size(), 2U);
    EXPECT_EQ(file.probabilistic_assertions.size(), 1U);
    EXPECT_EQ(file.probabilistic_definitions.size(), 2U);
    EXPECT_TRUE(file.kept.empty());
}

// ---------------------------------------------------------------- mistakes

struct Mistake {
    const char* text;
    const char* codes;
    bool is_assertions = false;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
    *out << ::testing::PrintToString(mistake.text);
}

class Mistakes : public ::testing::TestWithParam<Mistake> {};

TEST_P(Mistakes, GiveOneMessageEach) {
    const auto reading = read(GetParam().text, GetParam().is_assertions);
    EXPECT_EQ(reading->codes(), GetParam().codes) << GetParam().text << "\n" << reading->report();
}

INSTANTIATE_TEST_SUITE_P(
    Parser, Mistakes,
    ::testing::Values(
        Mistake{"stm S {\n var x nat\n event e\n}", "RC-P01@2"},
        Mistake{"stm {\n initial i\n}\nstm T { state }", "RC-P01@1 RC-P01@4"},
        Mistake{"stm S {\n transition t { from a to b condition x + }\n transition u { from a }\n}",
                "RC-P01@2 RC-P01@3"},
        Mistake{"stm S {\n state s { entry e ! }\n state t { entry 3 }\n}", "RC-P01@2 RC-P01@3"},
        Mistake{"interface I { var a:nat\n\ninterface J { var a nat }", "RC-P01@1 RC-P01@3"},
        Mistake{"stm S {\n state end {}\n}", "RC-P11@2"},
        Mistake{"stm S { state a { entry e!x+1 } state b { entry e!-1 } }", "RC-P12@1 RC-P12@1"},
        Mistake{"interface I { var a:Set (nat)\n var b:nat }", "RC-P10@1"}, Mistake{"type A\n/* open", "RC-P03@2"},
        Mistake{"stm S { transition t { from a to b condition x == 'open\n } }\ntype B", "RC-P04@1"},
        Mistake{"type A\ntype B\xC3\xA9", "RC-P05@2"},
        Mistake{"interface I { const c:nat = 9223372036854775808 }", "RC-P06@1"},
        Mistake{"interface I { const c:real = 0.1234567890123456789 }", "RC-P07@1"},
        Mistake{"interface I { const c:real = 0.123456789012345678 const d:nat = 9223372036854775807 }", ""},
        Mistake{"stm S { transition t { from a to b trigger #C condition x } }", "RC-P09@1"},
        Mistake{"stm S { transition t { from a to b trigger\n condition x } }", "RC-P09@1"},
        Mistake{"stm S { transition t { from a to b condition a /\\ forall x:nat @ x > 1 } }", "RC-P15@1"},
        Mistake{"stm S { transition t { from a to b condition a == not b } }", "RC-P15@1"},
        Mistake{"type A\npackage P", "RC-P16@2"},
        Mistake{"stm S { transition t { from a to b action skip condition x } }", "RC-P18@1"},
        Mistake{"type A }\ntype B", "RC-P19@1"},
        Mistake{"interface I { const c:matrix(nat,2,2) = [|1,2;3|] }", "RC-P20@1"},
        Mistake{"csp X csp-begin x", "RC-P13@1", true},
        Mistake{"assertion A: S terminates with constant a of S set to 1, constant b of S set to 2", "RC-P17@1", true},
        Mistake{"assertion A: S is deadlock\nassertion B: S terminates", "RC-P01@1", true}));

/// Returns "LINE: message" of the first finding's first note.
std::string first_note(const std::string& text) {
    const auto reading = read(text);
    if (reading->findings.ok()) return "no finding";
    const diagnostics::Diagnostic finding = reading->findings.sorted_findings().front();
    if (finding.notes.empty()) return "no note";
    const auto& note = finding.notes.front();
    return std::to_string(reading->sources.position(note.span.source, note.span.begin).line) + ": " + note.message;
}

TEST(Parser, ABraceThatIsNotClosedIsPointedAt) {
    EXPECT_EQ(first_note("stm S {\n  initial i\n  state A {\n    entry skip\n  state B { }\n}\nstm T { }"),
              "3: this `{` is not closed");
    EXPECT_EQ(first_note("interface I {\n  event a\n\nstm S {\n}\n"), "1: this `{` is not closed");
    EXPECT_EQ(first_note("stm S {\n  transition t {\n    from i to A\n  transition u { from A to A }\n}\n"),
              "2: this `{` is not closed");
    EXPECT_EQ(first_note("stm S {\n  state A {\n    initial i\n    transition t { from i to i }\n"
                         "  transition u { from A to A }\n}\n"),
              "2: this `{` is not closed");
    // No text is indented deeper than the state, so the following lines may belong to it, and the brace at the left
    // margin closes it.
    EXPECT_EQ(first_note("stm S {\n  state A { entry skip\n  transition u { from A to A }\n}\n"),
              "2: this `{` is probably not closed, because the matching `}` has a smaller indentation");
    EXPECT_EQ(first_note("stm S { state A { entry x = 1 y } }"), "no note");
}

TEST(Parser, ReadsOnAfterAMistake) {
    const auto reading = read("stm S {\n var x nat\n state s { entry = 1 }\n initial i\n}\nmodule M { }");
    EXPECT_EQ(reading->findings.error_count(), 2U) << reading->report();
    ASSERT_EQ(reading->file().declarations.size(), 2U);
    const auto* machine = dynamic_cast<const Machine*>(reading->file().declarations[0].get());
    EXPECT_EQ(machine->nodes.size(), 2U);
    EXPECT_TRUE(reading->file().has_syntax_errors);
}

TEST(Parser, LongOperatorChainsAreBounded) {
    std::string sum = "1";
    for (int i = 0; i < 5000; ++i) sum += "+1";
    EXPECT_EQ(read("interface I { const c:nat = " + sum + " }")->codes(), "RC-P02@1");
    std::string members = "x";
    for (int i = 0; i < 5000; ++i) members += ".a";
    EXPECT_EQ(read("interface I { const c:nat = " + members + " }")->codes(), "RC-P02@1");
}

TEST(Parser, RefusesWhatIsNoText) {
    EXPECT_EQ(read(std::string("\x7F"
                               "ELF\0\1\2\3",
                               8))
                  ->codes(),
              "RC-P08@1");
    std::string bytes;
    for (int i = 0; i < 100'000; ++i) bytes += static_cast<char>(1 + (i * 7919) % 255);
    const auto noise = read(bytes);
    EXPECT_FALSE(noise->findings.ok());
    EXPECT_LE(noise->findings.error_count(), 100'000U);
}

TEST(Parser, OddTextsGiveOneMessageOrNone) {
    const Mistake odd[] = {{"", ""},
                           {"\xEF\xBB\xBFtype A", ""},
                           {"type A\r\ntype B\r\n", ""},
                           {"type A\rtype B", ""},
                           {"// nothing but this", ""},
                           {"/* nothing but this */", ""},
                           {"/*", "RC-P03@1"},
                           {"type A /* /* */ type B", ""},
                           {"type A\xEF\xBB\xBF", "RC-P05@1"},
                           {"type \xED\xA0\x80", "RC-P05@1"},
                           {"type A\n\xFF\xFE\n", "RC-P05@2"},
                           {"\f", "RC-P05@1"},
                           {"csp P csp-begin", "RC-P13@1", true},
                           {"csp P csp-begin csp-end", "", true},
                           {"csp P csp-end", "RC-P01@1", true}};
    for (const Mistake& text : odd) EXPECT_EQ(read(text.text, text.is_assertions)->codes(), text.codes) << text.text;
}

TEST(Parser, StopsAfterAHundredMistakes) {
    std::string text;
    for (int i = 0; i < 1000; ++i) text += "interface I { var x nat }\n";
    const auto reading = read(text);
    EXPECT_EQ(reading->findings.error_count(), 101U);
    EXPECT_NE(reading->codes().find("RC-P14"), std::string::npos);
}

TEST(SyntaxRules, HaveCodesAndMessages) {
    std::vector<std::string_view> codes;
    for (const auto* rule : syntax::rule_list) {
        codes.push_back(rule->code);
        EXPECT_FALSE(rule->message.empty()) << rule->code;
    }
    std::ranges::sort(codes);
    EXPECT_EQ(std::ranges::adjacent_find(codes), codes.end());
}

}  // namespace
}  // namespace robochart::frontend
