// SPDX-License-Identifier: Apache-2.0
// Lowers the two case studies, and compares the result field by field with the model texts in corpus/.
#include <gtest/gtest.h>

#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/dump.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/query.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"
#include "tests/semantics/sample_systems/sample_systems.hpp"
#include "tests/source_folder.hpp"

namespace robochart::ir {
namespace {

using namespace samples;

const std::string corpus = tests::source_folder().string() + "/corpus/";

TEST(LowerCorpus, AggregationEqualsTheSystemWrittenByHand) {
    auto lowered = lower_path(corpus + "aggregation/aggregation.rct");
    lowered->system.properties.clear();
    lowered->system.csp_blocks.clear();
    EXPECT_EQ(dump_text(lowered->system), dump_text(aggregation()));
}

TEST(LowerCorpus, AggregationOrigins) {
    const auto lowered = lower_path(corpus + "aggregation/aggregation.rct");
    const auto& machine = lowered->machine("AggregationFSM");
    EXPECT_EQ(machine.origin.element, "AggregationFSM");
    EXPECT_EQ(lowered->node("AggregationFSM", "S1").origin.element, "AggregationFSM::S1");
    EXPECT_EQ(lowered->transition("AggregationFSM", "t1").origin.element, "AggregationFSM::t1");
    EXPECT_EQ(lowered->transition("MoveClockwise", "t1").origin.element, "MoveClockwise::t1");
    const auto& entry = *lowered->node("AggregationFSM", "S1").entry;
    EXPECT_EQ(entry.origin.element, "AggregationFSM::S1");
    EXPECT_EQ(
        lowered->sources.line_text(entry.origin.span.source,
                                   lowered->sources.position(entry.origin.span.source, entry.origin.span.begin).line),
        "\tstate S1 { entry MoveClockwise(-0.75, -10.88) }");
}

TEST(LowerCorpus, AggregationNumbers) {
    const auto lowered = lower_path(corpus + "aggregation/aggregation.rct");
    const auto& call = *lowered->node("AggregationFSM", "S1").entry;
    ASSERT_EQ(call.kind, StmtKind::call);
    ASSERT_EQ(call.args.size(), 2U);
    EXPECT_EQ(call.args[0]->kind, ExprKind::real);
    EXPECT_EQ(call.args[0]->decimal.unscaled, -75);
    EXPECT_EQ(call.args[0]->decimal.decimals, 2U);
    EXPECT_EQ(call.args[1]->decimal.unscaled, -1088);
    diagnostics::Diagnostics diagnostics;
    EXPECT_EQ(instantiate_system(lowered->system, {}, diagnostics).scale, 100);
}

TEST(LowerCorpus, SwarmTaxisMachine) {
    const auto lowered = lower_path(corpus + "swarm_taxis/swarm_taxis.rct");
    const auto& machine = lowered->machine("SwarmTaxisFSM");
    ASSERT_EQ(machine.variables.size(), 4U);
    for (const auto& variable : machine.variables) {
        EXPECT_EQ(variable.scope, VariableScope::required);
        EXPECT_EQ(variable.interface, "SwarmTaxisIface");
        EXPECT_NE(variable.initial, nullptr);
    }
    EXPECT_EQ(machine.variables[0].name, "avoidanceRadius");
    EXPECT_EQ(lowered->text("SwarmTaxisFSM", machine.variables[0].initial), "0.1r");
    EXPECT_EQ(lowered->text("SwarmTaxisFSM", machine.variables[3].initial), "0r");
    ASSERT_EQ(machine.clocks.size(), 1U);
    EXPECT_EQ(machine.clocks[0].name, "T");
    ASSERT_EQ(machine.events.size(), 4U);
    for (const auto& event : machine.events) EXPECT_FALSE(event.output) << event.name;
    EXPECT_TRUE(machine.events[0].input);   // robotDetected is a trigger
    EXPECT_TRUE(machine.events[1].input);   // illumination is a trigger
    EXPECT_TRUE(machine.events[2].input);   // heading is received by a statement
    EXPECT_FALSE(machine.events[3].input);  // turned is only used by the operation Turn
    EXPECT_EQ(machine.operations.size(), 7U);
}

TEST(LowerCorpus, SwarmTaxisTransitions) {
    const auto lowered = lower_path(corpus + "swarm_taxis/swarm_taxis.rct");
    const std::string fsm = "SwarmTaxisFSM";
    EXPECT_EQ(lowered->guard(fsm, "t1"), "(since(T) < 25)");
    EXPECT_EQ(lowered->guard(fsm, "t2"), "(since(T) >= 25)");
    EXPECT_EQ(lowered->guard(fsm, "t4"), "(reached == true)");
    EXPECT_TRUE(lowered->transition(fsm, "t1").guard_timed);
    EXPECT_FALSE(lowered->transition(fsm, "t4").guard_timed);
    EXPECT_EQ(lowered->transition(fsm, "t1").resets, std::vector<ClockId>{ClockId{0}});
    EXPECT_TRUE(lowered->transition(fsm, "t3").resets.empty());
    const auto& trigger = lowered->transition(fsm, "t3").trigger;
    ASSERT_TRUE(trigger.has_value());
    EXPECT_EQ(trigger->kind, CommKind::input);
    EXPECT_EQ(lowered->machine(fsm).variables[trigger->variable.index].name, "illuminated");
    ASSERT_NE(lowered->transition(fsm, "t3").action, nullptr);
    EXPECT_EQ(lowered->transition(fsm, "t3").action->kind, StmtKind::call);
}

TEST(LowerCorpus, SwarmTaxisDefinitionsInTheController) {
    const auto lowered = lower_path(corpus + "swarm_taxis/swarm_taxis.rct");
    const auto& controller = lowered->controller("SwarmTaxisController");
    EXPECT_EQ(controller.definition_names, (std::vector<std::string>{"update_ref", "turn_ref"}));
    const auto& machine = lowered->machine("SwarmTaxisFSM");
    ASSERT_EQ(controller.machines.size(), 1U);
    const auto& definitions = controller.machines[0].definitions;
    ASSERT_EQ(definitions.size(), machine.operations.size());
    for (std::size_t i = 0; i < definitions.size(); ++i) {
        const auto& name = machine.operations[i].name;
        const bool defined = name == "UpdateAvoidanceRadius" || name == "Turn";
        ASSERT_EQ(definitions[i].is_valid(), defined) << name;
        if (defined) {
            EXPECT_EQ(lowered->system.machine(definitions[i]).name, name);
        }
    }
    EXPECT_EQ(controller.operations.size(), 5U);  // seven operations are required, two of them are defined
    // Turn calls StartTurning, which has no definition.
    const auto& turn = lowered->machine("Turn");
    ASSERT_EQ(called_operations(turn).size(), 1U);
    const auto& start = turn.operations[called_operations(turn)[0].index];
    EXPECT_EQ(start.name, "StartTurning");
    EXPECT_FALSE(definition_in(lowered->system, controller, start).is_valid());
    EXPECT_TRUE(turn.events[3].input);
}

TEST(LowerCorpus, SwarmTaxisFinite) {
    const auto lowered = lower_path(corpus + "swarm_taxis/swarm_taxis.rct");
    diagnostics::Diagnostics diagnostics;
    const auto inst = instantiate_system(lowered->system, {}, diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    EXPECT_EQ(inst.scale, 10);
    EXPECT_EQ(inst.real, (std::vector<std::int64_t>{-20, -10, 0, 1, 2, 10, 20}));
    EXPECT_EQ(inst.nat, (std::vector<std::int64_t>{0, 1, 2}));
    EXPECT_EQ(inst.clock_bound, 26);
    const auto& machine = lowered->machine("SwarmTaxisFSM");
    EXPECT_EQ(clock_saturation(lowered->system, inst, machine, ClockId{0}), 26);
}

TEST(LowerCorpus, Module) {
    const auto lowered = lower_path(corpus + "aggregation/aggregation.rct");
    ASSERT_EQ(lowered->system.modules.size(), 1U);
    const auto& module = lowered->system.modules[0];
    EXPECT_EQ(module.platform.name, "EPuck");
    EXPECT_EQ(module.platform.variables[0].scope, VariableScope::required);  // provided: visible to the platform
    EXPECT_EQ(module.platform.operations.size(), 2U);
    ASSERT_EQ(module.connections.size(), 2U);
    EXPECT_EQ(module.connections[0].from.kind, EndKind::self);
    EXPECT_EQ(module.connections[0].to.kind, EndKind::part);
    EXPECT_EQ(module.connections[0].to.part, 0U);
    EXPECT_EQ(module.connections[0].from.event, "seeWall");
    EXPECT_TRUE(module.connections[0].async);
    EXPECT_TRUE(module.platform.events[0].input);
    EXPECT_FALSE(module.platform.events[0].output);
}

}  // namespace
}  // namespace robochart::ir
