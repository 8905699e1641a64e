// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/resolve_component.hpp"

#include <algorithm>
#include <cassert>

#include "cpp_emit/plan/connection_resolution.hpp"
#include "cpp_emit/plan/feature_analysis.hpp"
#include "cpp_emit/plan/liveness.hpp"
#include "cpp_emit/plan/register_variables.hpp"
#include "cpp_emit/plan/register_wiring.hpp"
#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"
#include "semantics/evaluate/carrier.hpp"
#include "semantics/evaluate/evaluate.hpp"
#include "semantics/evaluate/preconditions.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/query.hpp"

namespace robochart::cpp_emit {

namespace {

using diagnostics::Diagnostics;

/// Returns the element with this name, or null if there is none.
template <class Item>
const Item* find_named(const std::vector<Item>& items, const std::string& name) {
    const auto found = std::ranges::find_if(items, [&](const Item& item) { return item.name == name; });
    return found == items.end() ? nullptr : &*found;
}

/// The context of a part; empty for a single machine.
struct Context {
    const ir::Module* module = nullptr;
    const ir::Controller* controller = nullptr;
};

class Resolver {
public:
    Resolver(const ir::System& system, const ir::Instantiation& inst, Diagnostics& diagnostics)
        : system_(system), inst_(inst), diagnostics_(diagnostics), errors_before_(diagnostics.error_count()) {}

    std::optional<Component> resolve_reference(const ir::ComponentRef& ref) {
        component_.ref = ref;
        if (!find_parts(ref)) return std::nullopt;
        for (std::size_t part = 0; part < component_.parts.size(); ++part) {
            part_ = part;
            (void)add_unit(roots_[part], true);
            component_.parts[part].root = component_.units.size() - 1;
        }
        if (diagnostics_.error_count() != errors_before_) return std::nullopt;
        assert(open_.empty() && component_.unit_places.size() == component_.units.size());
        assert(roots_.size() == component_.parts.size() && contexts_.size() == component_.parts.size());
        number_transitions();
        if (component_.robosim) {
            wire_registers(component_, module_, contexts(), diagnostics_);
        } else {
            wire_component(component_, system_, module_, contexts(), diagnostics_);
        }
        collect_variables();
        if (component_.robosim && contexts_.front() != nullptr)
            connect_variables(component_, system_, inst_, module_, contexts(), diagnostics_);
        if (!component_.robosim) find_local_variables(component_, system_);
        collect_calls();
        collect_functions();
        collect_types();
        collect_uses(component_, system_);
        name_everything();
        if (diagnostics_.error_count() != errors_before_) return std::nullopt;
        return std::move(component_);
    }

private:
    template <class Element>
    void describe_component(const Element& element, std::string kind) {
        component_.name = element.name;
        component_.cpp_name = to_identifier(element.name);
        component_.package = element.package;
        component_.origin = element.origin;
        component_.kind = std::move(kind);
    }

    bool find_parts(const ir::ComponentRef& ref) {
        switch (ref.kind) {
            case ir::ComponentKind::machine:
                return machine_alone(ref);
            case ir::ComponentKind::controller:
                return in_controller(ref);
            case ir::ComponentKind::module:
                return in_module(ref);
            case ir::ComponentKind::operation:
            case ir::ComponentKind::simulation:
            case ir::ComponentKind::process:
                break;
        }
        diagnostics_.report(rules::no_component, {}, {ref.path, "it is neither a machine, a controller nor a module"});
        return false;
    }

    bool is_defined(std::size_t size, const ir::ComponentRef& ref) {
        if (ref.definition < size) return true;
        diagnostics_.report(rules::no_component, {}, {ref.path, "the model has no such component"});
        return false;
    }

    bool machine_alone(const ir::ComponentRef& ref) {
        if (!is_defined(system_.machines.size(), ref)) return false;
        const ir::Machine& machine = system_.machines[ref.definition];
        if (machine.kind == ir::MachineKind::operation) {
            diagnostics_.report(rules::no_component, machine.origin.span, {machine.name, "it is an operation"});
            return false;
        }
        describe_component(machine, "state machine");
        component_.robosim = machine.robosim;
        component_.parts.emplace_back();
        roots_.push_back({ref.definition});
        contexts_.push_back(nullptr);
        return true;
    }

