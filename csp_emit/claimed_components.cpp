// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/claimed_components.hpp"

#include <map>

#include "checker/cspm/syntax/lookup.hpp"

namespace robochart::csp_emit {
namespace {

using Visitor = std::function<void(const cspm::ExprPtr&)>;

class Walk {
public:
    Walk(const Emission& emission, const Visitor& visit) : visit_(visit) { collect_bodies(emission.script.decls); }

    void visit_expression(const cspm::ExprPtr& expr) {
        if (!expr) return;
        visit_(expr);
        if (expr->kind == cspm::ExprKind::name) visit_definitions(expr->text);
        for (const cspm::ExprPtr& part : expr->args) visit_expression(part);
        for (const cspm::Field& field : expr->fields) visit_expression(field.value);
        for (const cspm::Clause& clause : expr->clauses) visit_expression(clause.value);
        for (const cspm::Link& link : expr->links) {
            visit_expression(link.from);
            visit_expression(link.to);
        }
        for (const cspm::DeclPtr& decl : expr->decls) visit_expression(decl->body);
    }

private:
    void collect_bodies(const std::vector<cspm::DeclPtr>& decls) {
        for (const cspm::DeclPtr& decl : decls) {
            if (decl->kind == cspm::DeclKind::timed) collect_bodies(decl->decls);
            if (decl->kind == cspm::DeclKind::function || decl->kind == cspm::DeclKind::value)
                for (const std::string& name : cspm::declared_names(*decl)) bodies_[name].push_back(decl->body);
        }
    }

    void visit_definitions(const std::string& name) {
        const auto known = bodies_.find(name);
        if (known == bodies_.end() || !seen_.insert(name).second) return;
        for (const cspm::ExprPtr& body : known->second) visit_expression(body);
    }

    const Visitor& visit_;
    std::map<std::string, std::vector<cspm::ExprPtr>> bodies_;
    std::set<std::string> seen_;
};

}  // namespace

void visit_named(const Emission& emission, const std::vector<cspm::ExprPtr>& expressions, const Visitor& visit) {
    Walk walk(emission, visit);
    for (const cspm::ExprPtr& expr : expressions) walk.visit_expression(expr);
}

std::set<std::string> components_in(const Emission& emission, const std::vector<cspm::ExprPtr>& expressions) {
    std::set<std::string> paths, found;
    for (const ComponentProcesses& component : emission.components) paths.insert(component.path);
    visit_named(emission, expressions, [&](const cspm::ExprPtr& expr) {
        // "P::C::s::D__" belongs to "P::C::s"; events and event sets do not belong to a process
        const std::size_t end = expr->kind == cspm::ExprKind::name ? expr->text.rfind("::") : std::string::npos;
        if (end == std::string::npos) return;
        const std::string last = expr->text.substr(end + 2);
        const bool process = (last.ends_with("__") && last != "sem__events") || last == "HEXT";
        if (process && paths.contains(expr->text.substr(0, end))) found.insert(expr->text.substr(0, end));
    });
    return found;
}

}  // namespace robochart::csp_emit
