// SPDX-License-Identifier: Apache-2.0
// Computes the types of literals, collections and conditionals. The rules are those of the type provider (language
// reference 2, Types).
#include "frontend/types/typer.hpp"

#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"

namespace robochart::frontend {

const Expr& strip_parentheses(const Expr& expr) {
    const Expr* inner = &expr;
    while (inner->kind == ExprKind::parenthesised) inner = inner->args[0].get();
    return *inner;
}

std::string plural(std::size_t n) {
    return n == 1 ? "" : "s";
}

TypePtr Typer::assign_type(Expr& expr, Surroundings& around) {
    finder_.out().poll();
    expr.type = compute_type(expr, around);
    return expr.type;
}

TypePtr Typer::compute_type(Expr& expr, Surroundings& around) {
    switch (expr.kind) {
        case ExprKind::integer:
            return make_type(TypeForm::nat);
        case ExprKind::real:
            return make_type(TypeForm::real);
        case ExprKind::string:
            return make_type(TypeForm::string);
        case ExprKind::boolean:
            return make_type(TypeForm::boolean);
        case ExprKind::name:
            return name(expr, around);
        case ExprKind::result:
            return around.function != nullptr ? around.function->result : nullptr;
        case ExprKind::to:
        case ExprKind::from:
            return make_type(TypeForm::nat);
        case ExprKind::unary:
            return type_unary(expr, around);
        case ExprKind::binary:
            return type_binary(expr, around);
        case ExprKind::if_then_else:
            return type_conditional(expr, around);
        case ExprKind::let:
            return type_let(expr, around);
        case ExprKind::forall:
        case ExprKind::exists:
        case ExprKind::exists_unique:
        case ExprKind::lambda:
        case ExprKind::the:
        case ExprKind::set_comprehension:
            return type_binder(expr, around);
        case ExprKind::cast:
        case ExprKind::is_type:
            return type_cast(expr, around);
        case ExprKind::member:
            return type_member(expr, around);
        case ExprKind::index:
            return type_index(expr, around);
        case ExprKind::call:
            return check_call(expr, around);
        case ExprKind::record:
            return type_record(expr, around);
        case ExprKind::tuple:
        case ExprKind::sequence:
        case ExprKind::set:
        case ExprKind::set_range:
        case ExprKind::range:
            return type_elements(expr, around);
        case ExprKind::matrix:
        case ExprKind::inverse:
        case ExprKind::transpose:
            return type_matrix(expr, around);
        case ExprKind::since:
            return type_since(expr, around);
        case ExprKind::since_entry:
            return since_entry(expr, around);
        case ExprKind::parenthesised:
            return assign_type(expr.args[0], around);
        case ExprKind::register_:
            return type_register(expr, around);
        case ExprKind::cycle:
            return make_type(TypeForm::nat);
        case ExprKind::path:
        case ExprKind::probability:
        case ExprKind::reward:
        case ExprKind::all_paths:
        case ExprKind::some_path:
        case ExprKind::in_state:
        case ExprKind::event:
        case ExprKind::marked:
        case ExprKind::simulation:  // in probabilistic assertions, which are not typed yet
        case ExprKind::error:
            break;
    }
    return nullptr;
}

void Typer::check_boolean(const ExprPtr& expr, Surroundings& around, const std::string& what) {
    const TypePtr type = this->assign_type(expr, around);
    if (type && !is_compatible(type, make_type(TypeForm::boolean)))
        finder_.out().report(rules::condition_boolean, expr->span, {what, to_string(type)});
}

/// Computes the types of the elements of a literal. The parts of a tuple may have different types. The elements of a
/// set, a sequence or a range have one common type.
TypePtr Typer::type_elements(Expr& expr, Surroundings& around) {
    if (expr.kind == ExprKind::set_range || expr.kind == ExprKind::range) return type_range(expr, around);
    if (expr.kind != ExprKind::tuple)
        return type_all(expr, around, expr.kind == ExprKind::sequence ? TypeForm::sequence : TypeForm::set);
    std::vector<TypePtr> parts;
    bool known = true;
    for (const ExprPtr& arg : expr.args) known = (parts.emplace_back(assign_type(arg, around)) != nullptr) && known;
    return known ? make_type(TypeForm::product, std::move(parts)) : nullptr;
}

/// Returns the type of a range of numbers: a set of the larger of the two types.
TypePtr Typer::type_range(Expr& expr, Surroundings& around) {
    TypePtr both = make_type(TypeForm::nat);
    for (const ExprPtr& arg : expr.args) {
        const TypePtr bound = simplify_type(assign_type(arg, around));
        if (bound && !is_number(bound) && bound->form != TypeForm::any)
            finder_.out().report(rules::range_bounds, arg->span, {to_string(bound)});
        both = both && is_number(bound) ? join_types(both, bound) : nullptr;
    }
    return both ? make_type(TypeForm::set, {both}) : nullptr;
}

TypePtr Typer::type_all(Expr& expr, Surroundings& around, TypeForm collection) {
    TypePtr element = make_type(TypeForm::any);
    for (const ExprPtr& arg : expr.args) {
        const TypePtr next = assign_type(arg, around);
        if (!element || !next) {
            element = nullptr;
            continue;
        }
        const TypePtr both = join_types(element, next);
        if (!both) finder_.out().report(rules::mixed_types, arg->span, {to_string(element), to_string(next)});
        element = both;
    }
    return element ? make_type(collection, {element}) : nullptr;
}

TypePtr Typer::type_conditional(Expr& expr, Surroundings& around) {
    check_boolean(expr.args[0], around, "the condition of `if`");
    const TypePtr yes = assign_type(expr.args[1], around);
    const TypePtr no = assign_type(expr.args[2], around);
    if (!yes || !no) return nullptr;
    const TypePtr both = join_types(yes, no);
    if (!both) finder_.out().report(rules::mixed_types, expr.args[2]->span, {to_string(yes), to_string(no)});
    return both;
}

/// Computes the type of a matrix `[| … |]`, an inverse or a transpose.
TypePtr Typer::type_matrix(Expr& expr, Surroundings& around) {
    if (expr.kind == ExprKind::matrix) {
        const TypePtr all = type_all(expr, around, TypeForm::sequence);
        if (!all || expr.columns == 0) return nullptr;
        const long columns = static_cast<long>(expr.columns);
        const long rows = static_cast<long>(expr.args.size() / expr.columns);
        return rows == 1 ? make_vector(all->args[0], columns) : make_matrix(all->args[0], rows, columns);
    }
    const TypePtr operand = simplify_type(assign_type(expr.args[0], around));
    // `last(<>)` and similar expressions may have any type.
    if (!operand || operand->form == TypeForm::any) return nullptr;
    const bool transposes = expr.kind == ExprKind::transpose;
    // A vector is a column, so its transpose has one row.
    if (operand->form == TypeForm::vector && transposes) return make_matrix(operand->args[0], 1, operand->sizes[0]);
    const bool square = operand->form == TypeForm::matrix &&
                        (operand->sizes[0] < 0 || operand->sizes[1] < 0 || operand->sizes[0] == operand->sizes[1]);
    if (operand->form != TypeForm::matrix || (!transposes && !square)) {
        finder_.out().report(rules::unary_type, expr.span, {transposes ? "transpose" : "inverse", to_string(operand)});
        return nullptr;
    }
    if (transposes) return make_matrix(operand->args[0], operand->sizes[1], operand->sizes[0]);
    return make_matrix(make_type(TypeForm::real), operand->sizes[0], operand->sizes[1]);
}

TypePtr Typer::type_cast(Expr& expr, Surroundings& around) {
    const TypePtr from = assign_type(expr.args[0], around);
    const TypePtr to = assign_type(*expr.type_expr, around);
    if (from && to && !is_compatible(from, to) && !is_compatible(to, from))
        finder_.out().report(rules::cast_type, expr.span, {to_string(from), to_string(to)});
    return expr.kind == ExprKind::cast ? to : make_type(TypeForm::boolean);
}

// ---------------------------------------------------------------- binders

/// Computes the type of a quantifier, lambda expression, definite description or comprehension.
TypePtr Typer::type_binder(Expr& expr, Surroundings& around) {
    std::vector<TypePtr> types;
    bool known = true;
    for (Binding& binding : expr.bindings) {
        binding.variable->type = assign_type(*binding.variable->type_expr, around);
        known = known && binding.variable->type != nullptr;
        types.push_back(binding.variable->type);
    }
    const std::size_t outer = around.bound.size();
    for (const Binding& binding : expr.bindings) around.bound.push_back(binding.variable.get());
    if (expr.args[0]) check_boolean(expr.args[0], around, "what follows `|`");
    const TypePtr result = bound_body(expr, around, known ? make_type(TypeForm::product, types) : nullptr);
    around.bound.resize(outer);
    return result;
}

TypePtr Typer::bound_body(Expr& expr, Surroundings& around, const TypePtr& variables) {
    const TypePtr body = assign_type(expr.args[1], around);
    if (expr.kind == ExprKind::lambda)
        return variables && body ? make_type(TypeForm::function, {variables, body}) : nullptr;
    if (expr.kind == ExprKind::the) return expr.args[1] ? body : simplify_type(variables);
    if (expr.kind == ExprKind::set_comprehension) {
        const TypePtr element = expr.args[1] ? body : simplify_type(variables);
        return element ? make_type(TypeForm::set, {element}) : nullptr;
    }
    if (body && !is_compatible(body, make_type(TypeForm::boolean)))
        finder_.out().report(rules::condition_boolean, expr.args[1]->span, {"what follows `@`", to_string(body)});
    return make_type(TypeForm::boolean);
}

/// Computes the type of a `let`. Each of its bindings may use the earlier ones.
TypePtr Typer::type_let(Expr& expr, Surroundings& around) {
    const std::size_t outer = around.bound.size();
    for (Binding& binding : expr.bindings) {
        binding.variable->type = assign_type(binding.value, around);
        around.bound.push_back(binding.variable.get());
    }
    const TypePtr result = assign_type(expr.args[0], around);
    around.bound.resize(outer);
    return result;
}

}  // namespace robochart::frontend
