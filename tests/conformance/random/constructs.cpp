// SPDX-License-Identifier: Apache-2.0
#include "tests/conformance/random/constructs.hpp"

#include <algorithm>

#include "cpp_emit/plan/walk.hpp"
#include "semantics/evaluate/toolkit.hpp"

namespace robochart::conformance::test {

namespace {

using ir::NodeKind;
using ir::StmtKind;

class Constructs {
public:
    explicit Constructs(const ir::System& system) : system_(system) {}

    std::set<std::string> collect() {
        for (const ir::Machine& machine : system_.machines) look_at(machine);
        for (const ir::Controller& controller : system_.controllers) look_at(controller);
        for (const ir::Module& module : system_.modules) look_at(module);
        return found_;
    }

private:
    void note_construct(bool is, const std::string& word) {
        if (is) found_.insert(word);
    }

    void look_at(const ir::Machine& machine) {
        note_construct(machine.kind == ir::MachineKind::operation, "operation");
        for (const ir::Node& node : machine.nodes) look_at(machine, node);
        for (const ir::Transition& transition : machine.transitions) look_at(machine, transition);
        const bool operation = machine.kind == ir::MachineKind::operation;
        for (const ir::Variable& variable : machine.variables) {
            note_construct(variable.scope == ir::VariableScope::required, "shared variable");
            note_construct(variable.scope == ir::VariableScope::local, "variable");
            note_construct(operation && variable.scope == ir::VariableScope::required,
                           "operation with a required variable");
            note_construct(operation && variable.scope == ir::VariableScope::local,
                           "operation with a variable of its own");
            note_construct(true, "variable of type " + type_word(system_.type(variable.type).kind));
        }
        for (const ir::Constant& constant : machine.constants) {
            note_construct(constant.required, "required constant");
            note_construct(constant.value == nullptr, "constant without a value");
        }
        for (const ir::Clock& clock : machine.clocks) note_construct(clock.required, "operation with a required clock");
        for (const ir::Event& event : machine.events)
            if (event.type) note_construct(true, "event of type " + type_word(system_.type(*event.type).kind));
        look_at_needs(machine);
        ir::visit_statements(machine, [&](const ir::Stmt& stmt) { look_at(machine, stmt); });
        cpp_emit::visit_expressions(machine, [&](const ir::Expr& expr) {
            note_construct(expr.kind == ir::ExprKind::since, "since");
            note_construct(expr.kind == ir::ExprKind::since_entry, "sinceEntry");
            note_construct(expr.kind == ir::ExprKind::call && expr.function.is_valid() &&
                               !system_.functions[expr.function.index].preconditions.empty(),
                           "call of a function with a precondition");
            note_construct(expr.kind == ir::ExprKind::toolkit && ir::toolkit_precondition(expr.text),
                           "call of a toolkit function with a precondition");
        });
    }

    /// Records for each variable that a called operation requires, whether it is the caller's own, or comes from the
    /// caller's caller.
    void look_at_needs(const ir::Machine& caller) {
        for (const ir::OperationSignature& called : caller.operations)
            for (const ir::Machine& operation : system_.machines) {
                if (operation.kind != ir::MachineKind::operation || operation.name != called.name) continue;
                const std::string by = caller.kind == ir::MachineKind::operation ? "an operation" : "a machine";
                note_construct(caller.kind == ir::MachineKind::operation, "operation that requires an operation");
                for (const ir::Variable& need : operation.variables)
                    for (const ir::Variable& own : caller.variables)
                        if (need.scope == ir::VariableScope::required && own.name == need.name)
                            note_construct(true, (own.scope == ir::VariableScope::required ? "variable passed on by "
                                                                                           : "variable provided by ") +
                                                     by);
                for (const ir::Clock& need : operation.clocks)
                    for (const ir::Clock& own : caller.clocks)
                        if (need.required && own.name == need.name)
                            note_construct(true, (own.required ? "clock passed on by " : "clock provided by ") + by);
            }
    }

