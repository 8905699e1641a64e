#include "cpp_emit/component.hpp"

#include <algorithm>

#include "cpp_emit/rules.hpp"
#include "cpp_emit/walk.hpp"
#include "semantics/evaluate.hpp"
#include "semantics/query.hpp"

namespace robochart::cpp_emit {

namespace {

using diagnostics::Diagnostics;

/// Names that generated State, Inputs and platform classes use themselves.
const std::set<std::string> state_names = {"at", "wait", "leaving", "filler", "State", "Inputs", "At", "Types"};

template <class Item>
const Item* find_named(const std::vector<Item>& items, const std::string& name) {
    const auto found = std::find_if(items.begin(), items.end(), [&](const Item& item) { return item.name == name; });
    return found == items.end() ? nullptr : &*found;
}

/// The parts around the machine: none for a machine alone.
struct Context {
    const ir::Controller* controller = nullptr;
    const ir::Module* module = nullptr;
};

class Resolver {
public:
    Resolver(const ir::System& system, const ir::Instantiation& inst, Diagnostics& diagnostics)
        : system_(system), inst_(inst), diagnostics_(diagnostics), errors_before_(diagnostics.errors()) {}

    std::optional<Component> resolve(const ir::ComponentRef& ref) {
        component_.ref = ref;
        const std::optional<ir::MachineId> root = find_machine(ref);
        if (!root) return std::nullopt;
        add_unit(*root, true);
        if (diagnostics_.errors() != errors_before_) return std::nullopt;
        collect_events();
        collect_variables();
        collect_calls();
        collect_types();
        name_everything();
        if (diagnostics_.errors() != errors_before_) return std::nullopt;
        return std::move(component_);
    }

private:
    template <class Element>
    void describe(const Element& element, std::string kind) {
        component_.name = element.name;
        component_.cpp_name = identifier(element.name);
        component_.package = element.package;
        component_.origin = element.origin;
        component_.kind = std::move(kind);
    }

    std::optional<ir::MachineId> find_machine(const ir::ComponentRef& ref) {
        switch (ref.kind) {
            case ir::ComponentKind::machine:
                return machine_alone(ref);
            case ir::ComponentKind::controller:
                return in_controller(ref);
            case ir::ComponentKind::module:
                return in_module(ref);
            case ir::ComponentKind::operation:
            case ir::ComponentKind::process:
                break;
        }
        diagnostics_.report(rules::no_component, {}, {ref.path, "it is neither a machine, a controller nor a module"});
        return std::nullopt;
    }

    bool within(std::size_t size, const ir::ComponentRef& ref) {
        if (ref.definition < size) return true;
        diagnostics_.report(rules::no_component, {}, {ref.path, "the model has no such component"});
        return false;
    }

    std::optional<ir::MachineId> machine_alone(const ir::ComponentRef& ref) {
        if (!within(system_.machines.size(), ref)) return std::nullopt;
        const ir::Machine& machine = system_.machines[ref.definition];
        if (machine.kind == ir::MachineKind::operation) {
            diagnostics_.report(rules::no_component, machine.origin.span, {machine.name, "it is an operation"});
            return std::nullopt;
        }
        describe(machine, "state machine");
        return ir::MachineId{ref.definition};
    }

    std::optional<ir::MachineId> in_controller(const ir::ComponentRef& ref) {
        if (!within(system_.controllers.size(), ref)) return std::nullopt;
        describe(system_.controllers[ref.definition], "controller");
        return only_machine(system_.controllers[ref.definition]);
    }

    std::optional<ir::MachineId> in_module(const ir::ComponentRef& ref) {
        if (!within(system_.modules.size(), ref)) return std::nullopt;
        const ir::Module& module = system_.modules[ref.definition];
        describe(module, "module");
        context_.module = &module;
        if (module.controllers.size() != 1) {
            refuse_number(module.controllers.size(), "controllers");
            return std::nullopt;
        }
        return only_machine(system_.controller(module.controllers.front().controller));
    }

    std::optional<ir::MachineId> only_machine(const ir::Controller& controller) {
        context_.controller = &controller;
        if (controller.machines.size() == 1) return controller.machines.front().machine;
        refuse_number(controller.machines.size(), "state machines");
        return std::nullopt;
    }

