// SPDX-License-Identifier: Apache-2.0
// Computes the types of calls (of functions, literals and function values) and of parts of tuples, vectors and records.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "base/diagnostics/spelling.hpp"
#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

TypePtr Typer::check_call(Expr& expr, Surroundings& around) {
    TypePtr callee;
    if (expr.callee) {
        callee = assign_type(*expr.callee, around);
    } else {
        expr.target = value_named(expr.name, around);
        if (expr.target == nullptr) unknown_value(expr.name, around);
    }
    std::vector<TypePtr> args;
    for (const ExprPtr& arg : expr.args) args.push_back(assign_type(arg, around));
    if (const auto* function = dynamic_cast<const Function*>(expr.target)) return call_function(expr, *function, args);
    if (const auto* literal = dynamic_cast<const EnumLiteral*>(expr.target)) return call_literal(expr, *literal, args);
    if (const auto* variable = dynamic_cast<const Variable*>(expr.target)) callee = variable->type;
    if (!callee) return nullptr;
    return apply(expr, simplify_type(callee), args, expr.callee ? to_text(*expr.callee) : expr.name.text());
}

TypePtr Typer::call_function(Expr& expr, const Function& function, const std::vector<TypePtr>& args) {
    const std::size_t expected = function.parameters.size();
    if (args.size() != expected) {
        finder_.out()
            .report(rules::function_count, expr.span,
                    {function.name, std::to_string(expected), plural(expected), std::to_string(args.size())})
            .notes.push_back({function.name_span, "the function is declared here"});
        return nullptr;
    }
    TypeBindings bindings;
    for (std::size_t i = 0; i < expected; ++i) {
        if (match_types(function.parameters[i]->type, args[i], bindings)) continue;
        finder_.out().report(
            rules::function_type, expr.args[i]->span,
            {std::to_string(i + 1), function.name,
             to_string(substitute_variables(function.parameters[i]->type, bindings)), to_string(args[i])});
    }
    return substitute_variables(function.result, bindings);
}

TypePtr Typer::call_literal(Expr& expr, const EnumLiteral& literal, const std::vector<TypePtr>& args) {
    const std::size_t expected = literal.arguments.size();
    if (expected == 0 && args.empty()) finder_.out().report(rules::literal_bare, expr.span, {literal.name});
    if (args.size() != expected)
        finder_.out().report(rules::literal_count, expr.span,
                             {literal.name, std::to_string(expected), plural(expected), std::to_string(args.size())});
    for (std::size_t i = 0; i < std::min(expected, args.size()); ++i)
        if (args[i] && !is_compatible(args[i], literal.arguments[i]->type))
            finder_.out().report(
                rules::literal_type, expr.args[i]->span,
                {std::to_string(i + 1), literal.name, to_string(literal.arguments[i]->type), to_string(args[i])});
    return declared_type(static_cast<const TypeDeclaration&>(*literal.parent));
}

/// Applies a function value, or a sequence, which is a function from positions to elements.
TypePtr Typer::apply(Expr& expr, const TypePtr& function, const std::vector<TypePtr>& args, const std::string& name) {
    if (function->form == TypeForm::any || function->form == TypeForm::variable) return nullptr;
    const bool is_function = function->form == TypeForm::function;
    const bool is_sequence = function->form == TypeForm::sequence;
    if (!is_function && !is_sequence) {
        finder_.out().report(rules::not_callable, expr.span, {name, to_string(function)});
        return nullptr;
    }
    const TypePtr formal = is_function ? function->args[0] : make_type(TypeForm::nat);
    const TypePtr actual = make_type(TypeForm::product, args);
    const bool typed = std::ranges::all_of(args, [](const TypePtr& arg) { return arg != nullptr; });
    TypeBindings bindings;
    if (typed && !match_types(formal, actual, bindings))
        finder_.out().report(rules::function_type, expr.span, {"list", name, to_string(formal), to_string(actual)});
    return is_function ? substitute_variables(function->args[1], bindings) : function->args[0];
}

// ---------------------------------------------------------------- parts