    bool in_controller(const ir::ComponentRef& ref) {
        if (!is_defined(system_.controllers.size(), ref)) return false;
        describe_component(system_.controllers[ref.definition], "controller");
        component_.robosim = system_.controllers[ref.definition].robosim;
        add_parts(system_.controllers[ref.definition], 0, "");
        return has_parts();
    }

    bool in_module(const ir::ComponentRef& ref) {
        if (!is_defined(system_.modules.size(), ref)) return false;
        module_ = &system_.modules[ref.definition];
        component_.robosim = module_->robosim;
        describe_component(*module_, "module");
        for (std::size_t i = 0; i < module_->controllers.size(); ++i)
            add_parts(system_.controller(module_->controllers[i].controller), i, module_->controllers[i].name + "::");
        return has_parts();
    }

    void add_parts(const ir::Controller& controller, std::size_t index, const std::string& prefix) {
        for (std::size_t i = 0; i < controller.machines.size(); ++i) {
            Part& part = component_.parts.emplace_back();
            part.name = prefix + controller.machines[i].name;
            part.controller = index;
            part.machine = i;
            roots_.push_back(controller.machines[i].machine);
            contexts_.push_back(&controller);
        }
    }

    bool has_parts() {
        if (!component_.parts.empty()) return true;
        diagnostics_.report(rules::no_component, component_.origin.span, {component_.name, "it has no state machine"});
        return false;
    }

    /// Returns the context of the current part.
    Context context() const { return {module_, contexts_[part_]}; }
    const std::vector<const ir::Controller*>& contexts() const { return contexts_; }

    /// Returns the operation's definition in this context (semantics 3.8); invalid for a single machine.
    ir::MachineId find_definition(const ir::OperationSignature& signature) const {
        const ir::Controller* const controller = context().controller;
        if (signature.output) return {};  // RoboSim: an operation of the platform
        return controller == nullptr ? ir::MachineId{} : ir::definition_in(system_, *controller, signature);
    }

    /// Returns the name under which a machine or operation runs in the controller.
    std::string part_name(ir::MachineId id, bool root) const {
        if (context().controller == nullptr) return {};
        const ir::Controller& controller = *context().controller;
        if (root) return controller.machines[component_.parts[part_].machine].name;
        const auto found = std::ranges::find(controller.definitions, id);
        assert(found != controller.definitions.end());
        return controller.definition_names[static_cast<std::size_t>(found - controller.definitions.begin())];
    }

    /// Returns the initial value of a variable in this context, or the default of its type (semantics 3.6).
    ir::Value initial_value(const ir::Machine& machine, const std::vector<ir::Value>& constants, ir::TypeId type,
                            const ir::ExprPtr& initial) const {
        const ir::Value otherwise = ir::default_value(system_, inst_, type);
        if (!initial) return otherwise;
        ir::Environment environment;
        environment.constants = constants;
        try {
            return ir::evaluate_expression(system_, inst_, &machine, environment, *initial);
        } catch (const ir::EvaluationFault& fault) {
            diagnostics_.report(rules::unsupported_expr, fault.span,
                                {"an initial value (" + std::string(fault.what()) + ")", machine.name});
        } catch (const std::length_error& error) {
            diagnostics_.report(rules::unsupported_expr, initial->span,
                                {"an initial value (" + std::string(error.what()) + ")", machine.name});
        }
        return otherwise;
    }

