// SPDX-License-Identifier: Apache-2.0
#include "app/rules/show_findings.hpp"

#include "app/command/output.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::app {

void show_rule_findings(const driver::LoadedRules& loaded, const Options& options) {
    const diagnostics::TextStyle style = findings_style(options);
    diagnostics::Diagnostics wrong;  // not printed with --quiet
    for (const diagnostics::Diagnostic& each : loaded.diagnostics.sorted_findings()) {
        if (each.rule->severity == diagnostics::Severity::note) continue;
        diagnostics::Diagnostic& kept = wrong.report(*each.rule, each.span, each.arguments);
        kept.notes = each.notes;
        kept.fixes = each.fixes;
    }
    print_error_styled(
        diagnostics::render_text(loaded.sources, options.output.quiet ? wrong : loaded.diagnostics, style));
}

}  // namespace robochart::app
