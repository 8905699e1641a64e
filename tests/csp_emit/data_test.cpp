// SPDX-License-Identifier: Apache-2.0
// Compares the values of expressions in the script with those of the evaluator of the semantics. The expected values
// follow from the contracts of the libraries (frontend/toolkits/library) and from the rules for finite types (semantics
// 3.13).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/syntax/reader.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/ir/visit.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::data_test {
namespace {

using testing::check_equivalence;
using ::testing::Contains;
using ::testing::HasSubstr;
using testing::load_model;

/// A RoboChart expression and its value: a number, or true or false.
struct Case {
    const char* expression;
    const char* value;
};

const char* const declarations = R"(
import set_toolkit::*
import relation_toolkit::*
import function_toolkit::*
import sequence_toolkit::*

record Place { x : int y : int }
enumeration Colour { red green(int) }
function below(n : int) : int { postcondition result == n - 1 }
function any(n : int) : int { postcondition result > 0 }
function constant(n : int) : int { }
function nothing() : int { }
function down(n : nat) : int { postcondition n == 0 => result == 2 postcondition n > 0 => result == down((n - 1) as nat) }
function chosen(a : Set(?X)) : ?X { precondition a != {} postcondition result in a }
function positive(n : int) : int { precondition n > 0 postcondition result == n }
)";

bool is_truth(const Case& item) {
    return std::string(item.value) == "true" || std::string(item.value) == "false";
}

std::string machine_of(const std::vector<Case>& cases) {
    std::string actions;
    for (const Case& item : cases)
        actions +=
            std::string(actions.empty() ? "" : " ; ") + (is_truth(item) ? "t" : "m") + " ! (" + item.expression + ")";
    return std::string(declarations) +
           "stm S {\n var p : Place , c : Colour , s : Seq(int) , r : nat <-> int , v : vector(int, 2)\n"
           " event m : int event t : boolean\n initial i\n state A { entry " +
           actions + " }\n transition t0 { from i to A }\n}\n";
}

std::string specification_of(const std::vector<Case>& cases) {
    std::string text = "Spec = ";
    for (const Case& item : cases)
        text += std::string("S::") + (is_truth(item) ? "t" : "m") + ".out.(" + item.value + ") -> ";
    return text + "STOP";
}

/// Returns the evaluator's values for the outputs of the machine, in order.
std::vector<std::string> evaluate_outputs(const testing::Model& m) {
    std::vector<std::string> result;
    const ir::Machine& machine = m.system.machines.front();
    ir::Environment environment;
    for (const ir::Variable& variable : machine.variables)
        environment.variables.push_back(ir::default_value(m.system, m.instantiation, variable.type));
    ir::visit_statements(machine, [&](const ir::Stmt& stmt) {
        if (stmt.kind != ir::StmtKind::communicate) return;
        const ir::Expr& expr = *stmt.communication.value;
        const auto value = ir::evaluate_expression(m.system, m.instantiation, &machine, environment, expr).number;
        if (m.system.type(expr.type).kind == ir::TypeKind::boolean)
            result.emplace_back(value != 0 ? "true" : "false");
        else
            result.push_back(std::to_string(value));
    });
    return result;
}

