// SPDX-License-Identifier: Apache-2.0
// The IR as text, for `--print ir`.
#include <fmt/format.h>

#include "semantics/ir/dump.hpp"
#include "semantics/ir/dump_expressions.hpp"

namespace robochart::ir {
namespace {

std::string qualified(const std::string& package, const std::string& name) {
    return package.empty() ? name : package + "::" + name;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const auto& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string from(const std::string& interface) {
    return interface.empty() ? "" : " from " + interface;
}

std::string scope_text(VariableScope scope) {
    switch (scope) {
        case VariableScope::required:
            return "required";
        case VariableScope::parameter:
            return "parameter";
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
                                     "clock-initialised", "event-missed",    "conforms"};
    return words[static_cast<std::size_t>(kind)];
}

std::string kind_text(ComponentKind kind) {
    constexpr const char* words[] = {"module", "controller", "machine", "operation", "process"};
    return words[static_cast<std::size_t>(kind)];
}

std::string model_text(PropertyModel model) {
    constexpr const char* words[] = {"FD", "T", "F", "TT"};
    return words[static_cast<std::size_t>(model)];
}

class Dump {
public:
    explicit Dump(const System& system) : system_(system) {}

    std::string text() {
        for (const auto& type : system_.types) declared(type);
        for (const auto& item : system_.functions) function(item);
        for (const auto& item : system_.machines) machine(item);
        for (const auto& item : system_.controllers) controller(item);
        for (const auto& item : system_.modules) module(item);
        for (const auto& item : system_.csp_blocks) block(item);
        for (const auto& item : system_.properties) property(item);
        return std::move(text_);
    }

private:
    template <class... Args>
    void line(fmt::format_string<Args...> pattern, Args&&... args) {
        text_ += fmt::format(pattern, std::forward<Args>(args)...);
        text_ += '\n';
    }
    [[nodiscard]] std::string type(TypeId id) const { return type_text(system_, id); }

    void declared(const Type& type);
    void function(const Function& function);
    void signature(const OperationSignature& signature);
    template <class Context>
    void declarations(const Context& context, const Machine* machine);
    void machine(const Machine& machine);
    void node(const Machine& machine, const Node& node);
    void action(const Machine& machine, const char* word, const StmtPtr& stmt);
    void transition(const Machine& machine, const Transition& transition);
    void controller(const Controller& controller);
    void module(const Module& module);
    template <class Parts>
    void connection(const Connection& connection, const Parts& parts);
    void block(const CspBlock& block);
    void property(const Property& property);
    [[nodiscard]] std::string reference(const ComponentRef& ref) const {
        return kind_text(ref.kind) + " " + qualified(ref.package, ref.path);
    }

    const System& system_;
    std::string text_;
};

void Dump::declared(const Type& type) {
    if (type.kind == TypeKind::given) line("type {}", qualified(type.package, type.name));
    if (type.kind == TypeKind::enumeration)
        line("enumeration {} {{ {} }}", qualified(type.package, type.name), joined(type.labels));
    if (type.kind != TypeKind::record) return;
    std::string fields;
    for (std::size_t i = 0; i < type.labels.size(); ++i)
        fields += (i > 0 ? ", " : "") + type.labels[i] + ": " + this->type(type.args[i]);
    line("record {} {{ {} }}", qualified(type.package, type.name), fields);
}

void Dump::function(const Function& function) {
    std::string parameters;
    for (std::size_t i = 0; i < function.parameters.size(); ++i)
        parameters += (i > 0 ? ", " : "") + function.parameter_names[i] + ": " + type(function.parameters[i]);
    line("function {}({}): {}", qualified(function.package, function.name), parameters, type(function.result));
    for (const auto& condition : function.preconditions)
        line("  precondition {}", expression_text(system_, nullptr, *condition));
    for (const auto& condition : function.postconditions)
        line("  postcondition {}", expression_text(system_, nullptr, *condition));
}

void Dump::signature(const OperationSignature& signature) {
    std::string parameters;
    for (std::size_t i = 0; i < signature.parameters.size(); ++i)
        parameters += (i > 0 ? ", " : "") + signature.parameter_names[i] + ": " + type(signature.parameters[i]);
    line("  operation {}({}){}{}", signature.name, parameters, signature.terminates ? " terminates" : "",
         from(signature.interface));
}

template <class Context>
void Dump::declarations(const Context& context, const Machine* machine) {
    if (!context.interfaces.empty()) line("  interfaces {}", joined(context.interfaces));
    for (const auto& item : context.variables)
        line("  variable {} {}: {}{}{}", scope_text(item.scope), item.name, type(item.type),
             clause(system_, machine, "=", item.initial), from(item.interface));
    for (const auto& item : context.constants)
        line("  constant{} {}: {}{}{}", item.required ? " required" : "", item.name, type(item.type),
             clause(system_, machine, "=", item.value), from(item.interface));
    for (const auto& item : context.events)
        line("  event{}{}{} {}{}{}", item.broadcast ? " broadcast" : "", item.input ? " in" : "",
             item.output ? " out" : "", item.name, item.type ? ": " + type(*item.type) : "", from(item.interface));
    for (const auto& item : context.operations) signature(item);
}

void Dump::action(const Machine& machine, const char* word, const StmtPtr& stmt) {
    if (!stmt) return;
    line("    {}", word);
    text_ += program_text(system_, machine, *stmt, 6);
}

void Dump::node(const Machine& machine, const Node& node) {
    line("  {} {}", kind_text(node.kind), node.path);
    action(machine, "entry", node.entry);
    action(machine, "during", node.during);
    action(machine, "exit", node.exit);
}

void Dump::transition(const Machine& machine, const Transition& transition) {
    std::string resets;
    for (const auto clock : transition.resets) resets += " reset " + machine.clocks[clock.index].name;
    line("  transition {} {} -> {}{}{}{}{}{}{}", transition.name, machine.nodes[transition.source.index].path,
         machine.nodes[transition.target.index].path,
         transition.trigger ? " on " + communication_text(system_, machine, *transition.trigger) : "", resets,
         clause(system_, &machine, "within", transition.deadline),
         clause(system_, &machine, transition.guard_timed ? "when-timed" : "when", transition.guard),
         clause(system_, &machine, "probability", transition.probability), transition.action ? " do" : "");
    if (transition.action) text_ += program_text(system_, machine, *transition.action, 6);
}

void Dump::machine(const Machine& machine) {
    const char* kind = machine.kind == MachineKind::operation ? "operation" : "machine";
    line("{} {}{}", kind, qualified(machine.package, machine.path), machine.terminates ? " terminates" : "");
    declarations(machine, &machine);
    for (const auto& clock : machine.clocks)
        line("  clock{} {}{}{}", clock.required ? " required" : "", clock.name,
             clock.entry_of.valid() ? " of entry" : "", from(clock.interface));
    for (const auto& condition : machine.preconditions)
        line("  precondition {}", expression_text(system_, &machine, *condition));
    for (const auto& condition : machine.postconditions)
        line("  postcondition {}", expression_text(system_, &machine, *condition));
    for (const auto& item : machine.nodes) node(machine, item);
    for (const auto& item : machine.transitions) transition(machine, item);
}

template <class Parts>
void Dump::connection(const Connection& connection, const Parts& parts) {
    const auto end_text = [&](const ConnectionEnd& end) {
        const bool part = end.kind == EndKind::part && end.part < parts.size();
        return (part ? parts[end.part].name : "self") + "." + end.event;
    };
    line("  connection {} -> {}{}{}", end_text(connection.from), end_text(connection.to),
         connection.async ? " async" : "", connection.multiple ? " mult" : "");
}

void Dump::controller(const Controller& controller) {
    line("controller {}", qualified(controller.package, controller.path));
    declarations(controller, nullptr);
    for (std::size_t i = 0; i < controller.definitions.size(); ++i)
        line("  defines {} as {}", system_.machine(controller.definitions[i]).path, controller.definition_names[i]);
    for (const auto& part : controller.machines) {
        const Machine& machine = system_.machine(part.machine);
        line("  machine {} = {}", part.name, qualified(machine.package, machine.path));
        for (std::size_t i = 0; i < part.definitions.size(); ++i)
            line("    {} is {}", machine.operations[i].name,
                 part.definitions[i].valid() ? system_.machine(part.definitions[i]).path : "called on the platform");
    }
    for (const auto& item : controller.connections) connection(item, controller.machines);
}

void Dump::module(const Module& module) {
    line("module {}", qualified(module.package, module.name));
    line("  platform {}", module.platform.name);
    declarations(module.platform, nullptr);
    for (const auto& part : module.controllers) {
        const Controller& controller = system_.controller(part.controller);
        line("  controller {} = {}", part.name, qualified(controller.package, controller.path));
    }
    for (const auto& item : module.connections) connection(item, module.controllers);
}

void Dump::block(const CspBlock& block) {
    std::string associated;
    for (const auto& ref : block.associated) associated += " " + reference(ref);
    line("csp {}{}{}{}", block.name, block.timed ? " timed" : "", block.untimed ? " untimed" : "",
         associated.empty() ? "" : " for" + associated);
}

void Dump::property(const Property& property) {
    const std::string missed = property.event.empty() ? "" : fmt::format(" {} {}", property.event, property.time_units);
    line("property {}{}{}: {}{} {} [{}]{}{}{}{}", property.name, property.timed ? " timed" : "",
         property.untimed ? " untimed" : "", reference(property.subject), property.negated ? " not" : "",
         kind_text(property.kind), model_text(property.model), property.state.empty() ? "" : " " + property.state,
         missed, property.other.path.empty() ? "" : " " + reference(property.other),
         property.rule.empty() ? "" : " " + property.rule);
    for (const auto& [name, value] : property.constants)
        line("  with {} = {}", name, expression_text(system_, nullptr, *value));
}

}  // namespace

std::string dump(const System& system) {
    return Dump(system).text();
}

}  // namespace robochart::ir
