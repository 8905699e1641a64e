// SPDX-License-Identifier: Apache-2.0
// Lowers calls, parts of composed values, casts and clocks.
#include <algorithm>
#include <array>

#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/types.hpp"

namespace robochart::ir {

namespace {

constexpr std::array toolkits{"set_toolkit", "relation_toolkit", "function_toolkit", "sequence_toolkit", "core"};

}  // namespace

/// Lowers the application of a function value, or of a sequence, which is a function from positions to elements.
ExprPtr Expressions::lower_application(const ast::Expr& source, ExprPtr function) {
    const Type type = lowering_.system.type(function->type);
    Expr expr = start_node(source, type.kind == TypeKind::sequence ? ExprKind::index : ExprKind::apply);
    std::vector<TypeId> operand_types(source.args.size());
    if (type.kind == TypeKind::function) {
        const Type& argument = lowering_.system.type(type.args.at(0));
        if (operand_types.size() == 1)
            operand_types = {type.args[0]};
        else if (argument.args.size() == operand_types.size())
            operand_types = argument.args;
        expr.type = type.args.at(1);
    }
    expr.args.push_back(std::move(function));
    for (std::size_t i = 0; i < source.args.size(); ++i)
        expr.args.push_back(lower_operand(source, i, operand_types[i]));
    return share_expression(std::move(expr));
}

ExprPtr Expressions::function_call(const ast::Expr& source, const ast::Function& function) {
    Expr expr;
    expr.kind = ExprKind::call;
    expr.span = source.span;
    expr.text = function.name;
    expr.function = lower_function(lowering_, function, source.span);
    if (!expr.function.is_valid()) return make_boolean(true, source.span);
    expr.type = lower_type(lowering_, function.result, source.span);
    for (std::size_t i = 0; i < source.args.size(); ++i) {
        const bool typed = i < function.parameters.size();
        const TypeId type = typed ? lower_type(lowering_, function.parameters[i]->type, source.span) : TypeId{};
        expr.args.push_back(lower_operand(source, i, type));
    }
    return share_expression(std::move(expr));
}

/// Returns the function as a set of pairs.
ExprPtr Expressions::function_value(const ast::Expr& source, const ast::Function& function) {
    if (std::ranges::find(toolkits, lowering_.package_of(function)) != toolkits.end())
        return reject_construct(source,
                                "function " + function.name + " of " + lowering_.package_of(function) + " as a value");
    Expr expr;
    expr.kind = ExprKind::function_value;
    expr.span = source.span;
    expr.text = function.name;
    expr.function = lower_function(lowering_, function, source.span);
    if (!expr.function.is_valid()) return make_boolean(true, source.span);
    Type type;
    type.kind = TypeKind::function;
    const Function& lowered = lowering_.system.functions[expr.function.index];
    TypeId argument;
    if (lowered.parameters.size() == 1) {
        argument = lowered.parameters[0];
    } else {
        Type product;
        product.kind = TypeKind::product;
        product.args = lowered.parameters;
        argument = intern_type(lowering_, std::move(product));
    }
    type.args = {argument, lowering_.system.functions[expr.function.index].result};
    expr.type = intern_type(lowering_, std::move(type));
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_call(const ast::Expr& source, TypeId expected) {
    if (source.callee) return lower_application(source, lower(*source.callee));
    if (source.target == nullptr) {
        lowering_.report_unresolved("'" + source.name.text() + "'", source.span);
        return make_boolean(true, source.span);
    }
    if (source.target->kind == ast::DeclKind::function) {
        const auto& function = static_cast<const ast::Function&>(*source.target);
        const std::string package = lowering_.package_of(function);
        const bool library = std::ranges::find(toolkits, package) != toolkits.end();
        if (library) return toolkit_call(source, function, expected);
        return is_generic(function) ? generic_call(source, function, expected) : function_call(source, function);
    }
    if (source.target->kind == ast::DeclKind::enum_literal)
        return enum_literal(source, static_cast<const ast::EnumLiteral&>(*source.target));
    ast::Expr callee;
    callee.kind = ast::ExprKind::name;
    callee.span = source.name.span;
    callee.target = source.target;
    return lower_application(source, name(callee, {}));
}

ExprPtr Expressions::lower_member(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::member);
    expr.args = {lower_operand(source, 0)};
    const Type& type = lowering_.system.type(expr.args[0]->type);
    const auto at = std::ranges::find(type.labels, source.text);
    if (type.kind != TypeKind::record || at == type.labels.end()) {
        lowering_.report_unresolved("field '" + source.text + "'", source.span);
        return share_expression(std::move(expr));
    }
    expr.number = at - type.labels.begin();
    expr.text = source.text;
    expr.type = type.args[static_cast<std::size_t>(expr.number)];
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_index(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::index);
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(lower_operand(source, i));
    const Type& type = lowering_.system.type(expr.args[0]->type);
    if (type.kind != TypeKind::product) return share_expression(std::move(expr));
    const bool fixed = expr.args.size() == 2 && expr.args[1]->kind == ExprKind::integer && expr.args[1]->number >= 1 &&
                       expr.args[1]->number <= static_cast<std::int64_t>(type.args.size());
    if (!fixed) return reject_construct(source, "a tuple's place that is not a number literal");
    expr.kind = ExprKind::member;
    expr.number = expr.args[1]->number;
    expr.type = type.args[static_cast<std::size_t>(expr.number - 1)];
    expr.args.pop_back();
    return share_expression(std::move(expr));
}

/// Returns the default value of a type as an expression (semantics 3.6), or null if no literal denotes it (functions,
/// given types).
ExprPtr Expressions::default_of(const ast::Expr& source, TypeId id) {
    const Type type = lowering_.system.type(id);
    Expr expr;
    expr.span = source.span;
    expr.type = id;
    switch (type.kind) {
        case TypeKind::boolean:
            return make_boolean(true, source.span);
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real: {
            expr.kind = ExprKind::integer;
            expr.type = nat_type;
            return coerce_to_type(lowering_, share_expression(std::move(expr)), id);
        }
        case TypeKind::enumeration:
            if (!type.literal_args.empty() && !type.literal_args.front().empty()) return nullptr;
            expr.kind = ExprKind::enum_literal;
            expr.text = type.labels.front();
            return share_expression(std::move(expr));
        case TypeKind::set:
        case TypeKind::sequence:
            expr.kind = type.kind == TypeKind::set ? ExprKind::set : ExprKind::sequence;
            return share_expression(std::move(expr));
        case TypeKind::record:
        case TypeKind::product:
            expr.kind = type.kind == TypeKind::record ? ExprKind::record : ExprKind::tuple;
            for (const TypeId part : type.args) {
                expr.args.push_back(default_of(source, part));
                if (!expr.args.back()) return nullptr;
            }
            return share_expression(std::move(expr));
        case TypeKind::string:
        case TypeKind::given:
        case TypeKind::function:
        case TypeKind::relation:
        case TypeKind::vector:
        case TypeKind::matrix:
        case TypeKind::unit:
            break;
    }
    return nullptr;
}

/// Lowers a record. A missing field gets the default value of its type.
ExprPtr Expressions::lower_record(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::record);
    const Type type = lowering_.system.type(expr.type);
    for (std::size_t i = 0; i < type.labels.size(); ++i) {
        const auto binding = std::ranges::find_if(
            source.bindings, [&](const ast::Binding& b) { return b.variable && b.variable->name == type.labels[i]; });
        if (binding == source.bindings.end() || !binding->value) {
            expr.args.push_back(default_of(source, type.args[i]));
            if (!expr.args.back()) return reject_construct(source, "a record without its field " + type.labels[i]);
            continue;
        }
        expr.args.push_back(lower(*binding->value, type.args[i]));
    }
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_matrix(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::matrix);
    const Type& type = lowering_.system.type(expr.type);
    const bool vector = type.kind == TypeKind::vector;
    const TypeId element = type.args.empty() ? TypeId{} : type.args[0];
    for (std::size_t i = 0; i < source.args.size(); ++i) expr.args.push_back(lower_operand(source, i, element));
    expr.number = vector ? 1 : static_cast<std::int64_t>(source.columns);
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_cast(const ast::Expr& source) {
    if (!source.type_expr) return reject_construct(source, "a cast without a type");
    const TypeId type = lower_type(lowering_, source.type_expr->type, source.span);
    const ExprPtr value = lower_operand(source, 0, type);
    if (value->type == type) return value;
    Expr expr;
    expr.kind = ExprKind::cast;
    expr.span = source.span;
    expr.type = type;
    expr.args = {value};
    return share_expression(std::move(expr));
}

ExprPtr Expressions::type_test(const ast::Expr& source) {
    if (!source.type_expr) return reject_construct(source, "a type test without a type");
    Expr expr = start_node(source, ExprKind::is_type);
    expr.type = boolean_type;
    expr.args = {lower_operand(source, 0)};
    expr.bound_names = {""};
    expr.bound_types = {lower_type(lowering_, source.type_expr->type, source.span)};
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_range(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::range);
    const auto element = lowering_.system.type(expr.type).args;
    for (std::size_t i = 0; i < 2; ++i)
        expr.args.push_back(lower_operand(source, i, element.empty() ? TypeId{} : element[0]));
    expr.number = (source.lower_closed ? 0 : 1) + (source.upper_closed ? 0 : 2);
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_transpose(const ast::Expr& source) {
    Expr expr = start_node(source, ExprKind::transpose);
    expr.args = {lower_operand(source, 0)};
    return share_expression(std::move(expr));
}

namespace {

/// Returns the text between the quotes. A backslash escapes the next character. An escaped `n` denotes a line end, and
/// an escaped `t` a tabulator.
std::string remove_quotes(const std::string& written) {
    std::string text;
    for (std::size_t i = 1; i + 1 < written.size(); ++i) {
        const bool escaped = written[i] == '\\' && i + 2 < written.size();
        if (escaped) ++i;
        if (escaped && written[i] == 'n')
            text += '\n';
        else if (escaped && written[i] == 't')
            text += '\t';
        else
            text += written[i];
    }
    return text;
}

}  // namespace

ExprPtr Expressions::lower_string(const ast::Expr& source) {
    Expr expr;
    expr.kind = ExprKind::string;
    expr.type = string_type;
    expr.characters = remove_quotes(source.text);
    expr.span = source.span;
    return share_expression(std::move(expr));
}

ExprPtr Expressions::lower_result(const ast::Expr& source) {
    if (!names_.result.is_valid()) return reject_construct(source, "result outside a postcondition");
    Expr expr;
    expr.kind = ExprKind::bound;
    expr.type = names_.result;
    expr.text = "result";
    expr.span = source.span;
    return share_expression(std::move(expr));
}

namespace {

/// Adds the clock of sinceEntry(S) at its first use.
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

ExprPtr Expressions::lower_clock(const ast::Expr& source) {
    Expr expr;
    expr.span = source.span;
    expr.type = nat_type;
    if (source.kind == ast::ExprKind::since) {
        expr.kind = ExprKind::since;
        expr.clock = look_up(names_.clocks, source.target);
        if (!expr.clock.is_valid()) lowering_.report_unresolved("clock '" + source.name.text() + "'", source.span);
        return share_expression(std::move(expr));
    }
    expr.kind = ExprKind::since_entry;
    expr.node = look_up(names_.nodes, source.target);
    if (expr.node.is_valid() && names_.machine != nullptr)
        need_entry_clock(*names_.machine, expr.node);
    else
        lowering_.report_unresolved("state '" + source.name.text() + "'", source.span);
    return share_expression(std::move(expr));
}

}  // namespace robochart::ir