    /// Adds the operations that the machine calls, then the machine. Returns the machine's number. `open_` contains the
    /// calls in progress.
    std::size_t add_unit(ir::MachineId id, bool root) {
        const ir::Machine& machine = system_.machine(id);
        if (std::ranges::any_of(open_, [&](const Unit& unit) { return unit.id == id; })) {
            diagnostics_.report(rules::recursion, machine.origin.span, {machine.name});
            return 0;
        }
        if (root && !machine.initial.is_valid()) {
            diagnostics_.report(rules::no_body, machine.origin.span, {machine.name});
            return 0;
        }
        Unit unit;
        unit.id = id;
        unit.number = component_.unit_places.size();
        unit.part = part_;
        unit.machine = &machine;
        unit.root = root;
        find_owners(unit);
        assert(unit.variable_owners.size() == machine.variables.size());
        assert(unit.clock_owners.size() == machine.clocks.size());
        const auto& units = component_.units;
        const auto known = std::ranges::find_if(units, [&](const Unit& other) { return are_alike(other, unit); });
        if (known != units.end()) return known->number;
        component_.unit_places.push_back(units.size());  // set below
        unit.definitions.resize(machine.operations.size());
        unit.callees.resize(machine.operations.size());
        unit.constants =
            ir::constant_values(system_, inst_, context().module, context().controller, part_name(id, root), machine);
        for (const auto& variable : machine.variables) {
            const bool shared = variable.scope == ir::VariableScope::required;
            unit.initials.push_back(
                initial_value(machine, unit.constants, variable.type, shared ? nullptr : variable.initial));
        }
        assert(unit.initials.size() == machine.variables.size() && unit.callees.size() == machine.operations.size());
        open_.push_back(std::move(unit));
        std::set<ir::OperationId> followed;
        visit_statements(machine, [&](const ir::Stmt& stmt) {
            if (stmt.kind != ir::StmtKind::call || !followed.insert(stmt.operation).second) return;
            const ir::MachineId target = find_definition(machine.operations[stmt.operation.index]);
            open_.back().definitions[stmt.operation.index] = target;
            if (!target.is_valid()) return;
            const std::size_t callee = add_unit(target, false);
            open_.back().callees[stmt.operation.index] = callee;
        });
        unit = std::move(open_.back());
        open_.pop_back();
        const std::size_t number = unit.number;
        component_.unit_places[number] = component_.units.size();
        component_.units.push_back(std::move(unit));
        return number;
    }

    /// Returns whether both units are the same operation, and their required names denote the same elements.
    static bool are_alike(const Unit& known, const Unit& unit) {
        const auto same = [&](const std::vector<Owner>& left, const std::vector<Owner>& right) {
            const auto own = [](const Unit& of, const Owner& owner) { return owner.unit == of.number; };
            return std::ranges::equal(left, right, [&](const Owner& a, const Owner& b) {
                return own(known, a) ? own(unit, b) && a.place == b.place : a == b;
            });
        };
        return known.part == unit.part && known.id == unit.id && same(known.variable_owners, unit.variable_owners) &&
               same(known.clock_owners, unit.clock_owners);
    }

    /// Finds the owners of the unit's elements. A required element, or a register of RoboSim, is the caller's element
    /// with that name. The caller may require the element from its own caller (semantics 3.8). Any other element
    /// belongs to the unit.
    void find_owners(Unit& unit) {
        const ir::Machine& machine = *unit.machine;
        const Unit* const caller = unit.root ? nullptr : &open_.back();
        for (std::uint32_t place = 0; place < machine.variables.size(); ++place) {
            const ir::VariableScope scope = machine.variables[place].scope;
            const bool required = scope == ir::VariableScope::required || scope == ir::VariableScope::reg;
            const ir::Variable* const found =
                caller == nullptr || !required ? nullptr
                                               : find_named(caller->machine->variables, machine.variables[place].name);
            if (caller != nullptr && required && found == nullptr)
                report_missing(machine, "variable", machine.variables[place].name, machine.variables[place].origin);
            unit.variable_owners.push_back(
                found == nullptr
                    ? Owner{unit.number, place}
                    : caller->variable_owners[static_cast<std::size_t>(found - caller->machine->variables.data())]);
        }
        for (std::uint32_t place = 0; place < machine.clocks.size(); ++place) {
            const ir::Clock& clock = machine.clocks[place];
            const ir::Clock* const found =
                caller == nullptr || !clock.required ? nullptr : find_clock(*caller->machine, clock.name);
            if (caller != nullptr && clock.required && found == nullptr)
                report_missing(machine, "clock", clock.name, clock.origin);
            unit.clock_owners.push_back(
                found == nullptr
                    ? Owner{unit.number, place}
                    : caller->clock_owners[static_cast<std::size_t>(found - caller->machine->clocks.data())]);
        }
        std::set<std::size_t> lenders;
        for (const auto* owners : {&unit.variable_owners, &unit.clock_owners})
            for (const Owner& owner : *owners)
                if (owner.unit != unit.number && !open_.empty() && owner.unit != open_.front().number)
                    lenders.insert(owner.unit);
        unit.lenders.assign(lenders.begin(), lenders.end());
    }