TypePtr Typer::type_member(Expr& expr, Surroundings& around) {
    const TypePtr owner = simplify_type(assign_type(expr.args[0], around));
    if (!owner) return nullptr;
    std::vector<std::string> fields;
    if (owner->form == TypeForm::record)
        for (const VariablePtr& field : owner->declaration->fields) {
            if (field->name == expr.text) {
                expr.target = field.get();
                return field->type;
            }
            fields.push_back(field->name);
        }
    auto& finding = finder_.out().report(rules::no_field, expr.span, {to_string(owner), expr.text});
    const std::string meant = diagnostics::nearest_spelling(expr.text, fields);
    const auto written = static_cast<std::uint32_t>(expr.text.size());
    if (!meant.empty())
        finding.fixes.push_back(
            {{expr.span.source, expr.span.end - written, expr.span.end}, meant, diagnostics::suggestion_verb(false)});
    return nullptr;
}

TypePtr Typer::type_index(Expr& expr, Surroundings& around) {
    const TypePtr owner = simplify_type(assign_type(expr.args[0], around));
    for (std::size_t i = 1; i < expr.args.size(); ++i) assign_type(expr.args[i], around);
    if (!owner || owner->form == TypeForm::any) return nullptr;
    const std::size_t given = expr.args.size() - 1;
    const std::size_t expected = owner->form == TypeForm::matrix ? 2 : 1;
    const bool parts = owner->form == TypeForm::product || owner->form == TypeForm::sequence ||
                       owner->form == TypeForm::vector || owner->form == TypeForm::matrix;
    if (!parts) {
        finder_.out().report(rules::not_indexable, expr.span, {to_string(owner)});
        return nullptr;
    }
    if (given != expected) {
        finder_.out().report(
            rules::index_count, expr.span,
            {to_string(owner), std::to_string(expected), expected == 1 ? "ex" : "ices", std::to_string(given)});
        return nullptr;
    }
    if (owner->form == TypeForm::product) return tuple_part(expr, owner);
    check_indices(expr);
    return owner->args[0];
}

void Typer::check_indices(const Expr& expr) {
    for (std::size_t i = 1; i < expr.args.size(); ++i) {
        const TypePtr place = simplify_type(expr.args[i]->type);
        if (place && !is_compatible(place, make_type(TypeForm::integer)))
            finder_.out().report(rules::index_type, expr.args[i]->span, {to_string(place)});
    }
}

/// Computes the type of a part of a tuple. The index must be a literal, because the parts have different types.
TypePtr Typer::tuple_part(Expr& expr, const TypePtr& tuple) {
    const Expr& place = strip_parentheses(*expr.args[1]);
    std::size_t number = 0;
    if (place.kind == ExprKind::integer)
        std::from_chars(place.text.data(), place.text.data() + place.text.size(), number);
    if (number >= 1 && number <= tuple->args.size()) return tuple->args[number - 1];
    finder_.out().report(rules::tuple_index, expr.args[1]->span,
                         {std::to_string(tuple->args.size()), to_text(*expr.args[1])});
    return nullptr;
}

TypePtr Typer::type_record(Expr& expr, Surroundings& around) {
    expr.target = finder_.find(around.place, expr.name, {DeclKind::record_type}, "datatype");
    for (Binding& binding : expr.bindings) assign_type(binding.value, around);
    const auto* declaration = static_cast<const TypeDeclaration*>(expr.target);
    if (declaration == nullptr) return nullptr;
    for (const Binding& binding : expr.bindings) {
        const auto& fields = declaration->fields;
        const auto found =
            std::ranges::find_if(fields, [&](const VariablePtr& f) { return f->name == binding.variable->name; });
        if (found == fields.end()) {
            finder_.out().report(rules::no_field, binding.variable->name_span,
                                 {declaration->name, binding.variable->name});
        } else if (binding.value->type && (*found)->type && !is_compatible(binding.value->type, (*found)->type)) {
            finder_.out().report(rules::field_type, binding.value->span,
                                 {(*found)->name, to_string((*found)->type), to_string(binding.value->type)});
        }
    }
    std::vector<std::string> missing;
    for (const VariablePtr& field : declaration->fields)
        if (std::ranges::none_of(expr.bindings, [&](const Binding& b) { return b.variable->name == field->name; }))
            missing.push_back("`" + field->name + "`");
    if (!missing.empty())
        finder_.out().report(rules::field_missing, expr.span,
                             {declaration->name, plural(missing.size()), fmt::format("{}", fmt::join(missing, ", "))});
    return declared_type(*declaration);
}

}  // namespace robochart::frontend
