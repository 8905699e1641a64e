// SPDX-License-Identifier: Apache-2.0
// Writes controllers, modules, the interfaces that they share, and the claims.
#include "frontend/cycles/robosim.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "frontend/cycles/copies.hpp"
#include "frontend/cycles/event_reuse.hpp"
#include "frontend/cycles/machine_writer.hpp"
#include "frontend/format/format.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"

namespace robochart::frontend {

namespace {

/// A component of RoboChart and the file that declares it.
struct WrittenComponent {
    const File* file = nullptr;
    const Context* context = nullptr;
};

/// A part of a controller or module under the name that connections use.
template <class Kind>
struct NamedPart {
    std::string name;
    const Kind* definition = nullptr;
};

template <class Kind>
std::vector<NamedPart<Kind>> named_parts(const Component& component, DeclKind kind) {
    std::vector<NamedPart<Kind>> result;
    for (const Declaration* member : component.order) {
        const Declaration* const definition = follow_reference(member);
        if (definition == nullptr || definition->kind != kind) continue;
        if (const auto* part = dynamic_cast<const Kind*>(definition)) result.push_back({member->name, part});
    }
    return result;
}

/// A machine in the component, with the operations that it may call.
struct CyclicMachine {
    std::string name;
    Callers callers;
    std::vector<NamedPart<Machine>> operations;  ///< the operations that it calls
    std::set<std::string> reusable;
    Usage usage;
};

void merge(Usage& all, const Usage& more) {
    all.inputs.insert(more.inputs.begin(), more.inputs.end());
    all.outputs.insert(more.outputs.begin(), more.outputs.end());
    all.read.insert(more.read.begin(), more.read.end());
    all.written.insert(more.written.begin(), more.written.end());
    all.constants.insert(more.constants.begin(), more.constants.end());
    all.platform.insert(more.platform.begin(), more.platform.end());
    all.software.insert(more.software.begin(), more.software.end());
}

class ComponentWriter {
public:
    ComponentWriter(const Model& model, const WrittenComponent& subject, const std::string& full_name,
                    std::uint32_t cycle)
        : model_(model), subject_(subject), full_name_(full_name) {
        component_.cycle = cycle;
    }

    RoboSimFiles write() {
        const std::string name = new_name();
        body_ = write_subject(name);
        return {header() + interfaces() + body_, claims(), one_way()};
    }

private:
    // ------------------------------------------------------------ machines

    CyclicMachine machine_of(const std::string& name, const Machine& definition,
                             const std::vector<const Machine*>& operations) {
        CyclicMachine result{name, Callers(definition, operations), {}, {}, {}};
        result.usage = usage_of(definition, result.callers);
        const Usage& usage = result.usage;
        check_events(definition, usage);
        for (const auto& [operation, signature] : usage.software)
            result.operations.push_back({operation, result.callers.definition(operation)});
        result.reusable = reusable_inputs(result.callers);
        during_outputs_ = during_outputs_ || has_during_outputs(result);
        merge(component_.usage, usage);
        return result;
    }

    static void check_events(const Machine& machine, const Usage& usage) {
        for (const auto& [name, event] : usage.inputs) {
            if (usage.outputs.contains(name))
                throw NoCyclicForm(
                    event->name_span, fmt::format("event `{}`", name),
                    fmt::format("`{}` receives it and sends it, and a register has one direction", machine.name));
            if (event->broadcast)
                throw NoCyclicForm(event->name_span, fmt::format("event `{}`", name), "RoboSim has no broadcast");
        }
    }

    /// Adds the variables that the component requires. The environment may write all of them, even those that the
    /// component does not use. In the RoboSim model, each of them is therefore both an input and an output register.
    void add_required(const Context& subject) {
        reads_ = !component_.usage.read.empty();
        for (const Variable* variable : required_variables(subject)) {
            if (variable->kind != DeclKind::variable) continue;
            component_.usage.read.emplace(variable->name, variable);
            component_.usage.written.emplace(variable->name, variable);
        }
    }

