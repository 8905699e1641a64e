// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/rename.hpp"

#include <algorithm>

namespace robochart::cspm {
namespace {

const std::string& in(const NewNames& names, const std::string& old) {
    const auto found = names.find(old);
    return found == names.end() ? old : found->second;
}

/// Splits `A::b::c` into its parts; a leading `::` gives an empty part.
std::vector<std::string> parts_of(const std::string& name) {
    std::vector<std::string> result;
    std::size_t at = 0;
    for (std::size_t end = name.find("::"); end != std::string::npos; end = name.find("::", at)) {
        result.push_back(name.substr(at, end - at));
        at = end + 2;
    }
    result.push_back(name.substr(at));
    return result;
}

class Renaming {
public:
    explicit Renaming(const QualifiedNames& names) : names_(names) {}

    [[nodiscard]] DeclPtr decl(const DeclPtr& old) const {
        auto result = std::make_shared<Decl>(*old);
        for (std::string& each : result->names) each = name(each);
        for (auto& group : result->patterns)
            for (PatternPtr& each : group) each = pattern(each);
        result->body = expr(old->body);
        for (Constructor& each : result->constructors) {
            each.name = name(each.name);
            each.fields = expr(each.fields);
        }
        for (std::string& each : result->parameters) each = name(each);
        for (auto* list : {&result->decls, &result->exports})
            for (DeclPtr& each : *list) each = decl(each);
        for (ExprPtr& each : result->arguments) each = expr(each);
        if (old->kind == DeclKind::instance) result->text = name(old->text);
        Assertion& assertion = result->assertion;
        for (ExprPtr* each : {&assertion.specification, &assertion.implementation, &assertion.tau_priority})
            *each = expr(*each);
        return result;
    }

private:
    [[nodiscard]] std::string name(const std::string& old) const {
        if (old.find("::") == std::string::npos) return in(names_.plain, old);
        std::vector<std::string> parts = parts_of(old);
        const std::size_t first = parts.front().empty() ? 1 : 0;
        const bool own = names_.modules.contains(parts[first]);
        for (std::size_t i = first; i < parts.size(); ++i) {
            if (own || parts.size() == first + 1)
                parts[i] = in(names_.plain, parts[i]);
            else
                parts[i] = in(i == first              ? names_.first
                              : i + 1 == parts.size() ? names_.last
                                                      : names_.inside,
                              parts[i]);
        }
        std::string result = parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) result += "::" + parts[i];
        return result;
    }

    [[nodiscard]] PatternPtr pattern(const PatternPtr& old) const {
        if (!old) return old;
        auto result = std::make_shared<Pattern>(*old);
        if (old->kind == PatternKind::name) result->text = name(old->text);
        for (PatternPtr& each : result->args) each = pattern(each);
        return result;
    }

    [[nodiscard]] ExprPtr expr(const ExprPtr& old) const {
        if (!old) return old;
        auto result = std::make_shared<Expr>(*old);
        if (old->kind == ExprKind::name) result->text = name(old->text);
        for (ExprPtr& each : result->args) each = expr(each);
        for (Field& each : result->fields) {
            each.value = expr(each.value);
            each.pattern = pattern(each.pattern);
        }
        for (Clause& each : result->clauses) {
            each.value = expr(each.value);
            each.pattern = pattern(each.pattern);
        }
        for (Link& each : result->links) each = {expr(each.from), expr(each.to)};
        for (PatternPtr& each : result->patterns) each = pattern(each);
        for (DeclPtr& each : result->decls) each = decl(each);
        return result;
    }

    const QualifiedNames& names_;
};

class Bound {
public:
    void decls(const std::vector<DeclPtr>& list, bool local) {
        for (const DeclPtr& each : list) decl(*each, local);
    }
    std::set<std::string> names;

private:
    void decl(const Decl& decl, bool local) {
        if (local || decl.kind != DeclKind::value)
            for (const auto& group : decl.patterns) patterns(group);
        if (local) names.insert(decl.names.begin(), decl.names.end());
        names.insert(decl.parameters.begin(), decl.parameters.end());
        expr(decl.body);
        for (const Constructor& each : decl.constructors) expr(each.fields);
        decls(decl.decls, local);
        decls(decl.exports, local);
        for (const ExprPtr& each : decl.arguments) expr(each);
    }
    void patterns(const std::vector<PatternPtr>& list) {
        for (const PatternPtr& each : list) pattern(each);
    }
    void pattern(const PatternPtr& pattern) {
        if (!pattern) return;
        if (pattern->kind == PatternKind::name) names.insert(pattern->text);
        patterns(pattern->args);
    }
    void expr(const ExprPtr& expr) {
        if (!expr) return;
        for (const ExprPtr& each : expr->args) this->expr(each);
        for (const Field& each : expr->fields) {
            this->expr(each.value);
            pattern(each.pattern);
        }
        for (const Clause& each : expr->clauses) {
            this->expr(each.value);
            pattern(each.pattern);
        }
        patterns(expr->patterns);
        decls(expr->decls, true);
    }
};

}  // namespace

std::vector<DeclPtr> renamed(const std::vector<DeclPtr>& decls, const NewNames& names) {
    return renamed(decls, QualifiedNames{names, names, {}, {}, {}});
}

std::vector<DeclPtr> renamed(const std::vector<DeclPtr>& decls, const QualifiedNames& names) {
    if (names.plain.empty() && names.first.empty() && names.inside.empty() && names.last.empty()) return decls;
    const Renaming renaming(names);
    std::vector<DeclPtr> result;
    for (const DeclPtr& each : decls) result.push_back(renaming.decl(each));
    return result;
}

std::set<std::string> bound_names(const std::vector<DeclPtr>& decls) {
    Bound bound;
    bound.decls(decls, false);
    return bound.names;
}

std::set<std::string> value_names(const std::vector<DeclPtr>& decls) {
    std::set<std::string> result;
    for (const DeclPtr& each : decls) {
        if (each->kind == DeclKind::value)
            for (const PatternPtr& pattern : each->patterns.front()) result.insert(pattern->text);
        for (const auto* parts : {&each->decls, &each->exports}) result.merge(value_names(*parts));
    }
    return result;
}

}  // namespace robochart::cspm
