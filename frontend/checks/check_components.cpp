// SPDX-License-Identifier: Apache-2.0
// Checks the rules about the permitted contents of components and interfaces (language reference 2: STM1 to M, DT).
#include <fmt/format.h>

#include "frontend/checks/checks.hpp"
#include "frontend/names/scopes.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

namespace {

/// An interface clause of a component and the interface that it names.
struct Clause {
    const Context& owner;
    const InterfaceClause& written;
    const Context& interface;

    void report(const Rule& rule, Diagnostics& out) const {
        out.report(rule, written.name.span, {owner.name, interface.name})
            .notes.push_back({interface.name_span, "the interface is declared here"});
    }
};

void check_machine_clause(const Clause& clause, Diagnostics& out) {
    const bool machine = clause.owner.kind == DeclKind::state_machine;
    if (clause.written.use == InterfaceUse::provides) clause.report(machine ? rules::stm1 : rules::o1, out);
    if (machine && clause.written.use == InterfaceUse::requires_ && !clause.interface.clocks.empty())
        clause.report(rules::stm7, out);
}

void check_platform_clause(const Clause& clause, Diagnostics& out) {
    if (clause.written.use == InterfaceUse::requires_) clause.report(rules::rp1, out);
    if (clause.written.use == InterfaceUse::uses && !clause.interface.clocks.empty()) clause.report(rules::rp2, out);
}

void check_controller_clause(const Clause& clause, Diagnostics& out) {
    if (clause.written.use == InterfaceUse::provides) clause.report(rules::c2, out);
    if (clause.interface.clocks.empty()) return;
    if (clause.written.use == InterfaceUse::uses) clause.report(rules::c10, out);
    if (clause.written.use == InterfaceUse::requires_) clause.report(rules::c11, out);
}

/// Checks I1 and I2: which members an interface may declare depends on the keyword of the clause that names it.
void check_clause_contents(const Clause& clause, Diagnostics& out) {
    const auto i1 = [&](std::string_view verb, std::string_view what) {
        out.report(rules::i1, clause.written.name.span,
                   {clause.owner.name, std::string(verb), clause.interface.name, std::string(what)})
            .notes.push_back({clause.interface.name_span, "the interface is declared here"});
    };
    switch (clause.written.use) {
        case InterfaceUse::requires_:
            if (!clause.interface.events.empty()) i1("requires", "events");
            break;
        case InterfaceUse::provides:
            if (!clause.interface.events.empty()) i1("provides", "events");
            if (!clause.interface.clocks.empty()) i1("provides", "clocks");
            break;
        case InterfaceUse::uses:
            if (!clause.interface.signatures.empty()) clause.report(rules::i2, out);
    }
}

void check_clauses(const Context& context, Diagnostics& out) {
    for (const InterfaceClause& written : context.interfaces) {
        const Context* interface = interface_of(written);
        if (interface == nullptr) continue;
        const Clause clause{context, written, *interface};
        check_clause_contents(clause, out);
        if (context.kind == DeclKind::platform) check_platform_clause(clause, out);
        if (context.kind == DeclKind::controller) check_controller_clause(clause, out);
        if (context.kind == DeclKind::state_machine || context.kind == DeclKind::operation)
            check_machine_clause(clause, out);
    }
}

/// Reports members that the grammar accepts in every component, but that the rules allow only in some components.
void check_misplaced_members(const Context& context, Diagnostics& out) {
    for (const auto& signature : context.signatures) {
        if (context.kind == DeclKind::state_machine || context.kind == DeclKind::operation)
            out.report(rules::stm6, signature->span, {context.name, signature->name});
        if (context.kind == DeclKind::controller)
            out.report(rules::c7, signature->span, {context.name, signature->name});
    }
    for (const auto& clock : context.clocks) {
        if (context.kind == DeclKind::platform) out.report(rules::rp3, clock->span, {context.name, clock->name});
        if (context.kind == DeclKind::controller) out.report(rules::c9, clock->span, {context.name, clock->name});
    }
    if (context.kind == DeclKind::interface && !context.events.empty() && !context.signatures.empty())
        out.report(rules::i_mixed, context.name_span, {context.name});
}

void check_controller(const Component& controller, Diagnostics& out) {
    bool has_machine = !controller.machines.empty();
    for (const auto& reference : controller.references)
        has_machine = has_machine || reference->refers_to == DeclKind::state_machine;
    if (!has_machine) out.report(rules::c1, controller.name_span, {controller.name});
    std::map<std::string_view, const Declaration*> defined;
    for (const Declaration* part : controller.order) {
        const Declaration* behind = follow_reference(part);
        if (behind == nullptr || behind->kind != DeclKind::operation) continue;
        const auto [first, fresh] = defined.emplace(behind->name, part);
        if (!fresh)
            out.report(rules::c8, part->name_span, {controller.name, behind->name})
                .notes.push_back({first->second->name_span, "it is already defined here"});
    }
}

/// Reports M1 at each platform after the first.
void report_platforms(const Component& module, std::size_t platforms, Diagnostics& out) {
    auto& finding =
        out.report(rules::m1, module.name_span, {module.name, platforms == 0 ? "no" : std::to_string(platforms)});
    std::size_t seen = 0;
    for (const Declaration* part : module.order) {
        const Declaration* behind = follow_reference(part);
        if (behind != nullptr && behind->kind == DeclKind::platform && ++seen > 1)
            finding.notes.push_back({part->name_span, "another platform"});
    }
}

void check_module(const Component& module, Diagnostics& out) {
    std::size_t platforms = module.platforms.size();
    std::size_t controllers = module.controllers.size();
    for (const auto& reference : module.references) {
        if (reference->refers_to == DeclKind::platform) ++platforms;
        if (reference->refers_to == DeclKind::controller) ++controllers;
        if (reference->refers_to == DeclKind::state_machine)
            out.report(rules::m_machine, reference->name_span, {module.name, reference->name});
    }
    if (platforms != 1) report_platforms(module, platforms, out);
    if (controllers == 0) out.report(rules::m_controller, module.name_span, {module.name});
    for (const auto& machine : module.machines)
        out.report(rules::m_machine, machine->name_span, {module.name, machine->name});
}

}  // namespace

void check_component(const Context& context, Diagnostics& out) {
    check_clauses(context, out);
    check_misplaced_members(context, out);
    if (context.kind == DeclKind::controller) check_controller(static_cast<const Component&>(context), out);
    if (context.kind == DeclKind::module) check_module(static_cast<const Component&>(context), out);
}

void check_type(const TypeDeclaration& type, Diagnostics& out) {
    if (type.kind == DeclKind::record_type && type.fields.empty()) out.report(rules::dt, type.name_span, {type.name});
}

}  // namespace robochart::frontend