    /// Chooses names for the interfaces that have members.
    void name_interfaces() {
        const auto name = [&](bool used, const char* what) {
            return used ? robosim_name(subject_.context->name + what) : std::string();
        };
        const Usage& usage = component_.usage;
        const auto some = [&](bool read, bool written) {
            const auto fits = [&](const std::string& register_name) {
                return usage.read.contains(register_name) == read && usage.written.contains(register_name) == written;
            };
            return std::ranges::any_of(usage.read, [&](const auto& entry) { return fits(entry.first); }) ||
                   std::ranges::any_of(usage.written, [&](const auto& entry) { return fits(entry.first); });
        };
        component_.interfaces = {name(some(true, false), "_Inputs"),
                                 name(some(false, true), "_Outputs"),
                                 name(some(true, true), "_Variables"),
                                 name(!usage.constants.empty(), "_Constants"),
                                 name(!usage.platform.empty(), "_Platform"),
                                 name(!usage.software.empty(), "_Operations"),
                                 ""};
    }

    std::string write_operations(const CyclicMachine& machine) {
        std::string text;
        for (const auto& operation : machine.operations) {
            if (!operation.definition->has_body) {
                text += write_empty_operation(*operation.definition);
                continue;
            }
            MachineWriter writer(component_, machine.callers, *operation.definition, machine.reusable,
                                 usage_of(*operation.definition, machine.callers));
            text += writer.write(operation.name);
            callers_.insert(writer.needed_of_caller().begin(), writer.needed_of_caller().end());
        }
        return text;
    }

    static std::string write_empty_operation(const Machine& operation) {
        if (!operation.terminates)
            throw NoCyclicForm(operation.name_span, fmt::format("operation `{}`", operation.name),
                               "it has no nodes, and it does not say that it terminates");
        std::vector<std::string> parameters;
        for (const VariablePtr& parameter : operation.parameters)
            parameters.push_back(
                fmt::format("{} : {}", robosim_name(parameter->name), robosim_text(*parameter->type_expr)));
        return fmt::format("operation {}({}) {{\nterminates\ninput context {{ }}\noutput context {{ }}\n}}\n",
                           robosim_name(operation.name), fmt::join(parameters, ", "));
    }

    /// Writes the operations and the machine. The operations are written twice: the first pass finds the variables and
    /// clocks of the caller that they need.
    std::string write_machine(const CyclicMachine& machine) {
        callers_.clear();
        (void)write_operations(machine);
        if (!callers_.empty()) {
            component_.interfaces.callers = robosim_name(subject_.context->name + "_Callers");
            all_callers_.insert(callers_.begin(), callers_.end());
        }
        const std::string operations = write_operations(machine);
        MachineWriter writer(component_, machine.callers, machine.callers.root(), machine.reusable,
                             component_.alone ? component_.usage : machine.usage);
        return operations + writer.write(machine.name);
    }

    // ------------------------------------------------------------ components

    std::string write_subject(const std::string& name) {
        switch (subject_.context->kind) {
            case DeclKind::state_machine: {
                const auto& machine = dynamic_cast<const Machine&>(*subject_.context);
                const CyclicMachine cyclic = machine_of(name, machine, {});
                component_.alone = true;
                check_calls(machine, cyclic.usage);
                add_required(machine);
                name_interfaces();
                return write_machine(cyclic);
            }
            case DeclKind::controller: {
                const auto& controller = dynamic_cast<const Component&>(*subject_.context);
                const std::vector<CyclicMachine> machines = machines_of(controller);
                add_required(controller);
                name_interfaces();
                return write_controller(controller, name, machines);
            }
            default:
                return write_module(dynamic_cast<const Component&>(*subject_.context), name);
        }
    }

