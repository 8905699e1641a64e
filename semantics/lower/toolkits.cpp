// SPDX-License-Identifier: Apache-2.0
// Lowers calls of the toolkit libraries. The types of the function's type variables follow from the arguments or, if
// the arguments do not determine them, from the expected type.
#include <algorithm>
#include <map>

#include "semantics/lower/expression_lowering.hpp"
#include "semantics/lower/lower.hpp"
#include "semantics/lower/types.hpp"

namespace robochart::ir {
namespace {

using ast::TypeForm;

/// The types of type variables.
class Bindings {
public:
    explicit Bindings(Lowering& lowering) : lowering_(lowering) {}

    /// Binds the type variables of the formal type. A later binding of a variable widens an earlier one.
    void bind_variables(const ast::TypePtr& formal, TypeId actual);
    /// Binds the variables that are still open.
    void bind_remaining(const ast::TypePtr& formal, TypeId actual) {
        const auto before = types_;
        bind_variables(formal, actual);
        for (const auto& [name, type] : before)
            if (!is_open(lowering_.system, type)) types_[name] = type;
    }
    /// Binds unbound number types, as in min({}), to nat, which every number type includes.
    void complete_numbers(const ast::TypePtr& formal);
    /// Returns the formal type with its variables replaced. Unbound variables become the unit type.
    TypeId instantiate_type(const ast::TypePtr& formal);
    std::vector<TypeId> in_order(const ast::Function& function);
    /// Returns the types of all variables of the signature, by name.
    std::map<std::string, TypeId> by_name(const ast::Function& function);

private:
    const Type& type_at(TypeId id) const { return lowering_.system.type(id); }
    TypeId composed_type(TypeKind kind, std::vector<TypeId> args, std::vector<std::int64_t> sizes = {});
    std::vector<TypeId> pair_of(TypeId set_like) const;
    TypeId element_of(TypeId set_like);
    void bind_parts(const std::vector<ast::TypePtr>& formal, const std::vector<TypeId>& actual);
    std::vector<std::string> names_of(const ast::Function& function) const;
    void collect_variables(const ast::TypePtr& formal, std::vector<std::string>& names) const;