    void number_transitions() {
        std::map<std::pair<std::size_t, ir::MachineId>, std::size_t> first;
        std::size_t next = 0;
        for (Unit& unit : component_.units) {
            const auto [known, added] = first.try_emplace({unit.part, unit.id}, next);
            unit.first_transition = known->second;
            assert(unit.first_transition <= next);  // an operation has the same numbers for all callers
            if (added) next += unit.machine->transitions.size();
        }
    }

    /// Returns the declared or required clock with this name. Clocks of sinceEntry are ignored.
    static const ir::Clock* find_clock(const ir::Machine& machine, const std::string& name) {
        const auto& clocks = machine.clocks;
        const auto found = std::ranges::find_if(
            clocks, [&](const ir::Clock& clock) { return clock.name == name && !clock.entry_of.is_valid(); });
        return found == clocks.end() ? nullptr : &*found;
    }

    /// Reports an element that the operation's caller does not have. The rules STM8 and STM10 of the language report
    /// this earlier.
    void report_missing(const ir::Machine& operation, const char* what, const std::string& name,
                        const ir::Origin& origin) {
        diagnostics_.report(
            rules::unsupported_expr, origin.span,
            {std::string("the ") + what + " '" + name + "', which its caller does not have,", operation.name});
    }

    // ---- variables

    void collect_variables() {
        for (std::size_t part = 0; part < component_.parts.size(); ++part) {
            part_ = part;
            each_unit([&](const Unit& unit) {
                for (std::size_t place = 0; place < unit.machine->variables.size(); ++place) {
                    const ir::Variable& variable = unit.machine->variables[place];
                    const bool of_operation = !component_.unit_at(unit.variable_owners[place].unit).root;
                    const ir::VariableId id{static_cast<std::uint32_t>(place)};
                    if (ir::event_register(*unit.machine, id) != nullptr) continue;  // a member of Inputs
                    if (!of_operation && component_.parts[part].variables.count(variable.name) == 0)
                        add_variable(unit, variable);
                }
                mark_read(unit);
            });
        }
    }

    /// Returns whether some machine assigns a required variable of this name.
    [[nodiscard]] bool is_written(const std::string& name) const {
        bool result = false;
        for (const Unit& unit : component_.units) {
            const auto is = [&](ir::VariableId id) {
                if (!id.is_valid()) return false;
                const ir::Variable& variable = unit.machine->variables[id.index];
                return variable.scope == ir::VariableScope::required && variable.name == name &&
                       component_.unit_at(unit.variable_owners[id.index].unit).root;
            };
            visit_statements(*unit.machine, [&](const ir::Stmt& stmt) {
                result = result || (stmt.kind == ir::StmtKind::assign && is(stmt.variable));
            });
            visit_communications(*unit.machine, [&](const ir::Communication& communication, bool) {
                result = result || is(communication.variable);
            });
        }
        return result;
    }

    /// Visits the part's units, callers before callees.
    template <class Visit>
    void each_unit(const Visit& visit) const {
        for (auto unit = component_.units.rbegin(); unit != component_.units.rend(); ++unit)
            if (unit->part == part_) visit(*unit);
    }

