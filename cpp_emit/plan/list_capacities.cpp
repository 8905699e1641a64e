// SPDX-License-Identifier: Apache-2.0
#include "cpp_emit/plan/list_capacities.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "cpp_emit/plan/rules.hpp"
#include "cpp_emit/plan/types.hpp"
#include "cpp_emit/plan/walk.hpp"

namespace robochart::cpp_emit {

using ir::ExprKind;
using ir::TypeKind;

namespace {

/// Visits the outermost types of lists in a type.
void visit_list_types(const ir::System& system, ir::TypeId id, const std::function<void(ir::TypeId)>& visitor) {
    const ir::Type& type = system.type(id);
    if (type.kind == TypeKind::sequence || type.kind == TypeKind::set) return visitor(id);
    for (const ir::TypeId part : type.args) visit_list_types(system, part, visitor);
    for (const auto& arguments : type.literal_args)
        for (const ir::TypeId part : arguments) visit_list_types(system, part, visitor);
}

/// Visits the types of the events and variables of this name whose values contain lists.
void visit_named(const ir::System& system, const Component& component, const std::string& name,
                 const std::function<void(ir::TypeId)>& visitor) {
    const auto visit_type = [&](ir::TypeId type) {
        if (has_lists(system, type)) visitor(type);
    };
    for (const Part& part : component.parts)
        for (const EventUse& event : part.events)
            if (event.name == name && event.type) visit_type(*event.type);
    for (const EventPort& event : component.events)
        if (event.outside == name && event.type) visit_type(*event.type);
    for (const Unit& unit : component.units)
        for (const ir::Variable& variable : unit.machine->variables)
            if (variable.name == name) visit_type(variable.type);
}

using Capacities = std::map<ir::TypeId, std::size_t>;

void raise_capacity(Capacities& capacities, ir::TypeId type, std::size_t least) {
    std::size_t& capacity = capacities[type];
    capacity = std::max(capacity, least);
}

/// List literals may have more elements than the usual capacity.
void add_literals(const ir::System& system, const Component& component, Capacities& capacities) {
    for (const Unit& unit : component.units)
        visit_expressions(*unit.machine, [&](const ir::Expr& expr) {
            const bool literal = expr.kind == ExprKind::sequence || expr.kind == ExprKind::set;
            const TypeKind kind = literal ? system.type(expr.type).kind : TypeKind::unit;
            if ((kind != TypeKind::sequence && kind != TypeKind::set) || !has_lists(system, expr.type)) return;
            const bool outer = has_lists(system, system.type(expr.type).args.at(0));
            const std::size_t usual = outer ? usual_outer_capacity : usual_capacity;
            const auto given = capacities.find(expr.type);
            if (expr.args.size() > (given == capacities.end() ? usual : given->second))
                raise_capacity(capacities, expr.type, expr.args.size());
        });
}

}  // namespace

bool has_capacity(const ir::System& system, const Component& component, const std::string& name) {
    bool found = false;
    visit_named(system, component, name, [&](ir::TypeId) { found = true; });
    return found;
}

std::optional<ir::System> with_capacities(const ir::System& system, const Component& component,
                                          const Options& options) {
    Capacities capacities;
    for (const auto& [name, capacity] : options.capacities)
        visit_named(system, component, name, [&](ir::TypeId type) {
            visit_list_types(system, type, [&](ir::TypeId list) { raise_capacity(capacities, list, capacity); });
        });
    add_literals(system, component, capacities);
    if (capacities.empty()) return std::nullopt;
    ir::System result = system;
    for (const auto& [type, capacity] : capacities)
        result.types[type.index].sizes = {static_cast<std::int64_t>(capacity)};
    return result;
}

namespace {

/// Whether the expression is longer than the variable that it contains.
bool lengthens(const ir::Expr& expr, ir::VariableId variable) {
    const bool joins =
        expr.kind == ExprKind::concat || (expr.kind == ExprKind::toolkit &&
                                          (expr.text == "sequence_toolkit_concat" || expr.text == "set_toolkit_union"));
    const auto contains = [&](const ir::ExprPtr& part) {
        bool found = false;
        visit(part, [&](const ir::Expr& inner) {
            found = found || (inner.kind == ExprKind::variable && inner.variable == variable);
        });
        return found;
    };
    if (joins && std::ranges::any_of(expr.args, contains)) return true;
    return std::ranges::any_of(expr.args, [&](const ir::ExprPtr& part) { return part && lengthens(*part, variable); });
}

std::size_t usual_capacity_of(const ir::System& system, ir::TypeId type) {
    std::size_t result = usual_capacity;
    visit_list_types(system, type, [&](ir::TypeId list) {
        if (has_lists(system, system.type(list).args.at(0))) result = usual_outer_capacity;
    });
    return result;
}

}  // namespace

void report_capacities(const ir::System& system, const Component& component, const Options& options,
                       diagnostics::Diagnostics& diagnostics) {
    std::set<std::string> reported;
    const auto report = [&](const std::string& name, ir::TypeId type, diagnostics::Span span, const char* reason) {
        if (!has_lists(system, type) || options.capacities.contains(name) || !reported.insert(name).second) return;
        diagnostics.report(rules::usual_capacity, span,
                           {name, fmt::format("{}", usual_capacity_of(system, type)), reason, name});
    };
    for (const Unit& unit : component.units) {
        const ir::Machine& machine = *unit.machine;
        ir::visit_statements(machine, [&](const ir::Stmt& stmt) {
            if (stmt.kind != ir::StmtKind::assign || !stmt.value || !lengthens(*stmt.value, stmt.variable)) return;
            const ir::Variable& variable = machine.variables[stmt.variable.index];
            report(variable.name, variable.type, stmt.value->span,
                   "this assignment may make the list longer each time");
        });
    }
    for (const EventPort& event : component.events)
        if (event.received && event.type)
            report(event.model_name, *event.type, component.origin.span, "the model does not bound what it receives");
}

}  // namespace robochart::cpp_emit