void expect_values(const std::vector<Case>& cases) {
    const auto m = load_model(machine_of(cases));
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::vector<std::string> values = evaluate_outputs(*m);
    ASSERT_EQ(values.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(values[i], cases[i].value) << cases[i].expression;
    EXPECT_EQ(check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", specification_of(cases)), "holds")
        << m->messages();
}

TEST(Data, Sets) {
    expect_values({{"size(union({1}, {1, 2}))", "2"},
                   {"size(inter({0, 1}, {1, 2}))", "1"},
                   {"diff({0, 1}, {1, 2}) == {0}", "true"},
                   {"symetric_diff({0, 1}, {1, 2}) == {0, 2}", "true"},
                   {"notin(1, {1})", "false"},
                   {"subseteq({1}, {1, 2})", "true"},
                   {"subset({1, 2}, {1, 2})", "false"},
                   {"Union({{0}, {1}}) == {0, 1}", "true"},
                   {"Inter({{0, 1}, {1}}) == {1}", "true"},
                   {"size({})", "0"},
                   {"1 in {0 to 2}", "true"},
                   {"min({2, 1})", "1"},
                   {"max({-1, 0})", "0"},
                   {"hasMin({1})", "true"},
                   {"size({x : nat | x > 0 @ x})", "2"},
                   {"{x : nat | x > 0 @ x + 1} == {2}", "true"}});
}

TEST(Data, Relations) {
    expect_values({{"first((|1, 2|))", "1"},
                   {"second((|1, 2|))", "2"},
                   {"maplet(1, 2) == (|1, 2|)", "true"},
                   {"dom({(|0, 1|), (|1, 1|)}) == {0, 1}", "true"},
                   {"ran({(|0, 1|), (|1, 1|)}) == {1}", "true"},
                   {"relcomp({(|0, 1|)}, {(|1, 2|)}) == {(|0, 2|)}", "true"},
                   {"dres({0}, {(|0, 1|), (|1, 1|)}) == {(|0, 1|)}", "true"},
                   {"rres({(|0, 1|), (|1, 2|)}, {2}) == {(|1, 2|)}", "true"},
                   {"dsub({0}, {(|0, 1|), (|1, 1|)}) == {(|1, 1|)}", "true"},
                   {"rsub({(|0, 1|), (|1, 2|)}, {2}) == {(|0, 1|)}", "true"},
                   {"rinv({(|0, 1|)}) == {(|1, 0|)}", "true"},
                   {"rimage({(|0, 1|), (|1, 2|)}, {1}) == {2}", "true"},
                   {"override({(|0, 1|), (|1, 2|)}, {(|1, 0|)}) == {(|0, 1|), (|1, 0|)}", "true"},
                   {"tr_closure({(|0, 1|), (|1, 2|)}) == {(|0, 1|), (|1, 2|), (|0, 2|)}", "true"},
                   {"refl_tr_closure({(|0, 1|)}) == {(|0, 0|), (|0, 1|), (|1, 1|)}", "true"},
                   {"iter(2, {(|0, 1|), (|1, 2|)}) == {(|0, 2|)}", "true"},
                   {"iter(-1, {(|0, 1|)}) == {(|1, 0|)}", "true"},
                   {"(|1, 2|) in {(|1, 2|)}", "true"},
                   {"(|1, 2|) in <2>", "true"},
                   {"dom(<2, 2>) == {1, 2}", "true"},
                   {"ran(<2, 2>) == {2}", "true"},
                   {"id() == {(|true, true|), (|false, false|)}", "true"},
                   {"size(r)", "0"}});
}

TEST(Data, Functions) {
    expect_values({{"(lambda x : nat @ x + 1)(1)", "2"},
                   {"(lambda x : nat, y : nat | x < y @ y - x)(0, 2)", "2"},
                   {"(override(lambda x : nat @ x, {(|0, 2|)}) as nat -> nat)(0)", "2"},
                   {"isTotal(lambda x : nat @ x)", "true"},
                   {"isTotal(lambda x : nat | x > 0 @ x)", "false"},
                   {"isInjection(lambda x : nat @ 1)", "false"},
                   {"isSurjection(lambda x : nat @ x)", "true"},
                   {"isBijection(lambda x : nat @ x)", "true"},
                   {"isTotalSurjection(lambda x : nat @ 1)", "false"},
                   {"isFiniteInjection(lambda x : nat @ x)", "true"},
                   {"disjoint({(|1, {1}|), (|2, {1, 2}|)})", "false"},
                   {"partitions({(|1, {1}|), (|2, {2}|)}, {1, 2})", "true"},
                   {"(|1, 0|) in below", "true"},
                   {"below(1)", "0"},
                   {"any(1)", "1"},
                   {"constant(1)", "0"},
                   {"nothing()", "0"},
                   {"down(2)", "2"},
                   {"positive(2)", "2"},
                   {"chosen({2})", "2"},
                   {"chosen({0, 2})", "0"}});
}

TEST(Data, Sequences) {
    expect_values({{"head(<1, 2>)", "1"},
                   {"last(<1, 2>)", "2"},
                   {"tail(<1, 2>) == <2>", "true"},
                   {"front(<1, 2>) == <1>", "true"},
                   {"reverse(<1, 2>) == <2, 1>", "true"},
                   {"concat(<1>, <2>) == <1, 2>", "true"},
                   {"<1> cat <2> == <1, 2>", "true"},
                   {"<1, 2>[2]", "2"},
                   {"(<1, 2>)(1)", "1"},
                   {"isNonEmpty(s)", "false"},
                   {"isInjectiveSequence(<1, 1>)", "false"},
                   {"range(1, 2) == <1, 2>", "true"},
                   {"size(<1, 1>)", "2"},
                   {"squash(lambda x : int | x > 0 @ x - 1) == <0, 1>", "true"},
                   {"extract({2}, <0, 1>) == <1>", "true"},
                   {"filter(<0, 1, 0>, {0}) == <0, 0>", "true"},
                   {"prefix(<1>, <1, 2>)", "true"},
                   {"suffix(<1>, <1, 2>)", "false"},
                   {"infix(<2>, <1, 2, 0>)", "true"},
                   {"dconcat(<<1>, <2>>) == <1, 2>", "true"}});
}

TEST(Data, VectorsAndMatrices) {
    // int is -2..2, so products and sums outside this range yield their first operand (semantics 3.13).
    expect_values({{"[|1, 2|] + [|1, -1|] == [|2, 1|]", "true"},
                   {"[|2, 2|] + [|1, -1|] == [|2, 1|]", "true"},
                   {"[|1, 2|] - [|1, -1|] == [|0, 2|]", "true"},
                   {"-[|1, -2|] == [|-1, 2|]", "true"},
                   {"2 * [|1, 0|] == [|2, 0|]", "true"},
                   {"[|1, 0|] * 2 == [|2, 0|]", "true"},
                   {"[|1, 1|] * [|1, -2|]", "-1"},
                   {"[|0, -1; 1, 0|] * [|1, 2|] == [|-2, 1|]", "true"},
                   {"[|0, -1; 1, 0|] * [|0, -1; 1, 0|] == [|-1, 0; 0, -1|]", "true"},
                   {"transpose([|1, 2; 0, -1|]) == [|1, 0; 2, -1|]", "true"},
                   {"[|1, 2; 0, -1|][1, 2]", "2"},
                   {"[|1, 2|][2]", "2"},
                   {"v[1 + 1]", "0"}});
}

TEST(Data, RecordsLiteralsAndTests) {
    expect_values({{"Place (| x = 1, y = 2 |).y", "2"},
                   {"p.x", "0"},
                   {"(|1, true|)[1]", "1"},
                   {"green(1) == green(2)", "false"},
                   {"c == red", "true"},
                   {"-1 is nat", "false"},
                   {"1 is nat", "true"},
                   {"(1 as int) is nat", "true"},
                   {"let a == 1, b == a + 1 @ b", "2"},
                   {"let a == 1 @ let a == a + 1 @ a", "2"},
                   {"if 1 in {1} then 2 else 0 end", "2"},
                   {"forall x : nat @ x >= 0", "true"},
                   {"exists x : nat | x > 0 @ x == 0", "false"},
                   {"exists1 x : nat @ x > 1", "true"},
                   {"the x : nat | x > 1 @ x", "2"},
                   {"[0, 2] == {0, 1, 2}", "true"},
                   {"size((0, 2])", "2"},
                   {"size((0, 2))", "1"},
                   {"'ab' == 'ab'", "true"},
                   {"'a' cat 'b' == 'ab'", "true"}});
}

std::string compare_values(const std::string& body, const std::string& specification) {
    const auto m = load_model(std::string(declarations) + "stm S {\n event m : int event e\n" + body + "}\n");
    if (!m->diagnostics.ok()) return m->messages();
    return check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", specification);
}

TEST(Assignment, ChangesOnePart) {
    EXPECT_EQ(
        compare_values(R"(
        var p : Place , v : vector(int, 2) , a : matrix(int, 2, 2) , s : Seq(int) = <0, 1> , q : Seq(Place) , i : nat = 2
        var t : nat * Place
        initial j
        state A { entry p.x = 1 ; v[i] = 2 ; a[2, 1] = 1 ; s[1] = 2 ; t[2].y = -1 ;
            m ! (p.x) ; m ! (v[1]) ; m ! (v[2]) ; m ! (a[1, 2]) ; m ! (a[2, 1]) ; m ! (s[1]) ; m ! (s[2]) ; m ! (t[2].y) }
        transition t0 { from j to A })",
                       "Spec = S::m.out.1 -> S::m.out.0 -> S::m.out.2 -> S::m.out.0 -> S::m.out.1 -> S::m.out.2 -> "
                       "S::m.out.1 -> S::m.out.(-1) -> STOP"),
        "holds");
}

TEST(Assignment, OutsideTheIndicesHasNoMeaning) {
    const std::string verdict = compare_values(R"(
        var v : vector(int, 2) , i : nat
        initial j
        state A { entry v[i] = 2 ; m ! (v[1]) }
        transition t0 { from j to A })",
                                               "Spec = S::m.out.0 -> STOP");
    EXPECT_THAT(verdict, HasSubstr("index outside"));
}