    /// Rejects calls of operations that the controller defines. Only RoboChart allows them in a machine inside a
    /// controller.
    void check_calls(const Machine& machine, const Usage& usage) const {
        const auto* controller = dynamic_cast<const Component*>(machine.parent);
        if (controller == nullptr) return;
        for (const Machine* definition : defined_operations(*controller))
            if (usage.platform.contains(definition->name))
                throw NoCyclicForm(machine.name_span, fmt::format("state machine `{}`", machine.name),
                                   fmt::format("it calls operation `{}` of its controller; write controller `{}`",
                                               definition->name, controller->name));
    }

    std::vector<CyclicMachine> machines_of(const Component& controller) {
        std::vector<CyclicMachine> result;
        const std::vector<const Machine*> operations = defined_operations(controller);
        for (const NamedPart<Machine>& part : named_parts<Machine>(controller, DeclKind::state_machine)) {
            result.push_back(machine_of(part.name, *part.definition, operations));
            add_connected(controller, result.back());
            check_connected(controller, part.name, result.back().usage);
        }
        check_independent(controller, result);
        return result;
    }

    /// Adds the events that the controller connects. They are registers even if the machine does not use them.
    static void add_connected(const Component& controller, CyclicMachine& machine) {
        const Scope scope = scope_of(machine.callers.root());
        for (const auto& connection : controller.connections)
            for (const bool inwards : {true, false}) {
                const Connection::End& end = inwards ? connection->to : connection->from;
                const auto event = scope.events.find(end.event.text());
                if (end.node.text() != machine.name || event == scope.events.end()) continue;
                const std::string& name = event->second->name;
                if (machine.usage.inputs.contains(name) || machine.usage.outputs.contains(name)) continue;
                (inwards ? machine.usage.inputs : machine.usage.outputs).emplace(name, event->second);
            }
    }

    /// Rejects inputs without connection. In RoboChart such an input can occur at any time, and in RoboSim its register
    /// can have any content.
    static void check_connected(const Component& outer, const std::string& part, const Usage& usage) {
        for (const auto& [name, event] : usage.inputs) {
            const std::string& input = name;  // clang 14 does not capture structured bindings
            const bool connected = std::ranges::any_of(outer.connections, [&](const auto& connection) {
                const auto ends_here = [&](const Connection::End& end) {
                    return end.node.text() == part && end.event.text() == input;
                };
                return ends_here(connection->from) || ends_here(connection->to);
            });
            if (!connected)
                throw NoCyclicForm(event->name_span, fmt::format("event `{}` of `{}`", name, part),
                                   "no connection names it, so the machine takes it at any time");
        }
    }

    /// Rejects machines that communicate with each other. In RoboChart, an event or a write of a shared variable
    /// reaches another machine at once. In RoboSim, it reaches the machine one cycle later.
    static void check_independent(const Component& controller, const std::vector<CyclicMachine>& machines) {
        for (const auto& connection : controller.connections)
            if (connection->from.node.text() != controller.name && connection->to.node.text() != controller.name)
                throw NoCyclicForm(connection->span,
                                   fmt::format("the connection of `{}` with `{}`", connection->from.node.text(),
                                               connection->to.node.text()),
                                   "in RoboSim, an event between components arrives one cycle later");
        for (const CyclicMachine& writer : machines)
            for (const CyclicMachine& other : machines) {
                if (&writer == &other) continue;
                const Usage read = usage_of(other.callers.root(), other.callers);
                for (const auto& [name, variable] : usage_of(writer.callers.root(), writer.callers).written)
                    if (read.read.contains(name) || read.written.contains(name))
                        throw NoCyclicForm(variable->name_span, fmt::format("variable `{}`", name),
                                           fmt::format("`{}` and `{}` share it, and in RoboSim, `{}` sees changes one "
                                                       "cycle later",
                                                       writer.name, other.name, other.name));
                for (const auto& operation : writer.operations)
                    if (std::ranges::any_of(other.operations,
                                            [&](const auto& same) { return same.name == operation.name; }))
                        throw NoCyclicForm(operation.definition->name_span,
                                           fmt::format("operation `{}`", operation.name),
                                           "several machines call it, and its registers are those of its caller");
            }
    }