    void add_variable(const Unit& unit, const ir::Variable& variable) {
        StoredVariable entry;
        entry.variable = &variable;
        entry.shared = variable.scope == ir::VariableScope::required;
        entry.initial = unit.initials[static_cast<std::size_t>(&variable - unit.machine->variables.data())];
        const ir::ExprPtr declared = entry.shared ? declaring_level(entry) : nullptr;
        if (variable.scope == ir::VariableScope::reg) {
            const auto is_read = [&](const ir::Input& input) { return "$" + input.name == variable.name; };
            entry.visible = variable.output;
            entry.external = std::ranges::any_of(unit.machine->inputs, is_read);
        }
        if (declared) entry.initial = initial_value(*unit.machine, {}, variable.type, declared);
        auto& variables = component_.variables;
        const auto same = [&](const StoredVariable& other) {
            return other.shared && other.level == entry.level && other.variable->name == variable.name;
        };
        auto known = entry.shared ? std::ranges::find_if(variables, same) : variables.end();
        if (known != variables.end() && entry.external && is_written(variable.name)) {
            entry.copy = true;
            known = variables.end();
        }
        component_.parts[part_].variables[variable.name] = static_cast<std::size_t>(known - variables.begin());
        if (known != variables.end()) return;
        if (!entry.shared && component_.is_composed()) entry.home = part_;
        variables.push_back(std::move(entry));
    }

    /// Finds the level that declares a shared variable; this decides who sees the variable (semantics 3.7). Returns the
    /// initial value, if any, that this level passes to the machines at the start.
    ir::ExprPtr declaring_level(StoredVariable& entry) const {
        const std::string& name = entry.variable->name;
        if (context().controller == nullptr) {
            entry.visible = entry.external = true;
            return nullptr;
        }
        const ir::Variable* at_controller = find_named(context().controller->variables, name);
        // The controller's memory does not propagate its initial value, so copies start with the type's default.
        if (at_controller != nullptr && at_controller->scope == ir::VariableScope::local) {
            entry.level = module_ == nullptr ? static_cast<const void*>(context().controller)
                                             : &module_->controllers[component_.parts[part_].controller];
            entry.memories = 1;
            return nullptr;
        }
        if (context().module == nullptr) {
            entry.visible = entry.external = true;
            return nullptr;
        }
        entry.level = module_;
        entry.memories = 2;  // the memory of the module, then that of the controller
        const ir::Variable* at_platform = find_named(module_->platform.variables, name);
        if (at_platform == nullptr) return nullptr;
        entry.visible = at_platform->scope == ir::VariableScope::required;
        return at_platform->initial;
    }

    void mark_read(const Unit& unit) {
        ir::visit_reads(*unit.machine, [&](ir::VariableId variable) { mark_read(unit, variable); });
        // The guard of a watched deadline reads the variable's value, not the incoming value (semantics 3.10).
        for (const ir::Transition& transition : unit.machine->transitions)
            if (transition.deadline && transition.trigger && transition.trigger->variable.is_valid())
                visit(transition.guard, [&](const ir::Expr& expr) {
                    if (expr.kind == ir::ExprKind::trigger_value) mark_read(unit, transition.trigger->variable);
                });
    }

    void mark_read(const Unit& unit, ir::VariableId id) {
        if (!component_.unit_at(unit.variable_owners[id.index].unit).root) return;
        if (ir::event_register(*unit.machine, id) != nullptr) return;
        assert(id.index < unit.machine->variables.size());
        const std::string& name = unit.machine->variables[id.index].name;
        component_.variables[component_.parts[part_].variables.at(name)].read = true;
    }

    // ---- calls and names

    void collect_calls() {
        for (auto unit = component_.units.rbegin(); unit != component_.units.rend(); ++unit) {
            visit_statements(*unit->machine, [&](const ir::Stmt& stmt) {
                if (stmt.kind == ir::StmtKind::call) add_call(*unit, stmt.operation);
            });
        }
    }

    void collect_functions() {
        for (const Unit& unit : component_.units)
            visit_expressions(*unit.machine, [&](const ir::Expr& expr) { add_function(unit.constants, expr); });
    }

    /// Adds a called function. If its precondition is tested, also adds the functions that the precondition calls.
    void add_function(const std::vector<ir::Value>& constants, const ir::Expr& expr) {
        if (expr.kind != ir::ExprKind::call && expr.kind != ir::ExprKind::function_value) return;
        auto& functions = component_.functions;
        const auto same = [&](const FunctionHook& hook) { return hook.id == expr.function; };
        auto found = std::ranges::find_if(functions, same);
        if (found == functions.end()) found = functions.insert(found, {expr.function, "", false, ""});
        if (found->guarded || !ir::precondition_can_fail(system_, inst_, constants, expr)) return;
        found->guarded = true;
        for (const ir::ExprPtr& condition : system_.functions[expr.function.index].preconditions)
            visit(condition, [&](const ir::Expr& part) { add_function({}, part); });
    }

