// SPDX-License-Identifier: Apache-2.0
// Converts the type expressions of the source text to semantic types.
#include <array>
#include <charconv>

#include "frontend/rules/rules.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/types/typer.hpp"

namespace robochart::frontend {

namespace {

/// Returns the types of package core, which are always visible.
TypePtr core_type(std::string_view name) {
    constexpr std::array<std::pair<std::string_view, TypeForm>, 5> core = {{{"nat", TypeForm::nat},
                                                                            {"int", TypeForm::integer},
                                                                            {"real", TypeForm::real},
                                                                            {"boolean", TypeForm::boolean},
                                                                            {"string", TypeForm::string}}};
    for (const auto& [word, form] : core)
        if (word == name) return make_type(form);
    return nullptr;
}

long read_number(const std::string& digits) {
    long value = -1;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

}  // namespace

TypePtr Typer::declared_type(const TypeDeclaration& declaration) const {
    auto type = std::make_shared<Type>();
    type->form = TypeForm::given;
    if (declaration.kind == DeclKind::enumeration) type->form = TypeForm::enumeration;
    if (declaration.kind == DeclKind::record_type) type->form = TypeForm::record;
    type->name = finder_.names().type_name(declaration);
    type->declaration = &declaration;
    return type;
}

TypePtr Typer::named_type(TypeExpr& written, Surroundings& around) {
    const Kinds kinds = {DeclKind::primitive_type, DeclKind::record_type, DeclKind::enumeration};
    const bool may_be_core =
        written.name.parts.size() == 1 || (written.name.parts.size() == 2 && written.name.parts[0] == "core");
    const TypePtr core = may_be_core ? core_type(written.name.parts.back()) : nullptr;
    if (core) {
        const QualifiedName full{{"core", written.name.parts.back()}, {}, written.name.span};
        written.target = finder_.names().find({}, full, {DeclKind::primitive_type});
        return core;
    }
    written.target = finder_.find(around.place, written.name, kinds, "type");
    return written.target != nullptr ? declared_type(static_cast<const TypeDeclaration&>(*written.target)) : nullptr;
}

/// Resolves the size of a vector or matrix: a literal or a constant. Sets `value` if the size is a literal or the
/// constant has a literal value.
void Typer::size(Expr& expr, Surroundings& around, long& value) {
    const TypePtr type = this->assign_type(expr, around);
    const Expr& inner = strip_parentheses(expr);
    const auto* constant = inner.kind == ExprKind::name ? dynamic_cast<const Variable*>(inner.target) : nullptr;
    const bool is_constant = constant != nullptr && constant->kind != DeclKind::variable;
    if (inner.kind == ExprKind::integer) value = read_number(inner.text);
    if (is_constant && constant->initial && constant->initial->kind == ExprKind::integer)
        value = read_number(constant->initial->text);
    const bool whole = type && (type->form == TypeForm::nat || type->form == TypeForm::integer);
    const bool sensible = whole && value != 0 && (inner.kind == ExprKind::integer || is_constant);
    if (type && !sensible) finder_.out().report(rules::size_value, expr.span, {to_text(expr)});
}

TypePtr Typer::assign_type(TypeExpr& written, Surroundings& around) {
    std::vector<TypePtr> args;
    for (const auto& arg : written.args) args.push_back(assign_type(*arg, around));
    std::vector<long> sizes;
    for (const ExprPtr& size : written.sizes) this->size(*size, around, sizes.emplace_back(-1));
    for (const TypePtr& arg : args)
        if (!arg) return nullptr;
    constexpr std::array<std::pair<TypeKind, TypeForm>, 5> forms = {{{TypeKind::sequence, TypeForm::sequence},
                                                                     {TypeKind::set, TypeForm::set},
                                                                     {TypeKind::product, TypeForm::product},
                                                                     {TypeKind::function, TypeForm::function},
                                                                     {TypeKind::relation, TypeForm::relation}}};
    for (const auto& [kind, form] : forms)
        if (kind == written.kind) written.type = make_type(form, args);
    if (written.kind == TypeKind::name) written.type = named_type(written, around);
    if (written.kind == TypeKind::vector) written.type = make_vector(args[0], sizes[0]);
    if (written.kind == TypeKind::matrix) written.type = make_matrix(args[0], sizes[0], sizes[1]);
    if (written.kind == TypeKind::variable) {
        auto variable = std::make_shared<Type>();
        variable->form = TypeForm::variable;
        variable->name = written.name.text();
        variable->numeric = around.place.file != nullptr && around.place.file->is_library && variable->name == "Number";
        written.type = variable;
    }
    return written.type;
}

}  // namespace robochart::frontend