TEST(Preconditions, BlockTheStatement) {
    // Semantics 3.5: false & ... waits forever.
    EXPECT_EQ(compare_values(R"(
        var x : int
        initial j
        state A { entry e ; m ! (positive(x)) }
        transition t0 { from j to A })",
                             "Spec = S::e.out -> STOP"),
              "holds");
}

TEST(Preconditions, OfInnerCallsComeFirst) {
    // tail(<>) has no value, so only the precondition of tail may be evaluated.
    EXPECT_EQ(compare_values(R"(
        var s : Seq(int)
        initial j
        state A { entry e ; m ! (head(tail(s))) }
        transition t0 { from j to A })",
                             "Spec = S::e.out -> STOP"),
              "holds");
}

TEST(Preconditions, UnderABinderCountForEveryValue) {
    EXPECT_EQ(compare_values(R"(
        initial j
        state A { entry m ! (size({x : nat | x > 0 @ positive(x)})) ; m ! (size({x : nat @ positive(x)})) }
        transition t0 { from j to A })",
                             "Spec = S::m.out.2 -> STOP"),
              "holds");
}

// Semantics 3.5, 3.8: `pre & opCall` is urgent only while it is offered. Otherwise time passes.
TEST(Preconditions, LetTimePassBeforeACallThatNeverComes) {
    const auto m = load_model(std::string(declarations) + R"(
        interface Acts { act(n : int) }
        stm S { requires Acts event e var x : int initial j state A { entry e ; act(positive(x)) }
                transition t0 { from j to A } })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_EQ(check_equivalence(*m, Time::timed, "S::D__(0)", "Spec", R"(
        Spec = S::e.out -> Waits [] tock -> Spec
        Waits = tock -> Waits)"),
              "holds");
    const auto urgent = load_model(std::string(declarations) + R"(
        interface Acts { act(n : int) }
        stm S { requires Acts event e var x : int = 1 initial j state A { entry e ; act(positive(x)) }
                transition t0 { from j to A } })");
    EXPECT_EQ(check_equivalence(*urgent, Time::timed, "S::D__(0)", "Spec", R"(
        Spec = S::e.out -> S::actCall.1 -> Waits [] tock -> Spec
        Waits = tock -> Waits)"),
              "holds");
}

