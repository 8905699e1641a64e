// SPDX-License-Identifier: Apache-2.0
// Checks the rules about the elements that components require and that their contexts must provide (language reference
// 2: C3, C4, M2, STM8 to STM10). Variables match by name and compatible type.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "frontend/checks/checks.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/expression_visitor.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/types.hpp"

namespace robochart::frontend {

namespace {

/// Declarations indexed by name. Declarations with the same name stay in textual order. Models have hundreds of
/// operations and of components that require them, so a linear search for a name would be too slow.
template <class Item>
class Named {
public:
    Named() = default;
    explicit Named(const std::vector<const Item*>& items) {
        for (const Item* item : items) add(*item);
    }
    void add(const Item& item) { items_.emplace(item.name, &item); }
    template <class Fits>
    [[nodiscard]] bool any_fits(std::string_view name, Fits fits) const {
        const auto [begin, end] = items_.equal_range(name);
        return std::any_of(begin, end, [&](const auto& entry) { return fits(*entry.second); });
    }
    template <class Use>
    void for_each_named(std::string_view name, Use use) const {
        const auto [begin, end] = items_.equal_range(name);
        for (auto at = begin; at != end; ++at) use(*at->second);
    }
    /// Returns the first declaration of this name, or null if there is none.
    [[nodiscard]] const Item* find_first(std::string_view name) const {
        const auto found = items_.lower_bound(name);
        return found == items_.end() || found->first != name ? nullptr : found->second;
    }

private:
    std::multimap<std::string_view, const Item*> items_;
};

using Variables = Named<Variable>;

/// True if a provided variable has the same name, and its type accepts the values that the component writes:
/// compat(required, provided).
bool provides_variable(const Variables& provided, const Variable& required, bool same_kind) {
    return provided.any_fits(required.name, [&](const Variable& v) {
        return (!same_kind || v.kind == required.kind) && is_compatible(required.type, v.type);
    });
}

using Missing = std::vector<const Declaration*>;

std::string join_missing(const Missing& missing) {
    std::string names;
    for (const Declaration* declaration : missing) names += (names.empty() ? "`" : ", `") + declaration->name + "`";
    return names;
}
std::string plural_suffix(const Missing& missing) {
    return missing.size() == 1 ? "" : "s";
}

/// Adds notes that point at the missing declaration, and at declarations of the same name that do not fit.
void add_notes(diagnostics::Diagnostic& finding, const Missing& missing, const Variables& provided = {}) {
    for (const Declaration* declaration : missing) {
        finding.notes.push_back({declaration->name_span, fmt::format("`{}` is required here", declaration->name)});
        provided.for_each_named(declaration->name, [&](const Variable& other) {
            finding.notes.push_back({other.name_span, fmt::format("this {} has the name, but does not fit: {}",
                                                                  to_text(other.kind), to_string(other.type))});
        });
    }
}

Missing missing_variables(const std::vector<const Variable*>& required, const Variables& provided,
                          bool same_kind = false) {
    Missing missing;
    for (const Variable* variable : required)
        if (!provides_variable(provided, *variable, same_kind)) missing.push_back(variable);
    return missing;
}

/// True if the lists have equal lengths and compatible parameters at each position. The names may differ.
bool same_parameters(const std::vector<VariablePtr>& a, const std::vector<VariablePtr>& b) {
    return std::ranges::equal(a, b, [](const VariablePtr& x, const VariablePtr& y) {
        return is_compatible(x->type, y->type) || is_compatible(y->type, x->type);
    });
}

/// The definitions and signatures of operations in a controller.
struct Offer {
    Named<Machine> definitions;
    Named<OperationSignature> signatures;

    [[nodiscard]] bool offers_operation(const OperationSignature& required) const {
        const auto fits = [&](const auto& offered) { return same_parameters(offered.parameters, required.parameters); };
        return definitions.any_fits(required.name, fits) || signatures.any_fits(required.name, fits);
    }
};

Offer offer_of(const Component& controller) {
    Offer offer{Named(defined_operations(controller)), Named(required_operations(controller))};
    for (const auto& signature : controller.signatures) offer.signatures.add(*signature);
    return offer;
}

Missing missing_operations(const Context& part, const Offer& offer) {
    Missing missing;
    for (const OperationSignature* signature : required_operations(part))
        if (!offer.offers_operation(*signature)) missing.push_back(signature);
    return missing;
}

// ---------------------------------------------------------------- calls

/// A controller, with the data that the checks of all its components share.
struct Surroundings {
    explicit Surroundings(const Component& component)
        : controller(component), offer(offer_of(component)), variables(visible_variables(component)) {}

