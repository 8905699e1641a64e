// SPDX-License-Identifier: Apache-2.0
// Contains the table of constructs (constructs.hpp).
#include "constructs.hpp"

#define IN_GUARD(text) "stm S { transition t { from a to b condition " text " } }"
#define IN_ENTRY(text) "stm S { state s { entry " text " } }"
#define IN_TYPE(text) "interface I { var v:" text " }"

namespace robochart::frontend::testing {

std::ostream& operator<<(std::ostream& out, const Row& row) {
    return out << row.text;
}

const std::vector<Row>& atoms() {
    static const std::vector<Row> rows = {{"12", "12"},
                                          {"1.50", "1.50"},
                                          {"\"a \\\" b\"", "\"a \\\" b\""},
                                          {"'c'", "'c'"},
                                          {"true", "true"},
                                          {"false", "false"},
                                          {"x", "x"},
                                          {"^end", "end"},
                                          {"E::L", "E::L"},
                                          {"result", "RESULT"},
                                          {"to", "TO"},
                                          {"from", "FROM"},
                                          {"R(|f = 1, g = a + b|)", "(record R [f = 1] [g = (+ a b)])"},
                                          {"<>", "(seq)"},
                                          {"<a, b + 1>", "(seq a (+ b 1))"},
                                          {"<-1, a * b>", "(seq (neg 1) (* a b))"},
                                          {"<(a > b)>", "(seq (paren (> a b)))"},
                                          {"{}", "(set)"},
                                          {"{1, 2}", "(set 1 2)"},
                                          {"{1 to n + 1}", "(set-to 1 (+ n 1))"},
                                          {"{v:nat}", "(set-of [v : nat] _ _)"},
                                          {"{v:nat | p}", "(set-of [v : nat] p _)"},
                                          {"{v:nat @ v + 1}", "(set-of [v : nat] _ (+ v 1))"},
                                          {"{v:nat, w:T | p @ e}", "(set-of [v : nat] [w : T] p e)"},
                                          {"(||)", "(tuple)"},
                                          {"(|a, 1|)", "(tuple a 1)"},
                                          {"[|1, 2|]", "(rows-of-2 1 2)"},
                                          {"[|1, 2; 3, 4|]", "(rows-of-2 1 2 3 4)"},
                                          {"[|1; 2|]", "(rows-of-1 1 2)"},
                                          {"[a, b]", "(range[] a b)"},
                                          {"[a, b)", "(range[) a b)"},
                                          {"(a, b]", "(range(] a b)"},
                                          {"(a, b)", "(range() a b)"},
                                          {"inverse(m)", "(inverse m)"},
                                          {"transpose(m)", "(transpose m)"},
                                          {"since(C)", "(since C)"},
                                          {"sinceEntry(A)", "(sinceEntry A)"},
                                          {"sinceEntry(A::B)", "(sinceEntry A::B)"},
                                          {"(a)", "(paren a)"},
                                          {"f()", "(call f)"},
                                          {"f(1, g(2))", "(call f 1 (call g 2))"},
                                          {"(f)(1)", "(call (paren f) 1)"}};
    return rows;
}

const std::vector<Row>& operators() {
    static const std::vector<Row> rows = {
        {"forall v:nat @ a iff b", "(forall [v : nat] _ (iff a b))"},
        {"forall v:nat, w:Set(T) | p @ q", "(forall [v : nat] [w : (Set T)] p q)"},
        {"exists v:nat | p @ q", "(exists [v : nat] p q)"},
        {"exists v:nat @ q", "(exists [v : nat] _ q)"},
        {"exists1 v:nat | p @ q", "(exists1 [v : nat] p q)"},
        {"exists1 v:nat @ q", "(exists1 [v : nat] _ q)"},
        {"lambda v:nat | p @ v + 1", "(lambda [v : nat] p (+ v 1))"},
        {"lambda v:nat @ forall w:nat @ p", "(lambda [v : nat] _ (forall [w : nat] _ p))"},
        {"a iff b iff c", "(iff (iff a b) c)"},
        {"a iff b => c", "(iff a (=> b c))"},
        {"a => b => c", "(=> (=> a b) c)"},
        {"a => b \\/ c", "(=> a (\\/ b c))"},
        {"a \\/ b \\/ c", "(\\/ (\\/ a b) c)"},
        {"a \\/ b /\\ c", "(\\/ a (/\\ b c))"},
        {"a /\\ b /\\ c", "(/\\ (/\\ a b) c)"},
        {"not a /\\ not not b", "(/\\ (not a) (not (not b)))"},
        {"not a == b", "(not (== a b))"},
        {"a == b != c", "(!= (== a b) c)"},
        {"a > b >= c < d <= e", "(<= (< (>= (> a b) c) d) e)"},
        {"a in s == b", "(== (in a s) b)"},
        {"a == b in s", "(in (== a b) s)"},
        {"the v:nat | p @ v == 1", "(== (the [v : nat] p v) 1)"},
        {"a == the v:nat @ v + 1", "(== a (the [v : nat] _ (+ v 1)))"},
        {"the v:nat @ let x == v @ x", "(the [v : nat] _ (let [x = v] x))"},
        {"let x == 1, y == a iff b @ x + y == 2", "(== (let [x = 1] [y = (iff a b)] (+ x y)) 2)"},
        {"let x == 1 @ let y == 2 @ x", "(let [x = 1] (let [y = 2] x))"},
        {"let x == 1 @ if a then x else 2 end", "(let [x = 1] (if a x 2))"},
        {"if a iff b then forall v:nat @ p else c end == d", "(== (if (iff a b) (forall [v : nat] _ p) c) d)"},
        {"x + 1 as nat == y", "(== (as (+ x 1) nat) y)"},
        {"x is Seq(nat) /\\ y", "(/\\ (is x (Seq nat)) y)"},
        {"x as A -> B == y", "(== (as x (-> A B)) y)"},
        {"a - b + c", "(+ (- a b) c)"},
        {"a - b * c", "(- a (* b c))"},
        {"a * b / c % d", "(% (/ (* a b) c) d)"},
        {"a * b cat c", "(* a (cat b c))"},
        {"a cat b cat c", "(cat (cat a b) c)"},
        {"a ^ (b)", "(cat a (paren b))"},
        {"a ^b", "(cat a b)"},
        {"-a cat - -b", "(cat (neg a) (neg (neg b)))"},
        {"-a.f", "(neg (.f a))"},
        {"a.f.g", "(.g (.f a))"},
        {"a[1].f", "(.f (index a 1))"},
        {"a[1, i + 1]", "(index a 1 (+ i 1))"},
        {"f(1)[2].g", "(.g (index (call f 1) 2))"},
        {"(a.f)[1]", "(index (paren (.f a)) 1)"},
        {"R(|f = 1|).f", "(.f (record R [f = 1]))"},
        {"<1>[1]", "(index (seq 1) 1)"},
        {"a<b", "(< a b)"},
        {"a<-1", "(< a (neg 1))"},
        {"f\n(1)", "(call f 1)"}};
    return rows;
}

const std::vector<Row>& types() {
    static const std::vector<Row> rows = {{"nat", "nat"},
                                          {"P::Q::T", "P::Q::T"},
                                          {"?X", "?X"},
                                          {"(T)", "T"},
                                          {"Seq(nat)", "(Seq nat)"},
                                          {"Set(Seq(real))", "(Set (Seq real))"},
                                          {"A * B * C", "(* A B C)"},
                                          {"(A * B) * C", "(* (* A B) C)"},
                                          {"A * (B * C)", "(* A (* B C))"},
                                          {"A -> B -> C", "(-> A (-> B C))"},
                                          {"(A -> B) -> C", "(-> (-> A B) C)"},
                                          {"A * B -> C", "(-> (* A B) C)"},
                                          {"A <-> B", "(<-> A B)"},
                                          {"A -> B <-> C * D", "(<-> (-> A B) (* C D))"},
                                          {"A <-> B <-> C", "(<-> A (<-> B C))"},
                                          {"(A <-> B) -> C", "(-> (<-> A B) C)"},
                                          {"vector(real, 3)", "(vector real 3)"},
                                          {"vector(A -> B, (n + 1))", "(vector (-> A B) (paren (+ n 1)))"},
                                          {"matrix(int, 2, n)", "(matrix int 2 n)"},
                                          {"vector(real, 3) * A", "(* (vector real 3) A)"},
                                          {"A * (vector(real, 3))", "(* A (vector real 3))"}};
    return rows;
}

const std::vector<Row>& statements() {
    static const std::vector<Row> rows = {{"skip", "(skip)"},
                                          {"skip; e; skip", "(seq (skip) ({e}) (skip))"},
                                          {"(skip; e)", "(paren (seq (skip) ({e})))"},
                                          {"skip <{3}", "(within 3 (skip))"},
                                          {"skip <{a + 1}; e", "(seq (within (+ a 1) (skip)) ({e}))"},
                                          {"(skip; e) <{3}", "(within 3 (paren (seq (skip) ({e}))))"},
                                          {"if a then e end", "(if a ({e}))"},
                                          {"if a then e; e else skip end", "(if a (seq ({e}) ({e})) (skip))"},
                                          {"if a then if b then e else skip end end", "(if a (if b ({e}) (skip)))"},
                                          {"if a then e end <{2}", "(within 2 (if a ({e})))"},
                                          {"op()", "(call op)"},
                                          {"op(1, x + 1)", "(call op 1 (+ x 1))"},
                                          {"P::op(1)", "(call P::op 1)"},
                                          {"v = e + 1", "(= v (+ e 1))"},
                                          {"v.f = e", "(= (.f v) e)"},
                                          {"v[1, 2] = e", "(= (index v 1 2) e)"},
                                          {"v[1].f[2].g = e", "(= (.g (index (.f (index v 1)) 2)) e)"},
                                          {"v = forall x:nat @ p", "(= v (forall [x : nat] _ p))"},
                                          {"wait(2)", "(wait 2)"},
                                          {"wait([1, n])", "(wait-between 1 n)"},
                                          {"wait({1, 2})", "(wait (set 1 2))"},
                                          {"wait((1, 2])", "(wait (range(] 1 2))"},
                                          {"#C", "(# C)"},
                                          {"#C; #D", "(seq (# C) (# D))"},
                                          {"e", "({e})"},
                                          {"send e", "(send {e})"},
                                          {"send e!1", "(send {e!1})"},
                                          {"e?x", "({e?x})"},
                                          {"e?P::x", "({e?P::x})"},
                                          {"e!1", "({e!1})"},
                                          {"e!f(x)", "({e!(call f x)})"},
                                          {"e!(x + 1)", "({e!(paren (+ x 1))})"},
                                          {"e!E::L", "({e!E::L})"},
                                          {"e!<1>", "({e!(seq 1)})"},
                                          {"e.1", "({e.1})"},
                                          {"e.x", "({e.x})"},
                                          {"e.f(1)", "({e.(call f 1)})"},
                                          {"e[||]", "({e})"},
                                          {"e[|x = from|]?y", "({e?y from-into x})"},
                                          {"e[|x = from | x > 1|]", "({e from-into x such-that (> x 1)})"},
                                          {"e[|from == 2|]!1", "({e!1 such-that (== FROM 2)})"},
                                          {"e[|to == a|]", "({e such-that (== TO a)})"},
                                          {"^end!1", "({end!1})"}};
    return rows;
}

const std::vector<Row>& clauses() {
    static const std::vector<Row> rows = {
        {"", ""},
        {"trigger e", "trigger e"},
        {"trigger e?x", "trigger e?x"},
        {"trigger e!1", "trigger e!1"},
        {"trigger e.1", "trigger e.1"},
        {"trigger e[|x = from | x > 1|]?y", "trigger e[|x = from | x > 1|]?y"},
        {"probability 0.5", "probability 0.5"},
        {"#C #D", "#C; #D"},
        {"<{ a + 1 }", "<{a + 1}"},
        {"condition else", "condition else"},
        {"condition a /\\ b", "condition a /\\ b"},
        {"action skip; e", "action skip; e"},
        {"trigger e #C #D <{ 3 } condition a action skip", "trigger e; #C; #D; <{3}; condition a; action skip"},
        {"probability 1 condition else action skip", "probability 1; condition else; action skip"}};
    return rows;
}

const std::vector<Row>& declarations() {
    static const std::vector<Row> rows = {
        {"package A::B import C import D::E::*", "package A::B / import C / import D::E::*"},
        {"diagram D type T diagram E", "type T"},
        {"import P::* diagram D type T", "import P::* / type T"},
        {"type T", "type T"},
        {"datatype R { a:nat b:T * U }", "datatype R / >field a:nat / >field b:T * U"},
        {"record R { a:nat }", "datatype R / >field a:nat"},
        {"datatype R { }", "datatype R"},
        {"enumeration E { L1 L2(nat, Seq(T)) ^end }",
         "enumeration E / >literal L1 / >literal L2(nat, Seq(T)) / >literal end"},
        {"function f(a:nat, b:E):Set(nat) { }", "function f(a:nat, b:E):Set(nat)"},
        {"function f():nat { precondition true postcondition result == 1 precondition false }",
         "function f():nat / >precondition true / >precondition false / >postcondition result == 1"},
        {"interface I { op() op2(p:nat, q:T)[terminates] }", "interface I / >op() / >op2(p:nat, q:T) [terminates]"},
        {"interface I { event e _broadcast event b:nat event f:A -> B }",
         "interface I / >event e / >_broadcast event b:nat / >event f:A -> B"},
        {"interface I { var a:nat, b:T = x + 1 const c:real, d:nat = 2 clock C }",
         "interface I / >variable a:nat / >variable b:T = x + 1 / >constant c:real / >constant d:nat = 2 / >clock "
         "C"},
        {"robotic platform R { uses A provides B::C requires D var v:nat const c:nat op(p:nat) event e }",
         "robotic platform R / >uses A / >provides B::C / >requires D / >variable v:nat / >constant c:nat / >event "
         "e / >op(p:nat)"},
        {"controller C { uses A provides B requires D var v:nat event e }",
         "controller C / >uses A / >provides B / >requires D / >variable v:nat / >event e"},
        {"controller C { operation O() { } opref o = P::O stm S { } sref s = P::S }",
         "controller C / >operation O() / >operation reference o = P::O / >state machine S / >state machine "
         "reference s = P::S"},
        {"controller C { connection C on e to S on f connection S on f to C on e (_async) connection C on e to S on "
         "f [mult] "
         "connection C on e to S on f (_async) [mult] }",
         "controller C / >connection C on e to S on f / >connection S on f to C on e (_async) / "
         ">connection C on e to S on f [mult] / >connection C on e to S on f (_async) [mult]"},
        {"module M { robotic platform R { } controller C { } stm S { } }",
         "module M / >robotic platform R / >controller C / >state machine S"},
        {"module M { rref r = R cref c = P::C sref s = S connection r on e to c on e (_async) }",
         "module M / >robotic platform reference r = R / >controller reference c = P::C / >state machine reference "
         "s = S / "
         ">connection r on e to c on e (_async)"},
        {"stm S { uses A provides B requires D var v:nat event e clock C initial i final f junction j probabilistic "
         "p }",
         "state machine S / >uses A / >provides B / >requires D / >variable v:nat / >event e / >clock C / >initial "
         "junction "
         "i / "
         ">final state f / >junction j / >probabilistic junction p"},
        {"stm S { state a { state b { } initial i transition t { from i to b } entry skip during e exit e!1 } }",
         "state machine S / >state a / >>entry skip / >>during e / >>exit e!1 / >>state b / >>initial junction i / "
         ">>transition t: i -> b"},
        {"operation O(p:nat, q:T) { terminates precondition p > 0 postcondition true uses A var v:nat event e clock "
         "C initial i }",
         "operation O(p:nat, q:T) / >terminates / >precondition p > 0 / >postcondition true / >uses A / >variable "
         "v:nat / "
         ">event e / >clock C / >initial junction i"},
        {"operation O() { }", "operation O()"},
        {"/* a */ type T // b\n/* c\n*/ type U", "type T / type U"}};
    return rows;
}

const std::vector<Row>& assertions() {
    static const std::vector<Row> rows = {
        {"assertion A: M::c::s is deadlock-free", "A: M::c::s deadlock-free"},
        {"timed assertion A: X is not divergence-free.", "timed A: X not divergence-free"},
        {"untimed assertion A: X is deterministic", "untimed A: X deterministic"},
        {"assertion A: X is not timelock-free .", "A: X not timelock-free"},
        {"assertion A: X terminates", "A: X terminates"},
        {"assertion A: X does not terminate.", "A: X not terminates"},
        {"assertion A: X refines Y in the traces model.", "A: X refines Y in T"},
        {"assertion A: X does not refine Y in the failures model", "A: X not refines Y in F"},
        {"assertion A: X equals Y in the failures divergences model", "A: X equals Y in FD"},
        {"assertion A: X is not equal to Y in the tick-tock model.", "A: X not equals Y in TT"},
        {"assertion A: S::s is reachable in S", "A: S reachable S::s"},
        {"assertion A: S::s is not reachable in M::c::S.", "A: M::c::S not reachable S::s"},
        {"assertion A: clock S::C is initialised", "A: clock S::C"},
        {"assertion A: clock S::C is not initialised", "A: not clock S::C"},
        {"assertion A: event e is not missed in S::s", "A: not event e S::s"},
        {"timed assertion A: event e is missed in S for 3 time units.", "timed A: event e S for 3"},
        {"sleec assertion A: M::c conforms to R1", "timed A: M::c conforms R1"},
        {"timed sleec assertion A: X does not conform to R1.", "timed A: X not conforms R1"},
        {"assertion A: X terminates with constant k of S assigned 1", "A: X terminates c:k@S=1"},
        {"assertion A: X terminates with constant k of S set to 1 + 2.", "A: X terminates c:k@S=(+ 1 2)"},
        {"assertion A: X terminates with parameter p of O with value E::L.", "A: X terminates p:p@O=E::L"},
        {"assertion A: X terminates with constant a of S set to 1 and constant b of T set to 2.",
         "A: X terminates c:a@S=1 c:b@T=2"},
        {"assertion A: X terminates with constant a of S set to 1, constant b of S set to 2, and parameter c of O "
         "assigned 3 "
         "assertion B: X terminates",
         "A: X terminates c:a@S=1 c:b@S=2 p:c@O=3 / B: X terminates"},
        {"assertion A: X refines Y in the traces model with constant a of S set to r.f.",
         "A: X refines Y in T c:a@S=(.f r)"},
        {"csp P csp-begin P = STOP -- x\ncsp-end", "csp P [ P = STOP -- x\n]"},
        {"timed csp P associated to M, N::S csp-begin P = {- } -} csp- end csp-end",
         "csp P [ P = {- } -} csp- end ] M N::S"},
        {"package Q import A::* assertion A: X terminates", "A: X terminates"},
        {"instantiate P::T as [0, 3] assertion A: X terminates", "A: X terminates / instantiate P::T as [0, 3]"},
        {"const c : nat", "const c : nat"},
        {"constants C: M::s::k set to 1, and M::s::l from set {1 to 3 by step 2}",
         "constants C : M::s::k set to 1, M::s::l from set {1 to 3 by step 2}"},
        {"constants C: k from set {1,2}", "constants C : k from set {1, 2}"},
        {"label l = M::s is in M::s::t assertion A: X terminates", "A: X terminates / label l = M::s is in M::s::t"},
        {"formula f = $g + 1 /\\ #l", "formula f = $g + 1 /\\ #l"},
        {"rewards r = [e.in] true : 1; x : y; endrewards rewards s = [] v > 1 : 2; endrewards label l = 1",
         "rewards r = [e.in] true : 1; x : y; endrewards / rewards s = [] v > 1 : 2; endrewards / label l = 1"},
        {"prob property p: Prob>0.5 of [Finally #l] with constants M::k set to 1 prob generate path q: using "
         "simulation for 10 steps",
         "prob property p : Prob>0.5 of [Finally #l] with constants M::k set to 1 / prob generate path q : using "
         "simulation for 10 steps"},
        {"prob property p: Prob=? of [Finally #l]\nwith\nconstants C\nwith definitions pfunction f() = { return $$x "
         "+ 1 }",
         "prob property p : Prob=? of [Finally #l] with constants C with definitions pfunction f() = { return $$x + 1 "
         "}"},
        {"defs d: poperation o(x) = { (y = 1) } pmodules m: pmodule n { v: bool; [] @v -> skip; }",
         "defs d : poperation o(x) = { (y = 1) } / pmodules m : pmodule n { v : bool; [] @v -> skip; }"},
        {"pmodules m: pmodule n { v: [-1 to 2] init 0; [a::e.out] @v==1 -> (0.5:@v=2)&(@m::n::v=-1); }",
         "pmodules m : pmodule n { v : [-1 to 2] init 0; [a::e.out] @v == 1 -> (0.5 : @v = 2) & (@m::n::v = -1); }"},
        {"prob property p: Prob min=? of [a Until <=t b] with definitions D with modules M with cmdoptions \"-x\"",
         "prob property p : Prob min=? of [a Until <=t b] with definitions D with modules M with cmdoptions \"-x\""},
        {"prob property p: Reward{r}max=? of [Cumul 3] prob property q: Reward<=2 of [Reachable x] "
         "prob property s: Reward=? of [Total] prob property t: Reward=? of [LTL Globally x]",
         "prob property p : Reward {r} max=? of [Cumul 3] / prob property q : Reward<=2 of [Reachable x] / "
         "prob property s : Reward=? of [Total] / prob property t : Reward=? of [LTL Globally x]"},
        {"prob property p: Prob=? of [Globally [1,3] Weak Until x] using sim with APMC at epsilon=0.1, delta=0.2, and "
         "n=5",
         "prob property p : Prob=? of [Globally [1, 3] Weak Until x] using sim with APMC at epsilon = 0.1, delta = "
         "0.2, n = 5"},
        {"prob property p: not Exists [Release Next a::e.in.val == E::l iff &f(1)]",
         "prob property p : not Exists [Release Next a::e.in.val == E::l iff &f(1)]"},
        {"prob generate path p: using simulation for deadlock with 3 repeats up to 9 steps with constants C",
         "prob generate path p : using simulation for deadlock with 3 repeats up to 9 steps with constants C"},
        {"label \"l\" = x;\nassertion A: X terminates", "A: X terminates / label \"l\" = x;"}};
    return rows;
}

const std::vector<Row>& refused() {
    static const std::vector<Row> rows = {
        // levels of operators
        {IN_GUARD("a /\\ forall v:nat @ p"), "RC-P15@1"},
        {IN_GUARD("a == not b"), "RC-P15@1"},
        {IN_GUARD("a + the v:nat @ v"), "RC-P15@1"},
        {IN_GUARD("1 + let x == 1 @ x"), "RC-P15@1"},
        {IN_GUARD("1 + if a then 1 else 2 end"), "RC-P15@1"},
        {IN_GUARD("let x == 1 @ the v:nat @ v"), "RC-P15@1"},
        {IN_GUARD("if a then 1 else 2 end + 1 == 2"), "RC-P26@1"},
        {IN_GUARD("x as nat as int"), "RC-P26@1"},
        {IN_GUARD("a.f[1]"), "RC-P26@1"},
        {IN_GUARD("a[1][2]"), "RC-P26@1"},
        {IN_GUARD("f(1)(2)"), "RC-P26@1"},
        {IN_GUARD("<a, b == c>"), "RC-P26@1"},
        {IN_GUARD("<a as nat>"), "RC-P26@1"},
        {IN_GUARD("<if a then 1 else 2 end>"), "RC-P15@1"},
        {IN_GUARD("a = b"), "RC-P21@1"},
        {IN_GUARD("a && b"), "RC-P24@1"},
        {IN_GUARD("a || b"), "RC-P24@1"},
        {IN_GUARD("!a"), "RC-P24@1"},
        {IN_GUARD("let x = 1 @ x == 1"), "RC-P21@1"},
        {IN_GUARD("R(||)"), "RC-P01@1"},
        {IN_GUARD("[||] == x"), "RC-P01@1"},
        {IN_GUARD("forall v @ p"), "RC-P01@1"},
        {IN_GUARD("forall v:nat = 1 @ p"), "RC-P01@1"},
        {IN_GUARD("since(S::C) > 1"), "RC-P25@1"},
        // types
        {IN_TYPE("Set (nat)"), "RC-P10@1"},
        {IN_TYPE("Seq (nat)"), "RC-P10@1"},
        {IN_TYPE("A * vector(B, 2)"), "RC-P26@1"},
        {IN_TYPE("vector(A)"), "RC-P01@1"},
        {IN_TYPE("A ->"), "RC-P01@1"},
        // statements
        {IN_ENTRY("e!x+1"), "RC-P12@1"},
        {IN_ENTRY("e!-1"), "RC-P12@1"},
        {IN_ENTRY("e!x.f"), "RC-P12@1"},
        {IN_ENTRY("e!x[1]"), "RC-P12@1"},
        {IN_ENTRY("e;"), "RC-P29@1"},
        {IN_ENTRY("e f"), "RC-P01@1"},
        {IN_ENTRY("v := 1"), "RC-P22@1"},
        {IN_ENTRY("if a then e"), "RC-P01@1"},
        {IN_ENTRY("S::e!1"), "RC-P25@1"},
        {IN_ENTRY("#S::C"), "RC-P25@1"},
        {IN_ENTRY("send op(1)"), "RC-P01@1"},
        {IN_ENTRY("skip <{1} <{2}"), "RC-P01@1"},
        // transitions
        {"stm S { transition t { to b from a } }", "RC-P01@1"},
        {"stm S { transition t { from a to b condition a trigger e } }", "RC-P18@1"},
        {"stm S { transition t { from a to b trigger e probability 1 } }", "RC-P28@1"},
        {"stm S { transition t { from a to b condition a <{ 1 } } }", "RC-P18@1"},
        {"stm S { transition t { from S::a to b } }", "RC-P25@1"},
        {"stm S { transition t { from a to b trigger #C condition x } }", "RC-P09@1"},
        {"stm S { transition t { from a to b trigger\n condition x } }", "RC-P09@1"},
        {"stm S { transition t { from a to b trigger } }", "RC-P09@1"},
        // declarations
        {"type A package P", "RC-P16@1"},
        {"package P package Q", "RC-P16@1"},
        {"enumeration E { A, B }", "RC-P34@1"},
        {"datatype R { a:nat, b:nat }", "RC-P34@1"},
        {"datatype R { a:nat = 1 }", "RC-P01@1"},
        {"stm end { }", "RC-P11@1"},
        {"interface I { uses J }", "RC-P01@1"},
        {"interface I { state s { } }", "RC-P01@1"},
        {"module M { opref o = O }", "RC-P01@1"},
        {"controller C { cref c = D }", "RC-P01@1"},
        {"controller C { state s { } }", "RC-P01@1"},
        {"stm S { uses A, B }", "RC-P30@1"},
        {"module M { connection a on e to b on f _async }", "RC-P34@1"},
        {"module M { connection a on e to b on f [mult] (_async) }", "RC-P01@1"},
        {"module M { connection M::a on e to b on f }", "RC-P25@1"},
        {"type A }", "RC-P19@1"},
        {"operation O { }", "RC-P01@1"},
        {"function f() { }", "RC-P01@1"},
        {"import P::*::Q", "RC-P01@1"},
        // neural networks
        {"anncontroller N { params { layerstructure <1,1> weights <<< 0.0>>> } } type T", "RC-P27@1"},
        {"module M { anncontroller N { } controller C { } }", "RC-P27@1"},
        {"controller C { annoperation N(x:real) { } stm S { } }", "RC-P27@1"},
        // assertions
        {"assertion A: X is deadlock free", "RC-P32@1"},
        {"assertion A: X refines Y in the tick tock model", "RC-P32@1"},
        {"timed assertion A: clock C is initialised", "RC-P31@1"},
        {"assertion A: X terminates with constant a of S set to 1, constant b of S set to 2", "RC-P17@1"},
        {"assertion A: X does terminate", "RC-P01@1"},
        {"assertion A: X is not equal Y", "RC-P01@1"},
        {"assertion A: X refines Y in the stable model", "RC-P01@1"},
        {"assertion A X terminates", "RC-P01@1"},
        {"sleec assertion A: X conforms R", "RC-P01@1"},
        {"sleec assertion A: X does conform to R", "RC-P01@1"},
        {"untimed sleec assertion A: X conforms to R", "RC-P01@1"},
        {"assertion A: X is zeno-free\nassertion B: X terminates", "RC-P01@1"},
        {"timed rewards r = true : 1; endrewards", "RC-P01@1"}};
    return rows;
}

}  // namespace robochart::frontend::testing
