// Calls, parts of composed values, casts and clocks.
#include <algorithm>

#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/types.hpp"

namespace robochart::ir {

ExprPtr Expressions::application(const ast::Expr& source, ExprPtr function) {
    Expr expr = start(source, ExprKind::apply);
    expr.args.push_back(std::move(function));
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    return share(std::move(expr));
}

ExprPtr Expressions::function_call(const ast::Expr& source, const ast::Function& function) {
    Expr expr;
    expr.kind = ExprKind::call;
    expr.span = source.span;
    expr.text = function.name;
    expr.function = lower_function(lowering_, function, source.span);
    if (!expr.function.valid()) return make_boolean(true, source.span);
    expr.type = lower_type(lowering_, function.result, source.span);
    for (std::size_t i = 0; i < source.args.size(); ++i) {
        const bool typed = i < function.parameters.size();
        const TypeId type = typed ? lower_type(lowering_, function.parameters[i]->type, source.span) : TypeId{};
        expr.args.push_back(operand(source, i, type));
    }
    return share(std::move(expr));
}

ExprPtr Expressions::call(const ast::Expr& source) {
    if (source.callee) return application(source, lower(*source.callee));
    if (source.target == nullptr) {
        lowering_.unresolved("'" + source.name.text() + "'", source.span);
        return make_boolean(true, source.span);
    }
    if (source.target->kind == ast::DeclKind::function)
        return function_call(source, static_cast<const ast::Function&>(*source.target));
    if (source.target->kind == ast::DeclKind::enum_literal)
        return enum_literal(source, static_cast<const ast::EnumLiteral&>(*source.target));
    ast::Expr callee;
    callee.kind = ast::ExprKind::name;
    callee.span = source.name.span;
    callee.target = source.target;
    return application(source, name(callee, {}));
}

ExprPtr Expressions::member(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::member);
    expr.args = {operand(source, 0)};
    const Type& type = lowering_.system.type(expr.args[0]->type);
    const auto at = std::find(type.labels.begin(), type.labels.end(), source.text);
    if (type.kind != TypeKind::record || at == type.labels.end())
        return lowering_.unresolved("field '" + source.text + "'", source.span), share(std::move(expr));
    expr.number = at - type.labels.begin();
    expr.text = source.text;
    expr.type = type.args[static_cast<std::size_t>(expr.number)];
    return share(std::move(expr));
}

ExprPtr Expressions::index(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::index);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    const Type& type = lowering_.system.type(expr.args[0]->type);
    if (type.kind != TypeKind::product) return share(std::move(expr));
    const bool fixed = expr.args.size() == 2 && expr.args[1]->kind == ExprKind::integer && expr.args[1]->number >= 1 &&
                       expr.args[1]->number <= static_cast<std::int64_t>(type.args.size());
    if (!fixed) return refuse(source, "a tuple's place that is not a number literal");
    expr.kind = ExprKind::member;
    expr.number = expr.args[1]->number;
    expr.type = type.args[static_cast<std::size_t>(expr.number - 1)];
    expr.args.pop_back();
    return share(std::move(expr));
}

ExprPtr Expressions::record(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::record);
    const Type type = lowering_.system.type(expr.type);
    for (std::size_t i = 0; i < type.labels.size(); ++i) {
        const auto binding = std::find_if(source.bindings.begin(), source.bindings.end(), [&](const ast::Binding& b) {
            return b.variable && b.variable->name == type.labels[i];
        });
        if (binding == source.bindings.end() || !binding->value)
            return refuse(source, "a record without its field " + type.labels[i]);
        expr.args.push_back(lower(*binding->value, type.args[i]));
    }
    return share(std::move(expr));
}

ExprPtr Expressions::matrix(const ast::Expr& source) {
    Expr expr = start(source, ExprKind::matrix);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(operand(source, i));
    const bool vector = lowering_.system.type(expr.type).kind == TypeKind::vector;
    expr.number = vector ? 1 : static_cast<std::int64_t>(source.columns);
    return share(std::move(expr));
}

ExprPtr Expressions::cast(const ast::Expr& source) {
    if (!source.type_expr) return refuse(source, "a cast without a type");
    const TypeId type = lower_type(lowering_, source.type_expr->type, source.span);
    const ExprPtr value = operand(source, 0, type);
    if (value->type == type) return value;
    Expr expr;
    expr.kind = ExprKind::cast;
    expr.span = source.span;
    expr.type = type;
    expr.args = {value};
    return share(std::move(expr));
}

namespace {

/// The clock behind sinceEntry(S), made at its first use.
void need_entry_clock(Machine& machine, NodeId node) {
    for (const auto& clock : machine.clocks)
        if (clock.entry_of == node) return;
    Clock clock;
    clock.name = machine.nodes[node.index].path;
    for (std::size_t at = clock.name.find("::"); at != std::string::npos; at = clock.name.find("::", at))
        clock.name.replace(at, 2, "_");
    clock.entry_of = node;
    clock.origin = machine.nodes[node.index].origin;
    machine.clocks.push_back(std::move(clock));
}

}  // namespace

ExprPtr Expressions::clock(const ast::Expr& source) {
    Expr expr;
    expr.span = source.span;
    expr.type = nat_type;
    if (source.kind == ast::ExprKind::since) {
        expr.kind = ExprKind::since;
        expr.clock = look_up(names_.clocks, source.target);
        if (!expr.clock.valid()) lowering_.unresolved("clock '" + source.name.text() + "'", source.span);
        return share(std::move(expr));
    }
    expr.kind = ExprKind::since_entry;
    expr.node = look_up(names_.nodes, source.target);
    if (expr.node.valid() && names_.machine != nullptr)
        need_entry_clock(*names_.machine, expr.node);
    else
        lowering_.unresolved("state '" + source.name.text() + "'", source.span);
    return share(std::move(expr));
}

}  // namespace robochart::ir
