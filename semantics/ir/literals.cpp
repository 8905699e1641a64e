// Number literals of a model.
#include "semantics/ir/literals.hpp"

#include "semantics/ir/visit.hpp"

namespace robochart::ir {
namespace {

void add_literal(const System& system, const Expr& expr, bool time, Literals& literals) {
    if (expr.kind == ExprKind::real) return (time ? literals.real_time : literals.real).push_back(expr.decimal);
    if (time || !expr.type.valid()) return;
    const TypeKind kind = system.type(expr.type).kind;
    if (kind == TypeKind::nat) literals.nat.insert(expr.number);
    if (kind == TypeKind::integer) literals.integer.insert(expr.number);
    literals.places.emplace(expr.number, expr.span);
}

bool compares_clock(const Expr& expr) {
    return is_comparison(expr.kind) && expr.args.size() == 2 && expr.args[0] && expr.args[1] &&
           (reads_clock(*expr.args[0]) || reads_clock(*expr.args[1]));
}

/// A number that says which part is meant is no value that a variable holds.
bool is_place(const Expr& expr) {
    return expr.kind == ExprKind::integer;
}

}  // namespace

void add_literals(const System& system, const Expr& expr, bool time, Literals& literals) {
    if (expr.kind == ExprKind::integer || expr.kind == ExprKind::real) return add_literal(system, expr, time, literals);
    if (expr.kind == ExprKind::string) literals.strings.insert(expr.characters);
    const bool operands_time = compares_clock(expr);
    for (std::size_t i = 0; i < expr.args.size(); ++i) {
        if (!expr.args[i]) continue;
        const bool place = expr.kind == ExprKind::index && i > 0 && is_place(*expr.args[i]);
        if (!place) add_literals(system, *expr.args[i], operands_time, literals);
    }
}

Literals literals_of(const System& system) {
    Literals literals;
    visit_expressions(system, [&](const Expr& expr, ExprRole role) {
        if (role == ExprRole::probability || (role == ExprRole::place && is_place(expr))) return;
        add_literals(system, expr, role == ExprRole::time, literals);
    });
    for (const auto& function : system.functions)
        for (const auto& condition : function.postconditions) add_literals(system, *condition, false, literals);
    return literals;
}

}  // namespace robochart::ir