    /// Declares the events of a component in `outer` that the connections of `outer` use.
    static std::string event_lines(const std::vector<const Event*>& events, const Component& outer,
                                   const std::string& node) {
        std::string text;
        for (const Event* event : events)
            if (names_event(outer, node, event->name))
                text += fmt::format("event {}{}\n", robosim_name(event->name),
                                    event->type_expr ? " : " + robosim_text(*event->type_expr) : "");
        return text;
    }

    static bool names_event(const Component& component, const std::string& node, const std::string& event) {
        return std::ranges::any_of(component.connections, [&](const auto& connection) {
            const auto is = [&](const Connection::End& end) {
                return end.node.text() == node && end.event.text() == event;
            };
            return is(connection->from) || is(connection->to);
        });
    }

    std::string connection_lines(const Component& component, const std::string& name) const {
        std::string text;
        const auto node = [&](const Connection::End& end) {
            return end.node.text() == component.name ? name : robosim_name(end.node);
        };
        for (const auto& connection : component.connections)
            text += fmt::format("connection {} on {} to {} on {}\n", node(connection->from),
                                robosim_name(connection->from.event), node(connection->to),
                                robosim_name(connection->to.event));
        return text;
    }

    std::string write_controller(const Component& controller, const std::string& name,
                                 const std::vector<CyclicMachine>& machines) {
        Usage usage;
        for (const CyclicMachine& machine : machines) merge(usage, usage_of(machine.callers.root(), machine.callers));
        std::string text = fmt::format("controller {} {{\ncycleDef cycle == {}\n", name, component_.cycle);
        std::set<std::string> required;
        std::string variables;
        const std::vector<const Variable*> outside = required_variables(controller);
        const auto is_outside = [&](const std::string& variable) {
            return std::ranges::any_of(outside, [&](const Variable* one) { return one->name == variable; });
        };
        const auto add_variable = [&](const std::string& variable, const std::string& interface) {
            if (is_outside(variable)) {
                required.insert(interface);
                return;
            }
            const Scope scope = scope_of(controller);
            const auto own = scope.variables.find(variable);
            if (own == scope.variables.end()) return;
            variables += variable_line(*own->second) + "\n";
        };
        Usage registers = subject_.context == &controller ? component_.usage : usage;
        registers.read.insert(registers.written.begin(), registers.written.end());
        for (const auto& [variable, declared] : registers.read)
            add_variable(variable, interface_of_register(component_, variable));
        for (const auto& [constant, declared] : usage.constants)
            add_variable(constant, component_.interfaces.constants);
        if (!usage.platform.empty()) required.insert(component_.interfaces.platform);
        for (const std::string& interface : required) text += "requires " + interface + "\n";
        text += variables;
        text += event_lines(visible_events(controller), controller, controller.name);
        for (const CyclicMachine& machine : machines) text += write_machine(machine);
        return text + connection_lines(controller, name) + "}\n";
    }

    static std::string variable_line(const Variable& variable) {
        return fmt::format("{} {} : {}{}", variable.kind == DeclKind::constant ? "const" : "var",
                           robosim_name(variable.name), robosim_text(*variable.type_expr),
                           variable.initial ? " = " + robosim_text(*variable.initial, {}) : "");
    }

    std::string write_module(const Component& module, const std::string& name) {
        const auto controllers = named_parts<Component>(module, DeclKind::controller);
        const auto platforms = named_parts<Context>(module, DeclKind::platform);
        if (platforms.size() != 1)
            throw NoCyclicForm(module.name_span, fmt::format("module `{}`", module.name), "it has no robotic platform");
        if (controllers.size() > 1) check_module(module, platforms[0].name);
        std::vector<std::vector<CyclicMachine>> machines;
        for (const auto& controller : controllers) machines.push_back(machines_of(*controller.definition));
        check_shared(controllers, machines);
        for (std::size_t i = 0; i < controllers.size(); ++i) check_reached(module, controllers[i], machines[i]);
        name_interfaces();
        std::string text = fmt::format("module {} {{\ncycleDef cycle == {}\n", name, component_.cycle);
        text += write_platform(module, platforms[0]);
        for (std::size_t i = 0; i < controllers.size(); ++i)
            text += write_controller(*controllers[i].definition, robosim_name(controllers[i].name), machines[i]);
        return text + connection_lines(module, name) + "}\n";
    }

