// SPDX-License-Identifier: Apache-2.0
// Tests lowering construct by construct, on small models.
#include <gtest/gtest.h>

#include <algorithm>

#include "semantics/ir/dump.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/lower/expressions.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

using namespace samples;
using Codes = std::vector<std::string>;

std::string program(const Lowered& lowered, const std::string& machine, const std::string& node) {
    const auto& entry = lowered.node(machine, node).entry;
    if (!entry) return "none";
    const auto whole = dump_text(lowered.system);
    const auto start = whole.find("    entry\n", whole.find("  state " + node + "\n")) + 10;
    std::string text;
    for (auto at = start; at < whole.size() && whole.compare(at, 6, "      ") == 0; at = whole.find('\n', at) + 1)
        text += whole.substr(at + 6, whole.find('\n', at) + 1 - at - 6);
    return text;
}

TEST(LowerExpressions, NumbersTakeTheTypeTheirPlaceAsksFor) {
    const auto lowered =
        lower_text(machine_text("var x:real, n:nat, k:int\n"
                                "transition a { from A to A condition x < 5 }\n"
                                "transition b { from A to A condition x < n }\n"
                                "transition c { from A to A condition k == -3 }\n"
                                "transition d { from A to A condition x == -0.50 }\n"
                                "transition e { from A to A condition (x + 1) > 2.5 }\n"
                                "transition f { from A to A condition n - 1 > 0 }\n"));
    EXPECT_EQ(lowered->guard("S", "a"), "(x < 5r)");
    EXPECT_EQ(lowered->guard("S", "b"), "(x < (n) as real)");
    EXPECT_EQ(lowered->guard("S", "c"), "(k == -3)");
    EXPECT_EQ(lowered->guard("S", "d"), "(x == -0.5r)");
    EXPECT_EQ(lowered->guard("S", "e"), "((x + 1r) > 2.5r)");
    EXPECT_EQ(lowered->guard("S", "f"), "((n - 1) > 0)");
    const auto& difference = *lowered->transition("S", "f").guard->args[0];
    EXPECT_EQ(lowered->system.type(difference.type).kind, TypeKind::integer);
}

TEST(LowerExpressions, DivisionIsReal) {
    const auto lowered = lower_text(machine_text("var n:nat\ntransition a { from A to A condition n / 2 >= 1 }\n"));
    EXPECT_EQ(lowered->guard("S", "a"), "(((n) as real / 2r) >= 1r)");
}

TEST(LowerExpressions, OperatorsKeepTheirMeaningAndBrackets) {
    const auto lowered =
        lower_text(machine_text("var p:boolean, q:boolean\n"
                                "transition a { from A to A condition p => q iff not p \\/ (q /\\ p) }\n"
                                "transition b { from A to A condition if p then q else p end }\n"));
    EXPECT_EQ(lowered->guard("S", "a"), "((p => q) iff (not (p) \\/ (q /\\ p)))");
    EXPECT_EQ(lowered->guard("S", "b"), "if(p, q, p)");
}

TEST(LowerExpressions, EnumerationsRecordsAndTuples) {
    const auto lowered = lower_text(
        "enumeration Colour { red green }\n"
        "datatype Point { x:nat y:real }\n" +
        machine_text(
            "var c:Colour, p:Point, t:nat * real\n"
            "transition a { from A to A condition c == Colour::green }\n"
            "transition b { from A to A condition p.y > 1 }\n"
            "transition d { from A to A condition t[2] > 1 }\n"
            "transition e { from A to A action p = Point (| x = 1 , y = 2 |) ; p . y = 1 ; t = (| 1 , 2 |) }\n"));
    EXPECT_EQ(lowered->guard("S", "a"), "(c == green)");
    EXPECT_EQ(lowered->guard("S", "b"), "((p).1 > 1r)");
    EXPECT_EQ(lowered->guard("S", "d"), "((t).2 > 1r)");
    const auto& action = *lowered->transition("S", "e").action;
    ASSERT_EQ(action.body.size(), 3U);
    EXPECT_EQ(lowered->text("S", action.body[0]->value), "record(1, 2r)");
    ASSERT_EQ(action.body[1]->path.size(), 1U);
    EXPECT_EQ(action.body[1]->path[0]->number, 1);
    EXPECT_EQ(lowered->text("S", action.body[2]->value), "tuple(1, 2r)");
}