// Semantics 3.10: after d, a process that stops time interrupts `S <{d}`, in every state of S.
TEST(Preconditions, DoNotLiftADeadline) {
    for (const std::string blocked :
         {"wait(positive(x))", "x = positive(x)", "if positive(x) > 0 then skip else skip end"}) {
        const auto m =
            load_model(std::string(declarations) + "stm S { event e var x : int initial j state A { entry e ; (" +
                       blocked + " ; wait(1)) <{2} } transition t0 { from j to A } }");
        ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
        EXPECT_EQ(check_equivalence(*m, Time::timed, "S::D__(0)", "Spec", R"(
            Spec = S::e.out -> tock -> tock -> STOP [] tock -> Spec)"),
                  "holds")
            << blocked;
    }
}

// Preconditions of functions in an operation's precondition are checked first. Here, head(<>) has no value.
TEST(Preconditions, OfFunctionsInAnOperationsPrecondition) {
    const auto m = load_model(std::string(declarations) + R"(
        interface O { op(n : Seq(int)) }
        operation op(n : Seq(int)) { precondition head(n) > 0 initial i final f transition t { from i to f } }
        controller C {
            event e event d opref o = op
            stm S { requires O event e event d initial j state A { entry e ; op(<1>) ; d ; op(<>) ; d }
                    transition t0 { from j to A } }
            connection S on e to C on e connection S on d to C on d
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_EQ(check_equivalence(*m, Time::untimed, "C::D__(0)", "Spec", "Spec = C::e.out -> C::d.out -> STOP"),
              "holds");
}

// The search for a function's value skips a candidate for which the postcondition has no value. A function as a value
// contains the pairs for which its precondition holds.
TEST(Preconditions, OfFunctionsInPostconditionsAndOfFunctionsAsValues) {
    const std::vector<Case> cases = {{"starting(1)[1]", "1"}, {"size(dom(positive))", "2"}};
    const auto m =
        load_model("function starting(n : int) : Seq(int) { postcondition head(result) == n }\n" + machine_of(cases));
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::vector<std::string> values = evaluate_outputs(*m);
    ASSERT_EQ(values.size(), cases.size());
    for (std::size_t i = 0; i < cases.size(); ++i) EXPECT_EQ(values[i], cases[i].value) << cases[i].expression;
    EXPECT_EQ(check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", specification_of(cases)), "holds")
        << m->messages();
}

// No source defines whether a deadline without a value expires.
TEST(Preconditions, ThatCanBeFalseAreRefusedInTheDeadlineOfATransition) {
    const auto with = [](const std::string& deadline) {
        const auto m =
            load_model(std::string(declarations) +
                       "stm S { event e var s : Seq(int) initial j state A { } transition t0 { from j to A } "
                       "transition t1 { from A to A trigger e <{" +
                       deadline + "} } }");
        (void)m->emit(Time::timed);
        return m->codes();
    };
    EXPECT_THAT(with("head(s)"), Contains("RC-C01"));
    EXPECT_THAT(with("head(<1, 2>)"), ::testing::Not(Contains("RC-C01")));
}

TEST(Postconditions, WithoutAnyValueMakeTheCheckInconclusive) {
    const auto m = load_model(R"(
        function none(n : nat) : nat { postcondition result != result }
        stm S { event m : nat initial j state A { entry m ! (none(1)) } transition t0 { from j to A } })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_THAT(m->codes(), Contains("RC-S20"));
    EXPECT_THAT(check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", "Spec = S::m.out.0 -> STOP"),
                HasSubstr("no value satisfies the postcondition of none"));
}

// There is one definition for each combination of types. The model's own function same_2 keeps its name.
TEST(GenericFunctions, AreThereForEachOfTheirTypes) {
    const auto m = load_model(R"(
        function same(x : ?X) : ?X { postcondition result == x }
        function same_2(x : nat) : nat { postcondition result == x + 1 }
        stm S { event m : nat event t : boolean event s : Seq(nat) initial j
                state A { entry m ! (same(1)) ; t ! (same(false)) ; m ! (same_2(1)) ; s ! (same(<2>)) ; m ! (same(2)) }
                transition t0 { from j to A } })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_EQ(m->system.functions.size(), 4U);
    EXPECT_EQ(check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", R"(
        Spec = S::m.out.1 -> S::t.out.false -> S::m.out.2 -> S::s.out.<2> -> S::m.out.2 -> STOP)"),
              "holds");
}

TEST(GenericFunctions, PolymorphicRecursionIsRejected) {
    const auto m = load_model(R"(
        function deep(x : ?X) : boolean { postcondition result == deep(<x>) }
        stm S { event t : boolean initial j state A { entry t ! (deep(1)) } transition t0 { from j to A } })");
    EXPECT_THAT(m->codes(), Contains("RC-S01"));
    EXPECT_THAT(m->messages(), HasSubstr("function deep used for more than 64 types"));
}

TEST(Reals, SetsAndSequencesAreConvertedElementByElement) {
    // 0.5 makes the unit a half, and the whole numbers of `w` become 0 and 20 tenths.
    const auto m = load_model(R"(
        import set_toolkit::*
        import relation_toolkit::*
        stm S {
            event t : boolean
            var w : Set(int) = {0, 2} , f : Set(real) , u : Seq(int) = <2>
            initial j
            state A { entry f = union(w, {0.5}) ; t ! (f == {0, 0.5, 2}) ; t ! ((|1, 2.0|) in u) ; t ! (0.5 is nat) ;
                            t ! (2.0 is nat) ; t ! (0.5 in [0.0, 1)) }
            transition t0 { from j to A }
        })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    EXPECT_EQ(check_equivalence(
                  *m, Time::untimed, "S::D__(0)", "Spec",
                  "Spec = S::t.out.true -> S::t.out.true -> S::t.out.false -> S::t.out.true -> S::t.out.true -> STOP"),
              "holds");
}

TEST(Reals, LeastAndGreatestOfASet) {
    // Reals are in tenths in the script and in the evaluator. A value that is sent as a real is converted.
    const std::pair<const char*, const char*> cases[] = {{"r ! (min({1.5, -0.5, 2}))", "-5"},
                                                         {"r ! (max({1.5, -0.5, 2}))", "20"},
                                                         {"r ! (min({1, 0.5}))", "5"},
                                                         {"r ! (max({-1, -0.5}))", "-5"},
                                                         {"r ! (min({2, 1}))", "10"},
                                                         {"r ! (max({-2, 1}))", "10"},
                                                         {"n ! (min({2, 1}))", "1"},
                                                         {"n ! (max({2, 1}))", "2"},
                                                         {"k ! (min({2, -1}))", "-1"},
                                                         {"k ! (max({-2, -1}))", "-1"},
                                                         {"t ! (hasMin({0.5}))", "true"},
                                                         {"t ! (hasMax({x : real | x > 2 /\\ x < 1}))", "false"},
                                                         {"r ! (max({x : real | x < 0}))", "-5"}};
    std::string actions, specification = "Spec = ";
    for (const auto& [action, value] : cases) {
        actions += (actions.empty() ? "" : " ; ") + std::string(action);
        specification += std::string("S::") + action[0] + ".out.(" + value + ") -> ";
    }
    const auto m = load_model(
        "import sequence_toolkit::* stm S { event r : real event n : nat event k : int "
        "event t : boolean initial j state A { entry " +
        actions + " } transition t0 { from j to A } }");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::vector<std::string> values = evaluate_outputs(*m);
    ASSERT_EQ(values.size(), std::size(cases));
    for (std::size_t i = 0; i < std::size(cases); ++i) EXPECT_EQ(values[i], cases[i].second) << cases[i].first;
    EXPECT_EQ(check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", specification + "STOP"), "holds")
        << m->messages();
}

// For every type of numbers, the precondition of both functions is that the set is not empty (semantics 3.5).
TEST(Preconditions, TheEmptySetHasNoLeastElement) {
    for (const std::string type : {"nat", "int", "real"})
        for (const std::string function : {"min", "max"}) {
            const auto m = load_model("import sequence_toolkit::* stm S { event e event m : " + type + " var s : Set(" +
                                      type + ") initial j state A { entry e ; m ! (" + function +
                                      "(s)) } transition t0 { from j to A } }");
            ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
            EXPECT_EQ(check_equivalence(*m, Time::untimed, "S::D__(0)", "Spec", "Spec = S::e.out -> STOP"), "holds")
                << type << " " << function << m->messages();
        }
    const auto m = load_model(machine_of({{"min({})", ""}}));
    EXPECT_THROW(evaluate_outputs(*m), ir::EvaluationFault);
}

// The types of the bounds of such a range are unknown. Its script is still generated, and evaluation of the range
// fails.
TEST(Ranges, OfUnknownTypeAreWritten) {
    const auto m = load_model(
        "import sequence_toolkit::* stm S { var x : int initial j state A { } "
        "transition t0 { from j to A condition x in (head(<>), 1] } }");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    for (const Time time : {Time::untimed, Time::timed})
        EXPECT_NE(cspm::print(m->emit(time).definitions).find("{sequence_toolkit_head(<>) + 1..1}"), std::string::npos);
}

TEST(Probabilistic, JunctionsAreFreeChoices) {
    EXPECT_EQ(compare_values(R"(
        initial i
        probabilistic p
        state A { entry m ! 0 }
        state B { entry m ! 1 }
        transition t0 { from i to p }
        transition t1 { from p to A probability 0.5 }
        transition t2 { from p to B probability 0.5 })",
                             "Spec = S::m.out.0 -> STOP |~| S::m.out.1 -> STOP"),
              "holds");
}

}  // namespace
}  // namespace robochart::csp_emit::data_test
