// SPDX-License-Identifier: Apache-2.0
// Finds the data about one component in the IR and the emitted script; see component.hpp.
#include "conformance/model/component.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <set>
#include <utility>

#include "checker/cspm/syntax/build.hpp"
#include "checker/cspm/syntax/lookup.hpp"
#include "conformance/model/logged_value.hpp"
#include "cpp_emit/plan/types.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::conformance {

namespace {

namespace b = cspm::build;

/// Removes "::" from package and type names, because CSPM identifiers cannot contain it.
std::string flatten_name(const std::string& name) {
    std::string result;
    for (std::size_t i = 0; i < name.size(); ++i) {
        if (name[i] == ':' && i + 1 < name.size() && name[i + 1] == ':') ++i;
        result += std::isalnum(static_cast<unsigned char>(name[i])) != 0 ? name[i] : '_';
    }
    return result;
}

/// Returns the carrier for a type of the model. Values of composed types are numbered in the order of ir::carrier.
Carrier carrier_of(const ir::System& system, const ir::Instantiation& instantiation, ir::TypeId id) {
    const ir::Type& type = system.type(id);
    if (cpp_emit::is_composed(type)) {
        Carrier carrier{Carrier::Kind::enumeration, {}, {}};
        for (const ir::Value& value : ir::carrier_values(system, instantiation, id)) {
            carrier.names.push_back(cpp_emit::cspm_value(system, id, value));
            carrier.literals.push_back(log_text(system, instantiation, id, value));
        }
        return carrier;
    }
    if (type.kind == ir::TypeKind::boolean) return {Carrier::Kind::boolean, {}, {}};
    if (type.kind == ir::TypeKind::real) return {Carrier::Kind::real, {}, {}};
    if (type.kind != ir::TypeKind::enumeration) return {};
    Carrier carrier{Carrier::Kind::enumeration, type.shown.empty() ? type.labels : type.shown, {}};
    const std::string prefix = type.package.empty() ? "" : flatten_name(type.package) + "_";
    for (const std::string& label : type.labels) carrier.names.push_back(prefix + type.name + "_" + label);
    return carrier;
}

/// Collects the external variables in expressions of a machine and of the operations that it calls. An element that an
/// operation requires may be its caller's own (semantics 3.8).
class Reads {
public:
    /// `controller` defines the operations. If it is null, no operation is defined.
    Reads(const ir::System& system, const ir::Controller* controller, std::set<std::string>& found)
        : system_(system), controller_(controller), found_(found) {}

    void visit_machine(const ir::Machine& root) {
        std::set<std::string> shared;
        for (const ir::Variable& variable : root.variables)
            if (variable.scope == ir::VariableScope::required) shared.insert(variable.name);
        visit_machine(root, shared);
    }

private:
    /// `shared` contains the names that the machine shares with its environment. Calls are not recursive (lowering
    /// rejects recursion).
    void visit_machine(const ir::Machine& machine, const std::set<std::string>& shared) {
        if (!seen_.emplace(&machine, shared).second) return;
        const ir::Machine* const outer_machine = std::exchange(current_, &machine);
        const std::set<std::string>* const outer_shared = std::exchange(shared_, &shared);
        visit_all_expressions(machine);
        for (const ir::OperationId called : ir::called_operations(machine)) visit_call(machine, called, shared);
        current_ = outer_machine;
        shared_ = outer_shared;
    }

    void visit_call(const ir::Machine& caller, ir::OperationId called, const std::set<std::string>& outside) {
        if (controller_ == nullptr) return;
        const ir::MachineId id = ir::definition_in(system_, *controller_, caller.operations[called.index]);
        if (!id.is_valid()) return;
        std::set<std::string> shared;
        for (const ir::Variable& variable : system_.machine(id).variables)
            if (variable.scope == ir::VariableScope::required && outside.count(variable.name) != 0)
                shared.insert(variable.name);
        visit_machine(system_.machine(id), shared);
    }

