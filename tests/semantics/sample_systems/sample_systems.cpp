// SPDX-License-Identifier: Apache-2.0
// Builds the aggregation model (corpus/aggregation/aggregation.rct) as IR. The IR was written by hand from the model
// text.
#include "tests/semantics/sample_systems/sample_systems.hpp"

#include <utility>

namespace robochart::ir::samples {
namespace {

constexpr CoreTypes core{};
const char* const iface = "AggregationIface";
const char* const event_iface = "AggregationEvents";

ExprPtr share(Expr expr) {
    return std::make_shared<const Expr>(std::move(expr));
}

ExprPtr real(std::int64_t unscaled, std::uint32_t decimals) {
    Expr expr;
    expr.kind = ExprKind::real;
    expr.type = core.real;
    expr.decimal = {unscaled, decimals};
    return share(expr);
}

ExprPtr number(std::int64_t value) {
    Expr expr;
    expr.type = core.nat;
    expr.number = value;
    return share(expr);
}

ExprPtr variable(std::uint32_t index) {
    Expr expr;
    expr.kind = ExprKind::variable;
    expr.type = core.real;
    expr.variable = VariableId{index};
    return share(expr);
}

ExprPtr compare(ExprKind kind, ExprPtr left, ExprPtr right) {
    Expr expr;
    expr.kind = kind;
    expr.type = core.boolean;
    expr.args = {std::move(left), std::move(right)};
    return share(expr);
}

/// Numbers points in the order in which statements are created. A sequence is created before its parts.
class Program {
public:
    explicit Program(Machine& machine) : machine_(machine) {}

