// Rules about what parts require and their surroundings provide (language reference 2: C3, C4, M2, STM8 to STM10).
// Variables match by name and compatible type.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "frontend/checks.hpp"
#include "frontend/print.hpp"
#include "frontend/rules.hpp"
#include "frontend/scopes.hpp"
#include "frontend/types.hpp"
#include "frontend/walk.hpp"

namespace robochart::frontend {

namespace {

/// Same name, and what is written by the side that requires it fits: compat(required, provided).
bool provides(const std::vector<const Variable*>& provided, const Variable& wanted, bool same_kind) {
    return std::any_of(provided.begin(), provided.end(), [&](const Variable* v) {
        return v->name == wanted.name && (!same_kind || v->kind == wanted.kind) && compatible(wanted.type, v->type);
    });
}

using Missing = std::vector<const Declaration*>;

std::string list(const Missing& missing) {
    std::string names;
    for (const Declaration* declaration : missing) names += (names.empty() ? "`" : ", `") + declaration->name + "`";
    return names;
}
std::string s(const Missing& missing) {
    return missing.size() == 1 ? "" : "s";
}

/// Points at what is required, and at what has the name but does not fit.
void add_notes(diagnostics::Diagnostic& finding, const Missing& missing,
               const std::vector<const Variable*>& provided = {}) {
    for (const Declaration* wanted : missing) {
        finding.notes.push_back({wanted->name_span, fmt::format("`{}` is required here", wanted->name)});
        for (const Variable* other : provided)
            if (other->name == wanted->name)
                finding.notes.push_back({other->name_span, fmt::format("this {} has the name but does not fit: {}",
                                                                       to_text(other->kind), to_string(other->type))});
    }
}

Missing missing_variables(const std::vector<const Variable*>& wanted, const std::vector<const Variable*>& provided,
                          bool same_kind = false) {
    Missing missing;
    for (const Variable* variable : wanted)
        if (!provides(provided, *variable, same_kind)) missing.push_back(variable);
    return missing;
}

/// Parameters that fit each other, one by one. Their names may differ.
bool same_parameters(const std::vector<VariablePtr>& a, const std::vector<VariablePtr>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const VariablePtr& x, const VariablePtr& y) {
        return compatible(x->type, y->type) || compatible(y->type, x->type);
    });
}

/// Operations on offer: definitions and signatures.
struct Offer {
    std::vector<const Machine*> definitions;
    std::vector<const OperationSignature*> signatures;

    [[nodiscard]] bool has(const OperationSignature& wanted) const {
        const auto fits = [&](const auto* offered) {
            return offered->name == wanted.name && same_parameters(offered->parameters, wanted.parameters);
        };
        return std::any_of(definitions.begin(), definitions.end(), fits) ||
               std::any_of(signatures.begin(), signatures.end(), fits);
    }
};

Offer offer_of(const Component& controller) {
    Offer offer{defined_operations(controller), required_operations(controller)};
    for (const auto& signature : controller.signatures) offer.signatures.push_back(signature.get());
    return offer;
}

Missing missing_operations(const Context& part, const Offer& offer) {
    Missing missing;
    for (const OperationSignature* wanted : required_operations(part))
        if (!offer.has(*wanted)) missing.push_back(wanted);
    return missing;
}

// ---------------------------------------------------------------- calls

/// The definition in this controller of an operation called; null if it is the platform's.
const Machine* definition(const Component& controller, std::string_view name) {
    for (const Machine* defined : defined_operations(controller))
        if (defined->name == name) return defined;
    return nullptr;
}

/// A machine or operation that calls or requires operations: the part of its controller that runs it.
struct Caller {
    const Component& controller;
    const Declaration& part;
    const Machine& machine;

    /// The machine may be defined elsewhere: says which reference brings it here.
    void add_context(diagnostics::Diagnostic& finding) const {
        if (part.kind == DeclKind::reference)
            finding.notes.push_back(
                {part.name_span, fmt::format("in controller `{}`, which runs `{}` through this reference",
                                             controller.name, machine.name)});
    }
};

/// The caller's event for an event of the operation: same name, and a type that may widen on the way out.
bool event_fits(const Event& inner, const Event& outer) {
    const bool typed = inner.type_expr != nullptr;
    return (outer.type_expr != nullptr) == typed && (!typed || compatible(inner.type, outer.type));
}

/// What an operation takes from its caller and does not find there.
struct Lack {
    Missing variables;
    std::vector<const Event*> events;
    std::vector<const Clock*> clocks;
};