    void visit_all_expressions(const ir::Machine& machine) {
        for (const ir::ExprPtr& condition : machine.preconditions) visit_expression(condition);
        for (const ir::ExprPtr& condition : machine.postconditions) visit_expression(condition);
        for (const ir::Variable& variable : machine.variables) visit_expression(variable.initial);
        for (const ir::Constant& constant : machine.constants) visit_expression(constant.value);
        for (const ir::Node& node : machine.nodes) {
            for (const ir::StmtPtr& action : {node.entry, node.during, node.exit}) visit_statement(action);
        }
        for (const ir::Transition& transition : machine.transitions) {
            for (const ir::ExprPtr& part : {transition.guard, transition.deadline, transition.probability})
                visit_expression(part);
            if (transition.trigger) visit_communication(*transition.trigger);
            visit_statement(transition.action);
        }
    }

    void visit_variable(ir::VariableId id) {
        const std::string& name = current_->variables[id.index].name;
        if (shared_->count(name) != 0) found_.insert(name);
    }
    // Recursion depth: the depth of the model's expressions, which the reader limits.
    void visit_expression(const ir::ExprPtr& expr) {
        if (!expr) return;
        if (expr->kind == ir::ExprKind::variable) visit_variable(expr->variable);
        for (const ir::ExprPtr& part : expr->args) visit_expression(part);
    }
    void visit_communication(const ir::Communication& communication) {
        visit_expression(communication.value);
        visit_expression(communication.predicate);
    }
    void visit_statement(const ir::StmtPtr& stmt) {
        if (!stmt) return;
        for (const ir::ExprPtr& part : {stmt->value, stmt->upper, stmt->condition}) visit_expression(part);
        for (const ir::ExprPtr& part : stmt->args) visit_expression(part);
        for (const ir::ExprPtr& part : stmt->path) visit_expression(part);
        // An assignment to a part keeps the other parts, so it reads the variable.
        if (stmt->kind == ir::StmtKind::assign && !stmt->path.empty()) visit_variable(stmt->variable);
        visit_communication(stmt->communication);
        for (const ir::StmtPtr& part : stmt->body) visit_statement(part);
    }

    const ir::System& system_;
    const ir::Controller* controller_;
    std::set<std::string>& found_;
    std::set<std::pair<const ir::Machine*, std::set<std::string>>> seen_;
    const ir::Machine* current_ = nullptr;
    const std::set<std::string>* shared_ = nullptr;
};

std::set<std::string> read_variables(const ir::System& system, const ir::ComponentRef& ref) {
    std::set<std::string> read;
    if (ref.kind == ir::ComponentKind::machine)
        Reads(system, nullptr, read).visit_machine(system.machines[ref.definition]);
    if (ref.kind != ir::ComponentKind::controller) return read;
    const ir::Controller& controller = system.controllers[ref.definition];
    Reads reads(system, &controller, read);
    for (const ir::MachineInstance& instance : controller.machines)
        reads.visit_machine(system.machine(instance.machine));
    return read;
}

const std::vector<ir::Variable>* variables_of(const ir::System& system, const ir::ComponentRef& ref) {
    if (ref.definition == ir::no_id) return nullptr;
    if (ref.kind == ir::ComponentKind::machine) return &system.machines[ref.definition].variables;
    if (ref.kind == ir::ComponentKind::controller) return &system.controllers[ref.definition].variables;
    return nullptr;
}

const std::vector<ir::TypeId>* types_of(const csp_emit::Provenance& provenance, const std::string& event) {
    const auto found = provenance.events.find(event);
    return found == provenance.events.end() ? nullptr : &found->second.types;
}

}  // namespace

std::string component_prefix(const ir::ComponentRef& ref) {
    return ref.package.empty() ? ref.path : flatten_name(ref.package) + "::" + ref.path;
}

