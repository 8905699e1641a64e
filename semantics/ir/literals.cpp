// SPDX-License-Identifier: Apache-2.0
// Collects the literals of a model.
#include "semantics/ir/literals.hpp"

#include <algorithm>

#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

void add_literal(const System& system, const Expr& expr, bool time, Literals& literals) {
    if (expr.kind == ExprKind::real) return (time ? literals.real_time : literals.real).push_back(expr.decimal);
    if (time || !expr.type.is_valid()) return;
    const TypeKind kind = system.type(expr.type).kind;
    if (kind == TypeKind::nat) literals.nat.insert(expr.number);
    if (kind == TypeKind::integer) literals.integer.insert(expr.number);
    literals.places.emplace(expr.number, expr.span);
}

bool compares_clock(const Expr& expr) {
    return is_comparison(expr.kind) && expr.args.size() == 2 && expr.args[0] && expr.args[1] &&
           (reads_clock(*expr.args[0]) || reads_clock(*expr.args[1]));
}

/// True if the expression only selects a part by a number, which is then not a value of a variable.
bool is_place(const Expr& expr) {
    return expr.kind == ExprKind::integer;
}

/// True for a window that consists of literals only: `[31, 90]`, `{1, 5}`.
bool is_window(const Expr& expr) {
    if (expr.kind == ExprKind::integer) return true;
    const bool listed = expr.kind == ExprKind::set || expr.kind == ExprKind::set_range || expr.kind == ExprKind::range;
    return listed && std::ranges::all_of(expr.args, [](const ExprPtr& part) { return !part || is_window(*part); });
}

/// Records whether an expression uses constants as times or as values.
struct ConstantUses {
    std::set<std::string> times, values;

    void add(const std::vector<Constant>& constants, const Expr& expr, bool time) {
        if (expr.kind == ExprKind::constant && expr.constant.index < constants.size())
            (time ? times : values).insert(constants[expr.constant.index].name);
        const bool operands_time = compares_clock(expr);
        for (const ExprPtr& argument : expr.args)
            if (argument) add(constants, *argument, operands_time);
    }
};

/// Returns the initial values of the constants of these names.
std::set<const Expr*> values_of(const std::set<std::string>& names, const System& system) {
    std::set<const Expr*> result;
    const auto add = [&](const std::vector<Constant>& constants) {
        for (const Constant& constant : constants)
            if (constant.value && names.contains(constant.name)) result.insert(constant.value.get());
    };
    for (const Machine& machine : system.machines) add(machine.constants);
    for (const Controller& controller : system.controllers) add(controller.constants);
    for (const Module& module : system.modules) add(module.platform.constants);
    return result;
}

ConstantUses uses_of_constants(const System& system) {
    ConstantUses uses;
    uses.times.insert(cycle_length);
    for (const Machine& machine : system.machines)
        visit_expressions(machine, [&](const Expr& expr, ExprRole role) {
            uses.add(machine.constants, expr, role == ExprRole::time);
        });
    const auto declared = [&](const auto& context) {
        for (const Constant& constant : context.constants)
            if (constant.value) uses.add(context.constants, *constant.value, false);
        for (const Variable& variable : context.variables)
            if (variable.initial) uses.add(context.constants, *variable.initial, false);
    };
    for (const Controller& controller : system.controllers) declared(controller);
    for (const Module& module : system.modules) declared(module.platform);
    return uses;
}

}  // namespace

std::set<std::string> constants_of_durations(const System& system) {
    ConstantUses uses = uses_of_constants(system);
    for (const std::string& name : uses.values) uses.times.erase(name);
    return std::move(uses.times);
}

std::set<std::string> constants_read_as_times(const System& system) {
    return uses_of_constants(system).times;
}

void add_literals(const System& system, const Expr& expr, bool time, Literals& literals) {
    if (expr.kind == ExprKind::integer || expr.kind == ExprKind::real) return add_literal(system, expr, time, literals);
    if (expr.kind == ExprKind::string) literals.strings.insert(expr.characters);
    const bool operands_time = compares_clock(expr);
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (!expr.args[i]) continue;
        const bool place = expr.kind == ExprKind::index && i > 0 && is_place(*expr.args[i]);
        const bool window = expr.kind == ExprKind::toolkit && expr.text == "sequence_toolkit_extract" && i == 0 &&
                            is_window(*expr.args[i]);
        if (!place && (!window || literals.windows)) add_literals(system, *expr.args[i], operands_time, literals);
    }
}

Literals literals_of(const System& system, bool windows) {
    Literals literals;
    literals.windows = windows;
    literals.durations = constants_of_durations(system);
    const std::set<const Expr*> times = values_of(literals.durations, system);
    visit_expressions(system, [&](const Expr& expr, ExprRole role) {
        if (role == ExprRole::probability || (role == ExprRole::place && is_place(expr))) return;
        add_literals(system, expr, role == ExprRole::time || times.contains(&expr), literals);
    });
    for (const auto& function : system.functions)
        for (const auto& condition : function.postconditions) add_literals(system, *condition, false, literals);
    return literals;
}

}  // namespace robochart::ir