TEST(LowerExpressions, SequencesSetsAndIndex) {
    const auto lowered =
        lower_text(machine_text("var s:Seq(real), m:Set(nat)\n"
                                "transition a { from A to A condition s == <> }\n"
                                "transition b { from A to A condition 2 in m }\n"
                                "transition c { from A to A condition s[1] == 2 action s = <1, 2.5> ; s[1] = 3 }\n"));
    EXPECT_EQ(lowered->guard("S", "a"), "(s == seq())");
    EXPECT_EQ(lowered->transition("S", "a").guard->args[1]->type, lowered->machine("S").variables[0].type);
    EXPECT_EQ(lowered->guard("S", "b"), "(2 in m)");
    EXPECT_EQ(lowered->guard("S", "c"), "(index(s, 1) == 2r)");
    EXPECT_EQ(lowered->text("S", lowered->transition("S", "c").action->body[0]->value), "seq(1r, 2.5r)");
    EXPECT_EQ(lowered->text("S", lowered->transition("S", "c").action->body[1]->value), "3r");
}

TEST(LowerExpressions, FunctionsAreLoweredAtFirstUseAndWarnedOf) {
    const auto lowered =
        lower_text("function half(x:real):real { precondition x > 0 }\nfunction unused(n:nat):nat { }\n" +
                   machine_text("var y:real\ntransition a { from A to A action y = half(2) }\n"));
    EXPECT_EQ(lowered->codes(), Codes{"RC-S18"});
    ASSERT_EQ(lowered->system.functions.size(), 1U);
    EXPECT_EQ(lowered->system.functions[0].name, "half");
    ASSERT_EQ(lowered->system.functions[0].preconditions.size(), 1U);
    EXPECT_EQ(lowered->text("S", lowered->transition("S", "a").action->value), "half(2r)");
}

/// If a block defines a function, it does so for the semantics (timed, untimed) of the block. A block with another name
/// does not define it. A semantics without assertions needs no definition.
TEST(LowerExpressions, FunctionsThatBlocksDefineAreNotWarnedOf) {
    const auto codes = [](const std::string& blocks) {
        return lower_text("package a::b\nfunction half(n:nat):nat { }\n" +
                              machine_text("var y:nat\ntransition a { from A to A action y = half(2) }\n"),
                          blocks)
            ->codes();
    };
    const std::string text = " csp-begin\n a_b_half(n) = n\ncsp-end\n";
    EXPECT_EQ(codes("csp Instantiations" + text), Codes{});
    EXPECT_EQ(codes("untimed csp Instantiations" + text + "timed csp instantiations" + text), Codes{});
    EXPECT_EQ(codes("timed csp Instantiations" + text), Codes{"RC-S18"});
    const std::string claim = "assertion A : a::b::S is deadlock-free\n";
    EXPECT_EQ(codes("timed " + claim + "timed csp Instantiations" + text), Codes{});
    EXPECT_EQ(codes("timed " + claim + "untimed csp Instantiations" + text), Codes{"RC-S18"});
    EXPECT_EQ(codes(claim + "timed csp Instantiations" + text), Codes{"RC-S18"});
    EXPECT_EQ(codes(claim), Codes{"RC-S18"});
    EXPECT_EQ(codes("csp Other" + text), Codes{"RC-S18"});
    EXPECT_EQ(codes("csp Instantiations csp-begin\n y = a_b_half(1)\n-- a_b_half(n) = n\ncsp-end\n"), Codes{"RC-S18"});
}