cspm::ExprPtr component_process(const cspm::Script& script, const ir::ComponentRef& ref) {
    const std::string prefix = component_prefix(ref);
    const cspm::DeclPtr process = cspm::declaration_of(script, prefix + "::D__");
    if (!process || process->kind != cspm::DeclKind::function) return nullptr;
    // Semantics 3.12: the arguments are the id, then the constants, whose values are global definitions with the same
    // name.
    std::vector<cspm::ExprPtr> arguments{b::number(0)};
    const std::vector<cspm::PatternPtr>& parameters = process->patterns.front();
    for (std::size_t p = 1; p < parameters.size(); ++p) {
        if (!cspm::declaration_of(script, parameters[p]->text)) return nullptr;
        arguments.push_back(b::name(parameters[p]->text));
    }
    return b::call(prefix + "::D__", std::move(arguments));
}

std::vector<std::string> unread_variables(const ir::System& system, const ir::ComponentRef& ref) {
    std::vector<std::string> unread;
    const std::vector<ir::Variable>* const variables = variables_of(system, ref);
    if (variables == nullptr) return unread;
    const std::set<std::string> read = read_variables(system, ref);
    for (const ir::Variable& variable : *variables) {
        if (variable.scope == ir::VariableScope::required && read.count(variable.name) == 0)
            unread.push_back(variable.name);
    }
    return unread;
}

namespace {

/// Completes the interface of a RoboSim component: the carriers of the registers, and the readings of variables before
/// the first cycle.
void complete_registers(Interface& interface, const ir::System& system, const ir::Instantiation& instantiation,
                        const csp_emit::Provenance& provenance) {
    const auto types_of_register = [&](const std::string& channel, const std::string& name) {
        return types_of(provenance, fmt::format("{0}::{1}.{0}::{2}", interface.component, channel, name));
    };
    for (Register& input : interface.inputs) {
        const auto* types = types_of_register("registerRead", "i_" + input_name(input));
        if (types == nullptr || types->empty()) continue;
        input.carrier = carrier_of(system, instantiation, types->back());
        if (!input.name.starts_with("set_EXT_")) continue;
        const ir::Value first = ir::default_value(system, instantiation, types->back());
        const std::string text = cpp_emit::cspm_value(system, types->back(), first);
        const auto found = std::ranges::find(input.texts, text);
        assert(found != input.texts.end());
        input.kept = 1 + static_cast<std::uint32_t>(found - input.texts.begin());
    }
    for (Output& output : interface.outputs) {
        const auto* types = types_of_register("registerWrite", "o_" + output_name(output));
        for (std::size_t a = 0; types != nullptr && a < types->size() && a < output.arguments.size(); ++a)
            output.arguments[a] = carrier_of(system, instantiation, (*types)[a]);
    }
}

}  // namespace

void complete_interface(Interface& interface, const ir::System& system, const ir::Instantiation& instantiation,
                        const ir::ComponentRef& ref, const csp_emit::Provenance& provenance) {
    interface.component = component_prefix(ref);
    interface.robosim = ir::is_robosim(system, ref);
    if (interface.robosim) complete_registers(interface, system, instantiation, provenance);
    for (Register& input : interface.inputs) {
        const auto* types = types_of(provenance, interface.component + "::" + input.name);
        if (types != nullptr && !types->empty()) input.carrier = carrier_of(system, instantiation, types->front());
    }
    for (Output& output : interface.outputs) {
        const auto* types = types_of(provenance, interface.component + "::" + output.name);
        for (std::size_t a = 0; types != nullptr && a < types->size() && a < output.arguments.size(); ++a)
            output.arguments[a] = carrier_of(system, instantiation, (*types)[a]);
    }
    for (const std::string& variable : unread_variables(system, ref)) {
        const std::string channel = "set_EXT_" + variable;
        const bool has_register =
            std::ranges::any_of(interface.inputs, [&](const Register& input) { return input.name == channel; });
        if (!has_register) interface.blocked.push_back(channel);
    }
}

}  // namespace robochart::conformance