    static std::string type_word(ir::TypeKind kind) {
        switch (kind) {
            case ir::TypeKind::nat:
                return "nat";
            case ir::TypeKind::integer:
                return "int";
            case ir::TypeKind::real:
                return "real";
            case ir::TypeKind::boolean:
                return "boolean";
            case ir::TypeKind::string:
                return "string";
            case ir::TypeKind::enumeration:
                return "enumeration";
            case ir::TypeKind::given:
                return "given";
            case ir::TypeKind::record:
                return "record";
            case ir::TypeKind::sequence:
                return "sequence";
            case ir::TypeKind::set:
                return "set";
            case ir::TypeKind::product:
                return "product";
            case ir::TypeKind::vector:
                return "vector";
            case ir::TypeKind::function:
            case ir::TypeKind::relation:
            case ir::TypeKind::matrix:
            case ir::TypeKind::unit:
                break;
        }
        return "another kind";
    }

    void look_at(const ir::Machine& machine, const ir::Node& node) {
        std::size_t depth = 0;
        for (ir::NodeId at = node.parent; at.is_valid(); at = machine.nodes[at.index].parent) ++depth;
        for (std::size_t d = 1; d <= depth; ++d) note_construct(true, "depth " + std::to_string(d));
        note_construct(node.kind == NodeKind::junction, "junction");
        note_construct(node.kind == NodeKind::probabilistic, "probabilistic junction");
        note_construct(node.kind == NodeKind::final, depth == 0 ? "final" : "inner final");
        note_construct(node.entry != nullptr, "entry");
        note_construct(node.during != nullptr, "during");
        note_construct(node.during != nullptr && node.is_composite(), "during of a composite");
        note_construct(node.exit != nullptr, "exit");
        note_construct(node.exit != nullptr && node.is_composite(), "exit of a composite");
    }

    void look_at(const ir::Machine& machine, const ir::Transition& transition) {
        const ir::Node& source = machine.nodes[transition.source.index];
        const bool state = source.kind == NodeKind::state;
        note_construct(transition.trigger.has_value(), "trigger");
        note_construct(transition.trigger && transition.trigger->variable.is_valid(), "trigger with a value");
        note_construct(state && !transition.trigger, "no trigger");
        note_construct(transition.trigger && transition.guard, "trigger with a guard");
        note_construct(transition.deadline != nullptr, "deadline of a trigger");
        note_construct(transition.action != nullptr, "action");
        note_construct(!transition.resets.empty(), "reset with a transition");
        note_construct(state && source.is_composite(), "transition out of a composite");
        const ir::Node& target = machine.nodes[transition.target.index];
        const bool junction = target.kind == NodeKind::junction;
        note_construct(junction && source.kind == NodeKind::initial, "initial node to a junction");
        note_construct(junction && source.kind == NodeKind::junction, "junction to a junction");
        note_construct(transition.deadline && transition.guard, "deadline under a guard");
        if (transition.probability)
            note_construct(true, transition.probability->kind == ir::ExprKind::real ? "probability"
                                                                                    : "probability as an expression");
    }

    void look_at(const ir::Machine& machine, const ir::Stmt& stmt) {
        note_construct(stmt.kind == StmtKind::if_then_else, "if");
        note_construct(stmt.kind == StmtKind::assign, "assignment");
        note_construct(stmt.kind == StmtKind::assign && !stmt.path.empty(), "assignment to a part");
        note_construct(stmt.kind == StmtKind::wait && stmt.value->kind == ir::ExprKind::variable, "wait of a variable");
        note_construct(stmt.kind == StmtKind::wait, "wait");
        note_construct(stmt.kind == StmtKind::wait_interval, "wait of an interval");
        note_construct(stmt.kind == StmtKind::clock_reset, "reset");
        note_construct(stmt.kind == StmtKind::deadline, "deadline");
        if (stmt.kind == StmtKind::call) {
            const std::string& name = machine.operations[stmt.operation.index].name;
            const auto defines = [&](const ir::Machine& other) {
                return other.kind == ir::MachineKind::operation && other.name == name;
            };
            const bool defined = std::ranges::any_of(system_.machines, defines);
            note_construct(true, defined ? "call" : "call of the platform");
        }
        if (stmt.kind != StmtKind::communicate) return;
        const bool input = stmt.communication.kind == ir::CommKind::input;
        const bool value = stmt.communication.value != nullptr;
        note_construct(input, "input in an action");
        note_construct(!input && value, "output with a value");
        note_construct(!input && !value, "output");
    }