    static void check_module(const Component& module, const std::string& platform) {
        for (const auto& connection : module.connections)
            if (connection->from.node.text() != platform && connection->to.node.text() != platform)
                throw NoCyclicForm(connection->span,
                                   fmt::format("the connection of `{}` with `{}`", connection->from.node.text(),
                                               connection->to.node.text()),
                                   "in RoboSim, an event between components arrives one cycle later");
    }

    /// Rejects controllers that share a variable that one of them writes.
    static void check_shared(const std::vector<NamedPart<Component>>& controllers,
                             const std::vector<std::vector<CyclicMachine>>& machines) {
        std::vector<Usage> usage(machines.size());
        for (std::size_t i = 0; i < machines.size(); ++i)
            for (const CyclicMachine& machine : machines[i])
                merge(usage[i], usage_of(machine.callers.root(), machine.callers));
        for (std::size_t i = 0; i < usage.size(); ++i)
            for (std::size_t j = 0; j < usage.size(); ++j)
                for (const auto& [name, variable] : usage[i].written)
                    if (i != j && (usage[j].read.contains(name) || usage[j].written.contains(name)))
                        throw NoCyclicForm(
                            variable->name_span, fmt::format("variable `{}`", name),
                            fmt::format("`{}` and `{}` share it", controllers[i].name, controllers[j].name));
    }

    static void check_reached(const Component& module, const NamedPart<Component>& controller,
                              const std::vector<CyclicMachine>& machines) {
        for (const CyclicMachine& machine : machines)
            for (const auto& [name, event] : usage_of(machine.callers.root(), machine.callers).inputs)
                for (const auto& connection : controller.definition->connections) {
                    const std::string& input = name;
                    const auto outer = [&](const Connection::End& inner, const Connection::End& end) {
                        return inner.node.text() == machine.name && inner.event.text() == input ? end.event.text() : "";
                    };
                    const std::string event_outside =
                        outer(connection->to, connection->from) + outer(connection->from, connection->to);
                    if (!event_outside.empty() && !names_event(module, controller.name, event_outside))
                        throw NoCyclicForm(event->name_span,
                                           fmt::format("event `{}` of `{}`", event_outside, controller.name),
                                           "no connection names it, so the controller takes it at any time");
                }
    }

    std::string write_platform(const Component& module, const NamedPart<Context>& platform) {
        const Usage& usage = component_.usage;
        for (const VariablePtr& own : platform.definition->variables)
            if (own->kind == DeclKind::variable &&
                (usage.written.contains(own->name) || usage.read.contains(own->name)))
                throw NoCyclicForm(
                    own->name_span, fmt::format("variable `{}` of the platform", own->name),
                    "the platform does not provide it: RoboChart hides its changes, and RoboSim shows them");
        std::string text = fmt::format("robotic platform {} {{\n", robosim_name(platform.name));
        const SharedInterfaces& shared = component_.interfaces;
        for (const std::string& interface :
             {shared.read, shared.written, shared.both, shared.constants, shared.platform})
            if (!interface.empty()) text += "provides " + interface + "\n";
        return text + event_lines(visible_events(*platform.definition), module, platform.name) + "}\n";
    }

    // ------------------------------------------------------------ files

    /// Returns the name of the RoboSim component. In the unnamed package the name must differ from the name of the
    /// RoboChart component.
    std::string new_name() const {
        const std::string& name = subject_.context->name;
        return robosim_name(subject_.file->package.empty() ? name + "_sim" : name);
    }

    std::string package() const {
        const std::string name = subject_.file->package.text();
        return name.empty() ? "sim" : name + "_sim";
    }