    Lowering& lowering_;
    std::map<std::string, TypeId> types_;
};

TypeId Bindings::composed_type(TypeKind kind, std::vector<TypeId> args, std::vector<std::int64_t> sizes) {
    if (kind == TypeKind::product && args.size() == 1) return args[0];
    Type result;
    result.kind = kind;
    result.args = std::move(args);
    result.sizes = std::move(sizes);
    return intern_type(lowering_, std::move(result));
}

/// Returns the two types of a relation, function, sequence or set of pairs, or an empty result for other types.
std::vector<TypeId> Bindings::pair_of(TypeId id) const {
    const Type& found = type_at(id);
    if (found.kind == TypeKind::relation || found.kind == TypeKind::function) return found.args;
    if (found.kind == TypeKind::sequence) return {nat_type, found.args.at(0)};
    if (found.kind != TypeKind::set) return {};
    const Type& element = type_at(found.args.at(0));
    if (element.kind == TypeKind::product && element.args.size() == 2) return element.args;
    if (element.kind == TypeKind::vector && element.sizes.at(0) == 2) return {element.args[0], element.args[0]};
    return {};
}

TypeId Bindings::element_of(TypeId id) {
    if (type_at(id).kind == TypeKind::set) return type_at(id).args.at(0);
    const auto pair = pair_of(id);
    return pair.empty() ? TypeId{} : composed_type(TypeKind::product, pair);
}

void Bindings::bind_parts(const std::vector<ast::TypePtr>& formal, const std::vector<TypeId>& actual) {
    for (std::size_t i = 0; i < std::min(formal.size(), actual.size()); ++i) bind_variables(formal[i], actual[i]);
}

void Bindings::bind_variables(const ast::TypePtr& formal, TypeId actual) {
    if (!formal || !actual.is_valid() || type_at(actual).kind == TypeKind::unit) return;
    switch (formal->form) {
        case TypeForm::variable:
            if (formal->numeric && !is_number(actual)) break;
            types_[formal->name] = common_type(lowering_, types_[formal->name], actual);
            break;
        case TypeForm::set:
            bind_variables(formal->args[0], element_of(actual));
            break;
        case TypeForm::relation:
        case TypeForm::function:
            bind_parts(formal->args, pair_of(actual));
            break;
        case TypeForm::product:
            if (formal->args.size() == 1)
                bind_variables(formal->args[0], actual);
            else if (type_at(actual).kind == TypeKind::vector)
                bind_parts(formal->args, std::vector<TypeId>(formal->args.size(), type_at(actual).args.at(0)));
            else
                bind_parts(formal->args, type_at(actual).args);
            break;
        case TypeForm::any:
        case TypeForm::boolean:
        case TypeForm::nat:
        case TypeForm::integer:
        case TypeForm::real:
        case TypeForm::string:
        case TypeForm::given:
        case TypeForm::enumeration:
        case TypeForm::record:
        case TypeForm::sequence:
        case TypeForm::vector:
        case TypeForm::matrix:
            bind_parts(formal->args, type_at(actual).args);
            break;
    }
}

void Bindings::complete_numbers(const ast::TypePtr& formal) {
    if (!formal) return;
    if (formal->numeric && !types_[formal->name].is_valid()) types_[formal->name] = nat_type;
    for (const auto& arg : formal->args) complete_numbers(arg);
}

TypeId Bindings::instantiate_type(const ast::TypePtr& formal) {
    if (formal->form == TypeForm::variable) {
        const auto found = types_.find(formal->name);
        return found != types_.end() && found->second.is_valid() ? found->second : composed_type(TypeKind::unit, {});
    }
    std::vector<TypeId> args;
    for (const auto& arg : formal->args) args.push_back(instantiate_type(arg));
    switch (formal->form) {
        case TypeForm::sequence:
            return composed_type(TypeKind::sequence, std::move(args));
        case TypeForm::set:
            return composed_type(TypeKind::set, std::move(args));
        case TypeForm::product:
            return composed_type(TypeKind::product, std::move(args));
        case TypeForm::function:
            return composed_type(TypeKind::function, std::move(args));
        case TypeForm::relation:
            return composed_type(TypeKind::relation, std::move(args));
        case TypeForm::any:
        case TypeForm::boolean:
        case TypeForm::nat:
        case TypeForm::integer:
        case TypeForm::real:
        case TypeForm::string:
        case TypeForm::given:
        case TypeForm::enumeration:
        case TypeForm::record:
        case TypeForm::variable:
        case TypeForm::vector:
        case TypeForm::matrix:
            break;
    }
    return lower_type(lowering_, formal, {});  // rejects vectors and matrices of a type variable
}

void Bindings::collect_variables(const ast::TypePtr& formal, std::vector<std::string>& names) const {
    if (!formal) return;
    if (formal->form == TypeForm::variable && std::ranges::find(names, formal->name) == names.end())
        names.push_back(formal->name);
    for (const auto& arg : formal->args) collect_variables(arg, names);
}

std::map<std::string, TypeId> Bindings::by_name(const ast::Function& function) {
    const std::vector<std::string> names = names_of(function);
    const std::vector<TypeId> types = in_order(function);
    std::map<std::string, TypeId> result;
    for (std::size_t i = 0; i < names.size(); ++i) result[names[i]] = types[i];
    return result;
}

std::vector<std::string> Bindings::names_of(const ast::Function& function) const {
    std::vector<std::string> names;
    for (const auto& parameter : function.parameters) collect_variables(parameter->type, names);
    collect_variables(function.result, names);
    return names;
}

std::vector<TypeId> Bindings::in_order(const ast::Function& function) {
    const std::vector<std::string> names = names_of(function);
    std::vector<TypeId> result;
    for (const std::string& name : names) {
        const auto found = types_.find(name);
        const bool known = found != types_.end() && found->second.is_valid();
        result.push_back(known ? found->second : composed_type(TypeKind::unit, {}));
    }
    return result;
}

}  // namespace

ExprPtr Expressions::toolkit_call(const ast::Expr& source, const ast::Function& function, TypeId expected) {
    Expr expr;
    expr.kind = ExprKind::toolkit;
    expr.span = source.span;
    expr.text = lowering_.package_of(function) + "_" + function.name;
    Bindings bindings(lowering_);
    for (std::size_t i = 0; i < source.args.size(); ++i) {
        expr.args.push_back(lower_operand(source, i));
        bindings.bind_variables(function.parameters.at(i)->type, expr.args[i]->type);
    }
    bindings.bind_remaining(function.result, expected);
    for (const auto& parameter : function.parameters) bindings.complete_numbers(parameter->type);
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        expr.args[i] = coerce_to_type(lowering_, expr.args[i], bindings.instantiate_type(function.parameters[i]->type));
    expr.type = bindings.instantiate_type(function.result);
    expr.bound_types = bindings.in_order(function);
    return share_expression(std::move(expr));
}

/// Calls a generic function of the model: the instance for the types of this call.
ExprPtr Expressions::generic_call(const ast::Expr& source, const ast::Function& function, TypeId expected) {
    Expr expr;
    expr.kind = ExprKind::call;
    expr.span = source.span;
    expr.text = function.name;
    Bindings bindings(lowering_);
    for (std::size_t i = 0; i < source.args.size(); ++i) {
        expr.args.push_back(lower_operand(source, i));
        bindings.bind_variables(function.parameters.at(i)->type, expr.args[i]->type);
    }
    bindings.bind_remaining(function.result, expected);
    std::vector<TypeId> parameters;
    for (const auto& parameter : function.parameters) parameters.push_back(bindings.instantiate_type(parameter->type));
    for (std::size_t i = 0; i < expr.args.size(); ++i)
        expr.args[i] = coerce_to_type(lowering_, expr.args[i], parameters.at(i));
    expr.type = bindings.instantiate_type(function.result);
    expr.function = lower_instance(lowering_, function, parameters, expr.type, bindings.by_name(function), source.span);
    return expr.function.is_valid() ? share_expression(std::move(expr)) : make_boolean(true, source.span);
}

}  // namespace robochart::ir
