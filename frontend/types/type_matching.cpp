// SPDX-License-Identifier: Apache-2.0
// Determines the types of type variables in calls of generic functions: matches parameter types with variables `?X`
// against the types of the arguments.
#include "frontend/types/type_algebra.hpp"

namespace robochart::frontend {

namespace {

bool bind_variable(const Type& variable, const TypePtr& actual, TypeBindings& bindings) {
    if (variable.numeric && actual->form != TypeForm::variable && !is_number(actual)) {
        bindings[variable.name] = make_type(TypeForm::real);  // the largest type that would be allowed
        return false;
    }
    const auto [slot, fresh] = bindings.emplace(variable.name, actual);
    if (fresh) return true;
    const TypePtr both = join_types(slot->second, actual);
    if (both) slot->second = both;
    return both != nullptr;
}

bool match_args(const Type& formal, const Type& actual, TypeBindings& bindings) {
    if (formal.args.size() != actual.args.size()) return false;
    for (std::size_t i = 0; i < formal.args.size(); ++i)
        if (!match_types(formal.args[i], actual.args[i], bindings)) return false;
    return true;
}

bool has_variable(const TypePtr& type) {
    if (!type) return false;
    if (type->form == TypeForm::variable) return true;
    for (const TypePtr& arg : type->args)
        if (has_variable(arg)) return true;
    return false;
}

}  // namespace

bool match_types(const TypePtr& written_formal, const TypePtr& written_actual, TypeBindings& bindings) {
    const TypePtr formal = simplify_type(written_formal);
    const TypePtr actual = simplify_type(written_actual);
    if (!formal || !actual || actual->form == TypeForm::any) return true;
    if (formal->form == TypeForm::variable) return bind_variable(*formal, actual, bindings);
    if (!has_variable(formal)) return is_compatible(actual, formal);
    if (formal->form == actual->form) return match_args(*formal, *actual, bindings);
    if (formal->form == TypeForm::set || formal->form == TypeForm::relation) {
        const TypePtr a = as_set(formal);
        const TypePtr b = as_set(actual);
        return a && b && match_types(a->args[0], b->args[0], bindings);
    }
    const TypePtr a = as_product(formal);
    const TypePtr b = as_product(actual);
    return a && b && match_args(*a, *b, bindings);
}

TypePtr substitute_variables(const TypePtr& type, const TypeBindings& bindings) {
    if (!type) return nullptr;
    if (type->form == TypeForm::variable) {
        const auto bound = bindings.find(type->name);
        if (bound != bindings.end()) return bound->second;
        return make_type(type->numeric ? TypeForm::nat : TypeForm::any);
    }
    if (!has_variable(type)) return type;
    auto result = std::make_shared<Type>(*type);
    for (TypePtr& arg : result->args) arg = substitute_variables(arg, bindings);
    return result;
}

}  // namespace robochart::frontend