    void add_function_types(const FunctionHook& hook) {
        const ir::Function& function = system_.functions[hook.id.index];
        for (const ir::TypeId type : function.parameters) add_type(type);
        add_type(function.result);
    }

    void add_call(const Unit& unit, ir::OperationId id) {
        const ir::OperationSignature& signature = unit.machine->operations[id.index];
        const ir::MachineId definition = unit.definitions[id.index];
        const auto add = [&](auto& calls, auto call, const auto& same) {
            if (std::ranges::none_of(calls, same)) calls.push_back(std::move(call));
        };
        if (definition.is_valid()) {
            add(component_.modelled, ModelledCall{&signature, definition, {}},
                [&](const ModelledCall& call) { return call.definition == definition; });
        } else {
            add(component_.calls, PlatformCall{&signature, {}},
                [&](const PlatformCall& call) { return call.signature->name == signature.name; });
        }
    }

    void collect_types() {
        for (const auto& part : component_.parts)
            for (const auto& event : part.events)
                if (event.type) add_type(*event.type);
        for (const auto& function : component_.functions) add_function_types(function);
        const auto add_types = [&](const ir::Expr& expr) {
            add_type(expr.type);
            for (const ir::TypeId bound : expr.bound_types)
                if (bound.is_valid()) add_type(bound);
        };
        for (const auto& call : component_.calls)
            for (const ir::TypeId type : call.signature->parameters) add_type(type);
        for (const auto& unit : component_.units) {
            for (const auto& variable : unit.machine->variables) add_type(variable.type);
            visit_expressions(*unit.machine, add_types);
        }
        visit_tested_preconditions(component_, system_, add_types);
    }

    /// Adds a type after the types of its parts. Recursive types are rejected later (unsupported.cpp).
    void add_type(ir::TypeId id) {
        auto& types = component_.enumerations;
        if (std::ranges::find(seen_types_, id) != seen_types_.end()) return;
        seen_types_.push_back(id);
        const ir::Type& type = system_.type(id);
        for (const ir::TypeId part : type.args) add_type(part);
        for (const auto& arguments : type.literal_args)
            for (const ir::TypeId part : arguments) add_type(part);
        const auto same = [&](ir::TypeId other) { return declared_name(system_.type(other)) == declared_name(type); };
        if (is_declared(type) && is_supported(system_, id) && std::ranges::none_of(types, same)) types.push_back(id);
    }

    void name_everything() {
        NameScope platform(std::set<std::string>{"Log", "log_", "Platform", "machine", "choose", "taken", "pick", "std",
                                                 "Traced", "tracer_", "robochart", "core", "Real", "Nat", "Int",
                                                 "platform_", "Types", "Inputs", "State"});
        for (auto& call : component_.calls) call.method = platform.unique_name(call.signature->name);
        for (auto& call : component_.modelled) call.method = platform.unique_name("replaces_" + call.signature->name);
        NameScope preconditions;
        for (auto& function : component_.functions) {
            function.method = platform.unique_name(system_.functions[function.id.index].name);
            if (function.guarded) function.precondition = preconditions.unique_name("pre_" + function.method);
        }
        std::set<std::string> taken = never_members(system_, component_);
        for (const Unit& unit : component_.units) take_thread_members(unit, taken);
        NameScope inputs(taken);
        NameScope state(taken);
        if (component_.is_composed())
            for (Part& part : component_.parts) part.tag = state.unique_name(part.name);
        for (auto& event : component_.events) {
            if (event.received) event.input = inputs.unique_name(event.model_name);
            if (event.received) event.raised = state.unique_name("raised_" + event.input);
            if (event.sent) event.output = platform.unique_name("send_" + event.model_name);
        }
        for (auto& buffer : component_.buffers) buffer.field = state.unique_name("buffer_" + buffer.name);
        std::vector<NameScope> frames(component_.parts.size(), NameScope(taken));
        NameScope writers;
        taken_ = taken;
        for (auto& entry : component_.variables) name_variable(entry, state, frames, inputs, platform, writers);
        for (auto& entry : component_.variables)
            if (const StoredVariable* const memory = component_.memory_of(entry)) entry.output = memory->output;
        for (std::size_t index = 0; index < component_.variables.size(); ++index) find_holders(index, state, writers);
        NameScope types = core_type_scope(component_);
        for (const ir::TypeId type : component_.enumerations) types.reserve_name(declared_name(system_.type(type)));
        for (auto& unit : component_.units)
            name_unit(unit, component_.is_composed() ? frames[unit.part] : state, types);
        name_channels();
        mark_clocks_read();
    }

