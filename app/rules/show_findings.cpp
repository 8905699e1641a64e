// SPDX-License-Identifier: Apache-2.0
#include "app/rules/show_findings.hpp"

#include "app/command/output.hpp"
#include "base/diagnostics/render.hpp"

namespace robochart::app {

void show_rule_findings(const driver::LoadedRules& loaded, const Options& options) {
    const diagnostics::TextStyle style = findings_style(options);
    diagnostics::Diagnostics wrong;  // not printed with --quiet
    for (const diagnostics::Diagnostic& finding : loaded.diagnostics.sorted_findings()) {
        if (finding.rule->severity == diagnostics::Severity::note) continue;
        diagnostics::Diagnostic& reported = wrong.report(*finding.rule, finding.span, finding.arguments);
        reported.notes = finding.notes;
        reported.fixes = finding.fixes;
    }
    print_error_styled(
        diagnostics::render_text(loaded.sources, options.output.quiet ? wrong : loaded.diagnostics, style));
}

}  // namespace robochart::app