    /// Imports the packages of the model, and the packages that its files import, so that the names of the model are
    /// visible.
    std::string imports() const {
        std::set<std::string> imports;
        for (const auto& file : model_.files) {
            if (file->is_library || file->is_assertions || file->dialect != Dialect::robochart) continue;
            if (!file->package.empty()) imports.insert(robosim_name(file->package) + "::*");
            for (const Import& import : file->imports)
                imports.insert(robosim_name(import.name) + (import.wildcard ? "::*" : ""));
        }
        std::string text;
        for (const std::string& import : imports) text += "import " + import + "\n";
        return text;
    }

    std::string header() const {
        return fmt::format(
            "// {}, run in cycles of {} time unit{}: written by `robochart-verify emit rst`.\npackage {}\n{}\n",
            full_name_, component_.cycle, component_.cycle == 1 ? "" : "s", package(), imports());
    }

    std::string interface_text(const std::string& name, const std::vector<std::string>& members) const {
        if (name.empty()) return "";
        return fmt::format("\ninterface {} {{\n{}\n}}\n", name, fmt::join(members, "\n"));
    }

    std::string interfaces() const {
        const SharedInterfaces& shared = component_.interfaces;
        std::string text;
        std::map<std::string, std::vector<std::string>> members;
        std::map<std::string, const Variable*> registers = component_.usage.read;
        registers.insert(component_.usage.written.begin(), component_.usage.written.end());
        for (const auto& [name, variable] : registers)
            members[interface_of_register(component_, name)].push_back(variable_line(*variable));
        for (const auto& [name, variable] : component_.usage.constants)
            members[shared.constants].push_back(variable_line(*variable));
        for (const auto& [name, line] : all_callers_) members["callers"].push_back(line);
        for (const auto& [name, signature] : component_.usage.platform)
            members[shared.platform].push_back(signature_line(*signature));
        for (const auto& [name, signature] : component_.usage.software)
            members[shared.software].push_back(signature_line(*signature));
        for (const std::string& name :
             {shared.read, shared.written, shared.both, shared.constants, shared.platform, shared.software})
            text += interface_text(name, members[name]);
        if (!all_callers_.empty())
            text += interface_text(robosim_name(subject_.context->name + "_Callers"), members["callers"]);
        return text + "\n";
    }

    static std::string signature_line(const OperationSignature& signature) {
        std::vector<std::string> parameters;
        for (const VariablePtr& parameter : signature.parameters)
            parameters.push_back(
                fmt::format("{} : {}", robosim_name(parameter->name), robosim_text(*parameter->type_expr)));
        return fmt::format("{}({}){}", robosim_name(signature.name), fmt::join(parameters, ", "),
                           signature.terminates ? " [terminates]" : "");
    }

    /// Returns the reason why the RoboSim model refines the component but not vice versa, or "" if they refine each
    /// other.
    std::string one_way() const {
        if (reads_) return "the environment may write a variable that it reads in the middle of a cycle";
        if (during_outputs_)
            return "a transition may interrupt a during action with outputs, and in cycles, an output is decided "
                   "before "
                   "its register accepts it";
        return "";
    }

    /// True if a during action of the machine, or of its operations, makes outputs.
    static bool has_during_outputs(const CyclicMachine& machine) {
        bool found = false;
        const auto look = [&](const Machine& definition) {
            for_states(definition, [&](const State& state) {
                for (const Action& action : state.actions) {
                    if (action.kind != ActionKind::during || !action.statement) continue;
                    walk_tree(*action.statement, [&](const Stmt& part) {
                        const Variable* assigned =
                            part.kind == StmtKind::assignment ? assigned_variable(part) : nullptr;
                        found = found || part.kind == StmtKind::communication || part.kind == StmtKind::call ||
                                (assigned != nullptr &&
                                 machine.callers.role(definition, *assigned) == VariableRole::shared);
                    });
                }
            });
        };
        look(machine.callers.root());
        for (const auto& operation : machine.operations) look(*operation.definition);
        return found;
    }

