// SPDX-License-Identifier: Apache-2.0
// Tests every construct that the front end accepts: it has untimed and timed CSP, which parses to the same tree and
// type checks, or a named rule rejects it. Constructs that the front end rejects are listed with the rule. Each row
// adds one construct of RoboChart's grammar to the same model, so a failure identifies its construct.
#include <gtest/gtest.h>

#include "base/diagnostics/render.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::constructs_test {
namespace {

/// The position of a row's text in the model.
enum class At { action, condition, expression, transition, machine, state, package, platform };

struct Row {
    At at;
    std::string text;
    std::string refusal = {};  ///< part of the message of a rejection; empty if accepted
};

std::string model_with(const Row& row) {
    const auto in = [&](At at) { return row.at == at ? row.text : std::string(); };
    const std::string action = row.at == At::action ? row.text : "skip";
    const std::string condition = row.at == At::condition ? "condition " + row.text : "";
    const std::string use =
        row.at == At::expression ? "state U { entry seen ! (" + row.text + " == " + row.text + ") }" : "";
    return R"(
        import set_toolkit::* import relation_toolkit::* import function_toolkit::* import sequence_toolkit::*
        type Given
        enumeration Colour { red green mixed(nat, boolean) }
        record Pair { one : nat two : boolean }
        datatype Nested { pair : Pair colour : Colour }
        function twice(n : nat) : nat { precondition n < 2 postcondition result == n + n }
        function open(n : nat) : nat { }
        function same(x : ?X) : ?X { postcondition result == x }
        interface Events { event plain event number : nat event flag : boolean event other : nat event seen : boolean }
        interface Calls { go() run(speed : nat, hot : boolean) [ terminates ] defined(n : nat) bodiless() }
        interface Shared { var shared : nat }
        interface Timer { clock T }
        operation defined(n : nat) { requires Shared var l : nat initial i final f transition t { from i to f action shared = n } }
        operation bodiless() { }
    )" + in(At::package) +
           R"(
        stm S {
            uses Events requires Calls requires Shared uses Timer
            const k : nat const set_to : nat = 1
            var n : nat = 1 var z : int var r : real var b : boolean var c : Colour var g : Given var p : Pair
            var q : Nested var s : Seq(nat) var e : Set(nat) var t : nat * boolean var m : nat * nat * nat
            var f : nat -> nat var rel : nat <-> boolean var v : vector(int, 2) var w : matrix(int, 2, 2) var text : string
        )" +
           in(At::machine) +
           R"(
            initial i
            state A { )" +
           in(At::state) + R"( }
            state B { }
            )" +
           use + "transition t0 { from i to A } transition t1 { from A to B " + in(At::transition) + " " + condition +
           " action " + action + " } " + (use.empty() ? "" : "transition t2 { from B to U }") + R"( }
        controller C {
            uses Events requires Calls var shared : nat opref d = defined opref n = bodiless sref s = S
            connection s on seen to C on seen
        }
        robotic platform R { uses Events provides Calls )" +
           in(At::platform) + R"( }
        module M { rref r = R cref c = C connection c on seen to r on seen (_async) }
    )";
}

/// Describes the problem with the row, or returns "" if there is none.
std::string check_row(const Row& row, Time time) {
    const auto m = testing::load_model(model_with(row));
    if (!m->diagnostics.ok()) return m->messages();
    const Emission emission = m->emit(time, true);
    if (!m->diagnostics.ok()) return m->messages();
    diagnostics::Diagnostics findings;
    const cspm::Script again =
        cspm::read(m->sources, m->sources.add("printed.csp", cspm::print(emission.script)), findings);
    if (!equal(again, emission.script)) return "reads back as another script";
    cspm::check_types(again, findings);
    return findings.ok() ? "" : diagnostics::render_text(m->sources, findings);
}

void check_rows(const std::vector<Row>& rows) {
    for (const Row& row : rows) {
        for (const Time time : {Time::untimed, Time::timed}) {
            const std::string what = check_row(row, time);
            if (row.refusal.empty())
                EXPECT_EQ(what, "") << row.text;
            else
                EXPECT_NE(what.find(row.refusal), std::string::npos) << row.text << "\n" << what;
        }
    }
}

TEST(Constructs, Statements) {
    check_rows(
        {{At::action, "skip"},
         {At::action, "n = 2"},
         {At::action, "n = n + 1 ; z = n - 2"},
         {At::action, "p.one = 2"},
         {At::action, "q.pair.two = true"},
         {At::action, "s[1] = 2"},
         {At::action, "v[1] = 2"},
         {At::action, "w[1, 2] = 2"},
         {At::action, "t[1] = 0"},
         {At::action, "shared = shared + 1"},
         {At::action, "plain"},
         {At::action, "send plain"},
         {At::action, "number ! n"},
         {At::action, "number ! (n + 1)"},
         {At::action, "number . n"},
         {At::action, "other ? n"},
         {At::action, "other [| n > 0 |] ? n"},
         {At::action, "number [| b |] ! n", "a condition on a communication that receives no value in an action"},
         {At::action, "go()"},
         {At::action, "run(n, b)"},
         {At::action, "defined(n)"},
         {At::action, "bodiless()"},
         {At::action, "if b then n = 1 else n = 2 end"},
         {At::action, "if b then plain end"},
         {At::action, "(n = 1 ; plain)"},
         {At::action, "wait(2)"},
         {At::action, "wait([1, 2])"},
         {At::action, "#T"},
         {At::action, "plain <{ 2 }"},
         {At::action, "(go() ; wait(1)) <{ 2 }"},
         {At::action, "defined(n) <{ 1 }"},
         {At::state, "entry n = 1 during plain exit number ! n"},
         {At::state, "initial j state D { } final g transition d0 { from j to D } transition d1 { from D to g }"},
         {At::state, "entry defined(1) during defined(2) exit defined(0)"}});
}