    const Component& controller;
    const Offer offer;
    const Variables variables;
};

/// A machine or operation that calls or requires operations, with the component of the controller that runs it.
struct Caller {
    Caller(const Surroundings& around, const Declaration& part_of_it, const Machine& runs)
        : surroundings(around),
          controller(around.controller),
          part(part_of_it),
          machine(runs),
          variables(visible_variables(runs)),
          scope(scope_of(runs)) {}

    const Surroundings& surroundings;
    const Component& controller;
    const Declaration& part;
    const Machine& machine;
    const Variables variables;
    const Scope scope;

    /// Returns the controller's definition of a called operation, or null if the platform performs it.
    [[nodiscard]] const Machine* find_definition(std::string_view name) const {
        return surroundings.offer.definitions.find_first(name);
    }

    /// If the machine is defined elsewhere, adds a note at the reference to it.
    void add_context(diagnostics::Diagnostic& finding) const {
        if (part.kind == DeclKind::reference)
            finding.notes.push_back(
                {part.name_span, fmt::format("in controller `{}`, which runs `{}` through this reference",
                                             controller.name, machine.name)});
    }
};

/// True if neither event has a type, or if the values of the operation's event may be used as values of the caller's
/// event.
bool event_fits(const Event& inner, const Event& outer) {
    const bool typed = inner.type_expr != nullptr;
    return (outer.type_expr != nullptr) == typed && (!typed || is_compatible(inner.type, outer.type));
}

/// The members that an operation requires from its caller but that the caller does not have.
struct Lack {
    Missing variables;
    std::vector<const Event*> events;
    std::vector<const Clock*> clocks;
};

Lack lack_of(const Caller& caller, const Machine& operation) {
    Lack lack{missing_variables(required_variables(operation), caller.variables, true), {}, {}};
    const Scope& scope = caller.scope;
    for (const Event* event : visible_events(operation)) {
        const auto found = scope.events.find(event->name);
        if (found == scope.events.end() || !event_fits(*event, *found->second)) lack.events.push_back(event);
    }
    for (const InterfaceClause& clause : operation.interfaces) {
        const Context* interface = interface_of(clause);
        if (interface == nullptr || clause.use != InterfaceUse::requires_) continue;
        for (const auto& clock : interface->clocks)
            if (!scope.clocks.contains(clock->name)) lack.clocks.push_back(clock.get());
    }
    return lack;
}

/// Checks rules STM8 to STM10 and reports mistakes at the first call.
void check_call(const Caller& caller, const Stmt& call, const Machine& operation, Diagnostics& out) {
    const std::string& name = caller.machine.name;
    const Lack lack = lack_of(caller, operation);
    if (!lack.variables.empty()) {
        auto& finding = out.report(rules::stm8, call.span,
                                   {name, operation.name, plural_suffix(lack.variables), join_missing(lack.variables)});
        add_notes(finding, lack.variables, caller.variables);
        caller.add_context(finding);
    }
    const Scope& scope = caller.scope;
    for (const Event* event : lack.events) {
        const auto same = scope.events.find(event->name);
        const bool typed_otherwise = same != scope.events.end();
        auto& finding = out.report(rules::stm9, call.span,
                                   {operation.name, event->name, name, typed_otherwise ? " with this type" : ""});
        finding.notes.push_back({event->name_span, "the event of the operation"});
        if (typed_otherwise) finding.notes.push_back({same->second->name_span, fmt::format("the event of `{}`", name)});
        caller.add_context(finding);
    }
    for (const Clock* clock : lack.clocks) {
        auto& finding = out.report(rules::stm10, call.span, {operation.name, clock->name, name});
        finding.notes.push_back({clock->name_span, "the clock is declared here"});
        caller.add_context(finding);
    }
}

/// Checks an operation that is required but never called. The rules are those for a called operation, but mistakes are
/// less severe, because the operation is not used yet.
void check_required(const Caller& caller, const OperationSignature& signature, const Machine& operation,
                    Diagnostics& out) {
    const Lack lack = lack_of(caller, operation);
    Missing all = lack.variables;
    all.insert(all.end(), lack.events.begin(), lack.events.end());
    all.insert(all.end(), lack.clocks.begin(), lack.clocks.end());
    if (all.empty()) return;
    auto& finding = out.report(rules::stm8_required, caller.part.name_span,
                               {caller.machine.name, operation.name, join_missing(all)});
    finding.notes.push_back({signature.name_span, "the operation is required through this signature"});
}

void check_calls(const Caller& caller, Diagnostics& out) {
    if (has_unknown_interface(caller.machine)) return;
    std::set<std::string_view> seen;
    for_actions(caller.machine, [&](const Stmt& action) {
        walk_tree(action, [&](const Stmt& statement) {
            if (statement.kind != StmtKind::call || statement.declaration == nullptr) return;
            if (!seen.insert(statement.declaration->name).second) return;
            if (const Machine* defined = caller.find_definition(statement.declaration->name))
                check_call(caller, statement, *defined, out);
        });
    });
    for (const OperationSignature* signature : required_operations(caller.machine))
        if (const Machine* defined = caller.find_definition(signature->name);
            defined != nullptr && seen.insert(signature->name).second)
            check_required(caller, *signature, *defined, out);
}

// ---------------------------------------------------------------- controllers and modules

void check_part(const Caller& caller, bool first, Diagnostics& out) {
    const Machine& machine = caller.machine;
    const std::string& controller = caller.controller.name;
    const auto& visible = caller.surroundings.variables;
    const Missing variables = missing_variables(required_variables(machine), visible);
    if (!variables.empty())
        add_notes(out.report(rules::c3, caller.part.name_span,
                             {controller, plural_suffix(variables), machine.name, join_missing(variables)}),
                  variables, visible);
    const Missing operations = missing_operations(machine, caller.surroundings.offer);
    if (!operations.empty())
        add_notes(out.report(rules::c4, caller.part.name_span,
                             {controller, plural_suffix(operations), machine.name, join_missing(operations)}),
                  operations);
    if (first) check_calls(caller, out);
}

void check_operation(const Caller& caller, bool first, Diagnostics& out) {
    for (const OperationSignature* signature : required_operations(caller.machine))
        if (!caller.surroundings.offer.offers_operation(*signature))
            out.report(rules::c4_operation, caller.part.name_span,
                       {caller.machine.name, signature->name, caller.controller.name})
                .notes.push_back({signature->name_span, "it is required through this signature"});
    if (first) check_calls(caller, out);
}

void check_controller_provision(const Component& controller, Diagnostics& out) {
    if (has_unknown_interface(controller)) return;  // the offers of the controller are unknown
    const Surroundings surroundings(controller);
    std::set<const Machine*> seen;  // a machine has the same calls for every reference to it
    for (const Declaration* part : controller.order) {
        const auto* machine = follow_to<Machine>(part);
        if (machine == nullptr) continue;
        const bool first = seen.insert(machine).second;
        out.poll();
        const Caller caller(surroundings, *part, *machine);
        if (machine->kind == DeclKind::operation)
            check_operation(caller, first, out);
        else
            check_part(caller, first, out);
    }
}

void check_module_provision(const Component& module, Diagnostics& out) {
    const Context* platform = nullptr;
    std::size_t platforms = 0;
    for (const Declaration* part : module.order)
        if (const auto* found = follow_to<Context>(part); found != nullptr && found->kind == DeclKind::platform) {
            platform = found;
            ++platforms;
        }
    if (platforms != 1 || has_unknown_interface(*platform)) return;  // reported by M1 or as an unknown interface
    const Offer offer{{}, Named(provided_operations(*platform))};
    const Variables visible(offered_variables(*platform));
    for (const Declaration* part : module.order) {
        const auto* controller = follow_to<Component>(part);
        if (controller == nullptr || controller->kind != DeclKind::controller) continue;
        const Missing variables = missing_variables(required_variables(*controller), visible);
        if (!variables.empty())
            add_notes(out.report(rules::m2_variables, part->name_span,
                                 {module.name, plural_suffix(variables), controller->name, join_missing(variables)}),
                      variables, visible);
        const Missing operations = missing_operations(*controller, offer);
        if (!operations.empty())
            add_notes(out.report(rules::m2_operations, part->name_span,
                                 {module.name, plural_suffix(operations), controller->name, join_missing(operations)}),
                      operations);
    }
}

}  // namespace

void check_provision(const Component& component, Diagnostics& out) {
    if (component.kind == DeclKind::module)
        check_module_provision(component, out);
    else
        check_controller_provision(component, out);
}

}  // namespace robochart::frontend
