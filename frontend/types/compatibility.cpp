// SPDX-License-Identifier: Apache-2.0
// Decides compat(a, b) of RoboTool's type provider: a value of type a may be used where b is expected (language
// reference 2, Types).
#include <algorithm>

#include "frontend/types/type_algebra.hpp"

namespace robochart::frontend {

TypePtr make_type(TypeForm form, std::vector<TypePtr> args) {
    auto type = std::make_shared<Type>();
    type->form = form;
    type->args = std::move(args);
    return type;
}

TypePtr make_vector(TypePtr element, long size) {
    auto type = std::make_shared<Type>();
    type->form = TypeForm::vector;
    type->args = {std::move(element)};
    type->sizes = {size};
    return type;
}

TypePtr make_matrix(TypePtr element, long rows, long columns) {
    auto type = std::make_shared<Type>();
    type->form = TypeForm::matrix;
    type->args = {std::move(element)};
    type->sizes = {rows, columns};
    return type;
}

TypePtr simplify_type(const TypePtr& type) {
    if (type && type->form == TypeForm::product && type->args.size() == 1) return simplify_type(type->args[0]);
    return type;
}

bool is_number(const TypePtr& type) {
    return type && (type->form == TypeForm::nat || type->form == TypeForm::integer || type->form == TypeForm::real);
}

TypePtr as_set(const TypePtr& type) {
    if (!type) return nullptr;
    switch (type->form) {
        case TypeForm::set:
            return type;
        case TypeForm::relation:
        case TypeForm::function:
            return make_type(TypeForm::set, {make_type(TypeForm::product,
                                                       {simplify_type(type->args[0]), simplify_type(type->args[1])})});
        case TypeForm::sequence:
            return make_type(TypeForm::set, {make_type(TypeForm::product, {make_type(TypeForm::nat), type->args[0]})});
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
        case TypeForm::product:
        case TypeForm::vector:
        case TypeForm::matrix:
            break;
    }
    return nullptr;
}

TypePtr as_product(const TypePtr& type) {
    if (!type) return nullptr;
    if (type->form == TypeForm::product) return type;
    constexpr long most = 1000;
    if (type->form == TypeForm::vector && type->sizes[0] >= 0 && type->sizes[0] <= most)
        return make_type(TypeForm::product,
                         std::vector<TypePtr>(static_cast<std::size_t>(type->sizes[0]), type->args[0]));
    if (type->form == TypeForm::matrix && type->sizes[0] >= 0 && type->sizes[0] <= most)
        return make_type(TypeForm::product, std::vector<TypePtr>(static_cast<std::size_t>(type->sizes[0]),
                                                                 make_vector(type->args[0], type->sizes[1])));
    return nullptr;
}

namespace {

bool sizes_agree(const std::vector<long>& a, const std::vector<long>& b) {
    return std::ranges::equal(a, b, [](long x, long y) { return x < 0 || y < 0 || x == y; });
}

bool args_agree(const Type& from, const Type& to) {
    return std::ranges::equal(from.args, to.args, is_compatible);
}

bool same_form(const Type& from, const Type& to) {
    switch (to.form) {
        case TypeForm::given:
        case TypeForm::enumeration:
        case TypeForm::record:
            return from.declaration == to.declaration;
        case TypeForm::vector:
        case TypeForm::matrix:
            return sizes_agree(from.sizes, to.sizes) && args_agree(from, to);
        case TypeForm::any:
        case TypeForm::boolean:
        case TypeForm::nat:
        case TypeForm::integer:
        case TypeForm::real:
        case TypeForm::string:
        case TypeForm::variable:
        case TypeForm::sequence:
        case TypeForm::set:
        case TypeForm::product:
        case TypeForm::function:
        case TypeForm::relation:
            break;
    }
    return args_agree(from, to);
}

bool is_free(const Type& type) {
    return type.form == TypeForm::any || type.form == TypeForm::variable;
}

}  // namespace

bool is_compatible(const TypePtr& written_from, const TypePtr& written_to) {
    const TypePtr from = simplify_type(written_from);
    const TypePtr to = simplify_type(written_to);
    // The error in an expression without a type has been reported already.
    if (!from || !to || is_free(*from) || is_free(*to)) return true;
    if (from->form == to->form) return same_form(*from, *to);
    // nat converts to int, and int to real.
    if (is_number(from) && is_number(to)) return from->form < to->form;
    if (to->form == TypeForm::set || to->form == TypeForm::relation) {
        const TypePtr a = as_set(from);
        const TypePtr b = as_set(to);
        return a && b && is_compatible(a->args[0], b->args[0]);
    }
    const TypePtr a = as_product(from);
    const TypePtr b = as_product(to);
    return a && b && same_form(*a, *b);
}

TypePtr join_types(const TypePtr& a, const TypePtr& b) {
    if (!a || !b) return nullptr;
    if (a->form == TypeForm::any) return b;
    if (is_compatible(a, b)) return b->form == TypeForm::any ? a : b;
    return is_compatible(b, a) ? a : nullptr;
}

}  // namespace robochart::frontend
