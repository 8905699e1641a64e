// One row a construct of the grammar (language reference 1.1, assertion reference 4): the text, and the tree it must
// give; or the rule that refuses it. A construct without a row is a construct without a test.
#include <gtest/gtest.h>

#include <array>
#include <ostream>

#include "fixture.hpp"
#include "frontend/print.hpp"
#include "tree.hpp"

namespace robochart::frontend {
namespace {

using testing::read;
using testing::tree;

struct Row {
    const char* text;
    const char* expected;
};

std::ostream& operator<<(std::ostream& out, const Row& row) {
    return out << row.text;
}

class Expressions : public ::testing::TestWithParam<Row> {};

const Machine& machine_of(const testing::Reading& reading) {
    return dynamic_cast<const Machine&>(*reading.file().declarations.at(0));
}

TEST_P(Expressions, GiveTheTree) {
    const auto reading = read("stm S { transition t { from a to b condition " + std::string(GetParam().text) + " } }");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const Expr& condition = *machine_of(*reading).transitions.at(0)->condition;
    EXPECT_EQ(tree(condition), GetParam().expected);
    if (std::string_view(GetParam().text).starts_with("^")) return;  // escapes: the formatter writes them
    const auto again = read("stm S { transition t { from a to b condition " + to_text(condition) + " } }");
    EXPECT_EQ(tree(*machine_of(*again).transitions.at(0)->condition), GetParam().expected) << to_text(condition);
}

INSTANTIATE_TEST_SUITE_P(
    Atoms, Expressions,
    ::testing::Values(Row{"12", "12"}, Row{"1.50", "1.50"}, Row{"\"a \\\" b\"", "\"a \\\" b\""}, Row{"'c'", "'c'"},
                      Row{"true", "true"}, Row{"false", "false"}, Row{"x", "x"}, Row{"^end", "end"},
                      Row{"E::L", "E::L"}, Row{"result", "RESULT"}, Row{"to", "TO"}, Row{"from", "FROM"},
                      Row{"R(|f = 1, g = a + b|)", "(record R [f = 1] [g = (+ a b)])"}, Row{"<>", "(seq)"},
                      Row{"<a, b + 1>", "(seq a (+ b 1))"}, Row{"<-1, a * b>", "(seq (neg 1) (* a b))"},
                      Row{"<(a > b)>", "(seq (paren (> a b)))"}, Row{"{}", "(set)"}, Row{"{1, 2}", "(set 1 2)"},
                      Row{"{1 to n + 1}", "(set-to 1 (+ n 1))"}, Row{"{v:nat}", "(set-of [v : nat] _ _)"},
                      Row{"{v:nat | p}", "(set-of [v : nat] p _)"},
                      Row{"{v:nat @ v + 1}", "(set-of [v : nat] _ (+ v 1))"},
                      Row{"{v:nat, w:T | p @ e}", "(set-of [v : nat] [w : T] p e)"}, Row{"(||)", "(tuple)"},
                      Row{"(|a, 1|)", "(tuple a 1)"}, Row{"[|1, 2|]", "(rows-of-2 1 2)"},
                      Row{"[|1, 2; 3, 4|]", "(rows-of-2 1 2 3 4)"}, Row{"[|1; 2|]", "(rows-of-1 1 2)"},
                      Row{"[a, b]", "(range[] a b)"}, Row{"[a, b)", "(range[) a b)"}, Row{"(a, b]", "(range(] a b)"},
                      Row{"(a, b)", "(range() a b)"}, Row{"inverse(m)", "(inverse m)"},
                      Row{"transpose(m)", "(transpose m)"}, Row{"since(C)", "(since C)"},
                      Row{"sinceEntry(A)", "(sinceEntry A)"}, Row{"sinceEntry(A::B)", "(sinceEntry A::B)"},
                      Row{"(a)", "(paren a)"}, Row{"f()", "(call f)"}, Row{"f(1, g(2))", "(call f 1 (call g 2))"},
                      Row{"(f)(1)", "(call (paren f) 1)"}));

// From the loosest to the tightest; each level with its neighbours.
INSTANTIATE_TEST_SUITE_P(
    Operators, Expressions,
    ::testing::Values(
        Row{"forall v:nat @ a iff b", "(forall [v : nat] _ (iff a b))"},
        Row{"forall v:nat, w:Set(T) | p @ q", "(forall [v : nat] [w : (Set T)] p q)"},
        Row{"exists v:nat | p @ q", "(exists [v : nat] p q)"}, Row{"exists v:nat @ q", "(exists [v : nat] _ q)"},
        Row{"exists1 v:nat | p @ q", "(exists1 [v : nat] p q)"}, Row{"exists1 v:nat @ q", "(exists1 [v : nat] _ q)"},
        Row{"lambda v:nat | p @ v + 1", "(lambda [v : nat] p (+ v 1))"},
        Row{"lambda v:nat @ forall w:nat @ p", "(lambda [v : nat] _ (forall [w : nat] _ p))"},
        Row{"a iff b iff c", "(iff (iff a b) c)"}, Row{"a iff b => c", "(iff a (=> b c))"},
        Row{"a => b => c", "(=> (=> a b) c)"}, Row{"a => b \\/ c", "(=> a (\\/ b c))"},
        Row{"a \\/ b \\/ c", "(\\/ (\\/ a b) c)"}, Row{"a \\/ b /\\ c", "(\\/ a (/\\ b c))"},
        Row{"a /\\ b /\\ c", "(/\\ (/\\ a b) c)"}, Row{"not a /\\ not not b", "(/\\ (not a) (not (not b)))"},
        Row{"not a == b", "(not (== a b))"}, Row{"a == b != c", "(!= (== a b) c)"},
        Row{"a > b >= c < d <= e", "(<= (< (>= (> a b) c) d) e)"}, Row{"a in s == b", "(== (in a s) b)"},
        Row{"a == b in s", "(in (== a b) s)"}, Row{"the v:nat | p @ v == 1", "(== (the [v : nat] p v) 1)"},
        Row{"a == the v:nat @ v + 1", "(== a (the [v : nat] _ (+ v 1)))"},
        Row{"the v:nat @ let x == v @ x", "(the [v : nat] _ (let [x = v] x))"},
        Row{"let x == 1, y == a iff b @ x + y == 2", "(== (let [x = 1] [y = (iff a b)] (+ x y)) 2)"},
        Row{"let x == 1 @ let y == 2 @ x", "(let [x = 1] (let [y = 2] x))"},
        Row{"let x == 1 @ if a then x else 2 end", "(let [x = 1] (if a x 2))"},
        Row{"if a iff b then forall v:nat @ p else c end == d", "(== (if (iff a b) (forall [v : nat] _ p) c) d)"},
        Row{"x + 1 as nat == y", "(== (as (+ x 1) nat) y)"}, Row{"x is Seq(nat) /\\ y", "(/\\ (is x (Seq nat)) y)"},
        Row{"x as A -> B == y", "(== (as x (-> A B)) y)"}, Row{"a - b + c", "(+ (- a b) c)"},
        Row{"a - b * c", "(- a (* b c))"}, Row{"a * b / c % d", "(% (/ (* a b) c) d)"},
        Row{"a * b cat c", "(* a (cat b c))"}, Row{"a cat b cat c", "(cat (cat a b) c)"},
        Row{"a ^ (b)", "(cat a (paren b))"}, Row{"a ^b", "(cat a b)"},
        Row{"-a cat - -b", "(cat (neg a) (neg (neg b)))"}, Row{"-a.f", "(neg (.f a))"}, Row{"a.f.g", "(.g (.f a))"},
        Row{"a[1].f", "(.f (index a 1))"}, Row{"a[1, i + 1]", "(index a 1 (+ i 1))"},
        Row{"f(1)[2].g", "(.g (index (call f 1) 2))"}, Row{"(a.f)[1]", "(index (paren (.f a)) 1)"},
        Row{"R(|f = 1|).f", "(.f (record R [f = 1]))"}, Row{"<1>[1]", "(index (seq 1) 1)"}, Row{"a<b", "(< a b)"},
        Row{"a<-1", "(< a (neg 1))"}, Row{"f\n(1)", "(call f 1)"}));

class Types : public ::testing::TestWithParam<Row> {};

TEST_P(Types, GiveTheTree) {
    const auto type_of = [](const testing::Reading& reading) -> const TypeExpr& {
        return *dynamic_cast<const Context&>(*reading.file().declarations.at(0)).variables.at(0)->type_expr;
    };
    const auto reading = read("interface I { var v:" + std::string(GetParam().text) + " }");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    EXPECT_EQ(tree(type_of(*reading)), GetParam().expected);
    if (std::string_view(GetParam().text).starts_with("^")) return;  // escapes: the formatter writes them
    const auto again = read("interface I { var v:" + to_text(type_of(*reading)) + " }");
    EXPECT_EQ(tree(type_of(*again)), GetParam().expected) << to_text(type_of(*reading));
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, Types,
    ::testing::Values(Row{"nat", "nat"}, Row{"P::Q::T", "P::Q::T"}, Row{"?X", "?X"}, Row{"(T)", "T"},
                      Row{"Seq(nat)", "(Seq nat)"}, Row{"Set(Seq(real))", "(Set (Seq real))"},
                      Row{"A * B * C", "(* A B C)"}, Row{"(A * B) * C", "(* (* A B) C)"},
                      Row{"A * (B * C)", "(* A (* B C))"}, Row{"A -> B -> C", "(-> A (-> B C))"},
                      Row{"(A -> B) -> C", "(-> (-> A B) C)"}, Row{"A * B -> C", "(-> (* A B) C)"},
                      Row{"A <-> B", "(<-> A B)"}, Row{"A -> B <-> C * D", "(<-> (-> A B) (* C D))"},
                      Row{"A <-> B <-> C", "(<-> A (<-> B C))"}, Row{"(A <-> B) -> C", "(-> (<-> A B) C)"},
                      Row{"vector(real, 3)", "(vector real 3)"},
                      Row{"vector(A -> B, (n + 1))", "(vector (-> A B) (paren (+ n 1)))"},
                      Row{"matrix(int, 2, n)", "(matrix int 2 n)"}, Row{"vector(real, 3) * A", "(* (vector real 3) A)"},
                      Row{"A * (vector(real, 3))", "(* A (vector real 3))"}));

class Statements : public ::testing::TestWithParam<Row> {};

TEST_P(Statements, GiveTheTree) {
    const auto statement_of = [](const testing::Reading& reading) -> const Stmt& {
        return *machine_of(reading).nodes.at(0)->actions.at(0).statement;
    };
    const auto reading = read("stm S { state s { entry " + std::string(GetParam().text) + " } }");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    EXPECT_EQ(tree(statement_of(*reading)), GetParam().expected);
    if (std::string_view(GetParam().text).starts_with("^")) return;  // escapes: the formatter writes them
    const auto again = read("stm S { state s { entry " + to_text(statement_of(*reading)) + " } }");
    EXPECT_EQ(tree(statement_of(*again)), GetParam().expected) << to_text(statement_of(*reading));
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, Statements,
    ::testing::Values(
        Row{"skip", "(skip)"}, Row{"skip; e; skip", "(seq (skip) ({e}) (skip))"},
        Row{"(skip; e)", "(paren (seq (skip) ({e})))"}, Row{"skip <{3}", "(within 3 (skip))"},
        Row{"skip <{a + 1}; e", "(seq (within (+ a 1) (skip)) ({e}))"},
        Row{"(skip; e) <{3}", "(within 3 (paren (seq (skip) ({e}))))"}, Row{"if a then e end", "(if a ({e}))"},
        Row{"if a then e; e else skip end", "(if a (seq ({e}) ({e})) (skip))"},
        Row{"if a then if b then e else skip end end", "(if a (if b ({e}) (skip)))"},
        Row{"if a then e end <{2}", "(within 2 (if a ({e})))"}, Row{"op()", "(call op)"},
        Row{"op(1, x + 1)", "(call op 1 (+ x 1))"}, Row{"P::op(1)", "(call P::op 1)"},
        Row{"v = e + 1", "(= v (+ e 1))"}, Row{"v.f = e", "(= (.f v) e)"}, Row{"v[1, 2] = e", "(= (index v 1 2) e)"},
        Row{"v[1].f[2].g = e", "(= (.g (index (.f (index v 1)) 2)) e)"},
        Row{"v = forall x:nat @ p", "(= v (forall [x : nat] _ p))"}, Row{"wait(2)", "(wait 2)"},
        Row{"wait([1, n])", "(wait-between 1 n)"}, Row{"wait({1, 2})", "(wait (set 1 2))"},
        Row{"wait((1, 2])", "(wait (range(] 1 2))"}, Row{"#C", "(# C)"}, Row{"#C; #D", "(seq (# C) (# D))"},
        Row{"e", "({e})"}, Row{"send e", "(send {e})"}, Row{"send e!1", "(send {e!1})"}, Row{"e?x", "({e?x})"},
        Row{"e?P::x", "({e?P::x})"}, Row{"e!1", "({e!1})"}, Row{"e!f(x)", "({e!(call f x)})"},
        Row{"e!(x + 1)", "({e!(paren (+ x 1))})"}, Row{"e!E::L", "({e!E::L})"}, Row{"e!<1>", "({e!(seq 1)})"},
        Row{"e.1", "({e.1})"}, Row{"e.x", "({e.x})"}, Row{"e.f(1)", "({e.(call f 1)})"}, Row{"e[||]", "({e})"},
        Row{"e[|x = from|]?y", "({e?y from-into x})"},
        Row{"e[|x = from | x > 1|]", "({e from-into x such-that (> x 1)})"},
        Row{"e[|from == 2|]!1", "({e!1 such-that (== FROM 2)})"}, Row{"e[|to == a|]", "({e such-that (== TO a)})"},
        Row{"^end!1", "({end!1})"}));

class Clauses : public ::testing::TestWithParam<Row> {};

/// What stands in a transition behind `from a to b`, as `dump` shows it.
TEST_P(Clauses, GiveTheTree) {
    const auto reading = read("stm S { transition t { from a to b " + std::string(GetParam().text) + " } }");
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const std::string dumped = reading->dumped();
    std::string clauses;
    for (std::size_t at = dumped.find('\n', dumped.find("transition t: a -> b")); at + 1 < dumped.size();) {
        const std::size_t end = dumped.find('\n', at + 1);
        const std::string line = dumped.substr(at + 1, end - at - 1);
        clauses += (clauses.empty() ? "" : "; ") + line.substr(line.find_first_not_of(' '));
        at = end;
    }
    EXPECT_EQ(clauses, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, Clauses,
    ::testing::Values(Row{"", ""}, Row{"trigger e", "trigger e"}, Row{"trigger e?x", "trigger e?x"},
                      Row{"trigger e!1", "trigger e!1"}, Row{"trigger e.1", "trigger e.1"},
                      Row{"trigger e[|x = from | x > 1|]?y", "trigger e[|x = from | x > 1|]?y"},
                      Row{"probability 0.5", "probability 0.5"}, Row{"#C #D", "#C; #D"}, Row{"<{ a + 1 }", "<{a + 1}"},
                      Row{"condition else", "condition else"}, Row{"condition a /\\ b", "condition a /\\ b"},
                      Row{"action skip; e", "action skip; e"},
                      Row{"trigger e #C #D <{ 3 } condition a action skip",
                          "trigger e; #C; #D; <{3}; condition a; action skip"},
                      Row{"probability 1 condition else action skip", "probability 1; condition else; action skip"}));

class Declarations : public ::testing::TestWithParam<Row> {};

/// A file's dump, without its first line and with `/` for line ends.
TEST_P(Declarations, GiveTheTree) {
    const auto reading = read(GetParam().text);
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    const std::string dumped = reading->dumped();
    std::string flat;
    for (std::size_t at = dumped.find('\n') + 1; at < dumped.size(); at = dumped.find('\n', at) + 1) {
        const std::string line = dumped.substr(at, dumped.find('\n', at) - at);
        const std::size_t indent = line.find_first_not_of(' ');
        flat += (flat.empty() ? "" : " / ") + std::string(indent / 2 - 1, '>') + line.substr(indent);
    }
    EXPECT_EQ(flat, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, Declarations,
    ::testing::Values(
        Row{"package A::B import C import D::E::*", "package A::B / import C / import D::E::*"},
        Row{"diagram D type T diagram E", "type T"}, Row{"import P::* diagram D type T", "import P::* / type T"},
        Row{"type T", "type T"}, Row{"datatype R { a:nat b:T * U }", "datatype R / >field a:nat / >field b:T * U"},
        Row{"record R { a:nat }", "datatype R / >field a:nat"}, Row{"datatype R { }", "datatype R"},
        Row{"enumeration E { L1 L2(nat, Seq(T)) ^end }",
            "enumeration E / >literal L1 / >literal L2(nat, Seq(T)) / >literal end"},
        Row{"function f(a:nat, b:E):Set(nat) { }", "function f(a:nat, b:E):Set(nat)"},
        Row{"function f():nat { precondition true postcondition result == 1 precondition false }",
            "function f():nat / >precondition true / >precondition false / >postcondition result == 1"},
        Row{"interface I { op() op2(p:nat, q:T)[terminates] }", "interface I / >op() / >op2(p:nat, q:T) [terminates]"},
        Row{"interface I { event e _broadcast event b:nat event f:A -> B }",
            "interface I / >event e / >_broadcast event b:nat / >event f:A -> B"},
        Row{"interface I { var a:nat, b:T = x + 1 const c:real, d:nat = 2 clock C }",
            "interface I / >variable a:nat / >variable b:T = x + 1 / >constant c:real / >constant d:nat = 2 / >clock "
            "C"},
        Row{"robotic platform R { uses A provides B::C requires D var v:nat const c:nat op(p:nat) event e }",
            "robotic platform R / >uses A / >provides B::C / >requires D / >variable v:nat / >constant c:nat / >event "
            "e / >op(p:nat)"},
        Row{"controller C { uses A provides B requires D var v:nat event e }",
            "controller C / >uses A / >provides B / >requires D / >variable v:nat / >event e"},
        Row{"controller C { operation O() { } opref o = P::O stm S { } sref s = P::S }",
            "controller C / >operation O() / >operation reference o = P::O / >state machine S / >state machine "
            "reference s = P::S"},
        Row{"controller C { connection C on e to S on f connection S on f to C on e (_async) connection C on e to S on "
            "f [mult] "
            "connection C on e to S on f (_async) [mult] }",
            "controller C / >connection C on e to S on f / >connection S on f to C on e (_async) / "
            ">connection C on e to S on f [mult] / >connection C on e to S on f (_async) [mult]"},
        Row{"module M { robotic platform R { } controller C { } stm S { } }",
            "module M / >robotic platform R / >controller C / >state machine S"},
        Row{"module M { rref r = R cref c = P::C sref s = S connection r on e to c on e (_async) }",
            "module M / >robotic platform reference r = R / >controller reference c = P::C / >state machine reference "
            "s = S / "
            ">connection r on e to c on e (_async)"},
        Row{"stm S { uses A provides B requires D var v:nat event e clock C initial i final f junction j probabilistic "
            "p }",
            "state machine S / >uses A / >provides B / >requires D / >variable v:nat / >event e / >clock C / >initial "
            "junction "
            "i / "
            ">final state f / >junction j / >probabilistic junction p"},
        Row{"stm S { state a { state b { } initial i transition t { from i to b } entry skip during e exit e!1 } }",
            "state machine S / >state a / >>entry skip / >>during e / >>exit e!1 / >>state b / >>initial junction i / "
            ">>transition t: i -> b"},
        Row{"operation O(p:nat, q:T) { terminates precondition p > 0 postcondition true uses A var v:nat event e clock "
            "C initial i }",
            "operation O(p:nat, q:T) / >terminates / >precondition p > 0 / >postcondition true / >uses A / >variable "
            "v:nat / "
            ">event e / >clock C / >initial junction i"},
        Row{"operation O() { }", "operation O()"}, Row{"/* a */ type T // b\n/* c\n*/ type U", "type T / type U"}));

class Assertions : public ::testing::TestWithParam<Row> {};

std::string shown(const Assertion& a) {
    constexpr std::array kinds = {"deadlock-free", "divergence-free", "deterministic", "timelock-free", "terminates",
                                  "refines",       "equals",          "reachable",     "clock"};
    constexpr std::array times = {"", "timed ", "untimed "};
    constexpr std::array models = {"FD", "T", "F", "TT"};
    std::string out = times.at(static_cast<std::size_t>(a.time)) + a.name + ": " + a.subject.text();
    out += std::string(a.subject.empty() ? "" : " ") + (a.negated ? "not " : "") +
           kinds.at(static_cast<std::size_t>(a.kind));
    if (!a.other.empty()) out += " " + a.other.text();
    if (a.model) out += std::string(" in ") + models.at(static_cast<std::size_t>(*a.model));
    for (const AssertionParameter& p : a.parameters)
        out += (p.constant ? " c:" : " p:") + p.name.text() + "@" + p.context.text() + "=" + tree(*p.value);
    return out;
}

TEST_P(Assertions, GiveTheTree) {
    const auto reading = read(GetParam().text, true);
    EXPECT_TRUE(reading->findings.empty()) << reading->report();
    std::string out;
    for (const Assertion& a : reading->file().assertions) out += (out.empty() ? "" : " / ") + shown(a);
    for (const CspBlock& b : reading->file().csp_blocks) {
        out += (out.empty() ? "" : " / ") + std::string("csp ") + b.name + " [" + b.text + "]";
        for (const QualifiedName& name : b.associated) out += " " + name.text();
    }
    for (const std::string& text : reading->file().verbatim) out += (out.empty() ? "" : " / ") + text;
    EXPECT_EQ(out, GetParam().expected);
}

INSTANTIATE_TEST_SUITE_P(
    Grammar, Assertions,
    ::testing::Values(
        Row{"assertion A: M::c::s is deadlock-free", "A: M::c::s deadlock-free"},
        Row{"timed assertion A: X is not divergence-free.", "timed A: X not divergence-free"},
        Row{"untimed assertion A: X is deterministic", "untimed A: X deterministic"},
        Row{"assertion A: X is not timelock-free .", "A: X not timelock-free"},
        Row{"assertion A: X terminates", "A: X terminates"},
        Row{"assertion A: X does not terminate.", "A: X not terminates"},
        Row{"assertion A: X refines Y in the traces model.", "A: X refines Y in T"},
        Row{"assertion A: X does not refine Y in the failures model", "A: X not refines Y in F"},
        Row{"assertion A: X equals Y in the failures divergences model", "A: X equals Y in FD"},
        Row{"assertion A: X is not equal to Y in the tick-tock model.", "A: X not equals Y in TT"},
        Row{"assertion A: S::s is reachable in S", "A: S reachable S::s"},
        Row{"assertion A: S::s is not reachable in M::c::S.", "A: M::c::S not reachable S::s"},
        Row{"assertion A: clock S::C is initialised", "A: clock S::C"},
        Row{"assertion A: clock S::C is not initialised", "A: not clock S::C"},
        Row{"assertion A: X terminates with constant k of S assigned 1", "A: X terminates c:k@S=1"},
        Row{"assertion A: X terminates with constant k of S set to 1 + 2.", "A: X terminates c:k@S=(+ 1 2)"},
        Row{"assertion A: X terminates with parameter p of O with value E::L.", "A: X terminates p:p@O=E::L"},
        Row{"assertion A: X terminates with constant a of S set to 1 and constant b of T set to 2.",
            "A: X terminates c:a@S=1 c:b@T=2"},
        Row{"assertion A: X terminates with constant a of S set to 1, constant b of S set to 2, and parameter c of O "
            "assigned 3 "
            "assertion B: X terminates",
            "A: X terminates c:a@S=1 c:b@S=2 p:c@O=3 / B: X terminates"},
        Row{"assertion A: X refines Y in the traces model with constant a of S set to r.f.",
            "A: X refines Y in T c:a@S=(.f r)"},
        Row{"csp P csp-begin P = STOP -- x\ncsp-end", "csp P [ P = STOP -- x\n]"},
        Row{"timed csp P associated to M, N::S csp-begin P = {- } -} csp- end csp-end",
            "csp P [ P = {- } -} csp- end ] M N::S"},
        Row{"package Q import A::* assertion A: X terminates", "A: X terminates"},
        Row{"instantiate P::T as [0, 3] assertion A: X terminates", "A: X terminates / instantiate P::T as [0, 3]"},
        Row{"const c : nat", "const c : nat"},
        Row{"constants C: M::s::k set to 1, and M::s::l from set {1 to 3 by step 2}",
            "constants C: M::s::k set to 1, and M::s::l from set {1 to 3 by step 2}"},
        Row{"label l = M::s is in M::s::t assertion A: X terminates", "A: X terminates / label l = M::s is in M::s::t"},
        Row{"formula f = $g + 1 /\\ #l", "formula f = $g + 1 /\\ #l"},
        Row{"rewards r = [e.in] true : 1; endrewards label l = 1",
            "rewards r = [e.in] true : 1; endrewards / label l = 1"},
        Row{"prob property p: Prob>0.5 of [Finally #l] with constants M::k set to 1 prob generate path q: using "
            "simulation for 10 steps",
            "prob property p: Prob>0.5 of [Finally #l] with constants M::k set to 1 / prob generate path q: using "
            "simulation for 10 steps"},
        Row{"prob property p: Prob=? of [Finally #l]\nwith\nconstants C\nwith definitions pfunction f() = { return $$x "
            "& 1 }",
            "prob property p: Prob=? of [Finally #l]\nwith\nconstants C\nwith definitions pfunction f() = { return $$x "
            "& 1 }"},
        Row{"defs d: poperation o(x) = { (y = 1) } pmodules m: pmodule n { v: bool; [] @v -> skip; }",
            "defs d: poperation o(x) = { (y = 1) } / pmodules m: pmodule n { v: bool; [] @v -> skip; }"}));

// ---------------------------------------------------------------- what the grammar forbids

class Refused : public ::testing::TestWithParam<Row> {};

TEST_P(Refused, WithOneMessage) {
    const bool is_assertions =
        std::string(GetParam().text).starts_with("assertion") || std::string(GetParam().text).starts_with("timed");
    const auto reading = read(GetParam().text, is_assertions);
    EXPECT_EQ(reading->codes(), GetParam().expected) << GetParam().text << "\n" << reading->report();
}

#define IN_GUARD(text) "stm S { transition t { from a to b condition " text " } }"
#define IN_ENTRY(text) "stm S { state s { entry " text " } }"
#define IN_TYPE(text) "interface I { var v:" text " }"

INSTANTIATE_TEST_SUITE_P(
    Grammar, Refused,
    ::testing::Values(
        // levels of operators
        Row{IN_GUARD("a /\\ forall v:nat @ p"), "RC-P15@1"}, Row{IN_GUARD("a == not b"), "RC-P15@1"},
        Row{IN_GUARD("a + the v:nat @ v"), "RC-P15@1"}, Row{IN_GUARD("1 + let x == 1 @ x"), "RC-P15@1"},
        Row{IN_GUARD("1 + if a then 1 else 2 end"), "RC-P15@1"},
        Row{IN_GUARD("let x == 1 @ the v:nat @ v"), "RC-P15@1"},
        Row{IN_GUARD("if a then 1 else 2 end + 1 == 2"), "RC-P26@1"}, Row{IN_GUARD("x as nat as int"), "RC-P26@1"},
        Row{IN_GUARD("a.f[1]"), "RC-P26@1"}, Row{IN_GUARD("a[1][2]"), "RC-P26@1"}, Row{IN_GUARD("f(1)(2)"), "RC-P26@1"},
        Row{IN_GUARD("<a, b == c>"), "RC-P26@1"}, Row{IN_GUARD("<a as nat>"), "RC-P26@1"},
        Row{IN_GUARD("<if a then 1 else 2 end>"), "RC-P15@1"}, Row{IN_GUARD("a = b"), "RC-P21@1"},
        Row{IN_GUARD("a && b"), "RC-P24@1"}, Row{IN_GUARD("a || b"), "RC-P24@1"}, Row{IN_GUARD("!a"), "RC-P24@1"},
        Row{IN_GUARD("let x = 1 @ x == 1"), "RC-P21@1"}, Row{IN_GUARD("R(||)"), "RC-P01@1"},
        Row{IN_GUARD("[||] == x"), "RC-P01@1"}, Row{IN_GUARD("forall v @ p"), "RC-P01@1"},
        Row{IN_GUARD("forall v:nat = 1 @ p"), "RC-P01@1"}, Row{IN_GUARD("since(S::C) > 1"), "RC-P25@1"},
        // types
        Row{IN_TYPE("Set (nat)"), "RC-P10@1"}, Row{IN_TYPE("Seq (nat)"), "RC-P10@1"},
        Row{IN_TYPE("A * vector(B, 2)"), "RC-P26@1"}, Row{IN_TYPE("vector(A)"), "RC-P01@1"},
        Row{IN_TYPE("A ->"), "RC-P01@1"},
        // statements
        Row{IN_ENTRY("e!x+1"), "RC-P12@1"}, Row{IN_ENTRY("e!-1"), "RC-P12@1"}, Row{IN_ENTRY("e!x.f"), "RC-P12@1"},
        Row{IN_ENTRY("e!x[1]"), "RC-P12@1"}, Row{IN_ENTRY("e;"), "RC-P29@1"}, Row{IN_ENTRY("e f"), "RC-P01@1"},
        Row{IN_ENTRY("v := 1"), "RC-P22@1"}, Row{IN_ENTRY("if a then e"), "RC-P01@1"},
        Row{IN_ENTRY("S::e!1"), "RC-P25@1"}, Row{IN_ENTRY("#S::C"), "RC-P25@1"},
        Row{IN_ENTRY("send op(1)"), "RC-P01@1"}, Row{IN_ENTRY("skip <{1} <{2}"), "RC-P01@1"},
        // transitions
        Row{"stm S { transition t { to b from a } }", "RC-P01@1"},
        Row{"stm S { transition t { from a to b condition a trigger e } }", "RC-P18@1"},
        Row{"stm S { transition t { from a to b trigger e probability 1 } }", "RC-P28@1"},
        Row{"stm S { transition t { from a to b condition a <{ 1 } } }", "RC-P18@1"},
        Row{"stm S { transition t { from S::a to b } }", "RC-P25@1"},
        Row{"stm S { transition t { from a to b trigger #C condition x } }", "RC-P09@1"},
        Row{"stm S { transition t { from a to b trigger\n condition x } }", "RC-P09@1"},
        Row{"stm S { transition t { from a to b trigger } }", "RC-P09@1"},
        // declarations
        Row{"type A package P", "RC-P16@1"}, Row{"package P package Q", "RC-P16@1"},
        Row{"enumeration E { A, B }", "RC-P01@1"}, Row{"datatype R { a:nat, b:nat }", "RC-P01@1"},
        Row{"datatype R { a:nat = 1 }", "RC-P01@1"}, Row{"stm end { }", "RC-P11@1"},
        Row{"interface I { uses J }", "RC-P01@1"}, Row{"interface I { state s { } }", "RC-P01@1"},
        Row{"module M { opref o = O }", "RC-P01@1"}, Row{"controller C { cref c = D }", "RC-P01@1"},
        Row{"controller C { state s { } }", "RC-P01@1"}, Row{"stm S { uses A, B }", "RC-P30@1"},
        Row{"module M { connection a on e to b on f _async }", "RC-P01@1"},
        Row{"module M { connection a on e to b on f [mult] (_async) }", "RC-P01@1"},
        Row{"module M { connection M::a on e to b on f }", "RC-P25@1"}, Row{"type A }", "RC-P19@1"},
        Row{"operation O { }", "RC-P01@1"}, Row{"function f() { }", "RC-P01@1"}, Row{"import P::*::Q", "RC-P01@1"},
        // neural networks
        Row{"anncontroller N { params { layerstructure <1,1> weights <<< 0.0>>> } } type T", "RC-P27@1"},
        Row{"module M { anncontroller N { } controller C { } }", "RC-P27@1"},
        Row{"controller C { annoperation N(x:real) { } stm S { } }", "RC-P27@1"},
        // assertions
        Row{"assertion A: X is deadlock free", "RC-P32@1"},
        Row{"assertion A: X refines Y in the tick tock model", "RC-P32@1"},
        Row{"timed assertion A: clock C is initialised", "RC-P31@1"},
        Row{"assertion A: X terminates with constant a of S set to 1, constant b of S set to 2", "RC-P17@1"},
        Row{"assertion A: X does terminate", "RC-P01@1"}, Row{"assertion A: X is not equal Y", "RC-P01@1"},
        Row{"assertion A: X refines Y in the stable model", "RC-P01@1"}, Row{"assertion A X terminates", "RC-P01@1"},
        Row{"assertion A: X is zeno-free\nassertion B: X terminates", "RC-P01@1"},
        Row{"timed rewards r = true : 1; endrewards", "RC-P01@1"}));

TEST(Constructs, ArtificialNeuralNetworksDoNotHideWhatFollows) {
    const auto reading = read(
        "module M { anncontroller N { params { event e } } controller C { } }\nannoperation O(x:real) { }\ntype T");
    EXPECT_EQ(reading->codes(), "RC-P27@1 RC-P27@2");
    ASSERT_EQ(reading->file().declarations.size(), 2U);
    EXPECT_EQ(dynamic_cast<const Component&>(*reading->file().declarations[0]).controllers.size(), 1U);
}

}  // namespace
}  // namespace robochart::frontend