    void refuse_number(std::size_t number, const char* what) {
        diagnostics_.report(rules::several_machines, component_.origin.span,
                            {component_.name, std::to_string(number), what});
    }

    /// The operation's definition in this context (semantics 3.8); machines alone have none.
    ir::MachineId definition(const ir::OperationSignature& signature) const {
        return context_.controller == nullptr ? ir::MachineId{}
                                              : ir::definition_in(system_, *context_.controller, signature);
    }

    /// The name under which a machine or operation runs in the controller.
    std::string part_name(ir::MachineId id, bool root) const {
        if (context_.controller == nullptr) return {};
        const ir::Controller& controller = *context_.controller;
        if (root) return controller.machines.front().name;
        const auto found = std::find(controller.definitions.begin(), controller.definitions.end(), id);
        return controller.definition_names[static_cast<std::size_t>(found - controller.definitions.begin())];
    }

    /// The value of a variable at the start: its initial value in this context, else its type's default
    /// (semantics 3.6).
    ir::Value initial_value(const ir::Machine& machine, const std::vector<ir::Value>& constants, ir::TypeId type,
                            const ir::ExprPtr& initial) const {
        const ir::Value otherwise = ir::default_value(system_, inst_, type);
        if (!initial) return otherwise;
        ir::Environment environment;
        environment.constants = constants;
        try {
            return ir::evaluate(system_, inst_, &machine, environment, *initial);
        } catch (const ir::EvaluationFault& fault) {
            diagnostics_.report(rules::unsupported_expr, fault.span,
                                {"an initial value (" + std::string(fault.what()) + ")", machine.name});
        } catch (const std::length_error& error) {
            diagnostics_.report(rules::unsupported_expr, initial->span,
                                {"an initial value (" + std::string(error.what()) + ")", machine.name});
        }
        return otherwise;
    }

    /// Adds the operations that the machine calls, then the machine. `open_` holds the calls in progress.
    void add_unit(ir::MachineId id, bool root) {
        const ir::Machine& machine = system_.machine(id);
        if (std::find(open_.begin(), open_.end(), id) != open_.end()) {
            diagnostics_.report(rules::recursion, machine.origin.span, {machine.name});
            return;
        }
        if (root && !machine.initial.valid()) {
            diagnostics_.report(rules::no_body, machine.origin.span, {machine.name});
            return;
        }
        const auto& units = component_.units;
        if (std::any_of(units.begin(), units.end(), [&](const Unit& unit) { return unit.id == id; })) return;
        Unit unit;
        unit.id = id;
        unit.machine = &machine;
        unit.root = root;
        unit.definitions.resize(machine.operations.size());
        unit.constants =
            ir::constant_values(system_, inst_, context_.module, context_.controller, part_name(id, root), machine);
        for (const auto& variable : machine.variables) {
            const bool shared = variable.scope == ir::VariableScope::required;
            unit.initials.push_back(
                initial_value(machine, unit.constants, variable.type, shared ? nullptr : variable.initial));
        }
        open_.push_back(id);
        visit_statements(machine, [&](const ir::Stmt& stmt) {
            if (stmt.kind != ir::StmtKind::call) return;
            const ir::MachineId target = definition(machine.operations[stmt.operation.index]);
            unit.definitions[stmt.operation.index] = target;
            if (target.valid()) add_unit(target, false);
        });
        open_.pop_back();
        component_.units.push_back(std::move(unit));
    }

    // ---- events

    void collect_events() {
        for (auto unit = component_.units.rbegin(); unit != component_.units.rend(); ++unit) {
            visit_communications(*unit->machine, [&](const ir::Communication& communication, bool trigger) {
                EventPort& port = event_port(unit->machine->events[communication.event.index]);
                const bool receives = trigger || communication.kind == ir::CommKind::input;
                (receives ? port.received : port.sent) = true;
            });
        }
        const auto& declared = component_.root().machine->events;
        const auto place = [&](const EventPort& port) {
            return std::find_if(declared.begin(), declared.end(),
                                [&](const ir::Event& event) { return event.name == port.model_name; });
        };
        std::stable_sort(component_.events.begin(), component_.events.end(),
                         [&](const EventPort& a, const EventPort& b) { return place(a) < place(b); });
        for (const EventPort& port : component_.events) {
            if (!port.received || port.outside) continue;
            diagnostics_.report(rules::unconnected, component_.origin.span,
                                {component_.name, port.model_name, "not connected"});
        }
    }

