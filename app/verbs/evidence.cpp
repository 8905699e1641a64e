// SPDX-License-Identifier: Apache-2.0
// Decides everything about a scenario's model with the constants of the options: its assertions, the conformance of the
// robots' code, and the scenario's claims.
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
#include "driver/claims/model_claims.hpp"

namespace robochart::app {

namespace {

/// The texts of a model by file name, without the built-in libraries.
driver::Evidence::Files files_of(const driver::Project& project) {
    driver::Evidence::Files files;
    for (std::size_t i = 0; i < project.sources.size(); ++i) {
        const auto source = static_cast<diagnostics::SourceId>(i);
        const std::filesystem::path path = project.sources.path(source);
        const std::string ending = path.extension().string();
        if (std::filesystem::exists(path) && (ending == ".rct" || ending == ".assertions"))
            files.emplace_back(path.filename().string(), driver::content_digest(project.sources.source_text(source)));
    }
    std::ranges::sort(files);
    files.erase(std::unique(files.begin(), files.end()), files.end());
    return files;
}

Options over_the_model(const Options& options, const simulation::Scenario& scenario, std::size_t controller,
                       Verb verb) {
    Options wanted = options;
    static_cast<driver::Settings&>(wanted) = settings_for(scenario, options, controller);
    set_verb(wanted, verb);
    wanted.limits.progress = false;
    return wanted;
}

/// The prefix of results about a controller: "leaders: ", or "" for the first controller.
std::string in_front(const simulation::Scenario& scenario, std::size_t controller) {
    return controller == 0 ? "" : scenario.controller_name(controller) + ": ";
}

/// A model with its constants, for comparisons that do not depend on the notation of options.
using ModelRead = std::vector<std::string>;
ModelRead model_read(const Options& wanted, const std::vector<driver::Part>& parts) {
    ModelRead subject{wanted.load.inputs.front()};
    for (const driver::Part& part : parts) {
        subject.push_back(part.project->name);
        for (const std::string& each : constants_of(*part.project)) subject.push_back(each);
    }
    return subject;
}

void decide_assertions_of(const Options& wanted, const std::vector<driver::Part>& parts, const std::string& name,
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
        driver::Settings asked = wanted;
        asked.claims.core = core_wanted(part, wanted);
        if (is_acceptable(project, wanted.load)) check_assertions(project, {asked, *wanted.run}, report);
        if (!is_acceptable(project, wanted.load)) {
            for (const diagnostics::Diagnostic& each : project.diagnostics.sorted_findings())
                if (each.rule->severity == diagnostics::Severity::error)
                    add(fmt::format("{}: {}", project.name, each.message()), "error");
        }
        for (const driver::AssertionReport& each : report.assertions) {
            if (each.core && each.core->information) continue;
            std::string subject = each.title;
            if (each.core) subject = fmt::format("{} of {}", each.core->property, each.core->component);
            add(subject, std::string(name_of(each.answer)));
        }
    }
}

}  // namespace

void decide_assertions(const Options& options, const simulation::Scenario& scenario, driver::Evidence& evidence) {
    std::set<ModelRead> done;
    for (std::size_t controller = 0; controller < scenario.controller_count(); ++controller) {
        Options wanted = over_the_model(options, scenario, controller, Verb::check);
        const std::vector<driver::Part> parts = driver::load_parts(wanted, wanted.run->budget());
        record_projects(parts, wanted, options);
        if (done.insert(model_read(wanted, parts)).second)
            decide_assertions_of(wanted, parts, in_front(scenario, controller), evidence);
    }
}

void decide_conformance(const Options& options, const simulation::Scenario& scenario, driver::Evidence& evidence) {
    std::set<std::pair<std::string, ModelRead>> done;
    for (std::size_t controller = 0; controller < scenario.controller_count(); ++controller) {
        Options wanted = over_the_model(options, scenario, controller, Verb::conform);
        wanted.load.component = scenario.controller_at(controller).component.text;
        wanted.code.cycle = scenario.units_per_step;
        wanted.code.cycle_given = true;
        const std::vector<driver::Part> parts = driver::load_parts(wanted, wanted.run->budget());
        record_projects(parts, wanted, options);
        if (!done.emplace(wanted.load.component, model_read(wanted, parts)).second) continue;
        Report report;
        for (const driver::Part& part : parts)
            if (is_acceptable(*part.project, wanted.load) && !part.again &&
                !driver::code_components(part.project->system, wanted.load.component).empty())
                check_conformance(*part.project, wanted, report);
        const std::string name = in_front(scenario, controller);
        for (const ConformanceReport& each : report.conformance)
            evidence.conformance.push_back({name + each.component, std::string(name_of(each.result.outcome))});
        if (report.conformance.empty()) evidence.conformance.push_back({name + wanted.load.component, "error"});
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
    simulation::RunOptions wanted;
    wanted.threads = options.limits.threads;
    wanted.record = false;
    wanted.interrupted = when_a_limit_is_reached(options);
    const simulation::RunResult found =
        simulation::run_trials(plan, drives_of(*simulation, *controller), wanted, project.diagnostics);
    if (!project.diagnostics.ok()) return false;
    if (found.interrupted) options.run->budget().check();  // throws the reached limit
    evidence.scenario = scenario.name.text;
    std::string texts(project.sources.source_text(simulation->scenario.name.span.source));
    for (const std::string& drawing : simulation->scenario.drawings) texts += driver::content_digest(drawing);
    evidence.scenario_digest = driver::content_digest(texts);
    evidence.seed = scenario.seed;
    for (std::size_t c = 0; c < found.claims.size(); ++c) {
        const simulation::ClaimResult& each = found.claims[c];
        evidence.claims.push_back({scenario.claims[c].text, simulation::verdict_word(each.verdict), each.trial_count(),
                                   each.successes, each.interval.low, each.interval.high});
    }
    return true;
}

}  // namespace robochart::app