    /// Reserves the members that the machine's threads may have for its states (machine_code.cpp).
    static void take_thread_members(const Unit& unit, std::set<std::string>& taken) {
        for (const ir::Node& node : unit.machine->nodes)
            for (const char* prefix : {"during_", "entering_", "history_", "wait_"})
                taken.insert(prefix + to_identifier(node.path));
    }

    void name_variable(StoredVariable& entry, NameScope& state, std::vector<NameScope>& frames, NameScope& inputs,
                       NameScope& platform, NameScope& writers) {
        const std::string name = entry.name();
        const bool in_part = entry.home != no_part;
        const std::string tag = in_part ? component_.parts[entry.home].tag + "_" : "";
        if (entry.copy && !component_.robosim) return name_copy(entry, state, writers);
        if (entry.local) {
            entry.field = writers.unique_name("local_" + tag + name);
        } else if (entry.has_member()) {
            entry.field = in_part ? frames[entry.home].unique_name(name) : state.unique_name(name);
            entry.path = in_part ? component_.parts[entry.home].tag + "." + entry.field : entry.field;
        }
        if (entry.external && !entry.copy && (component_.robosim || some_copy_read(name)))
            entry.input = inputs.unique_name("external_" + name);
        if (!entry.visible) return;
        if (!entry.copy) entry.output = platform.unique_name("set_" + name);
        const bool of_machine = !component_.robosim || entry.variable->scope == ir::VariableScope::reg;
        if (of_machine) entry.writer = writers.unique_name("write_" + tag + name);
    }

    /// Finds the machines that may hold up writes of the variable. If a machine has one thread and is the only writer
    /// of the variable, it does not wait for itself.
    void find_holders(std::size_t index, NameScope& state, NameScope& writers) {
        StoredVariable& entry = component_.variables[index];
        if (!entry.shared || entry.memories == 0) return;
        for (std::size_t place = 0; place < component_.parts.size(); ++place) {
            const Part& part = component_.parts[place];
            const auto required = part.variables.find(entry.variable->name);
            if (required == part.variables.end() || required->second != index || !waits_with_deadline(place)) continue;
            if (!component_.is_composed() && !has_during(component_.root_unit(place))) continue;
            entry.holders.push_back({place, state.unique_name("held_" + part.tag + "_" + entry.variable->name)});
        }
        if (entry.holders.empty()) return;
        entry.held_up = writers.unique_name("held_up_" + entry.variable->name);
        entry.propagate = writers.unique_name("propagate_" + entry.variable->name);
    }

    static bool has_during(const Unit& unit) {
        return std::ranges::any_of(unit.machine->nodes, [](const ir::Node& node) { return node.during != nullptr; });
    }

    /// Returns whether a program of the part communicates with a deadline and may have to wait.
    [[nodiscard]] bool waits_with_deadline(std::size_t part) const {
        bool found = false;
        for (const Unit& unit : component_.units)
            if (unit.part == part)
                ir::visit_statements(*unit.machine, [&](const ir::Stmt& stmt) {
                    if (stmt.kind != ir::StmtKind::deadline) return;
                    const ir::Stmt& inside = *stmt.body.at(0);
                    if (inside.kind != ir::StmtKind::communicate) return;
                    const EventUse& use = component_.find_event(unit, inside.communication.event);
                    const bool received = inside.communication.kind == ir::CommKind::input;
                    found = found || (received ? !use.is_spontaneous() : use.waits_to_send());
                });
        return found;
    }

