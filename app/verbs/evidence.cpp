// SPDX-License-Identifier: Apache-2.0
// Decides all questions about a scenario's model with the constants of the options: its assertions, the conformance of
// the robots' code, and the scenario's claims.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>
#include <vector>

#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "app/verbs/simulate.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/containers.hpp"
#include "driver/claims/model_claims.hpp"
#include "frontend/syntax/dialect.hpp"

namespace robochart::app {

namespace {

/// Returns the texts of a model by file name, without the built-in libraries.
driver::Evidence::Files files_of(const driver::Project& project) {
    driver::Evidence::Files files;
    for (std::size_t i = 0; i < project.sources.size(); ++i) {
        const auto source = static_cast<diagnostics::SourceId>(i);
        const std::filesystem::path path = project.sources.path(source);
        const bool model = frontend::is_model_path(path.string()) || frontend::is_assertion_path(path.string());
        if (std::filesystem::exists(path) && model)
            files.emplace_back(path.filename().string(), driver::content_digest(project.sources.source_text(source)));
    }
    diagnostics::sort_unique(files);
    return files;
}

Options over_the_model(const Options& options, const simulation::Scenario& scenario, std::size_t controller,
                       Verb verb) {
    Options model_options = options;
    static_cast<driver::Settings&>(model_options) = settings_for(scenario, options, controller);
    set_verb(model_options, verb);
    model_options.limits.progress = false;
    return model_options;
}

/// Returns the prefix of results about a controller: "leaders: ", or "" for the first controller.
std::string in_front(const simulation::Scenario& scenario, std::size_t controller) {
    return controller == 0 ? "" : scenario.controller_name(controller) + ": ";
}

/// Identifies a model and its constants. The lists of two models can be compared even if the options write the same
/// values differently.
using ModelRead = std::vector<std::string>;
ModelRead model_read(const Options& options, const std::vector<driver::Part>& parts) {
    ModelRead subject{options.load.inputs.front()};
    for (const driver::Part& part : parts) {
        subject.push_back(part.project->name);
        for (const std::string& constant : constants_of(*part.project)) subject.push_back(constant);
    }
    return subject;
}

void decide_assertions_of(const Options& options, const std::vector<driver::Part>& parts, const std::string& name,
                          driver::Evidence& evidence) {
    if (!parts.empty())  // all parts share their sources
        for (const auto& [file, digest] : files_of(*parts.front().project))
            evidence.model.emplace_back(name + file, digest);
    const auto add = [&](const std::string& subject, std::string answer) {
        evidence.assertions.push_back({name + subject, std::move(answer)});
    };
    for (const driver::Part& part : parts) {
        driver::Project& project = *part.project;
        Report report;
        driver::Settings settings = options;
        settings.claims.core = core_wanted(part, options);
        if (is_acceptable(project, options.load)) check_assertions(project, {settings, *options.run}, report);
        if (!is_acceptable(project, options.load)) {
            for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings())
                if (finding.rule->severity == diagnostics::Severity::error)
                    add(fmt::format("{}: {}", project.name, finding.message()), "error");
        }
        for (const driver::AssertionReport& assertion : report.assertions) {
            if (assertion.core && assertion.core->information) continue;
            std::string subject = assertion.title;
            if (assertion.core) subject = fmt::format("{} of {}", assertion.core->property, assertion.core->component);
            add(subject, std::string(name_of(assertion.answer)));
        }
    }
}

}  // namespace

void decide_assertions(const Options& options, const simulation::Scenario& scenario, driver::Evidence& evidence) {
    std::set<ModelRead> done;
    for (std::size_t controller = 0; controller < scenario.controller_count(); ++controller) {
        Options model_options = over_the_model(options, scenario, controller, Verb::check);
        const std::vector<driver::Part> parts = driver::load_parts(model_options, model_options.run->budget());
        record_projects(parts, model_options, options);
        if (done.insert(model_read(model_options, parts)).second)
            decide_assertions_of(model_options, parts, in_front(scenario, controller), evidence);
    }
}

void decide_conformance(const Options& options, const simulation::Scenario& scenario, driver::Evidence& evidence) {
    std::set<std::pair<std::string, ModelRead>> done;
    for (std::size_t controller = 0; controller < scenario.controller_count(); ++controller) {
        Options model_options = over_the_model(options, scenario, controller, Verb::conform);
        model_options.load.component = scenario.controller_at(controller).component.text;
        model_options.code.cycle = scenario.units_per_step;
        model_options.code.cycle_given = true;
        const std::vector<driver::Part> parts = driver::load_parts(model_options, model_options.run->budget());
        record_projects(parts, model_options, options);
        if (!done.emplace(model_options.load.component, model_read(model_options, parts)).second) continue;
        Report report;
        for (const driver::Part& part : parts)
            if (is_acceptable(*part.project, model_options.load) && !part.again &&
                !driver::code_components(part.project->system, model_options.load.component, true).empty())
                check_conformance(*part.project, model_options, report);
        const std::string name = in_front(scenario, controller);
        for (const ConformanceReport& component_report : report.conformance)
            evidence.conformance.push_back(
                {name + component_report.component, std::string(name_of(component_report.result.outcome))});
        if (report.conformance.empty()) evidence.conformance.push_back({name + model_options.load.component, "error"});
    }
}

bool decide_claims(const Options& options, driver::Evidence& evidence, std::unique_ptr<Simulation>& simulation) {
    simulation = load_simulation(options);
    driver::Project& project = *simulation->project;
    if (!is_acceptable(project, options.load)) return false;
    const auto controller = build_controller(*simulation, options);
    if (controller == nullptr || !project.diagnostics.ok()) return false;
    simulation::Scenario scenario = simulation->scenario;
    scenario.bands.clear();
    scenario.abstraction.reset();  // the evidence does not include a chain
    simulation::Plan plan = simulation->plan;
    plan.scenario = &scenario;
    simulation::RunOptions run_options;
    run_options.threads = options.limits.threads;
    run_options.record = false;
    run_options.interrupted = when_a_limit_is_reached(options);
    const simulation::RunResult found =
        simulation::run_trials(plan, drives_of(*simulation, *controller), run_options, project.diagnostics);
    if (!project.diagnostics.ok()) return false;
    if (found.interrupted) options.run->budget().check();  // throws the reached limit
    evidence.scenario = scenario.name.text;
    std::string texts(project.sources.source_text(simulation->scenario.name.span.source));
    for (const std::string& drawing : simulation->scenario.drawings) texts += driver::content_digest(drawing);
    evidence.scenario_digest = driver::content_digest(texts);
    evidence.seed = scenario.seed;
    for (std::size_t c = 0; c < found.claims.size(); ++c) {
        const simulation::ClaimResult& claim = found.claims[c];
        evidence.claims.push_back({scenario.claims[c].text, simulation::verdict_word(claim.verdict),
                                   claim.trial_count(), claim.successes, claim.interval.low, claim.interval.high});
    }
    return true;
}

}  // namespace robochart::app