Lack lack_of(const Machine& caller, const Machine& operation) {
    Lack lack{missing_variables(required_variables(operation), visible_variables(caller), true), {}, {}};
    const Scope scope = scope_of(caller);
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

/// STM8 to STM10, at the first call.
void check_call(const Caller& caller, const Stmt& call, const Machine& operation, Diagnostics& out) {
    const std::string& name = caller.machine.name;
    const Lack lack = lack_of(caller.machine, operation);
    if (!lack.variables.empty()) {
        auto& finding =
            out.report(rules::stm8, call.span, {name, operation.name, s(lack.variables), list(lack.variables)});
        add_notes(finding, lack.variables, visible_variables(caller.machine));
        caller.add_context(finding);
    }
    const Scope scope = scope_of(caller.machine);
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

/// The same for an operation that is required and never called: no harm yet.
void check_required(const Caller& caller, const OperationSignature& wanted, const Machine& operation,
                    Diagnostics& out) {
    const Lack lack = lack_of(caller.machine, operation);
    Missing all = lack.variables;
    all.insert(all.end(), lack.events.begin(), lack.events.end());
    all.insert(all.end(), lack.clocks.begin(), lack.clocks.end());
    if (all.empty()) return;
    auto& finding =
        out.report(rules::stm8_required, caller.part.name_span, {caller.machine.name, operation.name, list(all)});
    finding.notes.push_back({wanted.name_span, "the operation is required through this signature"});
}

void check_calls(const Caller& caller, Diagnostics& out) {
    std::set<std::string_view> seen;
    for_actions(caller.machine, [&](const Stmt& action) {
        walk(action, [&](const Stmt& statement) {
            if (statement.kind != StmtKind::call || statement.declaration == nullptr) return;
            if (!seen.insert(statement.declaration->name).second) return;
            if (const Machine* defined = definition(caller.controller, statement.declaration->name))
                check_call(caller, statement, *defined, out);
        });
    });
    for (const OperationSignature* wanted : required_operations(caller.machine))
        if (const Machine* defined = definition(caller.controller, wanted->name);
            defined != nullptr && seen.insert(wanted->name).second)
            check_required(caller, *wanted, *defined, out);
}

// ---------------------------------------------------------------- controllers and modules

void check_part(const Caller& caller, bool first, Diagnostics& out) {
    const auto& [controller, part, machine] = caller;
    const auto visible = visible_variables(controller);
    const Missing variables = missing_variables(required_variables(machine), visible);
    if (!variables.empty())
        add_notes(out.report(rules::c3, part.name_span, {controller.name, s(variables), machine.name, list(variables)}),
                  variables, visible);
    const Missing operations = missing_operations(machine, offer_of(controller));
    if (!operations.empty())
        add_notes(
            out.report(rules::c4, part.name_span, {controller.name, s(operations), machine.name, list(operations)}),
            operations);
    if (first) check_calls(caller, out);
}

void check_operation(const Caller& caller, bool first, Diagnostics& out) {
    const auto& [controller, part, operation] = caller;
    const Offer offer = offer_of(controller);
    for (const OperationSignature* wanted : required_operations(operation))
        if (!offer.has(*wanted))
            out.report(rules::c4_operation, part.name_span, {operation.name, wanted->name, controller.name})
                .notes.push_back({wanted->name_span, "it is required through this signature"});
    if (first) check_calls(caller, out);
}

void check_controller(const Component& controller, Diagnostics& out) {
    std::set<const Machine*> seen;  // calls are the machine's, however many references lead to it
    for (const Declaration* part : controller.order) {
        const auto* machine = followed<Machine>(part);
        if (machine == nullptr) continue;
        const bool first = seen.insert(machine).second;
        const Caller caller{controller, *part, *machine};
        machine->kind == DeclKind::operation ? check_operation(caller, first, out) : check_part(caller, first, out);
    }
}

void check_module(const Component& module, Diagnostics& out) {
    const Context* platform = nullptr;
    std::size_t platforms = 0;
    for (const Declaration* part : module.order)
        if (const auto* found = followed<Context>(part); found != nullptr && found->kind == DeclKind::platform) {
            platform = found;
            ++platforms;
        }
    if (platforms != 1) return;  // M1 says so
    const Offer offer{{}, provided_operations(*platform)};
    for (const Declaration* part : module.order) {
        const auto* controller = followed<Component>(part);
        if (controller == nullptr || controller->kind != DeclKind::controller) continue;
        const auto visible = offered_variables(*platform);
        const Missing variables = missing_variables(required_variables(*controller), visible);
        if (!variables.empty())
            add_notes(out.report(rules::m2_variables, part->name_span,
                                 {module.name, s(variables), controller->name, list(variables)}),
                      variables, visible);
        const Missing operations = missing_operations(*controller, offer);
        if (!operations.empty())
            add_notes(out.report(rules::m2_operations, part->name_span,
                                 {module.name, s(operations), controller->name, list(operations)}),
                      operations);
    }
}

}  // namespace

void check_provision(const Component& component, Diagnostics& out) {
    component.kind == DeclKind::module ? check_module(component, out) : check_controller(component, out);
}

}  // namespace robochart::frontend
