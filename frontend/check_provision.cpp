// Rules about what parts require and their surroundings provide (language reference 2: C3, C4, M2, STM8 to STM10).
// Variables match by name and compatible type.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "frontend/checks.hpp"
#include "frontend/rules.hpp"
#include "frontend/scopes.hpp"
#include "frontend/types.hpp"
#include "frontend/walk.hpp"

namespace robochart::frontend {

namespace {

bool provides(const std::vector<const Variable*>& provided, const Variable& wanted) {
    return std::any_of(provided.begin(), provided.end(), [&](const Variable* v) {
        return v->name == wanted.name && (compatible(v->type, wanted.type) || compatible(wanted.type, v->type));
    });
}

std::string list(const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ", "));
}
std::string s(const std::vector<std::string>& names) {
    return names.size() == 1 ? "" : "s";
}

std::vector<std::string> missing_variables(const std::vector<const Variable*>& wanted,
                                           const std::vector<const Variable*>& provided) {
    std::vector<std::string> missing;
    for (const Variable* variable : wanted)
        if (!provides(provided, *variable)) missing.push_back("`" + variable->name + "`");
    return missing;
}

/// All variables of a platform: own, used and provided.
std::vector<const Variable*> platform_variables(const Context& platform) {
    std::vector<const Variable*> result = visible_variables(platform);
    for (const InterfaceClause& clause : platform.interfaces)
        if (const Context* interface = interface_of(clause);
            interface != nullptr && clause.use == InterfaceUse::provides)
            for (const auto& variable : interface->variables) result.push_back(variable.get());
    return result;
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

std::vector<std::string> missing_operations(const Context& part, const Offer& offer) {
    std::vector<std::string> missing;
    for (const OperationSignature* wanted : required_operations(part))
        if (!offer.has(*wanted)) missing.push_back("`" + wanted->name + "`");
    return missing;
}

// ---------------------------------------------------------------- calls

/// The definition in this controller of an operation called; null if it is the platform's.
const Machine* definition(const Component& controller, std::string_view name) {
    for (const Machine* defined : defined_operations(controller))
        if (defined->name == name) return defined;
    return nullptr;
}

/// What a called operation takes from its caller. Each operation is looked at once per machine, at its first call.
void check_call(const Machine& caller, const Stmt& call, const Machine& operation, Diagnostics& out) {
    const auto missing = missing_variables(required_variables(operation), visible_variables(caller));
    if (!missing.empty())
        out.report(rules::stm8, call.span, {caller.name, operation.name, s(missing), list(missing)})
            .notes.push_back({operation.name_span, "the operation is defined here"});
    const Scope scope = scope_of(caller);
    for (const Event* event : visible_events(operation))
        if (!scope.events.contains(event->name))
            out.report(rules::stm9, call.span, {operation.name, event->name, caller.name})
                .notes.push_back({event->name_span, "the event is declared here"});
    for (const InterfaceClause& clause : operation.interfaces) {
        const Context* interface = interface_of(clause);
        if (interface == nullptr || clause.use != InterfaceUse::requires_) continue;
        for (const auto& clock : interface->clocks)
            if (!scope.clocks.contains(clock->name))
                out.report(rules::stm10, call.span, {operation.name, clock->name, caller.name})
                    .notes.push_back({clock->name_span, "the clock is declared here"});
    }
}

void check_calls(const Component& controller, const Machine& caller, Diagnostics& out) {
    std::set<std::string_view> seen;
    for_actions(caller, [&](const Stmt& action) {
        walk(action, [&](const Stmt& statement) {
            if (statement.kind != StmtKind::call || statement.declaration == nullptr) return;
            if (!seen.insert(statement.declaration->name).second) return;
            if (const Machine* defined = definition(controller, statement.declaration->name))
                check_call(caller, statement, *defined, out);
        });
    });
}

// ---------------------------------------------------------------- controllers and modules

void check_part(const Component& controller, const Declaration& part, const Machine& machine, Diagnostics& out) {
    const auto variables = missing_variables(required_variables(machine), visible_variables(controller));
    if (!variables.empty())
        out.report(rules::c3, part.name_span, {controller.name, s(variables), machine.name, list(variables)});
    const auto operations = missing_operations(machine, offer_of(controller));
    if (!operations.empty())
        out.report(rules::c4, part.name_span, {controller.name, s(operations), machine.name, list(operations)});
    check_calls(controller, machine, out);
}

void check_operation(const Component& controller, const Declaration& part, const Machine& operation, Diagnostics& out) {
    const Offer offer = offer_of(controller);
    for (const OperationSignature* wanted : required_operations(operation))
        if (!offer.has(*wanted))
            out.report(rules::c4_operation, part.name_span, {operation.name, wanted->name, controller.name})
                .notes.push_back({wanted->name_span, "it is required through this signature"});
    check_calls(controller, operation, out);
}

void check_controller(const Component& controller, Diagnostics& out) {
    for (const Declaration* part : controller.order) {
        const auto* machine = followed<Machine>(part);
        if (machine == nullptr) continue;
        if (machine->kind == DeclKind::state_machine) check_part(controller, *part, *machine, out);
        if (machine->kind == DeclKind::operation) check_operation(controller, *part, *machine, out);
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
        const auto variables = missing_variables(required_variables(*controller), platform_variables(*platform));
        if (!variables.empty())
            out.report(rules::m2_variables, part->name_span,
                       {module.name, s(variables), controller->name, list(variables)});
        const auto operations = missing_operations(*controller, offer);
        if (!operations.empty())
            out.report(rules::m2_operations, part->name_span,
                       {module.name, s(operations), controller->name, list(operations)});
    }
}

}  // namespace

void check_provision(const Component& component, Diagnostics& out) {
    component.kind == DeclKind::module ? check_module(component, out) : check_controller(component, out);
}

}  // namespace robochart::frontend
