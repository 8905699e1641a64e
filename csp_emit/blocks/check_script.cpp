// SPDX-License-Identifier: Apache-2.0
#include "csp_emit/blocks/check_script.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <optional>

#include "base/diagnostics/fixes.hpp"
#include "checker/cspm/types/rules.hpp"
#include "checker/cspm/types/type_check.hpp"
#include "csp_emit/blocks/script_names.hpp"

namespace robochart::csp_emit {

namespace {

cspm::ExprPtr with_span(const cspm::ExprPtr& expr, diagnostics::Span span) {
    if (expr == nullptr || expr->span.is_known()) return expr;
    cspm::Expr result = *expr;
    result.span = span;
    for (cspm::ExprPtr& argument : result.args) argument = with_span(argument, span);
    return std::make_shared<const cspm::Expr>(std::move(result));
}

/// Returns the script with the span of each claim in the assertions generated for it.
cspm::Script with_places(const Emission& emission, const ir::System& system) {
    std::map<const cspm::Decl*, diagnostics::Span> places;
    for (const Obligation& obligation : emission.obligations) {
        const bool claimed = obligation.property != ir::no_id;
        const diagnostics::Span span =
            claimed ? system.properties[obligation.property].origin.span : obligation.origin.span;
        for (const auto* decls : {&obligation.preparation, &obligation.assertions})
            for (const cspm::DeclPtr& decl : *decls) places.emplace(decl.get(), span);
    }
    cspm::Script script = emission.script;
    for (cspm::DeclPtr& decl : script.decls) {
        const auto place = places.find(decl.get());
        if (place == places.end() || decl->span.is_known()) continue;
        cspm::Decl result = *decl;
        result.span = place->second;
        result.body = with_span(result.body, place->second);
        for (cspm::ExprPtr* part :
             {&result.assertion.specification, &result.assertion.implementation, &result.assertion.tau_priority})
            *part = with_span(*part, place->second);
        decl = std::make_shared<const cspm::Decl>(std::move(result));
    }
    return script;
}

}  // namespace

void check_script(const Emission& emission, const ir::System& system, diagnostics::Diagnostics& out) {
    diagnostics::Diagnostics found;
    found.set_budget(out.budget());
    (void)cspm::check_types(with_places(emission, system), found);
    std::optional<ScriptNames> names;
    for (const diagnostics::Diagnostic& finding : found.sorted_findings()) {
        diagnostics::Diagnostic& reported = out.report(*finding.rule, finding.span, finding.arguments);
        reported.notes = finding.notes;
        reported.fixes = finding.fixes;
        if (finding.rule != &cspm::types::rules::not_in_scope || finding.arguments.empty()) continue;
        if (!names) names.emplace(emission.definitions);
        const std::vector<std::string> meant = names->suggest_names(finding.arguments.front());
        if (meant.empty()) continue;
        reported.notes.push_back(
            {{},
             fmt::format("the script has `{}`: write the name of the component before the name of its "
                         "element (docs/claims-in-csp.md)",
                         fmt::join(meant, "`, `"))});
        const diagnostics::Span span = finding.span;
        if (span.is_known() && reported.fixes.empty())
            reported.fixes.push_back({span, meant.front(), std::string(diagnostics::suggestion_title)});
    }
}

}  // namespace robochart::csp_emit