    EventPort& event_port(const ir::Event& event) {
        auto& events = component_.events;
        const auto found = std::find_if(events.begin(), events.end(),
                                        [&](const EventPort& port) { return port.model_name == event.name; });
        if (found != events.end()) return *found;
        EventPort port;
        port.model_name = event.name;
        port.type = event.type;
        port.interface = event.interface;
        port.outside = outside_name(event.name);
        return events.emplace_back(std::move(port));
    }

    /// Follows the connections outwards; a direction is kept by all of them (semantics 3.9).
    std::optional<std::string> outside_name(const std::string& event) const {
        std::optional<std::string> name = event;
        if (context_.controller != nullptr) name = through(context_.controller->connections, *name);
        if (context_.module != nullptr && name) name = through(context_.module->connections, *name);
        return name;
    }

    static std::optional<std::string> through(const std::vector<ir::Connection>& connections,
                                              const std::string& event) {
        for (const auto& connection : connections) {
            for (const auto& [part, self] :
                 {std::pair{&connection.to, &connection.from}, std::pair{&connection.from, &connection.to}}) {
                const bool outwards = part->kind == ir::EndKind::part && self->kind == ir::EndKind::self;
                if (outwards && part->event == event) return self->event;
            }
        }
        return std::nullopt;
    }

    // ---- variables

    void collect_variables() {
        for (auto unit = component_.units.rbegin(); unit != component_.units.rend(); ++unit) {
            for (const auto& variable : unit->machine->variables) {
                const bool own_of_operation = !unit->root && variable.scope != ir::VariableScope::required;
                if (!own_of_operation && stored(variable.name) == nullptr) add_variable(*unit, variable);
            }
            mark_read(*unit);
        }
    }

    StoredVariable* stored(const std::string& name) {
        for (auto& entry : component_.variables)
            if (entry.variable->name == name) return &entry;
        return nullptr;
    }

    void add_variable(const Unit& unit, const ir::Variable& variable) {
        StoredVariable entry;
        entry.variable = &variable;
        entry.shared = variable.scope == ir::VariableScope::required;
        entry.initial = unit.initials[static_cast<std::size_t>(&variable - unit.machine->variables.data())];
        const ir::ExprPtr declared = entry.shared ? declaring_level(entry) : nullptr;
        if (declared) entry.initial = initial_value(*unit.machine, {}, variable.type, declared);
        component_.variables.push_back(std::move(entry));
    }

    /// Which level declares a shared variable decides who sees it (semantics 3.7). Returns the initial value, if any,
    /// that this level tells the machine at the start.
    ir::ExprPtr declaring_level(StoredVariable& entry) const {
        const std::string& name = entry.variable->name;
        if (context_.controller == nullptr) {
            entry.visible = entry.external = true;
            return nullptr;
        }
        const ir::Variable* at_controller = find_named(context_.controller->variables, name);
        // The controller's memory does not tell its initial value: copies start at the type's default.
        if (at_controller != nullptr && at_controller->scope == ir::VariableScope::local) return nullptr;
        if (context_.module == nullptr) {
            entry.visible = entry.external = true;
            return nullptr;
        }
        const ir::Variable* at_platform = find_named(context_.module->platform.variables, name);
        if (at_platform == nullptr) return nullptr;
        entry.visible = at_platform->scope == ir::VariableScope::required;
        return at_platform->initial;
    }

    void mark_read(const Unit& unit) {
        visit_expressions(*unit.machine, [&](const ir::Expr& expr) {
            if (expr.kind != ir::ExprKind::variable) return;
            const ir::Variable& variable = unit.machine->variables[expr.variable.index];
            if (!unit.root && variable.scope != ir::VariableScope::required) return;
            if (StoredVariable* entry = stored(variable.name)) entry->read = true;
        });
    }

    // ---- calls and names

    void collect_calls() {
        for (auto unit = component_.units.rbegin(); unit != component_.units.rend(); ++unit) {
            visit_statements(*unit->machine, [&](const ir::Stmt& stmt) {
                if (stmt.kind == ir::StmtKind::call) add_call(*unit, stmt.operation);
            });
        }
    }

