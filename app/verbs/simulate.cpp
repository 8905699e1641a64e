// SPDX-License-Identifier: Apache-2.0
// The verb `simulate`: runs a scenario with generated controllers of its model in trials, compares measures with bands,
// and writes pictures.
#include "app/verbs/simulate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <mutex>
#include <set>

#include "app/claims/event_order.hpp"
#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/progress.hpp"
#include "app/command/recording.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/pages/simulation_html.hpp"
#include "app/rules/claim_duties.hpp"
#include "app/verbs/monitor.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/json.hpp"
#include "base/diagnostics/spelling.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/project_claims.hpp"
#include "driver/settings/rules.hpp"
#include "frontend/syntax/syntax_rules.hpp"
#include "semantics/instantiate/instantiate.hpp"
#include "semantics/ir/query.hpp"
#include "simulation/report/report.hpp"
#include "simulation/scenario/read_scenario.hpp"
#include "simulation/scenario/rules.hpp"
#include "simulation/trial/kind_traces.hpp"
#include "simulation/trial/trace_log.hpp"

namespace robochart::app {
namespace fs = std::filesystem;

namespace {

/// Returns the time unit that is declared in claims files in the folder of the scenario, or in the folders of its
/// models.
std::optional<claims::DeclaredUnit> declared_unit(driver::Project& project, diagnostics::SourceId source,
                                                  const Options& options) {
    diagnostics::Diagnostics reported_later;
    const simulation::Scenario scenario = simulation::read_scenario(project.sources, source, reported_later);
    std::vector<std::string> paths{options.load.inputs.front()};
    for (std::size_t i = 0; i < scenario.controller_count(); ++i)
        paths.push_back(model_of(scenario, options.load.inputs.front(), i));
    return driver::unit_beside(paths, project.sources, project.diagnostics);
}

/// Reports an error if the time unit of the scenario differs from the declared one.
void compare_units(const simulation::Scenario& scenario, const std::optional<claims::DeclaredUnit>& declared,
                   driver::Project& project) {
    const auto unit = durations::nanoseconds_of_seconds(scenario.time_unit);
    if (!declared || !unit || !scenario.unit_span.is_known() || *unit == declared->nanoseconds) return;
    claims::report_difference(*declared, {*unit, scenario.unit_span}, project.sources, project.diagnostics);
}

}  // namespace

simulation::Scenario read_scenario_of(driver::Project& project, const Options& options) {
    std::string error;
    const auto source = project.sources.load_file(options.load.inputs.front(), error);
    if (!source) {
        project.diagnostics.report(
            frontend::syntax::unreadable, {},
            {options.load.inputs.front(), error + driver::files_inside(options.load.inputs.front(), ".scenario")});
        return {};
    }
    const auto declared = declared_unit(project, *source, options);
    simulation::Scenario scenario =
        simulation::read_scenario(project.sources, *source, project.diagnostics,
                                  declared ? durations::Unit(declared->nanoseconds) : std::nullopt);
    compare_units(scenario, declared, project);
    if (options.simulate.trials > 0) scenario.set_trials(options.simulate.trials);
    if (options.simulate.seed) scenario.seed = *options.simulate.seed;
    record_text(project.sources, *source, options);
    RunRecorder& recorder = options.run->recorder();
    for (std::size_t i = 0; i < scenario.drawings.size(); ++i)
        recorder.add_input(scenario.drawing_files[i], scenario.drawings[i]);
    if (options.verb == Verb::simulate) recorder.set_seed(scenario.seed);
    return scenario;
}

std::string model_of(const simulation::Scenario& scenario, const std::string& path, std::size_t controller) {
    const fs::path folder = fs::path(path).parent_path();
    const std::string& own = scenario.controller_at(controller).model;
    const std::string& given = own.empty() ? scenario.model : own;
    const fs::path model = given.empty() ? folder : folder / given;
    return model.empty() ? "." : model.string();
}

namespace {

std::string name_in(const std::string& constant) {
    return constant.substr(0, constant.find('='));
}

/// Reports names in `--const` that are not controllers of the scenario.
void check_addresses(driver::Project& project, const simulation::Scenario& scenario, const Options& options) {
    for (const std::string& constant : options.instantiation.constants) {
        if (simulation::find_constant_address(scenario, name_in(constant))) continue;
        const std::vector<std::string> known = simulation::controller_names(scenario);
        const std::string given = constant.substr(0, constant.find('.'));
        const std::string meant = diagnostics::nearest_spelling(given, known);
        std::string help;
        if (!meant.empty())
            help = fmt::format(", did you mean {}?", meant);
        else if (!known.empty())
            help = fmt::format("; there is {}", fmt::join(known, ", "));
        project.diagnostics.report(
            driver::rules::bad_option, {},
            {fmt::format("--const {}: there is no kind of robots called {} in the scenario{}",
                         diagnostics::escape_for_display(constant), diagnostics::escape_for_display(given), help)});
    }
}

}  // namespace

driver::Settings settings_for(const simulation::Scenario& scenario, driver::Settings settings, std::size_t controller) {
    std::vector<std::string> own;
    for (const std::string& constant : settings.instantiation.constants) {
        const auto address = simulation::find_constant_address(scenario, name_in(constant));
        if (address && address->controller == controller)
            own.push_back(address->constant + constant.substr(std::min(constant.find('='), constant.size())));
    }
    settings.load.inputs = {model_of(scenario, settings.load.inputs.front(), controller)};
    settings.instantiation.constants = std::move(own);
    settings.instantiation.weaker_constants = scenario.controller_at(controller).constants;
    return settings;
}

std::vector<std::string> constants_of(const driver::Project& project) {
    std::vector<std::string> result;
    for (const auto& [name, value] : project.asked.constants) result.push_back(fmt::format("{}={}", name, value));
    return result;
}

namespace {

using simulation::Name;

/// Lists the controllers: "swarm::Sheep", "swarm::Sheep; 2 dog by swarm::Dog; environment sky::Sun".
std::string controllers_text(const simulation::Scenario& scenario) {
    std::string text = scenario.component.text;
    for (const simulation::RobotKind& kind : scenario.others)
        text += fmt::format("; {} {} by {}", kind.robots, kind.kind.text, kind.component.text);
    if (scenario.environment) text += "; environment " + scenario.environment->component.text;
    return text;
}

/// Generates the code of one component. Errors are reported in the scenario's project.
cpp_emit::DriveEmission emit_component(Simulation& simulation, driver::Project& project, const Name& component,
                                       const std::string& model) {
    const auto components = driver::code_components(project.system, component.text, true);
    if (components.empty()) {
        simulation.project->diagnostics.report(simulation::rules::no_controller, component.span,
                                               {component.text, model});
        return {};
    }
    const std::uint32_t units = simulation.scenario.units_per_step;
    const bool robosim = ir::is_robosim(project.system, components.front());
    const std::int64_t cycle =
        robosim ? ir::cycle_of(project.system, project.instantiation, components.front()) : units;
    if (cycle != units) {
        simulation.project->diagnostics.report(
            simulation::rules::out_of_range, component.span,
            {fmt::format(
                "the cycle of {} is {} time units long, and a control step of the scenario is {}: they must be equal",
                component.text, cycle, units)});
        return {};
    }
    cpp_emit::Options generator;
    generator.cycle_length = units;
    generator.sources = &project.sources;
    generator.order = event_order(project, components.front());
    return cpp_emit::emit_drive(project.system, project.instantiation, components.front(), generator,
                                project.diagnostics);
}

/// Loads the model of another controller. If this model is not acceptable, it replaces the simulation's project, so
/// that its findings are shown.
bool load_other(Simulation& simulation, std::size_t number, const Options& options) {
    OtherController other;
    driver::Settings settings = settings_for(simulation.scenario, options, number);
    if (follows_claims(simulation.scenario, options)) settings.load.claims = driver::ClaimUse::read;
    other.model = settings.load.inputs.front();
    other.project = driver::load_project(settings, options.run->budget());
    driver::read_ignored_claims(*other.project, settings.load);
    record_project(*other.project, settings, options);
    if (is_acceptable(*other.project, settings.load))
        other.emission = emit_component(simulation, *other.project, simulation.scenario.controller_at(number).component,
                                        other.model);
    const bool good = is_acceptable(*other.project, settings.load);
    if (!good) simulation.project = std::move(other.project);
    simulation.others.push_back(std::move(other));
    return good && simulation.project->diagnostics.ok();
}

void emit_controllers(Simulation& simulation, const std::string& model, const Options& options) {
    simulation.emission = emit_component(simulation, *simulation.project, simulation.scenario.component, model);
    if (!simulation.project->diagnostics.ok()) return;
    const simulation::Scenario& scenario = simulation.scenario;
    for (std::size_t number = 1; number < scenario.controller_count(); ++number)
        if (!load_other(simulation, number, options)) return;
    simulation::Emissions emissions{{}, nullptr};
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind)
        emissions.kinds.push_back(&simulation.emission_of(kind));
    if (scenario.environment) emissions.environment = &simulation.others.back().emission;
    driver::Project& project = *simulation.project;
    simulation.plan = simulation::bind_scenario(simulation.scenario, emissions, project.diagnostics);
    // The first initial placement is computed here, so that robots that do not fit into the world are reported before
    // anything is compiled.
    if (project.diagnostics.ok()) (void)simulation::start(simulation.scenario, 0, project.diagnostics);
}

std::string with_progress(const simulation::RunProgress& p) {
    const double speed = p.seconds > 0 ? p.simulated_seconds / p.seconds : 0;
    return fmt::format("trial {} of {}: {:.1f} of {:.0f} s simulated, {:.0f} times real time",
                       std::min(p.trials_done + 1, p.trials), p.trials, p.simulated_seconds, p.total_seconds, speed);
}

}  // namespace

