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
        for (std::string& name : result->names) name = rename_name(name);
        for (auto& group : result->patterns)
            for (PatternPtr& pattern : group) pattern = rename_pattern(pattern);
        result->body = rename_expr(old->body);
        for (Constructor& constructor : result->constructors) {
            constructor.name = rename_name(constructor.name);
            constructor.fields = rename_expr(constructor.fields);
        }
        for (std::string& parameter : result->parameters) parameter = rename_name(parameter);
        for (auto* list : {&result->decls, &result->exports})
            for (DeclPtr& decl : *list) decl = rename_decl(decl);
        for (ExprPtr& argument : result->arguments) argument = rename_expr(argument);
        if (old->kind == DeclKind::instance) result->text = rename_name(old->text);
        Assertion& assertion = result->assertion;
        for (ExprPtr* expr : {&assertion.specification, &assertion.implementation, &assertion.tau_priority})
            *expr = rename_expr(*expr);
        return result;
    }

private:
    [[nodiscard]] std::string rename_name(const std::string& old) const {
        if (old.find("::") == std::string::npos) return new_name_of(names_.plain, old);
        std::vector<std::string> parts = parts_of(old);
        const std::size_t first = parts.front().empty() ? 1 : 0;
        const bool own = names_.modules.contains(parts[first]);
        const bool plain = own || parts.size() == first + 1;
        for (std::size_t i = first; i < parts.size(); ++i) {
            if (plain)
                parts[i] = new_name_of(names_.plain, parts[i]);
            else if (i == first)
                parts[i] = new_name_of(names_.first, parts[i]);
            else if (i + 1 == parts.size())
                parts[i] = new_name_of(names_.last, parts[i]);
            else
                parts[i] = new_name_of(names_.inside, parts[i]);
        }
        std::string result = parts.front();
        for (std::size_t i = 1; i < parts.size(); ++i) result += "::" + parts[i];
        return result;
    }

    [[nodiscard]] PatternPtr rename_pattern(const PatternPtr& old) const {
        if (!old) return old;
        auto result = std::make_shared<Pattern>(*old);
        if (old->kind == PatternKind::name) result->text = rename_name(old->text);
        for (PatternPtr& argument : result->args) argument = rename_pattern(argument);
        return result;
    }

    [[nodiscard]] ExprPtr rename_expr(const ExprPtr& old) const {
        if (!old) return old;
        auto result = std::make_shared<Expr>(*old);
        if (old->kind == ExprKind::name) result->text = rename_name(old->text);
        for (ExprPtr& argument : result->args) argument = rename_expr(argument);
        for (Field& field : result->fields) {
            field.value = rename_expr(field.value);
            field.pattern = rename_pattern(field.pattern);
        }
        for (Clause& clause : result->clauses) {
            clause.value = rename_expr(clause.value);
            clause.pattern = rename_pattern(clause.pattern);
        }
        for (Link& link : result->links) link = {rename_expr(link.from), rename_expr(link.to)};
        for (PatternPtr& pattern : result->patterns) pattern = rename_pattern(pattern);
        for (DeclPtr& decl : result->decls) decl = rename_decl(decl);
        return result;
    }

    const QualifiedNames& names_;
};

class Bound {
public:
    void collect_decls(const std::vector<DeclPtr>& list, bool local) {
        for (const DeclPtr& decl : list) collect_decl(*decl, local);
    }
    std::set<std::string> names;

private:
    void collect_decl(const Decl& decl, bool local) {
        if (local || decl.kind != DeclKind::value)
            for (const auto& group : decl.patterns) collect_patterns(group);
        if (local) names.insert(decl.names.begin(), decl.names.end());
        names.insert(decl.parameters.begin(), decl.parameters.end());
        collect_expr(decl.body);
        for (const Constructor& constructor : decl.constructors) collect_expr(constructor.fields);
        collect_decls(decl.decls, local);
        collect_decls(decl.exports, local);
        for (const ExprPtr& argument : decl.arguments) collect_expr(argument);
    }
    void collect_patterns(const std::vector<PatternPtr>& list) {
        for (const PatternPtr& pattern : list) collect_pattern(pattern);
    }
    void collect_pattern(const PatternPtr& pattern) {
        if (!pattern) return;
        if (pattern->kind == PatternKind::name) names.insert(pattern->text);
        collect_patterns(pattern->args);
    }
    void collect_expr(const ExprPtr& expr) {
        if (!expr) return;
        for (const ExprPtr& argument : expr->args) this->collect_expr(argument);
        for (const Field& field : expr->fields) {
            this->collect_expr(field.value);
            collect_pattern(field.pattern);
        }
        for (const Clause& clause : expr->clauses) {
            this->collect_expr(clause.value);
            collect_pattern(clause.pattern);
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
    for (const DeclPtr& decl : decls) result.push_back(renaming.rename_decl(decl));
    return result;
}

std::set<std::string> bound_names(const std::vector<DeclPtr>& decls) {
    Bound bound;
    bound.collect_decls(decls, false);
    return bound.names;
}

std::set<std::string> value_names(const std::vector<DeclPtr>& decls) {
    std::set<std::string> result;
    for (const DeclPtr& decl : decls) {
        if (decl->kind == DeclKind::value)
            for (const PatternPtr& pattern : decl->patterns.front()) result.insert(pattern->text);
        for (const auto* parts : {&decl->decls, &decl->exports}) result.merge(value_names(*parts));
    }
    return result;
}

}  // namespace robochart::cspm