TEST(LowerExpressions, LetAndLambda) {
    const auto lowered = lower_text(machine_text(
        "var n:nat\ntransition a { from A to A action n = let x == n + 1 @ x + 1 ; n = (lambda x:nat @ x + 1)(1) }\n"));
    const auto& body = lowered->transition("S", "a").action->body;
    EXPECT_EQ(lowered->text("S", body[0]->value), "let x:nat((n + 1), (\\x + 1))");
    EXPECT_EQ(body[1]->value->kind, ExprKind::apply);
}

/// The parser rejects such numbers (RC-P06, RC-P07). The test checks IR that was built in another way.
TEST(LowerExpressions, NumbersBeyond64BitsAreReported) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const frontend::Model model;
    Lowering lowering{model, sources, diagnostics};
    frontend::Expr huge;
    huge.kind = frontend::ExprKind::integer;
    huge.text = "9223372036854775808";
    EXPECT_NE(lower_expression(lowering, {}, huge), nullptr);
    ASSERT_EQ(diagnostics.sorted_findings().size(), 1U);
    EXPECT_EQ(diagnostics.sorted_findings()[0].rule->code, "RC-S03");
}

TEST(LowerExpressions, WhatHasNoMeaningYetIsNamed) {
    const auto lowered = lower_files(
        {{"t.rct", machine_text("var n:matrix(real, 2, 2)\ntransition a { from A to A action n = inverse(n) }\n")}});
    EXPECT_EQ(lowered->codes(), Codes{"RC-S01"}) << lowered->messages();
    EXPECT_NE(lowered->messages().find(
                  "inverse(..), whose entries need not be numbers of a finite type, is not supported yet"),
              std::string::npos);
}

TEST(LowerMachines, TriggerVariableInItsOwnGuardIsTheReceivedValue) {
    const auto lowered =
        lower_text(machine_text("event e:nat\nvar n:nat, m:nat\n"
                                "transition a { from A to A trigger e?n condition n > m action m = n }\n"));
    EXPECT_EQ(lowered->guard("S", "a"), "(received > m)");
    EXPECT_EQ(lowered->text("S", lowered->transition("S", "a").action->value), "n");
    EXPECT_TRUE(lowered->machine("S").events[0].input);
}

TEST(LowerMachines, ElseIsTheNegationOfTheSiblings) {
    const auto lowered = lower_text(
        "stm S {\n var n:nat\n initial i junction j state A { }\n"
        "transition t0 { from i to j }\n"
        "transition t1 { from j to A condition n == 0 }\n"
        "transition t2 { from j to A condition n == 1 }\n"
        "transition t3 { from j to A condition else }\n}\n");
    EXPECT_EQ(lowered->guard("S", "t3"), "(not ((n == 0)) /\\ not ((n == 1)))");
}

TEST(LowerMachines, ElseBesideAnUnconditionalSiblingIsNeverTaken) {
    const auto lowered = lower_text(
        "stm S {\n initial i junction j state A { }\n"
        "transition t0 { from i to j }\ntransition t1 { from j to A }\ntransition t2 { from j to A condition else "
        "}\n}\n");
    EXPECT_EQ(lowered->guard("S", "t2"), "not (true)");
}

TEST(LowerMachines, TimeInGuardsMarksTheWholeGuard) {
    const auto lowered =
        lower_text(machine_text("clock C\nvar p:boolean\n"
                                "transition a { from A to A # C condition p /\\ since(C) > 3 }\n"
                                "transition b { from A to A condition p }\n"
                                "transition c { from A to A condition sinceEntry(A) > 2 }\n"));
    EXPECT_TRUE(lowered->transition("S", "a").guard_timed);
    EXPECT_FALSE(lowered->transition("S", "b").guard_timed);
    EXPECT_TRUE(lowered->transition("S", "c").guard_timed);
    const auto& clocks = lowered->machine("S").clocks;
    ASSERT_EQ(clocks.size(), 2U);
    EXPECT_FALSE(clocks[0].entry_of.is_valid());
    EXPECT_EQ(clocks[1].name, "A");
    EXPECT_EQ(clocks[1].entry_of, lowered->transition("S", "c").source);
}

