// SPDX-License-Identifier: Apache-2.0
// Tests calls of defined operations (semantics 3.8). All calls share one definition, which continues after its call.
// Specifications were written by hand from the reference. Processes are equal if they refine each other in the
// failures-divergences model.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::calls_test {
namespace {

namespace b = cspm::build;
using ::testing::ElementsAre;

/// Returns a controller C with a machine S as `s`, and with these definitions of the operations `op` and `inner`.
std::string with_operations(const std::string& operations, const std::string& machine) {
    return R"(
        interface E { event a event b event c event n : nat event m : nat }
        interface V { var x : nat }
        interface K { clock T }
        interface O { op(p : nat) } interface I { inner(q : nat) }
    )" + operations +
           " stm S { uses E requires O " + machine +
           " } controller C { uses E requires V sref s = S opref o = op opref i = inner }";
}

std::string compare_process(const std::string& rct, Time time, const std::string& process,
                            const std::string& definitions) {
    const auto m = testing::load_model(rct);
    if (!m->diagnostics.ok()) return m->messages();
    return testing::check_equivalence(*m, time, process, "Spec", definitions);
}

const char* const steps = R"(
    operation op(p : nat) { uses E initial i final f transition t { from i to f action a ; b } }
    operation inner(q : nat) { uses E initial i final f transition t { from i to f } }
)";

TEST(Calls, ReturnToWhereTheyWereMade) {
    EXPECT_EQ(compare_process(with_operations(R"(
        operation op(p : nat) { uses E requires I initial i final f
            state A { entry n ! p ; inner(p + 1) ; inner(p) }
            transition t0 { from i to A } transition t1 { from A to f } }
        operation inner(q : nat) { uses E initial i final f transition t { from i to f action m ! q } }
    )",
                                              R"(
        initial i state A { entry op(0) ; a ; op(1) }
        transition t0 { from i to A } transition t1 { from A to A trigger b }
    )"),
                              Time::untimed, "C::s::D__(0)", R"(
        A(P) = C::s::n.out.0 -> C::s::m.out.1 -> C::s::m.out.0 -> C::s::a.out ->
               C::s::n.out.1 -> C::s::m.out.2 -> C::s::m.out.1 -> P
        Spec = A(C::s::b.in -> Spec))"),
              "holds");
}

// S does not call `inner`, which compares a clock of the same name with its own constant. This comparison does not
// bound the clock of S, because S does not have the constant.
TEST(Calls, ClocksOfOperationsThatAreNotCalledAreNotTheMachines) {
    EXPECT_EQ(compare_process(with_operations(R"(
        operation op(p : nat) { uses E initial i final f transition t { from i to f } }
        operation inner(q : nat) { uses E const k : nat clock T initial i final f state A { }
            transition t0 { from i to A } transition t1 { from A to f condition since(T) > k } }
    )",
                                              R"(
        clock T initial i state A { } state B { entry a }
        transition t0 { from i to A # T } transition t1 { from A to B condition since(T) >= 1 }
    )"),
                              Time::timed, "C::s::D__(0)", R"(
        Spec = tock -> Out
        Out = C::s::a.out -> Rest [] tock -> Out
        Rest = tock -> Rest)"),
              "holds");
}

// The caller's x is read only after the first call, and the operation has no access to it. The operation's own counter
// is initialised at each call.
TEST(Calls, KeepTheCallersVariablesAndStartTheirOwnAnew) {
    EXPECT_EQ(compare_process(with_operations(R"(
        operation op(p : nat) { uses E var count : nat = 1 initial i final f
            state A { entry count = count + p }
            transition t0 { from i to A } transition t1 { from A to f action n ! count } }
        operation inner(q : nat) { uses E initial i final f transition t { from i to f } }
    )",
                                              R"(
        var y : nat
        initial i state A { entry y = 2 ; op(1) ; m ! y } state B { entry op(0) ; a }
        transition t0 { from i to A } transition t1 { from A to B trigger m ? y }
        transition t2 { from B to A trigger b }
    )"),
                              Time::untimed, "C::s::D__(0)", R"(
        Spec = C::s::n.out.2 -> C::s::m.out.2 -> C::s::m.in?y -> C::s::n.out.1 -> C::s::a.out -> C::s::b.in -> Spec)"),
              "holds");
}

