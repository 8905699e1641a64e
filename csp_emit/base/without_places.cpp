// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/base/without_places.hpp"

#include <memory>

namespace robochart::csp_emit {
namespace {

cspm::DeclPtr without_place(const cspm::DeclPtr& old);

cspm::ExprPtr without_place(const cspm::ExprPtr& old) {
    if (!old) return old;
    auto result = std::make_shared<cspm::Expr>(*old);
    result->span = {};
    for (cspm::ExprPtr& arg : result->args) arg = without_place(arg);
    for (cspm::Field& field : result->fields) {
        field.span = {};
        field.value = without_place(field.value);
    }
    for (cspm::Clause& clause : result->clauses) clause.value = without_place(clause.value);
    for (cspm::Link& link : result->links) link = {without_place(link.from), without_place(link.to)};
    for (cspm::DeclPtr& decl : result->decls) decl = without_place(decl);
    return result;
}

cspm::DeclPtr without_place(const cspm::DeclPtr& old) {
    auto result = std::make_shared<cspm::Decl>(*old);
    result->span = {};
    result->body = without_place(old->body);
    for (cspm::Constructor& constructor : result->constructors) {
        constructor.span = {};
        constructor.fields = without_place(constructor.fields);
    }
    for (auto* const part : {&result->decls, &result->exports})
        for (cspm::DeclPtr& decl : *part) decl = without_place(decl);
    for (cspm::ExprPtr& argument : result->arguments) argument = without_place(argument);
    return result;
}

}  // namespace

std::vector<cspm::DeclPtr> without_places(const std::vector<cspm::DeclPtr>& decls) {
    std::vector<cspm::DeclPtr> result;
    result.reserve(decls.size());
    for (const cspm::DeclPtr& decl : decls) result.push_back(without_place(decl));
    return result;
}

}  // namespace robochart::csp_emit
