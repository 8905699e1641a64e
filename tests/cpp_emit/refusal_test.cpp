// SPDX-License-Identifier: Apache-2.0
// Tests that models for which no code can be generated are rejected with a named rule. For each rule of
// cpp_emit/plan/rules.hpp there is one model that violates only this rule.
#include "cpp_emit/plan/rules.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "semantics/instantiate/instantiate.hpp"
#include "tests/cpp_emit/harness.hpp"
#include "tests/cpp_emit/models.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"

namespace robochart::cpp_emit::refusal_test {
namespace {

using testing::component_named;

/// Returns the codes of the findings for a component.
std::vector<std::string> reported_codes(const ir::System& system, const ir::ComponentRef& ref) {
    diagnostics::Diagnostics diagnostics;
    const ir::Instantiation inst = ir::instantiate_system(system, {}, diagnostics);
    const Emission emission = emit(system, inst, ref, {}, diagnostics);
    EXPECT_TRUE(emission.files.empty());
    std::vector<std::string> result;
    for (const auto& finding : diagnostics.sorted_findings()) result.emplace_back(finding.rule->code);
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

std::vector<std::string> machine_codes(const std::string& body, const std::string& around = "") {
    const ir::System system = testing::load_model("package p\n" + around +
                                                  "stm M { initial i transition t0 { from i to A }\n" + body + "\n}\n");
    return reported_codes(system, component_named(system, "M"));
}

using Codes = std::vector<std::string>;

TEST(Refusals, NoSuchComponent) {
    const ir::System system = ir::samples::aggregation();
    ir::ComponentRef ref;
    ref.kind = ir::ComponentKind::machine;
    ref.path = "Nowhere";
    EXPECT_EQ(reported_codes(system, ref), Codes{"RC-G01"});
    ref.kind = ir::ComponentKind::process;
    EXPECT_EQ(reported_codes(system, ref), Codes{"RC-G01"});
    EXPECT_EQ(reported_codes(system, component_named(system, "MoveClockwise")), Codes{"RC-G01"});
}

TEST(Refusals, NoBody) {
    ir::System system = ir::samples::aggregation();
    system.machines[2].initial = {};
    EXPECT_EQ(reported_codes(system, component_named(system, "AggregationFSM")), Codes{"RC-G03"});
}

TEST(Refusals, Types) {
    std::string deep = "nat";
    for (int i = 0; i < 16; ++i) deep = "vector(" + deep + ", 1)";
    EXPECT_EQ(machine_codes("var s : vector(" + deep + ", 1) state A {}"), Codes{"RC-G04"});
    const ir::System system = testing::load_model("package p stm M { var s : " + deep +
                                                  " initial i state A {} transition t0 { from i to A } }");
    EXPECT_FALSE(testing::emit_ok(system, component_named(system, "M")).files.empty());
}

TEST(Refusals, Expressions) {
    EXPECT_EQ(machine_codes("var n : nat = <1, 2>[3] state A { entry n = n }"), Codes{"RC-G05"});
}

// These preconditions can be false. Two functions need each other in their preconditions. A deadline may have no value,
// and no source defines what it then means.
TEST(Refusals, Preconditions) {
    const std::string functions =
        "function f(n : nat) : nat { precondition g(n) > 0 } function g(n : nat) : nat { precondition f(n) > 0 }\n"
        "function h(n : nat) : nat { precondition n > 1 }\n";
    EXPECT_EQ(machine_codes("event e : nat var n : nat state A { entry e!(f(n)) }", functions), Codes{"RC-G05"});
    EXPECT_EQ(machine_codes("event e : nat var n : nat state A { } state B { } transition t1 { from A to B trigger e?n "
                            "<{ h(n) } }",
                            functions),
              Codes{"RC-G05"});
    const ir::System system = testing::load_model("package p\n" + functions +
                                                  "stm M { event e initial i state A {} transition t0 { from i to A }\n"
                                                  "transition t1 { from A to A trigger e <{ h(2) } } }");
    EXPECT_FALSE(testing::emit_ok(system, component_named(system, "M")).files.empty());
}

TEST(Refusals, SetsThatMayHaveTooManyMembers) {
    EXPECT_EQ(machine_codes("var s : Set(nat * nat * nat * nat * nat) state A { entry s = s }"), Codes{"RC-G13"});
}

TEST(Refusals, CompositeStatesWithoutInitialNode) {
    ir::System system = testing::load_model(
        "package p stm M { initial i state A { initial j state B {} transition u { from j to B } }\n"
        "transition t0 { from i to A } }");
    for (ir::Node& node : system.machines[0].nodes) node.initial = {};
    const auto got = reported_codes(system, component_named(system, "M"));
    EXPECT_EQ(std::ranges::count(got, "RC-G07"), 1);
}

TEST(Refusals, TriggersThatDoNotOnlyReceive) {
    ir::System system = ir::samples::aggregation();
    system.machines[2].transitions[1].trigger->kind = ir::CommKind::output;
    EXPECT_EQ(reported_codes(system, component_named(system, "AggregationFSM")), Codes{"RC-G08"});
}

TEST(Refusals, TriggersOutOfJunctions) {
    ir::System system = ir::samples::aggregation();
    system.machines[2].transitions[0].trigger = system.machines[2].transitions[1].trigger;
    EXPECT_EQ(reported_codes(system, component_named(system, "AggregationFSM")), Codes{"RC-G08"});
}

TEST(Refusals, Recursion) {
    ir::System system = ir::samples::aggregation();
    // MoveClockwise calls itself and does not write angularSpeed.
    auto& entry = system.machines[0].nodes[1].entry;
    ir::Stmt call = *system.machines[2].nodes[1].entry;
    ir::Stmt sequence = *entry;
    sequence.body[0] = std::make_shared<const ir::Stmt>(call);
    entry = std::make_shared<const ir::Stmt>(sequence);
    EXPECT_EQ(reported_codes(system, component_named(system, "Aggregation")), Codes{"RC-G10"});
    EXPECT_TRUE(testing::emit_ok(system, component_named(system, "AggregationFSM")).files.size() >
                1);  // in this component, the platform provides the operation
}

TEST(Refusals, ConditionsOnTheValueOfAnUnconnectedEvent) {
    const auto controller = [](const std::string& condition) {
        return testing::load_model(
            "package p\ncontroller C { sref m = M }\nstm M { event e : nat var x : nat initial i state A {} state B "
            "{}\n"
            "transition t0 { from i to A } transition t1 { from A to B trigger e?x" +
            condition + " } }");
    };
    const ir::System asking = controller(" condition x > 0");
    EXPECT_EQ(reported_codes(asking, component_named(asking, "C")), Codes{"RC-G11"});
    const ir::System taking = controller("");
    EXPECT_FALSE(testing::emit_ok(taking, component_named(taking, "C")).files.empty());
}

TEST(Refusals, ConnectionsOfAMachineWithItself) {
    const ir::System system = testing::load_model(
        "package p\ncontroller C { sref m = M connection m on e to m on f }\nstm M { event e event f initial i\n"
        "state A { entry e } transition t0 { from i to A } transition t1 { from A to A trigger f } }");
    EXPECT_EQ(reported_codes(system, component_named(system, "C")), Codes{"RC-G11"});
}

TEST(Refusals, TransitionsAcrossStates) {
    ir::System system = ir::samples::aggregation();
    system.machines[2].nodes[2].parent = ir::NodeId{1};
    const auto got = reported_codes(system, component_named(system, "AggregationFSM"));
    EXPECT_EQ(std::ranges::count(got, "RC-G12"), 1);
}

TEST(Refusals, TooManyArguments) {
    std::string parameters, arguments;
    for (int i = 0; i < 9; ++i) {
        parameters += (i == 0 ? "p" : ", p") + std::to_string(i) + " : nat";
        arguments += i == 0 ? "0" : ", 0";
    }
    EXPECT_EQ(
        machine_codes("requires I state A { entry op(" + arguments + ") }", "interface I { op(" + parameters + ") }\n"),
        Codes{"RC-G13"});
}

/// nat ranges over 0 to 2: 81, 19,683 and 43,046,721 values.
TEST(Refusals, MoreValuesThanTheExplorationInterfaceTakes) {
    const auto sends = [](const char* size) {
        const std::string type = std::string("matrix(nat, ") + size + ")";
        return "package p stm M { event out : " + type + " var m : " + type +
               " initial i state A { entry out!m } transition t0 { from i to A } }";
    };
    const ir::System large = testing::load_model(sends("4, 4"));
    EXPECT_EQ(reported_codes(large, component_named(large, "M")), Codes{"RC-G13"});
    for (const char* size : {"2, 2", "3, 3"}) {
        const ir::System system = testing::load_model(sends(size));
        EXPECT_FALSE(testing::emit_ok(system, component_named(system, "M")).shim.empty()) << size;
    }
    EXPECT_EQ(machine_codes("event e : matrix(nat, 3, 3) var m : matrix(nat, 3, 3) state A { }\n"
                            "transition t1 { from A to A trigger e?m }"),
              Codes{"RC-G13"});
}

/// The value is one of 65,536 sets of sets of four numbers. This number of values is acceptable, but each value has
/// many parts.
TEST(Refusals, ValuesOfManyPartsAreNotListed) {
    EXPECT_EQ(machine_codes("event out : Set(Set(nat)) var n : nat = 3 var s : Set(Set(nat)) state A { entry out!s }"),
              Codes{"RC-G13"});
    const ir::System small = testing::load_model(
        "stm M { event out : Set(nat) var n : nat = 3 var s : Set(nat) initial i transition t0 { from i to A }\n"
        "state A { entry out!s } }");
    EXPECT_FALSE(testing::emit_ok(small, component_named(small, "M")).shim.empty());
}

TEST(Refusals, NeedNotBeExplored) {
    const ir::System system = testing::load_model(
        "package p stm M { event e : matrix(nat, 3, 3) var m : matrix(nat, 3, 3) initial i state A { } transition t0 { "
        "from i to A }\n"
        "transition t1 { from A to A trigger e?m } }");
    diagnostics::Diagnostics diagnostics;
    Options options;
    options.explored = false;
    const ir::Instantiation inst = ir::instantiate_system(system, {}, diagnostics);
    const Emission emission = emit(system, inst, component_named(system, "M"), options, diagnostics);
    ASSERT_EQ(diagnostics.sorted_findings().size(), 1U);
    EXPECT_EQ(diagnostics.sorted_findings().front().rule->code, "RC-G15");
    EXPECT_TRUE(diagnostics.ok());
    EXPECT_TRUE(emission.shim.empty());
    EXPECT_FALSE(emission.files.empty());
    for (const OutputFile& file : emission.files) EXPECT_EQ(file.path.find("explore"), std::string::npos) << file.path;
}

TEST(Refusals, StatesThatGrowWithNestedOperations) {
    // Each operation calls the previous one from two threads, so there are 2^k frames of at least one byte.
    std::string text = "package p interface I { op0()";
    for (int k = 1; k <= 17; ++k) text += " op" + std::to_string(k) + "()";
    text +=
        " }\noperation op0() { initial i state S {} final F transition t0 { from i to S } transition t1 { from S to F "
        "} }\n";
    std::string references = " opref r0 = op0";
    for (int k = 1; k <= 17; ++k) {
        const std::string inner = "op" + std::to_string(k - 1) + "()";
        text += "operation op" + std::to_string(k) + "() { requires I initial i state S { entry " + inner + " during " +
                inner + " } final F transition t0 { from i to S } transition t1 { from S to F } }\n";
        references += " opref r" + std::to_string(k) + " = op" + std::to_string(k);
    }
    text +=
        "stm M { requires I initial i state A { entry op17() } transition t0 { from i to A } }\ncontroller C { sref m "
        "= M" +
        references + " }";
    const ir::System system = testing::load_model(text);
    EXPECT_EQ(reported_codes(system, component_named(system, "C")), Codes{"RC-G13"});
}

TEST(Rules, AreAllDistinct) {
    std::vector<std::string_view> seen;
    for (const auto* rule : rules::all) {
        EXPECT_EQ(std::ranges::count(seen, rule->code), 0) << rule->code;
        seen.push_back(rule->code);
    }
}

}  // namespace
}  // namespace robochart::cpp_emit::refusal_test
