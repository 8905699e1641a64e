// SPDX-License-Identifier: Apache-2.0
// Tests finite instantiations of a model (semantics 3.6, 3.13).

#include <gtest/gtest.h>
#include <algorithm>

#include <limits>

#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/query.hpp"
#include "semantics/rules.hpp"
#include "tests/semantics/expressions.hpp"
#include "tests/semantics/lower/lowering_fixture.hpp"

namespace robochart::ir {
namespace {

using namespace samples;
using diagnostics::Diagnostics;

/// Returns a system with one machine `S` of package P, whose only transition has this guard.
System with_guard(ExprPtr guard) {
    System system = core_system();
    Machine machine;
    machine.name = machine.path = "S";
    machine.package = "P";
    machine.variables.push_back({"n", types.nat, VariableScope::local, nullptr, "", {}});
    machine.variables.push_back({"x", types.real, VariableScope::local, nullptr, "", {}});
    machine.clocks.push_back({"C", {}, false, "", {}});
    machine.nodes.resize(1);
    Transition transition;
    transition.source = transition.target = NodeId{0};
    transition.guard = std::move(guard);
    machine.transitions.push_back(transition);
    system.machines.push_back(machine);
    return system;
}

ExprPtr compare(ExprKind kind, ExprPtr left, ExprPtr right) {
    return make(kind, types.boolean, {std::move(left), std::move(right)});
}

Instantiation instantiate_quietly(const System& system, const InstantiationOptions& options = {}) {
    Diagnostics diagnostics;
    auto result = instantiate_system(system, options, diagnostics);
    EXPECT_TRUE(diagnostics.empty());
    return result;
}

std::vector<std::string> codes(const System& system, const InstantiationOptions& options) {
    Diagnostics diagnostics;
    (void)instantiate_system(system, options, diagnostics);
    std::vector<std::string> result;
    for (const auto& item : diagnostics.sorted_findings()) result.emplace_back(item.rule->code);
    return result;
}

using Codes = std::vector<std::string>;
using Numbers = std::vector<std::int64_t>;

TEST(Instantiate, DefaultsWithoutLiterals) {
    const auto inst = instantiate_quietly(core_system());
    EXPECT_EQ(inst.nat, (Numbers{0, 1, 2}));
    EXPECT_EQ(inst.integer, (Numbers{-2, -1, 0, 1, 2}));
    EXPECT_EQ(inst.real, (Numbers{-2, -1, 0, 1, 2}));
    EXPECT_EQ(inst.scale, 1);
    EXPECT_EQ(inst.clock_bound, 10);
}

TEST(Instantiate, LiteralsWidenTheirTypeAndTheTypesAboveIt) {
    const auto inst = instantiate_quietly(with_guard(compare(ExprKind::less, samples::variable(0, types.nat), nat(4))));
    EXPECT_EQ(inst.nat, (Numbers{0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(inst.integer, (Numbers{-2, -1, 0, 1, 2, 3, 4, 5}));
    EXPECT_EQ(inst.real, (Numbers{-2, -1, 0, 1, 2, 3, 4, 5}));
}

TEST(Instantiate, RealLiteralsWidenRealOnly) {
    const auto inst =
        instantiate_quietly(with_guard(compare(ExprKind::less, samples::variable(1, types.real), decimal(4, 0))));
    EXPECT_EQ(inst.nat, (Numbers{0, 1, 2}));
    EXPECT_EQ(inst.real.back(), 5);
}

TEST(Instantiate, AggregationHasScaleOneHundredAndItsSpeeds) {
    const auto inst = instantiate_quietly(aggregation());
    EXPECT_EQ(inst.scale, 100);
    // The carrier contains the integers within -10.88..2 and the decimals -10.88, -5.02, -0.75.
    EXPECT_EQ(inst.real,
              (Numbers{-1088, -1000, -900, -800, -700, -600, -502, -500, -400, -300, -200, -100, -75, 0, 100, 200}));
    EXPECT_EQ(inst.nat, (Numbers{0, 1, 2}));
    EXPECT_EQ(inst.integer, (Numbers{-2, -1, 0, 1, 2}));
}

TEST(Instantiate, TimesDoNotWidenCarriers) {
    const auto guard = compare(ExprKind::less, since(0), nat(25));
    const auto inst = instantiate_quietly(with_guard(guard));
    EXPECT_EQ(inst.nat.back(), 2);
    EXPECT_EQ(inst.clock_bound, 26);
}

TEST(Instantiate, DecimalTimesCountForTheScaleAlone) {
    const auto clock = make(ExprKind::cast, types.real, {since(0)});
    const auto inst = instantiate_quietly(with_guard(compare(ExprKind::less, clock, decimal(25, 1))));
    EXPECT_EQ(inst.scale, 10);
    EXPECT_EQ(inst.real, (Numbers{-20, -10, 0, 10, 20}));
}

TEST(Instantiate, ClockSaturatesAboveTheLargestComparison) {
    Diagnostics diagnostics;
    auto system = with_guard(compare(ExprKind::greater_equal, since(0), samples::variable(0, types.nat)));
    auto inst = instantiate_system(system, {}, diagnostics);
    EXPECT_EQ(clock_saturation(system, inst, system.machines[0], ClockId{0}), 3);  // for n <= 2
    system = with_guard(compare(ExprKind::less, make(ExprKind::cast, types.real, {since(0)}), decimal(25, 1)));
    inst = instantiate_system(system, {}, diagnostics);
    EXPECT_EQ(clock_saturation(system, inst, system.machines[0], ClockId{0}), 4);  // 2.5 rounds up to 3
    system = with_guard(truth(true));
    EXPECT_EQ(clock_saturation(system, inst, system.machines[0], ClockId{0}), 1);
}

TEST(Instantiate, ClockSaturationLooksIntoCalledOperations) {
    auto system = with_guard(truth(true));
    Machine operation = with_guard(compare(ExprKind::less, since(0), nat(7))).machines[0];
    operation.kind = MachineKind::operation;
    operation.name = operation.path = "op";
    operation.clocks[0].required = true;
    system.machines.push_back(operation);
    system.machines[0].operations.push_back({"op", {}, {}, false, "", {}});
    Stmt call;
    call.kind = StmtKind::call;
    call.operation = OperationId{0};
    system.machines[0].transitions[0].action = std::make_shared<const Stmt>(call);
    const auto inst = instantiate_quietly(system);
    EXPECT_EQ(clock_saturation(system, inst, system.machines[0], ClockId{0}), 8);
    EXPECT_EQ(inst.clock_bound, 10);
}

/// Returns a system with a machine P::S with constants c (nat, without a value) and d (real, 0.5), and a controller
/// P::K, which references the machine as `ref` and provides r.
System with_constants() {
    System system = with_guard(truth(true));
    auto& machine = system.machines[0];
    machine.constants.push_back({"c", types.nat, nullptr, false, "", {}});
    machine.constants.push_back({"d", types.real, decimal(5, 1), false, "", {}});
    machine.constants.push_back({"r", types.boolean, nullptr, true, "I", {}});
    Controller controller;
    controller.name = controller.path = "K";
    controller.package = "P";
    controller.constants.push_back({"r", types.boolean, nullptr, false, "", {}});
    controller.machines.push_back({"ref", MachineId{0}, {}, {}});
    system.controllers.push_back(controller);
    return system;
}

TEST(Instantiate, ConstantsWithoutValueGetTheDefaultUnderRoboToolsNames) {
    const auto inst = instantiate_quietly(with_constants());
    const std::map<std::string, Value> expected{
        {"const_P_S_c", {0, {}}}, {"const_P_S_r", {1, {}}}, {"const_P_K_r", {1, {}}}, {"const_P_K_ref_c", {0, {}}}};
    EXPECT_EQ(inst.constants, expected);
}

TEST(Instantiate, OptionsSetConstantsByNameOrPath) {
    auto inst = instantiate_quietly(with_constants(), {{{"c", "4"}}, {}});
    EXPECT_EQ(inst.constants.at("const_P_S_c"), (Value{4, {}}));
    EXPECT_EQ(inst.constants.at("const_P_K_ref_c"), (Value{4, {}}));
    EXPECT_EQ(inst.nat.back(), 4);
    inst = instantiate_quietly(with_constants(), {{{"K::ref::c", "1"}, {"P::S::d", "0.25"}}, {}});
    EXPECT_EQ(inst.constants.at("const_P_S_c"), (Value{0, {}}));
    EXPECT_EQ(inst.constants.at("const_P_K_ref_c"), (Value{1, {}}));
    EXPECT_EQ(inst.scale, 100);
    EXPECT_EQ(inst.constants.at("const_P_S_d"), (Value{25, {}}));
}

TEST(Instantiate, AMachinesConstantIsThatOfItsPartsUnlessTheyHaveTheirOwn) {
    auto inst = instantiate_quietly(with_constants(), {{{"S::c", "1"}, {"P::S::d", "0.25"}}, {}});
    EXPECT_EQ(inst.constants.at("const_P_K_ref_c"), (Value{1, {}}));
    EXPECT_EQ(inst.constants.at("const_P_K_ref_d"), (Value{25, {}})) << "also where the model gives a value";
    inst = instantiate_quietly(with_constants(), {{{"S::c", "1"}, {"ref::c", "2"}}, {}});
    EXPECT_EQ(inst.constants.at("const_P_S_c"), (Value{1, {}}));
    EXPECT_EQ(inst.constants.at("const_P_K_ref_c"), (Value{2, {}}));
    EXPECT_EQ(instantiate_quietly(with_constants(), {{{"S::r", "false"}}, {}}).constants.at("const_P_K_r"),
              (Value{1, {}}))
        << "what the controller provides is another constant";
}

TEST(Instantiate, ConstantValuesFollowTheContext) {
    const auto system = with_constants();
    const auto inst = instantiate_quietly(system, {{{"P::K::r", "false"}, {"K::ref::c", "2"}}, {}});
    const auto& machine = system.machines[0];
    const std::vector<Value> alone{{0, {}}, {5, {}}, {1, {}}};
    const std::vector<Value> in_controller{{2, {}}, {5, {}}, {0, {}}};
    EXPECT_EQ(constant_values(system, inst, nullptr, nullptr, "", machine), alone);
    EXPECT_EQ(constant_values(system, inst, nullptr, &system.controllers[0], "ref", machine), in_controller);
}

TEST(Instantiate, WrongConstantOptionsAreReported) {
    EXPECT_EQ(codes(with_constants(), {{{"cc", "1"}}, {}}), Codes{"RC-S10"});
    EXPECT_EQ(codes(with_constants(), {{{"c", "-1"}}, {}}), Codes{"RC-S11"});
    EXPECT_EQ(codes(with_constants(), {{{"c", "1.5"}}, {}}), Codes{"RC-S11"});
    EXPECT_EQ(codes(with_constants(), {{{"r", "1"}}, {}}), Codes{"RC-S11"});
    EXPECT_EQ(codes(with_constants(), {{{"d", "99999999999999999999"}}, {}}), Codes{"RC-S11"});
}

/// "S::c" and "c" name the same constant. Two values contradict each other in either order, so they are rejected.
TEST(Instantiate, TwoNamesOfOneConstantAreRefused) {
    EXPECT_EQ(codes(with_constants(), {{{"c", "1"}, {"S::c", "2"}}, {}}), Codes{"RC-S24"});
    EXPECT_EQ(codes(with_constants(), {{{"S::c", "1"}, {"P::S::c", "2"}}, {}}), Codes{"RC-S24"});
    EXPECT_EQ(codes(with_constants(), {{{"ref::c", "1"}, {"c", "2"}}, {}}), Codes{"RC-S24"});
    EXPECT_EQ(codes(with_constants(), {{{"S::c", "1"}, {"ref::c", "2"}}, {}}), Codes{});
}

TEST(Instantiate, StrongerNamesOverrideHoweverTheyAreSpelled) {
    const System system = with_constants();
    EXPECT_EQ(not_overridden(system, {{"c", "1"}, {"d", "2"}}, {}), (GivenConstants{{"c", "1"}, {"d", "2"}}));
    EXPECT_EQ(not_overridden(system, {{"S::c", "1"}, {"d", "2"}}, {{"c", "3"}}), (GivenConstants{{"d", "2"}}));
    EXPECT_EQ(not_overridden(system, {{"P::S::d", "2"}}, {{"d", "3"}}), GivenConstants{});
    EXPECT_EQ(not_overridden(system, {{"d", "2"}}, {{"P::S::d", "3"}, {"ref::d", "3"}}), GivenConstants{});
    // A value of the machine's own constant also applies to its instances.
    EXPECT_EQ(not_overridden(system, {{"ref::c", "1"}}, {{"S::c", "3"}}), GivenConstants{});
    EXPECT_EQ(not_overridden(system, {{"S::c", "1"}}, {{"ref::c", "3"}}), (GivenConstants{{"S::c", "1"}}));
    // One of the constants called `c` is not overridden, so `c` is kept. (If both names are given together, they are
    // then rejected.)
    EXPECT_EQ(not_overridden(system, {{"c", "1"}}, {{"ref::c", "3"}}), (GivenConstants{{"c", "1"}}));
    EXPECT_EQ(not_overridden(system, {{"c", "1"}}, {{"P::S::c", "3"}}), GivenConstants{}) << "and so that of the part";
    EXPECT_EQ(not_overridden(system, {{"none", "1"}}, {{"c", "3"}}), (GivenConstants{{"none", "1"}}))
        << "it is reported";
}

TEST(Instantiate, ChosenRanges) {
    const auto inst = instantiate_quietly(core_system(), {{}, {{"nat", {0, 4}}}});
    EXPECT_EQ(inst.nat, (Numbers{0, 1, 2, 3, 4}));
    EXPECT_EQ(inst.real.back(), 4);
}

TEST(Instantiate, ChosenSizes) {
    const auto inst = instantiate_quietly(core_system(), {{}, {{"Seq", {0, 3}}, {"clock", {0, 4}}, {"given", {0, 4}}}});
    EXPECT_EQ(inst.sequence_bound, 3);
    EXPECT_EQ(inst.clock_bound, 4);
    EXPECT_EQ(inst.given_size, 5);
    // For since(C) < 25, the clock must count to 26, one beyond 25.
    const auto system = with_guard(compare(ExprKind::less, since(0), nat(25)));
    EXPECT_EQ(instantiate_quietly(system, {{}, {{"clock", {0, 26}}}}).clock_bound, 26);
    EXPECT_EQ(codes(system, {{}, {{"clock", {0, 25}}}}), Codes{"RC-S13"});
}

TEST(Instantiate, WrongRangesAreReported) {
    EXPECT_EQ(codes(core_system(), {{}, {{"bool", {0, 1}}}}), Codes{"RC-S12"});
    EXPECT_EQ(codes(core_system(), {{}, {{"nat", {2, 1}}}}), Codes{"RC-S13"});
    for (const char* size : {"Seq", "clock", "given"}) {
        EXPECT_EQ(codes(core_system(), {{}, {{size, {1, 3}}}}), Codes{"RC-S13"}) << size << " is counted from 0";
        EXPECT_EQ(codes(core_system(), {{}, {{size, {0, -1}}}}), Codes{"RC-S13"}) << size;
    }
    EXPECT_EQ(codes(core_system(), {{}, {{"nat", {-1, 1}}}}), Codes{"RC-S13"});
    EXPECT_EQ(codes(core_system(), {{}, {{"int", {1, 5}}}}), Codes{"RC-S13"});
    EXPECT_EQ(codes(core_system(), {{}, {{"int", {-1, 1}}}}), Codes{"RC-S14"});
    const auto most = std::numeric_limits<std::int64_t>::max();
    const auto least = std::numeric_limits<std::int64_t>::min();
    EXPECT_EQ(codes(core_system(), {{}, {{"real", {least, most}}}}), Codes{"RC-S15"});
}

TEST(Instantiate, LiteralOutsideAChosenRangeIsAWarning) {
    const auto system = with_guard(compare(ExprKind::less, samples::variable(0, types.nat), nat(9)));
    Diagnostics diagnostics;
    const auto inst = instantiate_system(system, {{}, {{"nat", {0, 3}}}}, diagnostics);
    EXPECT_EQ(diagnostics.warning_count(), 1U);
    EXPECT_EQ(diagnostics.error_count(), 0U);
    EXPECT_EQ(inst.nat.back(), 3);
}

TEST(Instantiate, NumbersTooLargeForTheScaleAreReported) {
    auto guard = make(ExprKind::conjunction, types.boolean,
                      {compare(ExprKind::less, samples::variable(1, types.real), decimal(20, 0)),
                       compare(ExprKind::less, samples::variable(1, types.real), decimal(1, 18))});
    EXPECT_EQ(codes(with_guard(guard), {}), Codes{"RC-S16"});
    EXPECT_EQ(codes(with_guard(compare(ExprKind::less, samples::variable(0, types.nat), nat(1LL << 40))), {}),
              Codes{"RC-S25"});
}

/// The carriers have the numbers that comparisons with the model's numbers can distinguish. Each type still contains
/// the narrower types.
TEST(Instantiate, ALargeRangeHasTheNumbersOfTheModelAndTheirNeighbours) {
    const auto lowered = samples::lower_text(samples::machine_text(
        "event e:nat var n:nat var k:int transition t { from A to A trigger e?n condition n < 4000000 /\\ k > 7 }"));
    Diagnostics diagnostics;
    const Instantiation inst = instantiate_system(lowered->system, {}, diagnostics);
    EXPECT_TRUE(diagnostics.ok());
    EXPECT_EQ(inst.nat, (std::vector<std::int64_t>{0, 1, 2, 6, 7, 8, 3999999, 4000000, 4000001}));
    EXPECT_EQ(inst.integer, (std::vector<std::int64_t>{-2, -1, 0, 1, 2, 6, 7, 8, 3999999, 4000000, 4000001}));
    EXPECT_EQ(inst.real, inst.integer);
}

/// The message shows the number that makes a type large, with its place in the model. If an option causes it, there is
/// no place.
TEST(Instantiate, ATypeThatIsTooLargeNamesTheNumber) {
    const auto lowered = samples::lower_text(
        samples::machine_text("event e:nat var n:nat transition t { from A to A trigger e?n condition n < 4000000 }"));
    const auto first = [&](const InstantiationOptions& options) {
        Diagnostics diagnostics;
        (void)instantiate_system(lowered->system, options, diagnostics);
        return diagnostics.sorted_findings().at(0);
    };
    const diagnostics::Diagnostic found = first({});
    EXPECT_EQ(found.rule->code, "RC-S25");
    ASSERT_TRUE(found.span.is_known());
    EXPECT_EQ(
        lowered->sources.source_text(found.span.source).substr(found.span.begin, found.span.end - found.span.begin),
        "4000000");
    const diagnostics::Diagnostic chosen = first({{}, {{"nat", {0, 5000000}}}});
    EXPECT_EQ(chosen.rule->code, "RC-S15");
    EXPECT_FALSE(chosen.span.is_known());
}

TEST(Carrier, ComposedTypes) {
    System system = core_system();
    const auto add = [&](Type type) {
        system.types.push_back(std::move(type));
        return TypeId{static_cast<std::uint32_t>(system.types.size() - 1)};
    };
    const auto of = [&](TypeKind kind, std::vector<TypeId> args) {
        Type type;
        type.kind = kind;
        type.args = std::move(args);
        return add(type);
    };
    Type colour;
    colour.kind = TypeKind::enumeration;
    colour.labels = {"red", "dim"};
    colour.literal_args = {{}, {types.boolean}};
    const auto colour_id = add(colour);
    const auto inst = instantiate_quietly(system);
    EXPECT_EQ(carrier_values(system, inst, colour_id), (std::vector<Value>{{0, {}}, {1, {{0, {}}}}, {1, {{1, {}}}}}));
    EXPECT_EQ(carrier_values(system, inst, of(TypeKind::sequence, {types.boolean})).size(), 1U + 2U + 4U);
    EXPECT_EQ(carrier_values(system, inst, of(TypeKind::set, {types.nat})).size(), 8U);
    EXPECT_EQ(carrier_values(system, inst, of(TypeKind::product, {types.nat, types.boolean})).size(), 6U);
    EXPECT_EQ(carrier_values(system, inst, of(TypeKind::function, {types.boolean, types.nat})).size(), 9U);
    EXPECT_EQ(carrier_values(system, inst, of(TypeKind::relation, {types.boolean, types.boolean})).size(), 16U);
    EXPECT_THROW((void)carrier_values(system, inst, of(TypeKind::set, {types.integer}), 31), std::length_error);
    Instantiation with_strings = inst;
    with_strings.strings = {"", "ab"};
    EXPECT_EQ(carrier_values(system, with_strings, types.string).size(), 2U);
    for (std::uint32_t id = 5; id < system.types.size(); ++id) {
        const auto values = carrier_values(system, inst, TypeId{id});
        EXPECT_TRUE(std::ranges::is_sorted(values)) << id;
        for (const auto& value : values) EXPECT_TRUE(in_carrier(system, inst, TypeId{id}, value)) << id;
        EXPECT_TRUE(in_carrier(system, inst, TypeId{id}, default_value(system, inst, TypeId{id}))) << id;
    }
    EXPECT_FALSE(in_carrier(system, inst, types.nat, {3, {}}));
    EXPECT_FALSE(in_carrier(system, inst, colour_id, {1, {}}));
}

TEST(Carrier, Defaults) {
    const auto system = core_system();
    const auto inst = instantiate_quietly(system);
    EXPECT_EQ(default_value(system, inst, types.boolean), (Value{1, {}}));  // semantics 3.6: booleans start true
    EXPECT_EQ(default_value(system, inst, types.nat), (Value{0, {}}));
    EXPECT_EQ(default_value(system, inst, types.real), (Value{0, {}}));
}

TEST(Constants, EvaluateConstantUsesTheMachinesOwn) {
    const auto system = with_constants();
    const auto inst = instantiate_quietly(system, {{{"P::S::c", "2"}}, {}});
    const auto& machine = system.machines[0];
    const auto sum = make(ExprKind::plus, types.nat, {samples::constant(0, types.nat), nat(0)});
    EXPECT_EQ(evaluate_constant(system, inst, &machine, *sum), (Value{2, {}}));
    EXPECT_EQ(evaluate_constant(system, inst, nullptr, *sum), std::nullopt);
    EXPECT_EQ(evaluate_constant(system, inst, &machine, *samples::variable(0, types.nat)), std::nullopt);
}

TEST(Rules, CodesAscend) {
    std::string last;
    for (const auto* rule : rules::all) {
        EXPECT_LE(last, std::string(rule->code));
        last = rule->code;
    }
}

}  // namespace
}  // namespace robochart::ir