    /// Names another machine's copy of a variable whose writes the environment propagates.
    void name_copy(StoredVariable& entry, NameScope& state, NameScope& writers) {
        const std::string& name = entry.variable->name;
        const auto first = std::ranges::find_if(
            component_.variables, [&](const StoredVariable& other) { return is_propagated(other, name); });
        assert(first != component_.variables.end());
        if (entry.has_member()) entry.field = entry.path = state.unique_name(name);
        entry.input = first->input;
        entry.output = first->output;
        entry.writer = writers.unique_name("write_" + name);
    }

    static bool is_propagated(const StoredVariable& entry, const std::string& name) {
        return entry.external && entry.variable->name == name;
    }
    [[nodiscard]] bool some_copy_read(const std::string& name) const {
        return std::ranges::any_of(component_.variables, [&](const StoredVariable& entry) {
            return is_propagated(entry, name) && entry.read;
        });
    }

    void name_channels() {
        NameScope scope;
        for (Part& part : component_.parts)
            for (EventUse& use : part.events)
                if (use.sent && !use.peers.empty()) use.channel = scope.unique_name(part.name + "_" + use.name);
    }

    void name_unit(Unit& unit, NameScope& fields, NameScope& types) {
        NameScope own(taken_);
        NameScope& scope = unit.root ? fields : own;
        const std::string& tag = component_.part_of(unit).tag;
        const bool alone = tag.empty();
        const std::string tag_prefix = alone ? "" : tag + "_";
        unit.prefix = unit.root ? tag_prefix : to_identifier(tag_prefix + unit.machine->name);
        if (unit.root && alone) {
            unit.frame = "State";
            unit.points = "At";
        } else {
            unit.frame = types.unique_name(unit.root ? tag + "State" : unit.prefix + "Frame");
            unit.points = types.unique_name(unit.root ? tag + "At" : unit.prefix + "At");
        }
        for (std::size_t place = 0; place < unit.machine->variables.size(); ++place) {
            const bool has_field = !unit.root && unit.variable_owners[place].unit == unit.number;
            unit.variable_fields.push_back(has_field ? scope.unique_name(unit.machine->variables[place].name) : "");
        }
        for (std::size_t place = 0; place < unit.machine->clocks.size(); ++place) {
            const ir::Clock& clock = unit.machine->clocks[place];
            const std::string name = (clock.entry_of.is_valid() ? "since_entry_" : "") + clock.name;
            unit.clock_fields.push_back(unit.clock_owners[place].unit == unit.number ? scope.unique_name(name) : "");
        }
        assert(unit.variable_fields.size() == unit.machine->variables.size());
        assert(unit.clock_fields.size() == unit.machine->clocks.size());
        unit.clock_read.assign(unit.machine->clocks.size(), false);
    }

    void mark_clocks_read() {
        for (const Unit& unit : component_.units) {
            visit_expressions(*unit.machine, [&](const ir::Expr& expr) {
                const ir::ClockId clock = clock_of(*unit.machine, expr);
                if (!clock.is_valid()) return;
                const auto [owner, id] = component_.clock_owner(unit, clock);
                component_.units[component_.unit_places[owner->number]].clock_read[id.index] = true;
            });
        }
    }

    const ir::System& system_;
    const ir::Instantiation& inst_;
    Diagnostics& diagnostics_;
    std::size_t errors_before_;
    Component component_;
    const ir::Module* module_ = nullptr;
    std::vector<const ir::Controller*> contexts_;  ///< by part
    std::vector<ir::MachineId> roots_;             ///< by part
    std::vector<ir::TypeId> seen_types_;
    std::set<std::string> taken_;  ///< names that members must not have
    std::size_t part_ = 0;         ///< the current part
    std::vector<Unit> open_;       ///< the calls in progress, the part's machine first
};

}  // namespace

std::optional<Component> resolve_component(const ir::System& system, const ir::Instantiation& inst,
                                           const ir::ComponentRef& ref, Diagnostics& diagnostics) {
    return Resolver(system, inst, diagnostics).resolve_reference(ref);
}

}  // namespace robochart::cpp_emit
