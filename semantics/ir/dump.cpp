// SPDX-License-Identifier: Apache-2.0
// Writes the IR as text, for `--print ir`.
#include <fmt/format.h>

#include "semantics/ir/dump.hpp"
#include "semantics/ir/dump_expressions.hpp"

namespace robochart::ir {
namespace {

std::string qualified(const std::string& package, const std::string& name) {
    return package.empty() ? name : package + "::" + name;
}

std::string join_names(const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string from_text(const std::string& interface) {
    return interface.empty() ? "" : " from " + interface;
}

std::string scope_text(VariableScope scope) {
    switch (scope) {
        case VariableScope::required:
            return "required";
        case VariableScope::parameter:
            return "parameter";
        case VariableScope::reg:
            return "register";
        case VariableScope::local:
            break;
    }
    return "local";
}

std::string kind_text(NodeKind kind) {
    switch (kind) {
        case NodeKind::initial:
            return "initial";
        case NodeKind::junction:
            return "junction";
        case NodeKind::probabilistic:
            return "probabilistic";
        case NodeKind::final:
            return "final";
        case NodeKind::state:
            break;
    }
    return "state";
}

std::string kind_text(PropertyKind kind) {
    constexpr const char* words[] = {"deadlock-free",     "divergence-free", "deterministic", "timelock-free",
                                     "terminates",        "refines",         "equals",        "reachable",
                                     "clock-initialised", "event-missed",    "conforms",      "schedulable"};
    return words[static_cast<std::size_t>(kind)];
}

std::string kind_text(ComponentKind kind) {
    constexpr const char* words[] = {"module", "controller", "machine", "operation", "simulation", "process"};
    return words[static_cast<std::size_t>(kind)];
}

std::string model_text(PropertyModel model) {
    constexpr const char* words[] = {"FD", "T", "F", "TT"};
    return words[static_cast<std::size_t>(model)];
}

class Dump {
public:
    explicit Dump(const System& system) : system_(system) {}

    std::string dump_all() {
        for (const auto& type : system_.types) dump_type(type);
        for (const auto& item : system_.functions) dump_function(item);
        for (const auto& item : system_.machines) dump_machine(item);
        for (const auto& item : system_.controllers) dump_controller(item);
        for (const auto& item : system_.modules) dump_module(item);
        for (const auto& item : system_.csp_blocks) dump_block(item);
        for (const auto& item : system_.properties) dump_property(item);
        return std::move(text_);
    }

private:
    template <class... Args>
    void write_line(fmt::format_string<Args...> pattern, Args&&... args) {
        text_ += fmt::format(pattern, std::forward<Args>(args)...);
        text_ += '\n';
    }
    [[nodiscard]] std::string text_of_type(TypeId id) const { return type_text(system_, id); }

    void dump_type(const Type& type);
    void dump_function(const Function& function);
    void dump_signature(const OperationSignature& signature);
    template <class Context>
    void dump_declarations(const Context& context, const Machine* machine);
    void dump_machine(const Machine& machine);
    void dump_node(const Machine& machine, const Node& node);
    void dump_action(const Machine& machine, const char* word, const StmtPtr& stmt);
    void dump_transition(const Machine& machine, const Transition& transition);
    void dump_controller(const Controller& controller);
    void dump_module(const Module& module);
    template <class Parts>
    void dump_connection(const Connection& connection, const Parts& parts);
    void dump_block(const CspBlock& block);
    void dump_property(const Property& property);
    [[nodiscard]] std::string reference_text(const ComponentRef& ref) const {
        return kind_text(ref.kind) + " " + qualified(ref.package, ref.path);
    }

    const System& system_;
    std::string text_;
};

void Dump::dump_type(const Type& type) {
    if (type.kind == TypeKind::given) write_line("type {}", qualified(type.package, type.name));
    if (type.kind == TypeKind::enumeration)
        write_line("enumeration {} {{ {} }}", qualified(type.package, type.name), join_names(type.labels));
    if (type.kind != TypeKind::record) return;
    std::string fields;
    for (std::size_t i = 0; i < type.labels.size(); ++i)
        fields += (i > 0 ? ", " : "") + type.labels[i] + ": " + this->text_of_type(type.args[i]);
    write_line("record {} {{ {} }}", qualified(type.package, type.name), fields);
}

void Dump::dump_function(const Function& function) {
    std::string parameters;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        parameters += (i > 0 ? ", " : "") + function.parameter_names[i] + ": " + text_of_type(function.parameters[i]);
    write_line("function {}({}): {}", qualified(function.package, function.name), parameters,
               text_of_type(function.result));
    for (const auto& condition : function.preconditions)
        write_line("  precondition {}", expression_text(system_, nullptr, *condition));
    for (const auto& condition : function.postconditions)
        write_line("  postcondition {}", expression_text(system_, nullptr, *condition));
}

void Dump::dump_signature(const OperationSignature& signature) {
    std::string parameters;
    for (std::size_t i = 0; i < signature.parameters.size(); ++i)
        parameters += (i > 0 ? ", " : "") + signature.parameter_names[i] + ": " + text_of_type(signature.parameters[i]);
    write_line("  operation {}({}){}{}", signature.name, parameters, signature.terminates ? " terminates" : "",
               from_text(signature.interface));
}

template <class Context>
void Dump::dump_declarations(const Context& context, const Machine* machine) {
    if (!context.interfaces.empty()) write_line("  interfaces {}", join_names(context.interfaces));
    for (const auto& item : context.variables)
        write_line("  variable {} {}: {}{}{}", scope_text(item.scope), item.name, text_of_type(item.type),
                   clause_text(system_, machine, "=", item.initial), from_text(item.interface));
    for (const auto& item : context.constants)
        write_line("  constant{} {}: {}{}{}", item.required ? " required" : "", item.name, text_of_type(item.type),
                   clause_text(system_, machine, "=", item.value), from_text(item.interface));
    for (const auto& item : context.events)
        write_line("  event{}{}{} {}{}{}", item.broadcast ? " broadcast" : "", item.input ? " in" : "",
                   item.output ? " out" : "", item.name, item.type ? ": " + text_of_type(*item.type) : "",
                   from_text(item.interface));
    for (const auto& item : context.operations) dump_signature(item);
}

void Dump::dump_action(const Machine& machine, const char* word, const StmtPtr& stmt) {
    if (!stmt) return;
    write_line("    {}", word);
    text_ += program_text(system_, machine, *stmt, 6);
}

void Dump::dump_node(const Machine& machine, const Node& node) {
    write_line("  {} {}", kind_text(node.kind), node.path);
    dump_action(machine, "entry", node.entry);
    dump_action(machine, "during", node.during);
    dump_action(machine, "exit", node.exit);
}

void Dump::dump_transition(const Machine& machine, const Transition& transition) {
    std::string resets;
    for (const auto clock : transition.resets) resets += " reset " + machine.clocks[clock.index].name;
    write_line("  transition {} {} -> {}{}{}{}{}{}{}{}", transition.name, machine.nodes[transition.source.index].path,
               machine.nodes[transition.target.index].path, transition.exec ? " exec" : "",
               transition.trigger ? " on " + communication_text(system_, machine, *transition.trigger) : "", resets,
               clause_text(system_, &machine, "within", transition.deadline),
               clause_text(system_, &machine, transition.guard_timed ? "when-timed" : "when", transition.guard),
               clause_text(system_, &machine, "probability", transition.probability), transition.action ? " do" : "");
    for (const auto& store : transition.stores) text_ += program_text(system_, machine, *store, 6);
    if (transition.action) text_ += program_text(system_, machine, *transition.action, 6);
}

void Dump::dump_machine(const Machine& machine) {
    const char* kind = machine.kind == MachineKind::operation ? "operation" : "machine";
    write_line("{} {}{}", kind, qualified(machine.package, machine.path), machine.terminates ? " terminates" : "");
    dump_declarations(machine, &machine);
    for (const auto& clock : machine.clocks)
        write_line("  clock{} {}{}{}", clock.required ? " required" : "", clock.name,
                   clock.entry_of.is_valid() ? " of entry" : "", from_text(clock.interface));
    for (const auto& condition : machine.preconditions)
        write_line("  precondition {}", expression_text(system_, &machine, *condition));
    for (const auto& condition : machine.postconditions)
        write_line("  postcondition {}", expression_text(system_, &machine, *condition));
    for (const auto& item : machine.nodes) dump_node(machine, item);
    for (const auto& item : machine.transitions) dump_transition(machine, item);
}

template <class Parts>
void Dump::dump_connection(const Connection& connection, const Parts& parts) {
    const auto end_text = [&](const ConnectionEnd& end) {
        const bool part = end.kind == EndKind::part && end.part < parts.size();
        return (part ? parts[end.part].name : "self") + "." + end.event;
    };
    write_line("  connection {} -> {}{}{}", end_text(connection.from), end_text(connection.to),
               connection.async ? " async" : "", connection.multiple ? " mult" : "");
}

void Dump::dump_controller(const Controller& controller) {
    write_line("controller {}", qualified(controller.package, controller.path));
    dump_declarations(controller, nullptr);
    for (std::size_t i = 0; i < controller.definitions.size(); ++i)
        write_line("  defines {} as {}", system_.machine(controller.definitions[i]).path,
                   controller.definition_names[i]);
    for (const auto& part : controller.machines) {
        const Machine& machine = system_.machine(part.machine);
        write_line("  machine {} = {}", part.name, qualified(machine.package, machine.path));
        for (std::size_t i = 0; i < part.definitions.size(); ++i)
            write_line(
                "    {} is {}", machine.operations[i].name,
                part.definitions[i].is_valid() ? system_.machine(part.definitions[i]).path : "called on the platform");
    }
    for (const auto& item : controller.connections) dump_connection(item, controller.machines);
}

void Dump::dump_module(const Module& module) {
    write_line("module {}", qualified(module.package, module.name));
    write_line("  platform {}", module.platform.name);
    dump_declarations(module.platform, nullptr);
    for (const auto& part : module.controllers) {
        const Controller& controller = system_.controller(part.controller);
        write_line("  controller {} = {}", part.name, qualified(controller.package, controller.path));
    }
    for (const auto& item : module.connections) dump_connection(item, module.controllers);
}

void Dump::dump_block(const CspBlock& block) {
    std::string associated;
    for (const auto& ref : block.associated) associated += " " + reference_text(ref);
    write_line("csp {}{}{}{}", block.name, block.timed ? " timed" : "", block.untimed ? " untimed" : "",
               associated.empty() ? "" : " for" + associated);
}

void Dump::dump_property(const Property& property) {
    const std::string missed = property.event.empty() ? "" : fmt::format(" {} {}", property.event, property.time_units);
    write_line("property {}{}{}: {}{} {} [{}]{}{}{}{}", property.name, property.timed ? " timed" : "",
               property.untimed ? " untimed" : "", reference_text(property.subject), property.negated ? " not" : "",
               kind_text(property.kind), model_text(property.model), property.state.empty() ? "" : " " + property.state,
               missed, property.other.path.empty() ? "" : " " + reference_text(property.other),
               property.rule.empty() ? "" : " " + property.rule);
    for (const auto& [name, value] : property.constants)
        write_line("  with {} = {}", name, expression_text(system_, nullptr, *value));
}

}  // namespace

std::string dump_text(const System& system) {
    return Dump(system).dump_all();
}

}  // namespace robochart::ir
