// SPDX-License-Identifier: Apache-2.0
// Resolves headers first: types, interface clauses and references of all files. Bodies can then be resolved in any
// order.
#include "frontend/resolve/resolver.hpp"

#include <fmt/format.h>

#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

void Resolver::run() {
    for (auto& file : model_.files) resolve_headers(*file);
    for (auto& file : model_.files) resolve_bodies(*file);
    resolve_all_assertions();
}

void Resolver::resolve_all_assertions() {
    resolve_assertions(model_, finder_, typer_);
    resolve_probabilistic(model_, finder_, typer_);
}

void Resolver::visit_declarations(File& file, void (Resolver::*visit)(File&, Declaration&)) {
    for (auto& declaration : file.declarations) each_part(file, *declaration, visit);
    for (auto& simulation : file.simulations) (this->*visit)(file, *simulation);
}

/// Visits the declaration and the components inside it.
void Resolver::each_part(File& file, Declaration& declaration, void (Resolver::*visit)(File&, Declaration&)) {
    (this->*visit)(file, declaration);
    auto* component = dynamic_cast<Component*>(&declaration);
    if (component == nullptr) return;
    for (auto& part : component->platforms) (this->*visit)(file, *part);
    for (auto& part : component->controllers) each_part(file, *part, visit);
    for (auto& part : component->machines) (this->*visit)(file, *part);
    for (auto& part : component->operations) (this->*visit)(file, *part);
}

void Resolver::resolve_header(File& file, Declaration& declaration) {
    if (auto* type = dynamic_cast<TypeDeclaration*>(&declaration)) return type_header(file, *type);
    if (auto* function = dynamic_cast<Function*>(&declaration)) return function_header(file, *function);
    if (auto* context = dynamic_cast<Context*>(&declaration)) context_header(file, *context);
    if (auto* component = dynamic_cast<Component*>(&declaration)) resolve_references(file, *component);
}

void Resolver::variable_type(Variable& variable, Surroundings& around) {
    if (variable.type_expr) variable.type = typer_.assign_type(*variable.type_expr, around);
}

void Resolver::parameter_types(std::vector<VariablePtr>& parameters, Surroundings& around) {
    for (VariablePtr& parameter : parameters) variable_type(*parameter, around);
}

void Resolver::type_header(File& file, TypeDeclaration& type) {
    Surroundings around{{&file, &type}, nullptr, nullptr, nullptr, {}};
    parameter_types(type.fields, around);
    for (auto& literal : type.literals)
        for (TypeExprPtr& argument : literal->arguments) typer_.assign_type(*argument, around);
}

void Resolver::function_header(File& file, Function& function) {
    Surroundings around{{&file, &function}, nullptr, nullptr, nullptr, {}};
    parameter_types(function.parameters, around);
    if (function.result_expr) function.result = typer_.assign_type(*function.result_expr, around);
}

void Resolver::context_header(File& file, Context& context) {
    for (auto* registers : {&context.input, &context.output})
        if (*registers) context_header(file, **registers);
    for (InterfaceClause& clause : context.interfaces)
        clause.target = finder_.find({&file, &context}, clause.name, {DeclKind::interface}, "interface");
    // The size of a vector may be a constant of the context itself.
    const Scope scope = scope_of(context);
    Surroundings around{{&file, &context}, &scope, nullptr, nullptr, {}};
    // Constants are resolved first, because the types of other variables may use them as sizes.
    for (auto& variable : context.variables)
        if (variable->kind == DeclKind::constant) variable_type(*variable, around);
    for (auto& variable : context.variables)
        if (variable->kind != DeclKind::constant) variable_type(*variable, around);
    for (auto& event : context.events)
        if (event->type_expr) event->type = typer_.assign_type(*event->type_expr, around);
    for (auto& signature : context.signatures) parameter_types(signature->parameters, around);
    if (auto* machine = dynamic_cast<Machine*>(&context)) parameter_types(machine->parameters, around);
}

void Resolver::resolve_references(File& file, Component& component) {
    for (auto& reference : component.references)
        reference->target = finder_.find({&file, &component}, reference->target_name, {reference->refers_to},
                                         to_text(reference->refers_to));
    // A platform has the same meaning in both dialects.
    for (auto& reference : component.references) {
        const auto* part = dynamic_cast<const Context*>(reference->target);
        if (part == nullptr || part->kind == DeclKind::platform || part->dialect == component.dialect) continue;
        finder_.out()
            .report(rules::mixed_dialects, reference->target_name.span,
                    {part->name, std::string(to_text(part->kind)), std::string(to_text(part->dialect)), component.name,
                     std::string(to_text(component.dialect))})
            .notes.push_back({part->name_span, "it is declared here"});
    }
}

void Resolver::resolve_body(File& file, Declaration& declaration) {
    if (auto* function = dynamic_cast<Function*>(&declaration)) return function_body(file, *function);
    if (auto* context = dynamic_cast<Context*>(&declaration)) context_body(file, *context);
    if (auto* component = dynamic_cast<Component*>(&declaration)) resolve_connections(*component);
}

}  // namespace robochart::frontend
