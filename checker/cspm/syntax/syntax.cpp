// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/syntax.hpp"

#include <algorithm>

namespace robochart::cspm {

namespace {

const ExprPtr& without_parentheses(const ExprPtr& expr) {
    const ExprPtr* result = &expr;
    while (*result && (*result)->kind == ExprKind::parenthesised) result = &(*result)->args.at(0);
    return *result;
}

bool equal_pattern(const PatternPtr& a, const PatternPtr& b) {
    if (a == b) return true;
    if (!a || !b) return false;
    return a->kind == b->kind && a->text == b->text && a->number == b->number &&
           std::ranges::equal(a->args, b->args, equal_pattern);
}

bool equal_decl_pointers(const DeclPtr& a, const DeclPtr& b) {
    return a == b || (a && b && equal(*a, *b));
}

// Converts a dot field to an output field. A dot field only describes how a text is written: in `c.x?y` the x belongs
// to the event, and in `c?y.x` to a pattern. So the printer writes the remaining dot fields as `!x`.
FieldKind canonical_kind(FieldKind kind) {
    return kind == FieldKind::dot ? FieldKind::output : kind;
}

bool equal_field(const Field& a, const Field& b) {
    return canonical_kind(a.kind) == canonical_kind(b.kind) && equal(a.value, b.value) &&
           equal_pattern(a.pattern, b.pattern);
}

bool equal_clause(const Clause& a, const Clause& b) {
    return equal_pattern(a.pattern, b.pattern) && equal(a.value, b.value);
}

bool equal_link(const Link& a, const Link& b) {
    return equal(a.from, b.from) && equal(a.to, b.to);
}

bool equal_exprs(const std::vector<ExprPtr>& a, const std::vector<ExprPtr>& b) {
    return std::ranges::equal(a, b, [](const ExprPtr& x, const ExprPtr& y) { return equal(x, y); });
}

bool equal_patterns(const std::vector<PatternPtr>& a, const std::vector<PatternPtr>& b) {
    return std::ranges::equal(a, b, equal_pattern);
}

bool equal_constructor(const Constructor& a, const Constructor& b) {
    return a.name == b.name && equal(a.fields, b.fields);
}

bool equal_assertion(const Assertion& a, const Assertion& b) {
    return a.kind == b.kind && a.negated == b.negated && a.model == b.model && a.partial_order == b.partial_order &&
           equal(a.specification, b.specification) && equal(a.implementation, b.implementation) &&
           equal(a.tau_priority, b.tau_priority);
}

}  // namespace

bool equal(const ExprPtr& left, const ExprPtr& right) {
    const ExprPtr& a = without_parentheses(left);
    const ExprPtr& b = without_parentheses(right);
    if (a == b) return true;
    if (!a || !b) return false;
    return a->kind == b->kind && a->text == b->text && a->number == b->number && equal_exprs(a->args, b->args) &&
           std::ranges::equal(a->fields, b->fields, equal_field) &&
           std::ranges::equal(a->clauses, b->clauses, equal_clause) &&
           std::ranges::equal(a->links, b->links, equal_link) && equal_patterns(a->patterns, b->patterns) &&
           std::ranges::equal(a->decls, b->decls, equal_decl_pointers);
}

bool equal(const Decl& a, const Decl& b) {
    return a.kind == b.kind && a.names == b.names && std::ranges::equal(a.patterns, b.patterns, equal_patterns) &&
           equal(a.body, b.body) && std::ranges::equal(a.constructors, b.constructors, equal_constructor) &&
           a.parameters == b.parameters && std::ranges::equal(a.decls, b.decls, equal_decl_pointers) &&
           std::ranges::equal(a.exports, b.exports, equal_decl_pointers) && equal_exprs(a.arguments, b.arguments) &&
           a.text == b.text && equal_assertion(a.assertion, b.assertion);
}

bool equal(const Script& a, const Script& b) {
    return std::ranges::equal(a.decls, b.decls, equal_decl_pointers);
}

}  // namespace robochart::cspm