    void add_call(const Unit& unit, ir::OperationId id) {
        const ir::OperationSignature& signature = unit.machine->operations[id.index];
        const ir::MachineId definition = unit.definitions[id.index];
        const auto add = [&](auto& calls, auto call, const auto& same) {
            if (std::none_of(calls.begin(), calls.end(), same)) calls.push_back(std::move(call));
        };
        if (definition.valid()) {
            add(component_.modelled, ModelledCall{&signature, definition, {}},
                [&](const ModelledCall& call) { return call.definition == definition; });
        } else {
            add(component_.calls, PlatformCall{&signature, {}},
                [&](const PlatformCall& call) { return call.signature->name == signature.name; });
        }
    }

    void collect_types() {
        for (const auto& event : component_.events)
            if (event.type) add_type(*event.type);
        for (const auto& call : component_.calls)
            for (const ir::TypeId type : call.signature->parameters) add_type(type);
        for (const auto& unit : component_.units) {
            for (const auto& variable : unit.machine->variables) add_type(variable.type);
            visit_expressions(*unit.machine, [&](const ir::Expr& expr) { add_type(expr.type); });
        }
    }

    void add_type(ir::TypeId id) {
        const ir::TypeKind kind = system_.type(id).kind;
        auto& types = component_.enumerations;
        const bool declared = kind == ir::TypeKind::enumeration || kind == ir::TypeKind::given;
        if (declared && std::find(types.begin(), types.end(), id) == types.end()) types.push_back(id);
    }

    void name_everything() {
        NameScope platform;
        for (auto& call : component_.calls) call.method = platform.unique(call.signature->name);
        for (auto& call : component_.modelled) call.method = platform.unique("replaces_" + call.signature->name);
        NameScope inputs(state_names);
        NameScope state(state_names);
        for (auto& event : component_.events) {
            if (event.received) event.input = inputs.unique(event.model_name);
            if (event.sent && event.outside) event.output = platform.unique("send_" + event.model_name);
        }
        for (auto& entry : component_.variables) {
            const std::string& name = entry.variable->name;
            if (entry.stored()) entry.field = state.unique(name);
            if (entry.external && entry.read) entry.input = inputs.unique("external_" + name);
            if (entry.visible) entry.output = platform.unique("set_" + name);
        }
        NameScope types(std::set<std::string>{"State", "Inputs", "Step", "At", "Real", "Nat", "Int"});
        for (auto& unit : component_.units) name_unit(unit, state, types);
        mark_clocks_read();
    }

    void name_unit(Unit& unit, NameScope& fields, NameScope& types) {
        NameScope own(state_names);
        NameScope& scope = unit.root ? fields : own;
        unit.frame = unit.root ? "State" : types.unique(unit.machine->name + "Frame");
        unit.points = unit.root ? "At" : types.unique(unit.machine->name + "At");
        for (const auto& variable : unit.machine->variables) {
            const bool own_variable = !unit.root && variable.scope != ir::VariableScope::required;
            unit.variable_fields.push_back(own_variable ? scope.unique(variable.name) : "");
        }
        for (const auto& clock : unit.machine->clocks) {
            const bool of_caller =
                !unit.root && clock.required && find_named(component_.root().machine->clocks, clock.name) != nullptr;
            const std::string name = (clock.entry_of.valid() ? "since_entry_" : "") + clock.name;
            unit.clock_fields.push_back(of_caller ? "" : scope.unique(name));
        }
        unit.clock_read.assign(unit.machine->clocks.size(), false);
    }

    void mark_clocks_read() {
        for (const Unit& unit : component_.units) {
            visit_expressions(*unit.machine, [&](const ir::Expr& expr) {
                const ir::ClockId clock = clock_of(*unit.machine, expr);
                if (!clock.valid()) return;
                const auto [owner, id] = component_.clock(unit, clock);
                component_.units[static_cast<std::size_t>(owner - component_.units.data())].clock_read[id.index] = true;
            });
        }
    }

    const ir::System& system_;
    const ir::Instantiation& inst_;
    Diagnostics& diagnostics_;
    std::size_t errors_before_;
    Context context_;
    Component component_;
    std::vector<ir::MachineId> open_;
};

}  // namespace

std::optional<Component> resolve(const ir::System& system, const ir::Instantiation& inst, const ir::ComponentRef& ref,
                                 Diagnostics& diagnostics) {
    return Resolver(system, inst, diagnostics).resolve(ref);
}

}  // namespace robochart::cpp_emit