TEST(Constructs, Conditions) {
    check_rows({{At::condition, "true"},
                {At::condition, "b /\\ not b \\/ b"},
                {At::condition, "b => b"},
                {At::condition, "b iff b"},
                {At::condition, "n == 1 /\\ n != 2 /\\ n < 2 /\\ n <= 2 /\\ n > 0 /\\ n >= 0"},
                {At::condition, "n in e"},
                {At::condition, "forall x : nat @ x >= 0"},
                {At::condition, "exists x : nat | x > 0 @ x == n"},
                {At::condition, "exists1 x : nat @ x == n"},
                {At::condition, "since(T) >= 2"},
                {At::condition, "sinceEntry(A) > 1 /\\ n == 0"},
                {At::condition, "c is Colour"},
                {At::condition, "twice(n) == 2"},
                {At::condition, "open(n) == 0"},
                {At::condition, "n in [0, 2)"},
                {At::condition, "k > set_to"},
                {At::condition, "shared > 0"}});
}

TEST(Constructs, Expressions) {
    check_rows({{At::expression, "1"},
                {At::expression, "1.5"},
                {At::expression, "true"},
                {At::expression, "\"text\""},
                {At::expression, "Colour::red"},
                {At::expression, "green"},
                {At::expression, "Colour::mixed(1, true)"},
                {At::expression, "n + 1 - 2 * 3 / 1 % 2"},
                {At::expression, "-z"},
                {At::expression, "r * 0.5"},
                {At::expression, "p.one"},
                {At::expression, "Pair(| one = 1, two = true |)"},
                {At::expression, "(| 1, true |)"},
                {At::expression, "t[1]"},
                {At::expression, "<1, 2>"},
                {At::expression, "s ^ <1>"},
                {At::expression, "s cat s"},
                {At::expression, "s[1]"},
                {At::expression, "{1, 2}"},
                {At::expression, "{1 to 3}"},
                {At::expression, "{x : nat | x > 0 @ x + 1}"},
                {At::expression, "the x : nat | x == 1 @ x"},
                {At::expression, "let x == n, y == 2 @ x + y"},
                {At::expression, "if b then 1 else 2 end"},
                {At::expression, "n as int"},
                {At::expression, "(lambda x : nat @ x + 1)(1)"},
                {At::expression, "f(1)"},
                {At::expression, "f"},
                {At::expression, "twice"},
                {At::expression, "rel"},
                {At::expression, "[| 1, 2 |]"},
                {At::expression, "[| 1, 2; 3, 4 |]"},
                {At::expression, "v + v"},
                {At::expression, "w * v"},
                {At::expression, "transpose(w)"},
                {At::expression, "inverse(w)", "inverse(..)"},
                {At::expression, "same(1)"},
                {At::expression, "same(true)"},
                {At::expression, "same(same(b))"},
                {At::expression, "size(s)"},
                {At::expression, "head(s)"},
                {At::expression, "union(e, {1})"},
                {At::expression, "dom(rel)"},
                {At::expression, "rinv(rel)"},
                {At::expression, "isInjection(f)"},
                {At::expression, "size", "as a value"},
                {At::expression, "iter(1, {})", "of elements whose type nothing tells"}});
}

TEST(Constructs, Transitions) {
    check_rows(
        {{At::transition, "trigger plain"},
         {At::transition, "trigger other ? n"},
         {At::transition, "trigger other ? n condition n > 0"},
         {At::transition, "trigger other [| n > 0 |] ? n"},
         {At::transition, "trigger plain [| n > 0 |]"},
         {At::transition, "trigger other ! n", "error[T2]"},
         {At::transition, "trigger other . n", "error[T2]"},
         {At::transition, "trigger plain #T"},
         {At::transition, "trigger plain <{ 2 }"},
         {At::transition, "#T condition n == 1"},
         {At::transition, "<{ 2 } condition n == 1", "error[TT1]"},
         {At::transition, "condition else"},
         {At::machine,
          "state X { } junction x transition x0 { from B to x } transition x1 { from x to X condition b } "
          "transition x2 { from x to B condition else }"},
         {At::machine,
          "probabilistic x transition x0 { from B to x } transition x1 { from x to A probability 0.5 } "
          "transition x2 { from x to B probability 0.5 }"},
         {At::machine, "final g transition x0 { from B to g }"},
         {At::machine, "clock K"},
         {At::machine, "_broadcast event all transition x0 { from B to A trigger all }", "broadcast event all"}});
}

TEST(Constructs, Declarations) {
    check_rows(
        {{At::package, "type Another"},
         {At::package, "enumeration One { only }"},
         {At::package, "function none() : nat { }"},
         {At::package, "interface Constants { const a : nat, second : real = 0.5 }"},
         {At::package, "stm Other { event z : Seq(nat * Colour) initial i state A { } transition t { from i to A } }"},
         {At::package,
          "stm Fn { var h : Colour -> boolean event z : Colour -> boolean initial i state A { } "
          "transition t { from i to A action z ! h } }"},
         {At::package,
          "operation lone(n : nat) { terminates uses Events initial i final f transition t { from i to f "
          "action number ! n } }"},
         {At::package,
          "operation timed_one(n : nat) { requires Timer initial i final f transition t { from i to f "
          "condition since(T) > n } }"},
         {At::platform, "var local : nat = 1"},
         {At::platform, "const fixed : nat = 1"}});
}

}  // namespace
}  // namespace robochart::csp_emit::constructs_test
