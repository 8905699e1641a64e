// The verb `validate`: read, resolve and report; with --fix, certain fixes are applied to the files first.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/verbs/verbs.hpp"
#include "diagnostics/fixes.hpp"
#include "diagnostics/render.hpp"
#include "frontend/project/project.hpp"

namespace robochart::app {
namespace {

/// Applies the certain fixes of every file, each file as a whole or not at all. Returns their number.
std::size_t apply_fixes(const std::vector<Part>& parts, std::string& error) {
    std::size_t made = 0;
    for (const Part& part : parts)
        for (const auto& file : part.project->model->files) {
            const diagnostics::Diagnostics& findings = part.project->diagnostics;
            if (file->is_library) continue;
            const auto fixes = diagnostics::certain_fixes(findings, file->source);
            if (fixes.empty()) continue;
            error = diagnostics::replace_text(part.project->sources.path(file->source),
                                              diagnostics::apply_fixes(part.project->sources.text(file->source), fixes),
                                              findings.budget());
            if (!error.empty()) return made;
            made += fixes.size();
        }
    return made;
}

/// The findings of all parts, which have their texts in common.
diagnostics::Diagnostics together(const std::vector<Part>& parts) {
    diagnostics::Diagnostics all;
    for (const Part& part : parts) all.add(part.project->diagnostics);
    return all;
}

/// No errors, and no warnings where they are denied.
bool valid(const diagnostics::Diagnostics& findings, const Options& options) {
    return findings.ok() && !(options.deny_warnings && findings.warnings() > 0);
}

/// `limit`: why not everything was looked at; "" if it was.
void show(const diagnostics::SourceManager& sources, const diagnostics::Diagnostics& findings, const std::string& limit,
          const Options& options) {
    if (options.format == Format::json) {
        print_exact(diagnostics::render_json(sources, findings, limit));
    } else if (options.format == Format::sarif) {
        print_exact(diagnostics::render_sarif(sources, findings, program_version, limit));
    } else {
        diagnostics::TextStyle style;
        style.color = color_wanted(options.color, STDERR_FILENO);
        print_error_styled(diagnostics::render_text(sources, findings, style));
        if (!options.quiet && limit.empty() && valid(findings, options)) print("valid\n");
    }
    if (!limit.empty()) print_error("robochart-verify: inconclusive: {}\n", limit);
}

/// Reads, applies fixes if asked to, and reports.
Exit validate(const Options& options) {
    std::vector<Part> parts = read_parts(options);
    if (options.fix) {
        std::string error;
        const std::size_t made = apply_fixes(parts, error);
        if (!error.empty()) {
            print_error("robochart-verify: {}\n", error);
            return Exit::bad_input;
        }
        if (made > 0) parts = read_parts(options);
        if (!options.quiet && options.format == Format::text)
            print_error("{} place{} fixed\n", made, made == 1 ? "" : "s");
    }
    options.run->finish();
    const diagnostics::Diagnostics findings = together(parts);
    show(parts.front().project->sources, findings, "", options);
    const bool good = valid(findings, options);
    if (findings.ok() && !good) print_error("warnings are denied (--deny-warnings)\n");
    return good ? Exit::success : Exit::bad_input;
}

}  // namespace

Exit run_validate(const Options& options) {
    options.run->last_word([&options](const std::string& why) {
        show(diagnostics::SourceManager(), diagnostics::Diagnostics(), why, options);
        return Exit::inconclusive;
    });
    return validate(options);
}

}  // namespace robochart::app