TEST(LowerMachines, CompositeStates) {
    const auto lowered = lower_text(
        "stm S {\n initial i\n state C { initial i0 state D { state E { } initial i1 transition u { from i1 to E } }\n"
        " final f entry skip exit skip during skip\n transition t { from i0 to D } transition v { from D to f } }\n"
        " transition s { from i to C }\n}\n");
    const auto& machine = lowered->machine("S");
    const auto& c = lowered->node("S", "C");
    const auto& e = lowered->node("S", "C::D::E");
    EXPECT_TRUE(c.is_composite());
    EXPECT_FALSE(e.is_composite());
    EXPECT_EQ(machine.nodes[e.parent.index].path, "C::D");
    EXPECT_EQ(machine.nodes[c.initial.index].path, "C::i0");
    EXPECT_EQ(c.children.size(), 3U);
    EXPECT_EQ(machine.top.size(), 2U);
    EXPECT_EQ(machine.nodes[machine.initial.index].name, "i");
    EXPECT_EQ(e.origin.element, "S::C::D::E");
    EXPECT_EQ(lowered->transition("S", "v").origin.element, "S::C::v");
    EXPECT_NE(c.entry, nullptr);
    EXPECT_NE(c.exit, nullptr);
    EXPECT_NE(c.during, nullptr);
}

TEST(LowerMachines, StatementPointsAreDenseAndUnique) {
    const auto lowered = lower_text(
        "stm S {\n event g event e:nat var n:nat clock C\n initial i\n"
        " state A { entry n = 1 ; (if n > 0 then e!n else skip end) ; wait(2) exit #C }\n"
        " state B { during wait([1,2]) ; e!n <{3} ; e?n }\n"
        " transition s { from i to A action skip }\n transition t { from A to B trigger g <{2} }\n}\n");
    EXPECT_EQ(program(*lowered, "S", "A"),
              "0: sequence\n  1: n = 1\n  2: if (n > 0)\n    3: send e!n\n    4: skip\n  5: wait 2\n");
    EXPECT_EQ(lowered->node("S", "A").exit->point, 6U);
    const auto& during = *lowered->node("S", "B").during;
    EXPECT_EQ(during.point, 7U);
    ASSERT_EQ(during.body.size(), 3U);
    EXPECT_EQ(during.body[0]->kind, StmtKind::wait_interval);
    EXPECT_EQ(during.body[1]->kind, StmtKind::deadline);
    EXPECT_EQ(during.body[1]->body.at(0)->kind, StmtKind::communicate);
    EXPECT_EQ(during.body[2]->communication.kind, CommKind::input);
    EXPECT_EQ(lowered->transition("S", "s").action->point, 12U);
    EXPECT_EQ(lowered->machine("S").points, 13U);
    EXPECT_NE(lowered->transition("S", "t").deadline, nullptr);
    EXPECT_TRUE(lowered->machine("S").events[1].input);
    EXPECT_TRUE(lowered->machine("S").events[1].output);
}

TEST(LowerMachines, LegacyTriggerWithoutEvent) {
    const auto lowered =
        lower_text(machine_text("clock T var n:nat\ntransition a { from A to A trigger # T condition n > 0 }\n"));
    EXPECT_FALSE(lowered->transition("S", "a").trigger.has_value());
    EXPECT_EQ(lowered->transition("S", "a").resets.size(), 1U);
    EXPECT_EQ(lowered->guard("S", "a"), "(n > 0)");
}