// The machine reads the result of the operation only after the call, in a condition. The operation itself reads the
// values on which the result depends.
TEST(Calls, WriteResultsToTheCallersVariable) {
    const std::string reading = R"(
        uses V
        initial i state A { entry op(2) ; if x == 2 then a else b end } transition t0 { from i to A })";
    for (const Time time : {Time::untimed, Time::timed}) {
        const std::string after = time == Time::timed
                                      ? "Spec = C::s::a.out -> Rest [] tock -> Spec\nRest = tock -> Rest"
                                      : "Spec = C::s::a.out -> STOP";
        EXPECT_EQ(compare_process(with_operations(R"(
            operation op(p : nat) { requires V var own : nat = 2 initial i final f
                transition t { from i to f action x = own } }
            operation inner(q : nat) { initial i final f transition t { from i to f } }
        )",
                                                  reading),
                                  time, "C::s::D__(0)", after),
                  "holds");
        EXPECT_EQ(compare_process(with_operations(R"(
            operation op(p : nat) { requires V requires I initial i final f
                state W { entry inner(p) } transition t0 { from i to W } transition t1 { from W to f } }
            operation inner(q : nat) { requires V initial i final f state W { }
                transition t0 { from i to W } transition t1 { from W to f action x = q } }
        )",
                                                  reading),
                                  time, "C::s::D__(0)", after),
                  "holds");
    }
}

// The machine reads the constant k only after the first call. After the second call, k is no longer a parameter.
TEST(Calls, KeepConstantsWhereTheyAreRead) {
    EXPECT_EQ(compare_process(with_operations(steps, R"(
        const k : nat = 2
        initial i state A { entry op(0) ; n ! k } state B { entry op(1) }
        transition t0 { from i to A } transition t1 { from A to B trigger c }
    )"),
                              Time::untimed, "C::s::D__(0, const_S_k)", R"(
        Spec = C::s::a.out -> C::s::b.out -> C::s::n.out.2 -> C::s::c.in -> C::s::a.out -> C::s::b.out -> STOP)"),
              "holds");
}

TEST(Calls, ClocksOfTheCallerCountOnInside) {
    EXPECT_EQ(compare_process(with_operations(R"(
        operation op(p : nat) { uses E initial i final f transition t { from i to f action wait(p) } }
        operation inner(q : nat) { uses E initial i final f transition t { from i to f } }
    )",
                                              R"(
        clock T
        initial i state A { entry #T ; op(2) } state B { entry op(1) }
        transition t0 { from i to A } transition t1 { from A to B condition since(T) >= 3 action a }
        transition t2 { from B to A trigger b }
    )"),
                              Time::timed, "C::s::D__(0)", R"(
        Reported = C::s::a.out -> tock -> Wait [] tock -> Reported
        Wait = C::s::b.in -> Spec [] tock -> Wait
        Spec = tock -> tock -> tock -> Reported)"),
              "holds");
}

TEST(Calls, UnderADeadlineAndWithoutOne) {
    EXPECT_EQ(compare_process(with_operations(R"(
        operation op(p : nat) { uses E initial i final f transition t { from i to f action wait(p) } }
        operation inner(q : nat) { uses E initial i final f transition t { from i to f } }
    )",
                                              R"(
        initial i state A { entry op(2) ; a ; op(1) <{ 1 } ; b ; op(2) <{ 1 } }
        transition t0 { from i to A }
    )"),
                              Time::timed, "C::s::D__(0)", R"(
        First = C::s::a.out -> tock -> Then [] tock -> First
        Then = C::s::b.out -> tock -> STOP [] tock -> Then
        Spec = tock -> tock -> First)"),
              "holds");
}

TEST(Calls, InDuringActionsAreCutLikeThem) {
    EXPECT_EQ(compare_process(with_operations(steps, R"(
        initial i state A { during op(0) } state B { }
        transition t0 { from i to A } transition t1 { from A to B trigger c action op(1) }
    )"),
                              Time::untimed, "C::s::D__(0)", R"(
        Left = C::s::a.out -> C::s::b.out -> STOP
        Last = C::s::c.in -> Left
        Spec = C::s::c.in -> Left [] C::s::a.out -> (C::s::c.in -> Left [] C::s::b.out -> Last))"),
              "holds");
}

