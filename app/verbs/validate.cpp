// SPDX-License-Identifier: Apache-2.0
// The verb `validate`: reads and resolves models, and reports findings. With --fix, it first applies fixes that are
// certain to the files.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "app/command/answer.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "app/rules/record_rules.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/fixes.hpp"
#include "base/diagnostics/render.hpp"
#include "base/repair/repair.hpp"
#include "checker/cspm/syntax/rules.hpp"
#include "claims/syntax/rules.hpp"
#include "csp_emit/blocks/check_blocks.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/rules/rule_claims.hpp"
#include "frontend/project/move_claims.hpp"
#include "frontend/project/project.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::app {
namespace {

bool is_syntax(const diagnostics::Rule& rule) {
    return frontend::syntax::is_syntax(rule) ||
           std::ranges::find(cspm::rules::all, &rule) != std::end(cspm::rules::all) ||
           std::ranges::find(claims::rules::syntax, &rule) != std::end(claims::rules::syntax);
}

/// Adds the findings in the claims of a part. Claims are resolved in the IR of the part, so nothing is added for a
/// model with errors, which has no IR.
void check_claims(driver::Project& project) {
    if (project.claims->files.empty() || !project.diagnostics.ok()) return;
    diagnostics::Diagnostics of_lowering;  // `check` reports these
    of_lowering.set_budget(project.diagnostics.budget());
    const ir::System system = ir::lower(*project.model, project.sources, of_lowering);
    if (of_lowering.ok()) driver::check_claim_files(project, system);
}

/// Reads the parts, including the findings in their claims and CSP blocks.
std::vector<driver::Part> read_with_blocks(const Options& options) {
    std::vector<driver::Part> parts = driver::read_parts(options.load, options.run->budget());
    for (const driver::Part& part : parts) record_texts(part.project->sources, options);
    for (const driver::Part& part : parts) check_claims(*part.project);
    for (const driver::Part& part : parts)
        csp_emit::check_blocks(*part.project->model, part.project->sources, part.project->diagnostics);
    return parts;
}

/// Repairs the texts of a part (base/repair/repair.hpp) and writes the changed ones; each file is written completely or
/// not at all. Returns the reason why a file could not be written, or "".
std::string repair_part(const driver::Part& part, const Options& options, diagnostics::Repaired& sum) {
    const driver::Project& project = *part.project;
    diagnostics::Texts texts;
    for (const auto& file : project.model->files)
        if (!file->is_library) texts[project.sources.path(file->source)] = project.sources.source_text(file->source);
    const auto read = [&](const diagnostics::Texts& with) {
        auto reading = std::make_unique<diagnostics::TextReading>();
        for (const std::string& code : options.load.allowed) reading->findings.allow_code(code);
        reading->findings.set_budget(&options.run->budget());
        std::vector<diagnostics::SourceId> sources;
        for (const auto& [path, text] : with) sources.push_back(reading->sources.add(path, text));
        const auto model = frontend::load_texts(reading->sources, sources, reading->findings);
        csp_emit::check_blocks(*model, reading->sources, reading->findings);
        return reading;
    };
    diagnostics::Repaired repaired = diagnostics::repair(texts, read, is_syntax);
    for (const auto& [path, text] : repaired.texts)
        if (std::string error = diagnostics::replace_text(path, text, &options.run->budget()); !error.empty())
            return error;
    sum.made += repaired.made;
    for (diagnostics::RefusedFix& refused : repaired.refused) sum.refused.push_back(std::move(refused));
    return {};
}

/// Moves the claims of assertion files into claims files. Returns an error, or "".
std::string move_claims_of(const driver::Part& part, const Options& options, diagnostics::Repaired& sum) {
    const driver::Project& project = *part.project;
    for (const auto& file : project.model->files) {
        const auto moved = frontend::move_claims(*file, project.sources);
        if (!moved || file->has_syntax_errors) continue;
        std::string text;
        std::error_code code;
        if (std::filesystem::exists(moved->path, code)) {
            std::string error;
            diagnostics::SourceManager there;
            const auto source = there.load_file(moved->path, error);
            if (!source) return fmt::format("{}: {}", moved->path, error);
            text = std::string(there.source_text(*source)) + "\n";
        }
        std::vector<diagnostics::FixIt> removals;
        for (const diagnostics::Span span : moved->removals) removals.push_back({span, "", ""});
        diagnostics::Budget* const budget = &options.run->budget();
        const std::string path(project.sources.path(file->source));
        const std::string rest = diagnostics::apply_fixes(project.sources.source_text(file->source), removals);
        if (std::string error = diagnostics::replace_text(moved->path, text + moved->text, budget); !error.empty())
            return error;
        if (std::string error = diagnostics::replace_text(path, rest, budget); !error.empty()) return error;
        ++sum.made;
    }
    return {};
}

/// Prints how many fixes were applied, and which were not.
void report_repair(const diagnostics::Repaired& sum) {
    print_error("{} place{} fixed\n", sum.made, sum.made == 1 ? "" : "s");
    for (const diagnostics::RefusedFix& refused : sum.refused)
        print_error("{}: not fixed: with `{}` the text would not read better ({})\n",
                    diagnostics::escape_for_display(refused.place),
                    diagnostics::escape_for_display(refused.replacement), refused.code);
}

/// Returns the findings of all parts, which share their texts.
diagnostics::Diagnostics all_findings(const std::vector<driver::Part>& parts) {
    diagnostics::Diagnostics all;
    for (const driver::Part& part : parts) all.add(part.project->diagnostics);
    return all;
}

/// True if there are no errors and, with --deny-warnings, no warnings.
bool is_valid(const diagnostics::Diagnostics& findings, const Options& options) {
    return findings.ok() && !(options.load.deny_warnings && findings.warning_count() > 0);
}

/// Outputs the findings. `limit` is the reason why not everything was checked, or "".
void output_findings(const diagnostics::SourceManager& sources, const diagnostics::Diagnostics& findings,
                     const std::string& limit, const Options& options) {
    output_document(options, [&](Format format) {
        return format == Format::json ? diagnostics::render_json(sources, findings, limit)
                                      : diagnostics::render_sarif(sources, findings, about_log(options, limit));
    });
    if (options.output.format == Format::text) {
        const diagnostics::TextStyle style = findings_style(options);
        print_error_styled(diagnostics::render_text(sources, findings, style));
        if (!options.output.quiet && limit.empty() && is_valid(findings, options)) print("valid\n");
    }
    if (!limit.empty()) print_error("robochart-verify: inconclusive: {}\n", limit);
}

/// Outputs the findings of a finished run.
Exit output_result(const diagnostics::SourceManager& sources, const diagnostics::Diagnostics& findings,
                   const Options& options) {
    output_findings(sources, findings, "", options);
    const bool good = is_valid(findings, options);
    if (findings.ok() && !good) print_error("warnings are denied (--deny-warnings)\n");
    return good ? Exit::success : Exit::bad_input;
}

bool is_rules(const std::string& path) {
    return path.ends_with(".sleec");
}

/// Reports the findings in rule files. If a `.claims` file in their folder declares a time unit, also checks their
/// limits.
Exit validate_rules(const Options& options) {
    driver::LoadedRules loaded;
    loaded.diagnostics.set_budget(&options.run->budget());
    for (const std::string& code : options.load.allowed) loaded.diagnostics.allow_code(code);
    for (const std::string& file : options.load.inputs) {
        const auto unit = driver::unit_beside({file}, loaded.sources, loaded.diagnostics);
        driver::load_rules(file, loaded, unit ? durations::Unit(unit->nanoseconds) : std::nullopt);
        record_rules(loaded, options);
    }
    options.run->finish();
    return output_result(loaded.sources, loaded.diagnostics, options);
}

/// Reads the inputs, applies fixes if requested, and reports the findings.
Exit validate(const Options& options) {
    std::vector<driver::Part> parts = read_with_blocks(options);
    if (options.fix) {
        diagnostics::Repaired sum;
        for (const driver::Part& part : parts)
            if (const std::string error = repair_part(part, options, sum); !error.empty()) {
                print_error("robochart-verify: {}\n", error);
                return Exit::bad_input;
            }
        if (sum.made > 0) parts = read_with_blocks(options);
        for (const driver::Part& part : parts)
            if (const std::string error = move_claims_of(part, options, sum); !error.empty()) {
                print_error("robochart-verify: {}\n", error);
                return Exit::bad_input;
            }
        if (sum.made > 0) parts = read_with_blocks(options);
        if (!options.output.quiet && options.output.format == Format::text) report_repair(sum);
    }
    options.run->finish();
    return output_result(parts.front().project->sources, all_findings(parts), options);
}

}  // namespace

Exit run_validate(const Options& options) {
    options.run->last_word([&options](const std::string& why) {
        output_findings(diagnostics::SourceManager(), diagnostics::Diagnostics(), why, options);
        return Exit::inconclusive;
    });
    const bool rules = !options.load.inputs.empty() && std::ranges::all_of(options.load.inputs, is_rules);
    return rules ? validate_rules(options) : validate(options);
}

}  // namespace robochart::app