std::function<bool()> when_a_limit_is_reached(const Options& options) {
    return [&budget = options.run->budget()] { return !budget.reached_limit().empty(); };
}

std::function<void(const simulation::RunProgress&)> progress_reports(const Options& options,
                                                                     const std::string& subject) {
    if (options.output.progress == ProgressMode::json)
        return [subject](const simulation::RunProgress& p) {
            using diagnostics::round_to_places;
            print_error_styled(diagnostics::json_text({{"event", "progress"},
                                                       {"subject", subject},
                                                       {"phase", "simulating"},
                                                       {"seconds", round_to_places(p.seconds, 3)},
                                                       {"trials", p.trials},
                                                       {"trialsDone", p.trials_done},
                                                       {"simulatedSeconds", round_to_places(p.simulated_seconds, 1)},
                                                       {"totalSeconds", round_to_places(p.total_seconds, 1)}}) +
                               "\n");
        };
    if (!progress_line_wanted(options.output)) return {};
    return [](const simulation::RunProgress& p) {
        redraw_error_line(p.trials_done == p.trials ? std::string() : with_progress(p));
    };
}

namespace {

Exit exit_of(const simulation::RunResult& result) {
    if (result.interrupted) return Exit::inconclusive;
    if (result.has_failed()) return Exit::failed;
    return result.all_hold() ? Exit::success : Exit::inconclusive;
}

Exit before_trials(const Options& options, const std::string& why) {
    const std::string text = fmt::format("{} before the trials had ended: the bands are not judged\n", why);
    const diagnostics::Json none = diagnostics::Json::array();
    output_json(options, {{"schema", "robochart-verify/simulation/1"},
                          {"scenario", options.load.inputs.front()},
                          {"trials", none},
                          {"interrupted", true},
                          {"limit", why},
                          {"bands", none},
                          {"files", none},
                          {"exit", static_cast<int>(Exit::inconclusive)}});
    if (options.output.format == Format::json) {
        print_error_text(text);
    } else {
        app::print_text(text);
    }
    return Exit::inconclusive;
}

void print_text(const Simulation& simulation, const simulation::RunResult& result, const Options& options,
                const OtherStage& stage, const std::vector<std::string>& files, const std::string& notes) {
    const simulation::Scenario& scenario = simulation.scenario;
    if (!options.output.quiet) {
        print("scenario {}: {} robots, {} trial{} of {:g} s, seed {}{}; controller {}\n", scenario.name.text,
              scenario.all_robots(), scenario.trials, scenario.trials == 1 ? "" : "s", scenario.duration, scenario.seed,
              stage.name.empty() ? "" : ", in " + stage.name, controllers_text(scenario));
        print("{}\n", simulation::run_text(scenario, result));
        if (!result.bands.empty()) print("bands\n{}\n", simulation::bands_text(scenario, result));
        if (!result.claims.empty()) print("claims\n{}\n", simulation::claims_text(scenario, result.claims));
        if (!result.claims.empty()) print("in this world\n{}\n", simulation::world_text(scenario));
        if (!files.empty()) print("files\n");
        for (const std::string& file : files) print("  {}\n", diagnostics::escape_for_display(file));
        print("{}{}", notes, files.empty() && notes.empty() ? "" : "\n");
    }
    if (result.interrupted)
        print("{}: {}\n", options.run->budget().reached_limit(),
              result.claims.empty() ? "the bands are not judged" : "what was not decided by then is open");
    else if (result.has_stopped_trial())
        print("a controller stopped: see above\n");
    else
        print("{}{}\n", result.watched ? "" : not_all_watched, simulation::summary_text(result));
}

/// The first log that a thread could not write.
struct LogFailure {
    std::mutex mutex;
    std::string text;
};

simulation::Guard::Maker log_maker_of(const Simulation& simulation, std::size_t kind, const Options& options,
                                      LogFailure& failure) {
    simulation::TraceLogOptions log_options;
    log_options.folder = options.simulate.log;
    log_options.format = options.simulate.log_format;
    log_options.component = simulation.scenario.kind_at(kind).component.text;
    log_options.model = model_of(simulation.scenario, options.load.inputs.front(), kind);
    log_options.constants = constants_of(simulation.project_of(kind));
    log_options.first = simulation.scenario.first_robot(kind);
    log_options.scenario = simulation.scenario.name.text;
    log_options.run = run_line(record_of(options));
    log_options.budget = &options.run->budget();
    log_options.failed = [&failure](const std::string& error) {
        const std::lock_guard lock(failure.mutex);
        if (failure.text.empty()) failure.text = error;
    };
    return [&simulation, kind, log_options](std::uint32_t trial) {
        return std::make_unique<simulation::TraceLog>(log_options, simulation.scenario, simulation.emission_of(kind),
                                                      trial);
    };
}

simulation::Guard::Maker log_maker(const Simulation& simulation, const Options& options, LogFailure& failure) {
    if (simulation.scenario.others.empty()) return log_maker_of(simulation, 0, options, failure);
    std::vector<simulation::Guard::Maker> makers;
    for (std::size_t kind = 0; kind < simulation.scenario.kind_count(); ++kind)
        makers.push_back(log_maker_of(simulation, kind, options, failure));
    return simulation::for_each_kind(simulation.scenario, std::move(makers));
}

}  // namespace

