// SPDX-License-Identifier: Apache-2.0
// Tests that variables in separate memory processes (semantics 3.6) have the same effect as the parameters that they
// replace.
#include "csp_emit/passes/variable_memory.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/reader.hpp"
#include "tests/csp_emit/fixture.hpp"

namespace robochart::csp_emit::variable_memory_test {
namespace {

namespace b = cspm::build;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

Remembered make_remembered(const std::string& name, const std::string& shared = "") {
    return {"v_" + name, name, shared, b::name("core_nat"), b::number(0), "Memory_" + name, name};
}

// P needs x because it outputs it. Q only passes x on.
TEST(VariableMemory, IsAskedForWhatTheNextFunctionEvaluates) {
    std::vector<Function> family{
        {"P", {"v_x"}, b::prefix(b::name("c"), {b::output(b::name("v_x"))}, b::call("Q", {b::name("v_x")}))},
        {"Q", {"v_x"}, b::prefix(b::name("a"), b::call("P", {b::name("v_x")}))}};
    auto initial = b::call("Q", {b::number(0)});
    move_to_memories(family, initial, {}, {make_remembered("x")});
    EXPECT_EQ(cspm::print(initial), "Q");
    EXPECT_EQ(cspm::print(family[0].body), "c!v_x -> Q");
    EXPECT_EQ(cspm::print(family[1].body), "a -> get_x?v_x -> P(v_x)");
    EXPECT_THAT(family[0].parameters, ElementsAre("v_x"));
    EXPECT_THAT(family[1].parameters, IsEmpty());
}

TEST(VariableMemory, IsGivenWhatChangesUnlessTheEventTellsIt) {
    const auto next = b::binary(cspm::ExprKind::plus, b::name("v_x"), b::number(1));
    std::vector<Function> own{{"P", {"v_x"}, b::prefix(b::name("a"), b::call("P", {next}))}};
    std::vector<Function> shared = own;
    auto initial = b::call("P", {b::number(2)});
    move_to_memories(own, initial, {}, {make_remembered("x")});
    EXPECT_EQ(cspm::print(initial), "setL_x!2 -> P(2)");
    EXPECT_EQ(cspm::print(own[0].body), "a -> setL_x!(v_x + 1) -> P(v_x + 1)");
    initial = b::call("P", {b::number(0)});
    move_to_memories(shared, initial, {}, {make_remembered("x", "x")});
    EXPECT_EQ(cspm::print(shared[0].body), "a -> P");  // because no later function needs the new value of x
}

TEST(VariableMemory, EndsWithTheMachine) {
    std::vector<Function> family{{"P", {"v_x"}, b::prefix(b::name("terminate"), b::skip())}};
    auto initial = b::call("P", {b::number(0)});
    move_to_memories(family, initial, {}, {make_remembered("x")});
    EXPECT_EQ(cspm::print(family[0].body), "terminate -> end__ -> SKIP");
    EXPECT_EQ(cspm::print(with_memories(initial, {make_remembered("x")}, true)),
              "(P [| {| end__, tock, get_x, setL_x |} |] Memory_x(0)) \\ {| end__, get_x, setL_x |}");
}

// Tests the machine in both representations: memories for both variables, and parameters.
TEST(VariableMemory, KeepsTheMeaningOfStateAndOperation) {
    const auto m = testing::load_model(R"(
        interface I { var shared : nat }
        interface O { op(p : nat) }
        operation op(p : nat) { requires I event reported : nat var local : nat = 1
            initial i final f state A { entry local = local + p; send reported!local; shared = local }
            transition t0 { from i to A } transition t1 { from A to f condition shared > 0 } }
        stm S { requires I requires O var x : nat event inp : nat event reported : nat
            initial i final f
            state A { during x = x + 1 } state B { entry op(x) }
            transition t0 { from i to A }
            transition t1 { from A to B trigger inp?x condition x < 2 }
            transition t2 { from B to A condition shared < 2 action shared = x }
            transition t3 { from B to f condition shared == 2 } }
        controller C { requires I opref op0 = op sref s = S })");
    ASSERT_TRUE(m->diagnostics.ok()) << m->messages();
    for (const Time time : {Time::untimed, Time::timed}) {
        const Emission parameters = m->emit(time);
        cspm::Script script = m->emit_with_memories(time).definitions;
        std::vector<cspm::DeclPtr> modules;
        for (const cspm::DeclPtr& decl : parameters.definitions.decls)
            if (decl->kind == cspm::DeclKind::module) modules.push_back(decl);
        script.decls.push_back(b::module_("inline__", {}, {}, modules));
        std::vector<cspm::Link> links;
        for (const char* event : {"terminate", "inp", "reported", "set_shared", "set_EXT_shared"})
            links.push_back({b::name(std::string("inline__::C::s::") + event), b::name(std::string("C::s::") + event)});
        const auto with = b::call("C::s::D__", {b::number(0)});
        const auto without = b::rename(b::call("inline__::C::s::D__", {b::number(0)}), links);
        script.decls.push_back(b::assert_refines(with, cspm::Model::failures_divergences, without));
        script.decls.push_back(b::assert_refines(without, cspm::Model::failures_divergences, with));
        EXPECT_THAT(testing::decide_script(script), ElementsAre("holds", "holds"));
    }
}

}  // namespace
}  // namespace robochart::csp_emit::variable_memory_test
