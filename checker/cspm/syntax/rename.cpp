// SPDX-License-Identifier: Apache-2.0
#include "checker/cspm/syntax/rename.hpp"

#include <algorithm>

namespace robochart::cspm {
namespace {

const std::string& new_name_of(const NewNames& names, const std::string& old) {
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

    [[nodiscard]] DeclPtr rename_decl(const DeclPtr& old) const {
        auto result = std::make_shared<Decl>(*old);
        for (std::string& each : result->names) each = rename_name(each);
        for (auto& group : result->patterns)
            for (PatternPtr& each : group) each = rename_pattern(each);
        result->body = rename_expr(old->body);
        for (Constructor& each : result->constructors) {
            each.name = rename_name(each.name);
            each.fields = rename_expr(each.fields);
        }
        for (std::string& each : result->parameters) each = rename_name(each);
        for (auto* list : {&result->decls, &result->exports})
            for (DeclPtr& each : *list) each = rename_decl(each);
        for (ExprPtr& each : result->arguments) each = rename_expr(each);
        if (old->kind == DeclKind::instance) result->text = rename_name(old->text);
        Assertion& assertion = result->assertion;
        for (ExprPtr* each : {&assertion.specification, &assertion.implementation, &assertion.tau_priority})
            *each = rename_expr(*each);
        return result;
    }

private:
    [[nodiscard]] std::string rename_name(const std::string& old) const {
        if (old.find("::") == std::string::npos) return new_name_of(names_.plain, old);
        std::vector<std::string> parts = parts_of(old);
        const std::size_t first = parts.front().empty() ? 1 : 0;
        const bool own = names_.modules.contains(parts[first]);
        for (std::size_t i = first; i < parts.size(); ++i) {
            if (own || parts.size() == first + 1)
                parts[i] = new_name_of(names_.plain, parts[i]);
            else
                parts[i] = new_name_of(i == first              ? names_.first
                                       : i + 1 == parts.size() ? names_.last
                                                               : names_.inside,
                                       parts[i]);
        }
        std::string result = parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) result += "::" + parts[i];
        return result;
    }

    [[nodiscard]] PatternPtr rename_pattern(const PatternPtr& old) const {
        if (!old) return old;
        auto result = std::make_shared<Pattern>(*old);
        if (old->kind == PatternKind::name) result->text = rename_name(old->text);
        for (PatternPtr& each : result->args) each = rename_pattern(each);
        return result;
    }

    [[nodiscard]] ExprPtr rename_expr(const ExprPtr& old) const {
        if (!old) return old;
        auto result = std::make_shared<Expr>(*old);
        if (old->kind == ExprKind::name) result->text = rename_name(old->text);
        for (ExprPtr& each : result->args) each = rename_expr(each);
        for (Field& each : result->fields) {
            each.value = rename_expr(each.value);
            each.pattern = rename_pattern(each.pattern);
        }
        for (Clause& each : result->clauses) {
            each.value = rename_expr(each.value);
            each.pattern = rename_pattern(each.pattern);
        }
        for (Link& each : result->links) each = {rename_expr(each.from), rename_expr(each.to)};
        for (PatternPtr& each : result->patterns) each = rename_pattern(each);
        for (DeclPtr& each : result->decls) each = rename_decl(each);
        return result;
    }

    const QualifiedNames& names_;
};

class Bound {
public:
    void collect_decls(const std::vector<DeclPtr>& list, bool local) {
        for (const DeclPtr& each : list) collect_decl(*each, local);
    }
    std::set<std::string> names;

private:
    void collect_decl(const Decl& decl, bool local) {
        if (local || decl.kind != DeclKind::value)
            for (const auto& group : decl.patterns) collect_patterns(group);
        if (local) names.insert(decl.names.begin(), decl.names.end());
        names.insert(decl.parameters.begin(), decl.parameters.end());
        collect_expr(decl.body);
        for (const Constructor& each : decl.constructors) collect_expr(each.fields);
        collect_decls(decl.decls, local);
        collect_decls(decl.exports, local);
        for (const ExprPtr& each : decl.arguments) collect_expr(each);
    }
    void collect_patterns(const std::vector<PatternPtr>& list) {
        for (const PatternPtr& each : list) collect_pattern(each);
    }
    void collect_pattern(const PatternPtr& pattern) {
        if (!pattern) return;
        if (pattern->kind == PatternKind::name) names.insert(pattern->text);
        collect_patterns(pattern->args);
    }
    void collect_expr(const ExprPtr& expr) {
        if (!expr) return;
        for (const ExprPtr& each : expr->args) this->collect_expr(each);
        for (const Field& each : expr->fields) {
            this->collect_expr(each.value);
            collect_pattern(each.pattern);
        }
        for (const Clause& each : expr->clauses) {
            this->collect_expr(each.value);
            collect_pattern(each.pattern);
        }
        collect_patterns(expr->patterns);
        collect_decls(expr->decls, true);
    }
};

}  // namespace

std::vector<DeclPtr> rename_declarations(const std::vector<DeclPtr>& decls, const NewNames& names) {
    return rename_declarations(decls, QualifiedNames{names, names, {}, {}, {}});
}

std::vector<DeclPtr> rename_declarations(const std::vector<DeclPtr>& decls, const QualifiedNames& names) {
    if (names.plain.empty() && names.first.empty() && names.inside.empty() && names.last.empty()) return decls;
    const Renaming renaming(names);
    std::vector<DeclPtr> result;
    for (const DeclPtr& each : decls) result.push_back(renaming.rename_decl(each));
    return result;
}

std::set<std::string> bound_names(const std::vector<DeclPtr>& decls) {
    Bound bound;
    bound.collect_decls(decls, false);
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