namespace {

/// Adds the claims to the hash, because trials follow them. Adds nothing if the settings ignore claims.
void add_claims(const driver::Project& project, diagnostics::Hasher& hasher) {
    if (project.claims->ignored) return;
    hasher.add(static_cast<std::uint64_t>(project.unit.value_or(0)));
    for (const claims::CheckedClaim& claim : project.claims->checked.claims) {
        hasher.add(claim.name);
        hasher.add(claim.component.path);
        hasher.add(claim.wording);
    }
}

}  // namespace

void add_trials(const Simulation& simulation, diagnostics::Hasher& hasher) {
    hasher.add(simulation.project->sources.source_text(simulation.scenario.name.span.source));
    for (const std::string& drawing : simulation.scenario.drawings) hasher.add(drawing);
    const auto add = [&](const cpp_emit::DriveEmission& emission) {
        for (const auto& file : emission.files) {
            hasher.add(file.path);
            hasher.add(file.text);
        }
    };
    add(simulation.emission);
    for (const OtherController& other : simulation.others) add(other.emission);
    add_claims(*simulation.project, hasher);
    for (const OtherController& other : simulation.others) add_claims(*other.project, hasher);
}

simulation::Drives drives_of(const Simulation& simulation, const simulation::Controller& first) {
    std::vector<const rc_drive*> drives{&first.drive()};
    for (const OtherController& other : simulation.others) drives.push_back(&other.controller->drive());
    const rc_drive* environment = nullptr;
    if (simulation.scenario.environment) {
        environment = drives.back();
        drives.pop_back();
    }
    return {std::move(drives), environment};
}