    StmtPtr assign(const std::string& origin, std::uint32_t target, ExprPtr value) {
        Stmt stmt = make(StmtKind::assign, origin);
        stmt.variable = VariableId{target};
        stmt.value = std::move(value);
        return share(stmt);
    }
    StmtPtr wait(const std::string& origin, ExprPtr duration) {
        Stmt stmt = make(StmtKind::wait, origin);
        stmt.value = std::move(duration);
        return share(stmt);
    }
    StmtPtr call(const std::string& origin, std::uint32_t operation, std::vector<ExprPtr> args) {
        Stmt stmt = make(StmtKind::call, origin);
        stmt.operation = OperationId{operation};
        stmt.args = std::move(args);
        return share(stmt);
    }
    Stmt make(StmtKind kind, const std::string& origin) {
        Stmt stmt;
        stmt.kind = kind;
        stmt.point = machine_.points++;
        stmt.origin.element = origin;
        return stmt;
    }
    static StmtPtr share(Stmt stmt) { return std::make_shared<const Stmt>(std::move(stmt)); }

private:
    Machine& machine_;
};

NodeId add_node(Machine& machine, NodeKind kind, const std::string& name) {
    Node node;
    node.kind = kind;
    node.name = name;
    node.path = name;
    node.origin.element = machine.name + "::" + name;
    const NodeId id{static_cast<std::uint32_t>(machine.nodes.size())};
    machine.nodes.push_back(std::move(node));
    machine.top.push_back(id);
    if (kind == NodeKind::initial) machine.initial = id;
    return id;
}

void add_transition(Machine& machine, NodeId from, NodeId to, std::optional<EventId> trigger = std::nullopt) {
    Transition transition;
    transition.name = "t" + std::to_string(machine.transitions.size());
    transition.source = from;
    transition.target = to;
    if (trigger) transition.trigger = Communication{CommKind::simple, *trigger, {}, {}, {}};
    transition.origin.element = machine.name + "::" + transition.name;
    machine.nodes[from.index].outgoing.push_back({static_cast<std::uint32_t>(machine.transitions.size())});
    machine.transitions.push_back(std::move(transition));
}

Variable make_variable(const std::string& owner, const std::string& name, VariableScope scope) {
    Variable result;
    result.name = name;
    result.type = core.real;
    result.scope = scope;
    if (scope != VariableScope::parameter) result.interface = iface;
    result.origin.element = owner + "::" + name;
    return result;
}

std::vector<Variable> shared_variables(VariableScope scope) {
    return {make_variable(iface, "linearSpeed", scope), make_variable(iface, "angularSpeed", scope)};
}

std::vector<OperationSignature> signatures() {
    return {
        {"MoveClockwise",
         {"angular", "linear"},
         {core.real, core.real},
         false,
         iface,
         {std::string(iface) + "::MoveClockwise", {}}},
        {"RotateClockwise", {"angular"}, {core.real}, false, iface, {std::string(iface) + "::RotateClockwise", {}}}};
}

std::vector<Event> sensor_events() {
    std::vector<Event> events(2);
    events[0].name = "seeWall";
    events[1].name = "seeRobot";
    for (auto& event : events) {
        event.input = true;
        event.interface = event_iface;
        event.origin.element = std::string(event_iface) + "::" + event.name;
    }
    return events;
}

Machine operation_head(const std::string& name, const std::vector<std::string>& parameters) {
    Machine machine;
    machine.kind = MachineKind::operation;
    machine.name = name;
    machine.path = name;
    machine.package = "aggregation";
    machine.origin.element = name;
    for (const auto& parameter : parameters)
        machine.variables.push_back(make_variable(name, parameter, VariableScope::parameter));
    for (auto& shared : shared_variables(VariableScope::required)) machine.variables.push_back(shared);
    machine.operations = signatures();
    machine.interfaces = {iface};
    return machine;
}

/// Adds initial i -> S { entry angularSpeed = angular ; linearSpeed = LINEAR ; wait(1) } -> final F.
void add_one_cycle_body(Machine& machine, std::uint32_t linear, std::uint32_t angular, ExprPtr linear_value) {
    const NodeId initial = add_node(machine, NodeKind::initial, "i");
    const NodeId state = add_node(machine, NodeKind::state, "S");
    const NodeId final = add_node(machine, NodeKind::final, "F");
    Program program(machine);
    const std::string origin = machine.name + "::S";
    Stmt sequence = program.make(StmtKind::sequence, origin);
    sequence.body.push_back(program.assign(origin, angular, variable(0)));
    sequence.body.push_back(program.assign(origin, linear, std::move(linear_value)));
    sequence.body.push_back(program.wait(origin, number(1)));
    machine.nodes[state.index].entry = Program::share(sequence);
    add_transition(machine, initial, state);
    add_transition(machine, state, final);
}

Machine move_clockwise() {
    Machine machine = operation_head("MoveClockwise", {"angular", "linear"});
    machine.preconditions = {compare(ExprKind::less, variable(0), real(0, 0)),
                             compare(ExprKind::not_equal, variable(1), real(0, 0))};
    add_one_cycle_body(machine, 2, 3, variable(1));
    return machine;
}

Machine rotate_clockwise() {
    Machine machine = operation_head("RotateClockwise", {"angular"});
    machine.preconditions = {compare(ExprKind::less, variable(0), real(0, 0))};
    add_one_cycle_body(machine, 1, 2, real(0, 0));
    return machine;
}

Machine aggregation_fsm() {
    Machine machine;
    machine.name = "AggregationFSM";
    machine.path = machine.name;
    machine.package = "aggregation";
    machine.origin.element = machine.name;
    machine.variables = shared_variables(VariableScope::required);
    machine.events = sensor_events();
    machine.operations = signatures();
    machine.interfaces = {iface, event_iface};
    const NodeId initial = add_node(machine, NodeKind::initial, "i");
    const NodeId first = add_node(machine, NodeKind::state, "S1");
    const NodeId second = add_node(machine, NodeKind::state, "S2");
    Program program(machine);
    machine.nodes[first.index].entry = program.call("AggregationFSM::S1", 0, {real(-75, 2), real(-1088, 2)});
    machine.nodes[second.index].entry = program.call("AggregationFSM::S2", 1, {real(-502, 2)});
    add_transition(machine, initial, first);
    add_transition(machine, first, second, EventId{1});
    add_transition(machine, second, first, EventId{0});
    return machine;
}

Connection connect(ConnectionEnd from, ConnectionEnd to, bool async, const std::string& origin) {
    return {std::move(from), std::move(to), async, false, {origin, {}}};
}

Controller aggregation_controller() {
    Controller controller;
    controller.name = "AggregationController";
    controller.path = controller.name;
    controller.package = "aggregation";
    controller.origin.element = controller.name;
    controller.variables = shared_variables(VariableScope::required);
    controller.events = sensor_events();
    controller.definitions = {MachineId{0}, MachineId{1}};
    controller.definition_names = {"move_ref", "rotate_ref"};
    controller.machines.push_back(
        {"stm_ref", MachineId{2}, {MachineId{0}, MachineId{1}}, {controller.name + "::stm_ref", {}}});
    for (const char* event : {"seeWall", "seeRobot"})
        controller.connections.push_back(
            connect({EndKind::self, no_id, event}, {EndKind::part, 0, event}, false, controller.name));
    controller.interfaces = {iface, event_iface};
    return controller;
}

Module aggregation_module() {
    Module module;
    module.name = "Aggregation";
    module.package = "aggregation";
    module.origin.element = module.name;
    module.platform.name = "EPuck";
    module.platform.variables = shared_variables(VariableScope::required);
    module.platform.events = sensor_events();
    module.platform.operations = signatures();
    module.platform.interfaces = {iface, event_iface};
    module.platform.origin.element = "EPuck";
    module.controllers.push_back({"ctrl_ref", ControllerId{0}, {"Aggregation::ctrl_ref", {}}});
    for (const char* event : {"seeWall", "seeRobot"})
        module.connections.push_back(
            connect({EndKind::self, no_id, event}, {EndKind::part, 0, event}, true, module.name));
    return module;
}

Type core_type(TypeKind kind, const char* name) {
    Type type;
    type.kind = kind;
    type.name = name;
    type.origin.element = name;
    return type;
}

}  // namespace

System aggregation() {
    System system;
    system.types = {core_type(TypeKind::boolean, "boolean"), core_type(TypeKind::nat, "nat"),
                    core_type(TypeKind::integer, "int"), core_type(TypeKind::real, "real"),
                    core_type(TypeKind::string, "string")};
    system.machines = {move_clockwise(), rotate_clockwise(), aggregation_fsm()};
    system.controllers = {aggregation_controller()};
    system.modules = {aggregation_module()};
    return system;
}

}  // namespace robochart::ir::samples