    void look_at(const ir::Controller& controller) {
        note_construct(controller.machines.size() > 1, "parallel machines");
        for (const ir::MachineInstance& one : controller.machines)
            for (const ir::MachineInstance& other : controller.machines)
                note_construct(one.name != other.name && one.machine == other.machine, "machine twice");
        for (const ir::Connection& connection : controller.connections)
            note_construct(connection.from.kind == ir::EndKind::part && connection.to.kind == ir::EndKind::part,
                           "connected machines");
    }

    void look_at(const ir::Module& module) {
        note_construct(module.controllers.size() > 1, "parallel controllers");
        for (const ir::ControllerInstance& one : module.controllers)
            for (const ir::ControllerInstance& other : module.controllers)
                note_construct(one.name != other.name && one.controller == other.controller, "controller twice");
        for (const ir::Connection& connection : module.connections)
            if (connection.from.kind == ir::EndKind::part && connection.to.kind == ir::EndKind::part)
                note_construct(true, connection.async ? "asynchronous connection" : "synchronous connection");
    }

    const ir::System& system_;
    std::set<std::string> found_;
};

}  // namespace

std::set<std::string> constructs_in(const ir::System& system) {
    return Constructs(system).collect();
}

std::set<std::string> claimed_constructs() {
    return {"action",
            "assignment",
            "asynchronous connection",
            "call",
            "call of the platform",
            "connected machines",
            "deadline",
            "deadline of a trigger",
            "depth 1",
            "depth 2",
            "depth 3",
            "depth 4",
            "during",
            "during of a composite",
            "entry",
            "exit",
            "exit of a composite",
            "final",
            "if",
            "inner final",
            "input in an action",
            "junction",
            "no trigger",
            "operation",
            "output",
            "output with a value",
            "parallel controllers",
            "parallel machines",
            "probabilistic junction",
            "reset",
            "reset with a transition",
            "shared variable",
            "since",
            "sinceEntry",
            "synchronous connection",
            "transition out of a composite",
            "trigger",
            "trigger with a guard",
            "trigger with a value",
            "variable",
            "wait",
            "wait of an interval"};
}

std::set<std::string> widened_constructs() {
    std::set<std::string> words = claimed_constructs();
    words.insert({"assignment to a part",
                  "clock passed on by an operation",
                  "clock provided by a machine",
                  "clock provided by an operation",
                  "constant without a value",
                  "controller twice",
                  "deadline under a guard",
                  "event of type boolean",
                  "event of type enumeration",
                  "event of type given",
                  "event of type nat",
                  "event of type product",
                  "event of type record",
                  "event of type sequence",
                  "event of type set",
                  "event of type string",
                  "initial node to a junction",
                  "junction to a junction",
                  "machine twice",
                  "operation that requires an operation",
                  "operation with a required clock",
                  "call of a function with a precondition",
                  "operation with a required variable",
                  "operation with a variable of its own",
                  "probability",
                  "probability as an expression",
                  "required constant",
                  "variable passed on by a machine",
                  "variable passed on by an operation",
                  "variable provided by a machine",
                  "variable provided by an operation",
                  "wait of a variable"});
    return words;
}

}  // namespace robochart::conformance::test
