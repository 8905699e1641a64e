// Number literals of a model.
#include "semantics/literals.hpp"

#include "semantics/visit.hpp"

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

}  // namespace

void add_literals(const System& system, const Expr& expr, bool time, Literals& literals) {
    if (expr.kind == ExprKind::integer || expr.kind == ExprKind::real) return add_literal(system, expr, time, literals);
    const bool operands_time = compares_clock(expr);
    for (const auto& arg : expr.args)
        if (arg) add_literals(system, *arg, operands_time, literals);
}

Literals literals_of(const System& system) {
    Literals literals;
    visit_expressions(
        system, [&](const Expr& expr, ExprRole role) { add_literals(system, expr, role == ExprRole::time, literals); });
    return literals;
}

}  // namespace robochart::ir
