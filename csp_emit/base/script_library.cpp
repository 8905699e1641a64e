// SPDX-License-Identifier: Apache-2.0
// Parses the library of emitted scripts, which is written in CSPM: clipped arithmetic, time, and the toolkit functions
// that the model calls.
#include "csp_emit/base/script_library.hpp"

#include <algorithm>
#include <set>
#include <string>

#include "checker/cspm/syntax/reader.hpp"
#include "csp_emit/base/library.hpp"
#include "csp_emit/base/toolkits.hpp"
#include "csp_emit/base/without_places.hpp"
#include "semantics/evaluate/toolkit.hpp"
#include "semantics/ir/visit.hpp"

namespace robochart::csp_emit {
namespace {

/// Collects the names that occur in an expression.
void collect_names(const cspm::Expr& expr, std::set<std::string>& names) {
    if (expr.kind == cspm::ExprKind::name) names.insert(expr.text);
    for (const auto& part : expr.args)
        if (part) collect_names(*part, names);
    for (const auto& clause : expr.clauses)
        if (clause.value) collect_names(*clause.value, names);
    for (const auto& decl : expr.decls)
        if (decl->body) collect_names(*decl->body, names);
}

void collect_names(const ir::Expr& expr, std::set<std::string>& names) {
    if (expr.kind == ir::ExprKind::toolkit) names.insert(expr.text);
    for (const auto& part : expr.args)
        if (part) collect_names(*part, names);
}

std::set<std::string> called_by_model(const ir::System& system) {
    std::set<std::string> names;
    ir::visit_expressions(system, [&](const ir::Expr& expr, ir::ExprRole) { collect_names(expr, names); });
    for (const ir::Function& function : system.functions)
        for (const auto* conditions : {&function.preconditions, &function.postconditions})
            for (const auto& condition : *conditions) collect_names(*condition, names);
    return names;
}

/// Returns the definitions of the toolkit functions that the model calls, directly or through other toolkit functions,
/// in a fixed order.
std::vector<cspm::DeclPtr> toolkit_definitions(const Project& project) {
    std::set<std::string> used = called_by_model(project.system);
    if (used.empty()) return {};
    for (const std::string& name : std::set<std::string>(used)) used.insert("pre_" + name);
    const auto source = project.sources.add("<toolkits of generated scripts>", toolkit_text());
    const auto all = cspm::read(project.sources, source, project.diagnostics).decls;
    for (std::size_t before = 0; before != used.size();) {
        before = used.size();
        for (const auto& decl : all)
            if (used.contains(decl->names.front())) collect_names(*decl->body, used);
    }
    std::vector<cspm::DeclPtr> result;
    for (const auto& decl : all)
        if (used.contains(decl->names.front())) result.push_back(decl);
    return result;
}

}  // namespace

std::vector<cspm::DeclPtr> script_library(const Project& project) {
    const auto source =
        project.sources.add("<library of generated scripts>", library_text(project.system, project.time));
    auto decls = cspm::read(project.sources, source, project.diagnostics).decls;
    const auto toolkits = toolkit_definitions(project);
    decls.insert(decls.end(), toolkits.begin(), toolkits.end());
    return without_places(decls);
}

}  // namespace robochart::csp_emit
