// SPDX-License-Identifier: Apache-2.0
// Interns types: equal structures get the same id.
#include "semantics/lower/types.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "semantics/rules.hpp"

namespace robochart::ir {
namespace {

using frontend::TypeForm;

constexpr std::int64_t largest_size = 64;  // limit on rows and columns; larger matrices have too many values to explore

std::string key_of(const Type& type) {
    std::string key = std::to_string(static_cast<int>(type.kind));
    const bool declared =
        type.kind == TypeKind::enumeration || type.kind == TypeKind::given || type.kind == TypeKind::record;
    if (declared) return key + "|" + type.package + "::" + type.name;
    for (const auto arg : type.args) key += "," + std::to_string(arg.index);
    for (const auto size : type.sizes) key += "#" + std::to_string(size);
    return key;
}

TypeKind kind_of(TypeForm form) {
    switch (form) {
        case TypeForm::boolean:
            return TypeKind::boolean;
        case TypeForm::nat:
            return TypeKind::nat;
        case TypeForm::integer:
            return TypeKind::integer;
        case TypeForm::real:
            return TypeKind::real;
        case TypeForm::string:
            return TypeKind::string;
        case TypeForm::given:
            return TypeKind::given;
        case TypeForm::enumeration:
            return TypeKind::enumeration;
        case TypeForm::record:
            return TypeKind::record;
        case TypeForm::sequence:
            return TypeKind::sequence;
        case TypeForm::set:
            return TypeKind::set;
        case TypeForm::product:
            return TypeKind::product;
        case TypeForm::function:
            return TypeKind::function;
        case TypeForm::relation:
            return TypeKind::relation;
        case TypeForm::vector:
            return TypeKind::vector;
        case TypeForm::matrix:
            return TypeKind::matrix;
        case TypeForm::any:
        case TypeForm::variable:
            break;
    }
    return TypeKind::unit;
}

void add_literals(Lowering& lowering, const frontend::TypeDeclaration& declaration, Type& type) {
    if (type.kind == TypeKind::enumeration && declaration.literals.empty())
        lowering.diagnostics.report(rules::no_literals, declaration.name_span, {declaration.name});
    lowering.check_unique(pointers(declaration.literals), declaration.name, "literal");
    for (const auto& literal : declaration.literals) {
        type.labels.push_back(literal->name);
        auto& args = type.literal_args.emplace_back();
        for (const auto& argument : literal->arguments)
            args.push_back(lower_type(lowering, argument->type, argument->span));
    }
}

void add_fields(Lowering& lowering, const frontend::TypeDeclaration& declaration, Type& type) {
    lowering.check_unique(pointers(declaration.fields), declaration.name, "field");
    for (const auto& field : declaration.fields) {
        type.labels.push_back(field->name);
        type.args.push_back(lower_type(lowering, field->type, field->span));
    }
}

TypeKind kind_of(const frontend::TypeDeclaration& declaration) {
    if (declaration.kind == frontend::DeclKind::enumeration) return TypeKind::enumeration;
    return declaration.kind == frontend::DeclKind::record_type ? TypeKind::record : TypeKind::given;
}

/// Returns the type as RoboChart writes it, with "?" for an unknown part.
std::string type_as_written(const System& system, const Type& type) {
    const auto part = [&](std::size_t i) {
        const Type& found = system.type(type.args.at(i));
        return found.kind == TypeKind::unit || found.name.empty() ? std::string("?") : found.name;
    };
    const auto operand = [&](std::size_t i) {
        const TypeKind kind = system.type(type.args.at(i)).kind;
        const bool loose = kind == TypeKind::product || kind == TypeKind::function || kind == TypeKind::relation;
        return loose ? "(" + part(i) + ")" : part(i);
    };
    switch (type.kind) {
        case TypeKind::sequence:
            return "Seq(" + part(0) + ")";
        case TypeKind::set:
            return "Set(" + part(0) + ")";
        case TypeKind::function:
            return operand(0) + " -> " + operand(1);
        case TypeKind::relation:
            return operand(0) + " <-> " + operand(1);
        case TypeKind::product: {
            std::string text;
            for (std::size_t i = 0; i < type.args.size(); ++i) text += (i > 0 ? " * " : "") + operand(i);
            return text;
        }
        case TypeKind::vector:
            return fmt::format("vector({}, {})", part(0), type.sizes.at(0));
        case TypeKind::matrix:
            return fmt::format("matrix({}, {}, {})", part(0), type.sizes.at(0), type.sizes.at(1));
        case TypeKind::boolean:
        case TypeKind::nat:
        case TypeKind::integer:
        case TypeKind::real:
        case TypeKind::string:
        case TypeKind::enumeration:
        case TypeKind::given:
        case TypeKind::record:
        case TypeKind::unit:
            break;
    }
    return type.name;
}

TypeId add(Lowering& lowering, Type type) {
    if (type.name.empty()) type.name = type_as_written(lowering.system, type);
    const TypeId id{static_cast<std::uint32_t>(lowering.system.types.size())};
    lowering.types.emplace(key_of(type), id);
    lowering.system.types.push_back(std::move(type));
    return id;
}

}  // namespace

void intern_core_types(Lowering& lowering) {
    constexpr std::pair<TypeKind, const char*> core[] = {{TypeKind::boolean, "boolean"},
                                                         {TypeKind::nat, "nat"},
                                                         {TypeKind::integer, "int"},
                                                         {TypeKind::real, "real"},
                                                         {TypeKind::string, "string"}};
    for (const auto& [kind, name] : core) {
        Type type;
        type.kind = kind;
        type.name = name;
        type.origin.element = name;
        add(lowering, std::move(type));
    }
}

TypeId intern_type(Lowering& lowering, Type type) {
    const auto known = lowering.types.find(key_of(type));
    return known != lowering.types.end() ? known->second : add(lowering, std::move(type));
}

TypeId lower_declared_type(Lowering& lowering, const frontend::TypeDeclaration& declaration, diagnostics::Span where) {
    const auto known = lowering.declared_types.find(&declaration);
    if (known != lowering.declared_types.end()) {
        if (!known->second.is_valid())
            lowering.report_unsupported("type " + declaration.name + ", which contains itself", where);
        return known->second.is_valid() ? known->second : nat_type;
    }
    lowering.declared_types[&declaration] = TypeId{};  // the type is in progress
    Type type;
    type.kind = kind_of(declaration);
    type.name = declaration.name;
    type.package = lowering.package_of(declaration);
    type.origin = origin_of(declaration.name, declaration.span);
    add_literals(lowering, declaration, type);
    add_fields(lowering, declaration, type);
    return lowering.declared_types[&declaration] = intern_type(lowering, std::move(type));
}

TypeId lower_type(Lowering& lowering, const frontend::TypePtr& source, diagnostics::Span where) {
    if (!source) {
        lowering.report_unresolved("a type", where);
        return nat_type;
    }
    if (source->declaration != nullptr) return lower_declared_type(lowering, *source->declaration, where);
    if (source->form == TypeForm::variable && lowering.type_variables.contains(source->name))
        return lowering.type_variables.at(source->name);
    if (source->form == TypeForm::variable) {
        lowering.report_unsupported("type variable ?" + source->name, where);
        return nat_type;
    }
    // The front end types the argument of a function with one parameter as a product of one.
    if (source->form == TypeForm::product && source->args.size() == 1)
        return lower_type(lowering, source->args[0], where);
    Type type;
    type.kind = kind_of(source->form);
    type.name = source->form == TypeForm::any ? "" : frontend::to_string(source);
    for (const auto& arg : source->args) type.args.push_back(lower_type(lowering, arg, where));
    for (const auto size : source->sizes) type.sizes.push_back(size);
    type.origin.element = type.name;
    const bool sized =
        std::ranges::all_of(type.sizes, [](std::int64_t size) { return size >= 1 && size <= largest_size; });
    if (!sized) {
        lowering.report_unsupported("type " + type.name + " of this size", where);
        return nat_type;
    }
    return intern_type(lowering, std::move(type));
}

TypeId wider_type(TypeId a, TypeId b) {
    if (!is_number(a) || !is_number(b)) return a;
    return std::max(a, b);  // nat < int < real by id
}

bool is_open(const System& system, TypeId id) {
    if (!id.is_valid() || system.type(id).kind == TypeKind::unit) return true;
    const Type& type = system.type(id);
    return type.kind != TypeKind::record &&
           std::ranges::any_of(type.args, [&](TypeId arg) { return is_open(system, arg); });
}

TypeId common_type(Lowering& lowering, TypeId a, TypeId b) {
    if (!a.is_valid() || lowering.system.type(a).kind == TypeKind::unit) return b;
    if (a == b || !b.is_valid() || lowering.system.type(b).kind == TypeKind::unit) return a;
    if (is_number(a) && is_number(b)) return wider_type(a, b);
    const Type left = lowering.system.type(a);
    const Type right = lowering.system.type(b);
    if (left.kind == TypeKind::sequence && is_set_like(right.kind)) return b;
    if (left.kind != right.kind || left.args.size() != right.args.size() || left.kind == TypeKind::record) return a;
    Type type = left;
    type.name.clear();
    for (std::size_t i = 0; i < left.args.size(); ++i)
        type.args[i] = common_type(lowering, left.args[i], right.args[i]);
    return intern_type(lowering, std::move(type));
}

bool is_number(TypeId id) {
    return id == nat_type || id == integer_type || id == real_type;
}

}  // namespace robochart::ir