TEST(LowerMachines, ScopesOfVariablesAndConstants) {
    const auto lowered = lower_text(
        "interface R { var r:nat const cr:nat }\ninterface U { var u:nat const cu:nat = 2 }\n"
        "stm S { requires R uses U var l:boolean const cl:real = 1\n initial i state A { } transition t { from i to A "
        "} }\n");
    const auto& machine = lowered->machine("S");
    ASSERT_EQ(machine.variables.size(), 3U);
    EXPECT_EQ(machine.variables[0].name, "l");
    EXPECT_EQ(machine.variables[0].interface, "");
    EXPECT_EQ(machine.variables[1].name, "r");
    EXPECT_EQ(machine.variables[1].scope, VariableScope::required);
    EXPECT_EQ(machine.variables[1].interface, "R");
    EXPECT_EQ(machine.variables[1].origin.element, "R::r");
    EXPECT_EQ(machine.variables[2].scope, VariableScope::local);
    EXPECT_EQ(machine.variables[2].interface, "U");
    ASSERT_EQ(machine.constants.size(), 3U);
    EXPECT_EQ(lowered->text("S", machine.constants[0].value), "1r");
    EXPECT_TRUE(machine.constants[1].required);
    EXPECT_FALSE(machine.constants[2].required);
    EXPECT_EQ(machine.interfaces, (std::vector<std::string>{"R", "U"}));
}

TEST(LowerComponents, InlinePartsHaveTheirPath) {
    const auto lowered = lower_text(R"(
interface I { op(n:nat) far() }
module M {
    robotic platform P { event e : nat provides I }
    controller C {
        requires I
        event e : nat
        var shared : nat
        stm S { requires I event e : nat initial i state A { entry op(1) ; far() } transition t { from i to A } transition u { from A to A action e!2 } }
        operation op(n:nat) { requires I initial i final f transition t { from i to f action far() } }
        connection S on e to C on e
    }
    connection C on e to P on e ( _async )
}
)");
    EXPECT_EQ(lowered->machine("M::C::S").name, "S");
    EXPECT_EQ(lowered->machine("M::C::op").kind, MachineKind::operation);
    const auto& controller = lowered->controller("M::C");
    EXPECT_EQ(controller.variables.at(0).scope, VariableScope::local);
    ASSERT_EQ(controller.machines.size(), 1U);
    EXPECT_EQ(controller.machines[0].name, "S");
    ASSERT_EQ(controller.machines[0].definitions.size(), 2U);
    EXPECT_TRUE(controller.machines[0].definitions[0].is_valid());
    EXPECT_FALSE(controller.machines[0].definitions[1].is_valid());
    ASSERT_EQ(controller.operations.size(), 1U);
    EXPECT_EQ(controller.operations[0].name, "far");
    EXPECT_TRUE(controller.events[0].output);
    EXPECT_FALSE(controller.events[0].input);
    EXPECT_TRUE(lowered->system.modules[0].platform.events[0].output);
    EXPECT_EQ(controller.connections[0].from.kind, EndKind::part);
    EXPECT_EQ(controller.connections[0].to.kind, EndKind::self);
    EXPECT_EQ(lowered->machine("M::C::op").variables[0].scope, VariableScope::parameter);
}