// The operation has no access to x, so another machine may write x while the operation runs.
TEST(Calls, OthersMayWriteTheCallersVariablesMeanwhile) {
    EXPECT_EQ(compare_process(with_operations(steps, R"(
        requires V
        initial i state A { entry op(0) ; n ! x ; op(1) ; c }
        transition t0 { from i to A }
    )"),
                              Time::untimed, "Alone", R"(
        Writer = C::s::a.out -> C::s::set_EXT_x.2 -> STOP
        Alone = C::s::D__(0) [| {| C::s::a, C::s::set_EXT_x |} |] Writer
        Spec = C::s::a.out -> (C::s::set_EXT_x.2 -> C::s::b.out -> C::s::n.out.2 -> STOP [] C::s::b.out -> Read)
        Read = (C::s::set_EXT_x.2 -> C::s::n.out.2 -> STOP [] Late) |~| Late
        Late = C::s::n.out.0 -> C::s::set_EXT_x.2 -> STOP [] C::s::set_EXT_x.2 -> C::s::n.out.0 -> STOP)"),
              "holds");
}

// Operation k calls operation k+1 twice, so there are 2^30 calls but only 31 definitions.
TEST(Calls, AreWrittenOnceForEachOperation) {
    constexpr int depth = 30;
    std::string text = "interface E { event a }";
    std::string references;
    for (int k = 0; k <= depth; ++k) {
        const std::string name = "op" + std::to_string(k);
        const std::string next = "op" + std::to_string(k + 1);
        const std::string action = k == depth ? "a" : next + "() ; " + next + "()";
        text += " interface I" + std::to_string(k) + " { " + name + "() } operation " + name + "() { uses E " +
                (k == depth ? "" : "requires I" + std::to_string(k + 1)) +
                " initial i final f transition t { from i to f action " + action + " } }";
        references += " opref r" + std::to_string(k) + " = " + name;
    }
    const auto m = testing::load_model(text + " controller C { uses E" + references + R"(
        stm S { uses E requires I0 initial i state A { entry op0() } transition t { from i to A } } })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    const std::string script = cspm::print(m->emit(Time::untimed).script);
    std::size_t definitions = 0;
    for (std::size_t at = script.find("_action_of_t__"); at != std::string::npos;
         at = script.find("_action_of_t__", at + 1))
        ++definitions;
    EXPECT_LT(definitions, 31U * 8U);
    // The model makes 2^30 calls, but the check explores only the first steps.
    EXPECT_EQ(testing::decide_with(*m, Time::untimed, R"(
        P(n) = if n == 0 then STOP else C::S::a.out -> P(n - 1)
        assert C::S::D__(0) [T= P(50))"),
              std::vector<std::string>{"holds"});
}

TEST(Calls, InMemoriesAndInParametersAreTheSame) {
    const auto m = testing::load_model(with_operations(R"(
        operation op(p : nat) { uses E requires V requires I var l : nat initial i final f
            state A { entry l = p ; x = l + 1 ; inner(l) }
            transition t0 { from i to A } transition t1 { from A to f trigger n ? x } }
        operation inner(q : nat) { uses E initial i final f transition t { from i to f action m ! q } }
    )",
                                                       R"(
        requires V var y : nat
        initial i state A { entry op(y) ; n ! y } state B { entry y = x ; op(1) }
        transition t0 { from i to A } transition t1 { from A to B trigger m ? y condition y < 2 }
        transition t2 { from B to A trigger b }
    )"));
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    cspm::Script script = m->emit_with_memories(Time::timed).definitions;
    std::vector<cspm::DeclPtr> modules;
    for (const cspm::DeclPtr& decl : m->emit(Time::timed).definitions.decls)
        if (decl->kind == cspm::DeclKind::module) modules.push_back(decl);
    script.decls.push_back(b::module_("inline__", {}, {}, modules));
    std::vector<cspm::Link> links;
    for (const char* event : {"terminate", "a", "b", "c", "n", "m", "set_x", "set_EXT_x"})
        links.push_back({b::name(std::string("inline__::C::s::") + event), b::name(std::string("C::s::") + event)});
    const auto with = b::call("C::s::D__", {b::number(0)});
    const auto without = b::rename(b::call("inline__::C::s::D__", {b::number(0)}), links);
    script.decls.push_back(b::assert_refines(with, cspm::Model::failures_divergences, without));
    script.decls.push_back(b::assert_refines(without, cspm::Model::failures_divergences, with));
    EXPECT_THAT(testing::decide_script(script), ElementsAre("holds", "holds"));
}

}  // namespace
}  // namespace robochart::csp_emit::calls_test