std::unique_ptr<simulation::Controller> build_controller(Simulation& simulation, const Options& options) {
    diagnostics::Diagnostics& found = simulation.project->diagnostics;
    const auto build = [&](const cpp_emit::DriveEmission& emission, const Name& component) {
        std::string error;
        auto made = simulation::Controller::build(emission, "", error, found.budget(), options.run->cache());
        if (made == nullptr) found.report(simulation::rules::not_compiled, component.span, {error});
        return made;
    };
    const simulation::Scenario& scenario = simulation.scenario;
    auto controller = build(simulation.emission, scenario.component);
    for (std::size_t i = 0; controller != nullptr && i < simulation.others.size(); ++i) {
        OtherController& other = simulation.others[i];
        other.controller = build(other.emission, scenario.controller_at(i + 1).component);
        if (other.controller == nullptr) return nullptr;
    }
    if (controller != nullptr)
        simulation::find_states(simulation.scenario,
                                simulation::machines_of(scenario, drives_of(simulation, *controller)), found);
    return controller;
}

void show_all_diagnostics(const Simulation& simulation, const Options& options) {
    (void)show_diagnostics(*simulation.project, options);
    std::set<std::string> shown;
    // Findings that two kinds of one model share are shown once.
    const auto is_new = [&](const driver::Project& project) {
        bool found = false;
        for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings()) {
            const std::string path =
                finding.span.is_known() ? std::string(project.sources.path(finding.span.source)) : "";
            found =
                shown
                    .insert(fmt::format("{}:{}:{}:{}", path, finding.span.begin, finding.rule->code, finding.message()))
                    .second ||
                found;
        }
        return found;
    };
    (void)is_new(*simulation.project);
    for (const OtherController& other : simulation.others)
        if (other.project != nullptr && is_new(*other.project)) (void)show_diagnostics(*other.project, options);
}