TEST(LowerComponents, RecursiveOperationsAreRefusedByName) {
    const auto lowered = lower_files({{"t.rct", R"(
interface I { walk() turn() }
operation walk() { requires I initial i final f transition t { from i to f action turn() } }
operation turn() { requires I initial i final f transition t { from i to f action walk() } }
stm S { requires I initial i state A { entry walk() } transition t { from i to A } }
controller C { requires I opref w = walk opref t = turn sref s = S }
)"}});
    EXPECT_EQ(lowered->codes(), Codes{"RC-S02"}) << lowered->messages();
    EXPECT_NE(lowered->messages().find("walk calls turn calls walk"), std::string::npos);
}

/// Returns a model in which walk requires `limit`, and each caller provides its own `limit`.
std::string limit_model(const std::string& second_caller) {
    return R"(
interface L { const limit : nat }
interface I { walk() }
operation walk() { requires L initial i final f transition t { from i to f } }
stm A { requires I const limit : nat initial i state s { entry walk() } transition t { from i to s } }
stm B { requires I const limit : nat initial i state s { )" +
           second_caller + R"( } transition t { from i to s } }
controller C { requires I opref w = walk sref a = A sref b = B }
)";
}

TEST(LowerComponents, ARequiredConstantOfAnOperationIsItsCallers) {
    const auto lowered = lower_text(limit_model(""));
    const auto& controller = lowered->controller("C");
    const auto source =
        constant_source(lowered->system, nullptr, &controller, "w", lowered->machine("walk"), ConstantId{0});
    EXPECT_EQ(source.name, "const_C_a_limit");
    std::vector<std::string> names;
    for (const auto& constant : named_constants(lowered->system)) names.push_back(constant.name);
    EXPECT_EQ(names, (std::vector<std::string>{"const_walk_limit", "const_A_limit", "const_B_limit", "const_C_a_limit",
                                               "const_C_b_limit"}));
}

TEST(LowerComponents, CallersThatProvideAConstantDifferentlyAreRefused) {
    const auto lowered = lower_files({{"t.rct", limit_model("entry walk()")}});
    EXPECT_EQ(lowered->codes(), Codes{"RC-S19"}) << lowered->messages();
    EXPECT_NE(lowered->messages().find("const_C_a_limit, const_C_b_limit"), std::string::npos);
}

TEST(LowerComponents, InstancesOfOneMachineShareAConstantUnlessAClaimSetsItForOne) {
    std::string two = limit_model("");
    two.replace(two.find("sref b = B"), 10, "sref b = A");
    EXPECT_EQ(lower_files({{"t.rct", two}})->codes(), Codes{});
    const auto one = [&](const std::string& name) {
        return lower_files({{"t.rct", two},
                            {"t.assertions",
                             "assertion A1 : C is deadlock-free with constant limit of " + name + " set to 1\n"}})
            ->codes();
    };
    EXPECT_EQ(one("C::a"), Codes{"RC-S19"});
    EXPECT_EQ(one("A"), Codes{}) << "it is set for both";
}

TEST(LowerMachines, StatesNestedTooDeepAreReported) {
    std::string text = "stm S {\n initial i\n transition t { from i to s }\n";
    const int depth = 70;
    for (int i = 0; i < depth; ++i) text += "state s {\n";
    for (int i = 0; i < depth; ++i) text += i == 0 ? "}\n" : "initial i\n transition t { from i to s }\n}\n";
    const auto lowered = lower_files({{"t.rct", text + "}\n"}});
    const auto codes = lowered->codes();
    EXPECT_NE(std::ranges::find(codes, "RC-S04"), codes.end()) << lowered->messages();
}

TEST(LowerExpressions, NamesLeftOpenAreReported) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    const frontend::Model model;
    Lowering lowering{model, sources, diagnostics};
    frontend::Expr name;
    name.kind = frontend::ExprKind::name;
    name.name.parts = {"nobody"};
    EXPECT_NE(lower_expression(lowering, {}, name), nullptr);
    ASSERT_EQ(diagnostics.sorted_findings().size(), 1U);
    EXPECT_EQ(diagnostics.sorted_findings()[0].rule->code, "RC-S05");
}

TEST(LowerComponents, FilesAreOrderedByPath) {
    const auto lowered = lower_files({{"b.rct", "stm B { initial i state A { } transition t { from i to A } }\n"},
                                      {"a.rct", "stm A { initial i state A { } transition t { from i to A } }\n"}});
    ASSERT_EQ(lowered->system.machines.size(), 2U) << lowered->messages();
    EXPECT_EQ(lowered->system.machines[0].name, "A");
}

TEST(Dump, IsStableAndComplete) {
    const auto lowered =
        lower_text("enumeration Colour { red green }\n" +
                   machine_text("event e:Colour\nclock C var c:Colour = green\n"
                                "transition a { from A to A trigger e?c # C <{2} condition since(C) > 3 "
                                "action c = red }\n"));
    EXPECT_EQ(dump_text(lowered->system),
              "enumeration Colour { red, green }\n"
              "machine S\n"
              "  variable local c: Colour = green\n"
              "  event in e: Colour\n"
              "  clock C\n"
              "  initial i\n"
              "  state A\n"
              "  transition start i -> A\n"
              "  transition a A -> A on e?c reset C within 2 when-timed (since(C) > 3) do\n"
              "      0: c = red\n");
}

}  // namespace
}  // namespace robochart::ir
