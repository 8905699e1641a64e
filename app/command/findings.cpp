// SPDX-License-Identifier: Apache-2.0
#include "app/command/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/base/junit.hpp"
#include "app/command/answer.hpp"
#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/render.hpp"
#include "csp_emit/base/rules.hpp"
#include "driver/settings/rules.hpp"
#include "semantics/rules.hpp"

namespace robochart::app {

bool write_output(driver::Project& project, const Options& options, const std::string& path, const std::string& text) {
    const std::string error =
        options.run->claim_path(path)
            ? diagnostics::write_below(options.output.folder, path, text, project.diagnostics.budget())
            : fmt::format(
                  "{}/{}: this run has already written a file of this name, "
                  "for something else of the same name",
                  options.output.folder, path);
    if (!error.empty()) project.diagnostics.report(rules::unwritable, {}, {error});
    return error.empty();
}

Exit refusal_code(const driver::Project& project) {
    const std::array about_options{&driver::rules::bad_option,       &ir::rules::unknown_constant_option,
                                   &ir::rules::bad_constant_value,   &ir::rules::constant_named_twice,
                                   &ir::rules::unknown_range_option, &ir::rules::bad_range,
                                   &ir::rules::ranges_not_nested,    &ir::rules::range_too_large};
    const std::vector<diagnostics::Diagnostic> all = project.diagnostics.sorted_findings();
    // An error in the text of the model has a place in this text.
    const auto about_the_model = [&](const diagnostics::Diagnostic& finding) {
        return finding.rule->severity == diagnostics::Severity::error &&
               (finding.span.is_known() || std::ranges::find(about_options, finding.rule) == about_options.end());
    };
    return project.diagnostics.ok() || std::ranges::any_of(all, about_the_model) ? Exit::bad_input : Exit::usage;
}

namespace {

/// Returns the document for a rejected model, which contains only its diagnostics, in a format for programs.
std::string refused_document(const driver::Project& project, const Options& options, Format format) {
    if (format == Format::json) return diagnostics::render_json(project.sources, project.diagnostics) + "\n";
    if (format == Format::sarif)
        return diagnostics::render_sarif(project.sources, project.diagnostics, about_log(options));
    const JunitCase refused{"model",
                            project.name,
                            JunitCase::Kind::error,
                            "refused, with errors",
                            diagnostics::render_text(project.sources, project.diagnostics),
                            0};
    return junit_document(project.name, {refused});
}

}  // namespace

void show_findings(const driver::Project& project, const Options& options) {
    const bool good = is_acceptable(project, options.load);
    const diagnostics::TextStyle style = findings_style(options);
    if (options.output.quiet && good) {
        // These warnings are shown even with --quiet, because the verdicts are about a model that differs from the
        // text.
        diagnostics::Diagnostics shown;
        for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings())
            if (finding.rule == &ir::rules::literal_outside_range || finding.rule == &csp_emit::rules::inputs_hidden)
                shown.report(*finding.rule, finding.span, finding.arguments);
        if (shown.warning_count() > 0) print_error_styled(diagnostics::render_text(project.sources, shown, style));
        return;
    }
    print_error_styled(diagnostics::render_text(project.sources, project.diagnostics, style));
    if (!good && project.diagnostics.ok()) print_error("warnings are denied (--deny-warnings)\n");
}

bool show_diagnostics(const driver::Project& project, const Options& options) {
    const bool good = is_acceptable(project, options.load);
    if (!good && (options.output.format != Format::text || !options.output.files.empty())) {
        // The diagnostics are the result of the run, so no second document must be printed at a later limit.
        options.run->finish();
        output_document(options, [&](Format format) { return refused_document(project, options, format); });
    }
    if (options.output.format != Format::json && (good || options.output.format == Format::text))
        show_findings(project, options);
    return good;
}

}  // namespace robochart::app
