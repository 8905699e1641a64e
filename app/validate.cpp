// The verb `validate`: read, resolve and report; with --fix, certain mends are written to the files first.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

#include "app/output.hpp"
#include "app/run.hpp"
#include "app/verbs.hpp"
#include "diagnostics/files.hpp"
#include "diagnostics/fixes.hpp"
#include "diagnostics/render.hpp"
#include "frontend/project.hpp"

namespace robochart::app {
namespace {

/// Writes the certain mends of every file, each file as a whole or not at all. Returns how many were made.
std::size_t mend(const Project& project, std::string& error) {
    std::size_t made = 0;
    for (const auto& file : project.model->files) {
        if (file->is_library) continue;
        const auto fixes = diagnostics::certain_fixes(project.diagnostics, file->source);
        if (fixes.empty()) continue;
        error = diagnostics::replace_file(project.sources.path(file->source),
                                          diagnostics::apply_fixes(project.sources.text(file->source), fixes),
                                          project.diagnostics.budget());
        if (!error.empty()) return made;
        made += fixes.size();
    }
    return made;
}

std::unique_ptr<Project> read(const Options& options) {
    auto project = std::make_unique<Project>();
    project->diagnostics.within(&options.run->budget());
    project->model = frontend::load_project(project->sources, options.inputs, project->diagnostics);
    return project;
}

void show(const Project& project, const Options& options) {
    if (options.format == Format::json) {
        print_exact(diagnostics::render_json(project.sources, project.diagnostics));
    } else if (options.format == Format::sarif) {
        print_exact(diagnostics::render_sarif(project.sources, project.diagnostics, program_version));
    } else {
        diagnostics::TextStyle style;
        style.color = color_wanted(options.color, STDERR_FILENO);
        print_error_styled(diagnostics::render_text(project.sources, project.diagnostics, style));
        if (!options.quiet && project.diagnostics.ok()) print("valid\n");
    }
}

}  // namespace

Exit run_validate(const Options& options) {
    auto project = read(options);
    if (options.fix) {
        std::string error;
        const std::size_t made = mend(*project, error);
        if (!error.empty()) {
            print_error("robochart-verify: {}\n", error);
            return Exit::bad_input;
        }
        if (made > 0) project = read(options);
        if (!options.quiet && options.format == Format::text)
            print_error("{} place{} mended\n", made, made == 1 ? "" : "s");
    }
    options.run->finish();
    show(*project, options);
    return project->diagnostics.ok() ? Exit::success : Exit::bad_input;
}

}  // namespace robochart::app