    std::string claims() const {
        const std::string name = subject_.context->name;
        const std::string simulation = robosim_name(name + "Simulation");
        const std::string own = package() + "::" + new_name();
        std::string text = fmt::format("import {}::*\n{}\nsimulation {} of {} {{\ncycleDef cycle == {}\n", package(),
                                       imports(), simulation, full_name_, component_.cycle);
        if (component_.alone) text += contexts();
        text += fmt::format("}}\n\nassertion {}_schedulable : {} is schedulable\n", name, simulation);
        text += fmt::format("assertion {}_refines : {} refines {}\n", name, own, simulation);
        if (one_way().empty()) text += fmt::format("assertion {}_is_refined : {} refines {}\n", name, simulation, own);
        return text;
    }

    /// Writes the contexts of the simulation. If the component is a machine, they are the contexts of the RoboSim
    /// machine.
    std::string contexts() const {
        const std::size_t begin = body_.find("input context");
        const std::size_t output = body_.find("output context", begin);
        return body_.substr(begin, body_.find('}', output) + 1 - begin) + "\n";
    }

    const Model& model_;
    WrittenComponent subject_;
    std::string full_name_;
    CyclicComponent component_;
    std::map<std::string, std::string> callers_, all_callers_;
    std::string body_;
    bool reads_ = false;           ///< a variable that the environment may write
    bool during_outputs_ = false;  ///< some during action makes outputs
};

// ---------------------------------------------------------------- the component

void find_inside(const Component& component, const std::string& prefix, const std::string& name,
                 WrittenComponent& found) {
    const auto look_at = [&](const Context& context) {
        const std::string full = prefix + context.name;
        if (full == name) found.context = &context;
        if (const auto* inner = dynamic_cast<const Component*>(&context)) find_inside(*inner, full + "::", name, found);
    };
    for (const auto& controller : component.controllers) look_at(*controller);
    for (const auto& machine : component.machines) look_at(*machine);
}

WrittenComponent find_subject(const Model& model, const std::string& name) {
    WrittenComponent found;
    for (const auto& file : model.files) {
        if (file->dialect != Dialect::robochart) continue;
        const std::string prefix = file->package.empty() ? "" : file->package.text() + "::";
        for (const auto& declared : file->declarations) {
            const auto* context = dynamic_cast<const Context*>(declared.get());
            if (context == nullptr) continue;
            const WrittenComponent before = found;
            if (prefix + context->name == name) found.context = context;
            if (const auto* component = dynamic_cast<const Component*>(context))
                find_inside(*component, prefix + context->name + "::", name, found);
            if (found.context != before.context) found.file = file.get();
        }
    }
    return found;
}

/// Formats a text that this file has written.
std::string in_layout(const std::string& text, bool claims) {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics findings;
    const diagnostics::SourceId id = sources.add(claims ? "emitted.rsa" : "emitted.rst", text);
    if (const std::optional<std::string> layout = format(sources, id, claims, findings)) return *layout;
    throw std::logic_error("the text in RoboSim has syntax errors: " + findings.first_error() + "\n" + text);
}

}  // namespace

std::optional<RoboSimFiles> write_robosim(const Model& model, const std::string& component, std::uint32_t cycle,
                                          diagnostics::Diagnostics& findings) {
    const WrittenComponent subject = find_subject(model, component);
    if (subject.context == nullptr) {
        findings.report(rules::no_cyclic_form, {},
                        {"a component inside another", component, "write the component that contains it"});
        return std::nullopt;
    }
    try {
        RoboSimFiles files = ComponentWriter(model, subject, component, cycle).write();
        files.model = in_layout(files.model, false);
        files.claims = in_layout(files.claims, true);
        return files;
    } catch (const NoCyclicForm& refused) {
        findings.report(rules::no_cyclic_form, refused.span(), {refused.construct(), component, refused.what()});
        return std::nullopt;
    }
}

}  // namespace robochart::frontend