std::unique_ptr<Simulation> load_simulation(const Options& options) {
    auto simulation = std::make_unique<Simulation>();
    simulation->project = std::make_unique<driver::Project>();
    simulation->scenario = read_scenario_of(*simulation->project, options);
    if (options.load.inputs.size() != 1)
        simulation->project->diagnostics.report(driver::rules::bad_option, {}, {"one scenario at a time"});
    if (simulation->project->diagnostics.ok()) check_addresses(*simulation->project, simulation->scenario, options);
    if (!simulation->project->diagnostics.ok()) return simulation;
    driver::Settings model = settings_for(simulation->scenario, options, 0);
    if (follows_claims(simulation->scenario, options)) {
        model.load.claims = driver::ClaimUse::read;
        const std::string& file = options.simulate.guarding_rules;
        if (file.ends_with(".claims")) model.load.inputs.push_back(file);
    }
    simulation->project = driver::load_project(model, options.run->budget());
    driver::read_ignored_claims(*simulation->project, model.load);
    record_project(*simulation->project, model, options);
    if (!is_acceptable(*simulation->project, options.load)) return simulation;
    simulation->scenario = read_scenario_of(*simulation->project, options);
    emit_controllers(*simulation, model.load.inputs.front(), options);
    return simulation;
}

namespace {

/// Writes the page of `--html`. A write error is reported in the project's diagnostics.
void write_page(Simulation& simulation, const simulation::RunResult& result, const simulation::Machines& machines,
                const std::string& simulator, const std::string& monitors, const std::string& notes,
                const std::vector<std::string>& files, const Options& options) {
    std::vector<KindModel> kinds{{simulation.project.get(), &simulation.emission}};
    for (std::size_t kind = 1; kind < simulation.scenario.kind_count(); ++kind)
        kinds.push_back({simulation.others[kind - 1].project.get(), &simulation.emission_of(kind)});
    const std::string page = render_simulation_html(
        {kinds, simulation.scenario, machines, result, simulator, monitors, notes, files}, options);
    const std::string error = diagnostics::replace_file(options.output.html, page, &options.run->budget());
    if (!error.empty()) simulation.project->diagnostics.report(rules::unwritable, {}, {error});
}

Exit show_errors(const driver::Project& project, const Options& options, Exit exit) {
    show_diagnostics(project, options);
    return exit;
}

Exit simulate(const Options& options, const OtherStage& stage) {
    const auto simulation = load_simulation(options);
    if (!simulation->scenario.variations.empty()) return sweep(options, stage);
    driver::Project& project = *simulation->project;
    if (!options.simulate.compare.empty())
        project.diagnostics.report(driver::rules::bad_option, {},
                                   {"--compare takes a scenario in which something varies"});
    if (!is_acceptable(project, options.load)) {
        show_diagnostics(project, options);
        return refusal_code(project);
    }
    if (simulation->scenario.abstraction) return study_chain(*simulation, options, stage);
    const auto controller = build_controller(*simulation, options);
    if (controller == nullptr || !project.diagnostics.ok()) return show_errors(project, options, Exit::bad_input);
    simulation::RunOptions run_options;
    run_options.threads = stage.parallel ? options.limits.threads : 1;
    run_options.stage = stage.make;
    run_options.record = options.simulate.pictures || !options.output.html.empty();
    LogFailure failure;
    if (!options.simulate.log.empty()) run_options.trace = log_maker(*simulation, options, failure);
    const auto monitors = make_guard(*simulation, options);
    if (!project.diagnostics.ok()) return show_errors(project, options, Exit::bad_input);
    if (monitors != nullptr) run_options.trace = monitors->make_observer(run_options.trace);
    run_options.interrupted = when_a_limit_is_reached(options);
    run_options.progress = progress_reports(options, simulation->scenario.name.text);
    const simulation::Drives drives = drives_of(*simulation, *controller);
    const simulation::Machines machines = simulation::machines_of(simulation->scenario, drives);
    const simulation::RunResult result =
        simulation::run_trials(simulation->plan, drives, run_options, project.diagnostics);
    if (!failure.text.empty()) project.diagnostics.report(rules::unwritable, {}, {failure.text});
    if (!project.diagnostics.ok() && !result.has_stopped_trial()) return show_errors(project, options, Exit::bad_input);
    std::string notes = monitors == nullptr ? "" : monitors->summary_lines();
    std::vector<std::string> files;
    if (options.simulate.pictures && !result.interrupted)
        files = write_simulation_files(*simulation, result, machines, options, notes);
    if (!options.output.html.empty() && !result.interrupted)
        write_page(*simulation, result, machines, stage.name, monitors == nullptr ? "" : monitors->summary_lines(),
                   notes, files, options);
    options.run->finish();
    // An error at this point is either a stopped trial or a file that could not be written.
    const bool unwritable = !project.diagnostics.ok() && !result.has_stopped_trial();
    const Exit exit = unwritable ? Exit::bad_input : exit_of(result);
    if (unwritable && options.output.format == Format::json) return show_errors(project, options, exit);
    if (!unwritable)
        output_document(options, [&](Format) {
            return simulation::result_json(simulation->scenario, result,
                                           simulation::guard_json(monitors.get(), result.watched), files,
                                           static_cast<int>(exit));
        });
    if (options.output.format == Format::json) return exit;
    show_all_diagnostics(*simulation, options);
    print_text(*simulation, result, options, stage, files, notes);
    return exit;
}

/// Moves a rule file from the inputs to the option --monitor, so that it guards the trials.
Options with_guarding_rules(Options options) {
    const auto is_rules = [](const std::string& input) {
        return input.ends_with(".sleec") || input.ends_with(".claims");
    };
    for (const std::string& input : options.load.inputs) {
        if (!is_rules(input)) continue;
        if (!options.simulate.monitor) throw UsageError("RULES.sleec and MODEL.claims need --monitor");
        if (!options.simulate.guarding_rules.empty()) throw UsageError("--monitor takes one file of rules or claims");
        options.simulate.guarding_rules = input;
    }
    std::erase_if(options.load.inputs, is_rules);
    if (options.load.inputs.empty()) throw UsageError("simulate needs a scenario");
    return options;
}

}  // namespace

Exit run_simulate(const Options& given, const OtherStage& stage) {
    const Options options = with_guarding_rules(given);
    options.run->last_word([options](const std::string& why) { return before_trials(options, why); });
    try {
        return simulate(options, stage);
    } catch (const cpp_emit::NoCompiler& missing) {
        return options.run->end_run(missing.what());
    }
}

int simulate_program(const char* program, int argc, char** argv, const OtherStage& stage) {
    std::vector<const char*> words{program, "simulate"};
    words.insert(words.end(), argv + 1, argv + argc);
    return run_command(program, static_cast<int>(words.size()), words.data(),
                       [&](const Options& options) { return run_simulate(options, stage); });
}

Exit run_simulate(const Options& options) {
    return run_simulate(options, {"", simulation::embedded_stage, true});
}

}  // namespace robochart::app
