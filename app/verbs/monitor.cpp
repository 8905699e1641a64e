// SPDX-License-Identifier: Apache-2.0
// Implements `emit monitor` and `simulate --monitor`.
#include "app/verbs/monitor.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "app/base/numbers.hpp"
#include "app/claims/event_order.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/rules/claim_duties.hpp"
#include "app/rules/record_rules.hpp"
#include "app/rules/rule_duties.hpp"
#include "app/rules/show_findings.hpp"
#include "app/verbs/verbs.hpp"
#include "app/verbs/write_files.hpp"
#include "base/diagnostics/escape.hpp"
#include "checker/process/term.hpp"
#include "claims/sleec/emit/monitor_file.hpp"
#include "claims/sleec/obligations/samples.hpp"
#include "conformance/monitor/cycle_cache.hpp"
#include "conformance/monitor/monitor.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "driver/model/places.hpp"
#include "driver/settings/rules.hpp"
#include "simulation/trial/kind_traces.hpp"

namespace robochart::app {
namespace {

/// Builds the monitor tables of one component. On failure, reports a diagnostic and returns null.
std::unique_ptr<conformance::MonitorBuild> build_monitor(driver::Project& project, const Options& options,
                                                         const ir::ComponentRef& component,
                                                         std::uint32_t cycle_length) {
    const auto refuse = [&](const std::string& why, diagnostics::Span place = {}) {
        project.diagnostics.report(rules::no_monitor,
                                   place.is_known() ? place : driver::declared_at(project.system, component),
                                   {component.path, why});
        return nullptr;
    };
    const cpp_emit::EventOrder order = event_order(project, component);
    if (!project.diagnostics.ok()) return nullptr;
    const refine::Limits bounds = limits(options, "monitor of " + component.path);
    try {
        std::string error;
        const auto model =
            conformance::CyclicModel::load(project.system, project.instantiation, component, cycle_length, bounds,
                                           project.sources, project.diagnostics, error, order);
        if (model == nullptr) return refuse(error);
        return conformance::MonitorBuild::make(*model, bounds, project.sources);
    } catch (const std::length_error& large) {
        return refuse(large.what());
    } catch (const cspm::EvaluationError& failed) {
        return refuse(runs::failure_text(failed, project.system), failed.span);
    } catch (const conformance::AlphabetError& mismatch) {
        return refuse(mismatch.what());
    }
}

/// The monitors of the robots of one kind.
class Monitors final : public simulation::Guard {
public:
    Monitors(std::unique_ptr<conformance::MonitorBuild> build, const cpp_emit::DriveEmission& emission)
        : build_(std::move(build)), emission_(emission) {}
    [[nodiscard]] Maker make_observer(Maker other) override;
    [[nodiscard]] std::string summary_lines() const override;

private:
    class Watch;

    [[nodiscard]] std::unique_ptr<conformance::CycleCache> borrow_cache();
    void give_back(std::unique_ptr<conformance::CycleCache>);

    std::unique_ptr<conformance::MonitorBuild> build_;
    const cpp_emit::DriveEmission& emission_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<conformance::CycleCache>>
        idle_;  ///< caches of finished trials, for reuse in later trials
    std::atomic<std::uint64_t> robots_ = 0;
    /// Number of monitors that stopped because their robot left the finite instantiation.
    std::atomic<std::uint64_t> lost_ = 0;
};

/// The monitors of one trial.
class Monitors::Watch final : public simulation::Trace {
public:
    Watch(Monitors& all, std::unique_ptr<simulation::Trace> other)
        : all_(all), other_(std::move(other)), cycles_(all.borrow_cache()) {}
    ~Watch() override {
        all_.give_back(std::move(cycles_));
        all_.robots_ += monitors_.size();
        for (const Monitor& monitor : monitors_)
            if (monitor.verdict() == MonitorVerdict::unknown) ++all_.lost_;
    }
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

    void observe_cycle(std::size_t robot, std::uint64_t step, const rc_signal* inputs, const rc_actions& outputs,
                       rc_drive_result result) override {
        if (other_ != nullptr) other_->observe_cycle(robot, step, inputs, outputs, result);
        if (robot >= monitors_.size()) monitors_.resize(robot + 1, Monitor(all_.build_->tables()));
        if (result != RC_DRIVE_QUIESCENT && ended_before(robot)) return;
        cycles_->pass_cycle(monitors_[robot], inputs, outputs, result);
        if (monitors_[robot].verdict() == MonitorVerdict::violated) set_objection(monitors_[robot]);
    }

    [[nodiscard]] const simulation::Objection* current_objection() const override {
        return objection_.cause.empty() ? nullptr : &objection_;
    }

    [[nodiscard]] bool is_conclusive() const override {
        return std::ranges::none_of(
            monitors_, [](const Monitor& monitor) { return monitor.verdict() == MonitorVerdict::unknown; });
    }

private:
    /// True if the robot has already terminated, because a terminated robot reports its termination in every later
    /// cycle.
    bool ended_before(std::size_t robot) {
        ended_.resize(monitors_.size());
        return std::exchange(ended_[robot], std::uint8_t{1}) != 0;
    }

    void set_objection(const Monitor& monitor) {
        const std::string where = monitor.where();
        const std::string element = monitor.element();
        objection_.cause = fmt::format("its model does not allow {} here", monitor.event());
        const char* const separator = element.empty() || where.empty() ? "" : "; ";
        objection_.place = where + separator + element;
    }

    Monitors& all_;
    std::unique_ptr<simulation::Trace> other_;
    std::unique_ptr<conformance::CycleCache> cycles_;
    std::vector<Monitor> monitors_;
    std::vector<std::uint8_t> ended_;  ///< index: robot; filled when the first robot terminates
    simulation::Objection objection_;
};

std::unique_ptr<conformance::CycleCache> Monitors::borrow_cache() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty())
        return std::make_unique<conformance::CycleCache>(build_->tables(), emission_.inputs, emission_.outputs);
    auto cycles = std::move(idle_.back());
    idle_.pop_back();
    return cycles;
}

void Monitors::give_back(std::unique_ptr<conformance::CycleCache> cycles) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(cycles));
}

Monitors::Maker Monitors::make_observer(Maker other) {
    return [this, other = std::move(other)](std::uint32_t trial) {
        return std::make_unique<Watch>(*this, other ? other(trial) : nullptr);
    };
}

std::string Monitors::summary_lines() const {
    const auto& tables = build_->tables();
    std::string text = fmt::format("  monitors: {} states, {} columns; {} robots watched", tables.states,
                                   tables.columns, robots_.load());
    if (lost_ > 0)
        text +=
            fmt::format(", {} of them not to the end: they left the finite instantiation of the model", lost_.load());
    return text + "\n";
}

/// The guards of all kinds of robots. The environment has no guard.
class KindGuards final : public simulation::Guard {
public:
    KindGuards(const simulation::Scenario& scenario, std::vector<std::unique_ptr<Guard>> guards)
        : scenario_(scenario), guards_(std::move(guards)) {}

    [[nodiscard]] Maker make_observer(Maker other) override {
        std::vector<Maker> makers;
        for (const auto& guard : guards_) makers.push_back(guard->make_observer({}));
        return simulation::for_each_kind(scenario_, std::move(makers), std::move(other));
    }
    [[nodiscard]] std::string summary_lines() const override {
        std::string text;
        for (const auto& guard : guards_) text += guard->summary_lines();
        if (scenario_.environment) text += "  the environment is not watched\n";
        return text;
    }

private:
    const simulation::Scenario& scenario_;
    std::vector<std::unique_ptr<Guard>> guards_;
};

/// Makes the guard of one component. Errors are reported in the simulation's project.
std::unique_ptr<simulation::Guard> guard_of(Simulation& simulation, driver::Project& project,
                                            const cpp_emit::DriveEmission& emission, const std::string& component,
                                            const Options& options) {
    const std::uint32_t cycle = simulation.scenario.units_per_step;
    if (options.simulate.guarding_rules.empty()) {
        auto made =
            build_monitor(project, options, driver::code_components(project.system, component, true).front(), cycle);
        if (made == nullptr && project.diagnostics.ok())
            simulation.project->diagnostics.report(driver::rules::bad_option, {},
                                                   {fmt::format("--monitor: there is no monitor of {}", component)});
        for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings())
            if (&project != simulation.project.get() && finding.rule->severity == diagnostics::Severity::error)
                simulation.project->diagnostics.report(
                    driver::rules::bad_option, {}, {fmt::format("--monitor: {}: {}", component, finding.message())});
        return made == nullptr ? nullptr : std::make_unique<Monitors>(std::move(made), emission);
    }
    std::string error;
    const GuardedTimes times{cycle, durations::nanoseconds_of_seconds(simulation.scenario.time_unit),
                             options.load.inputs.front()};
    auto duties = find_rule_duties(options.simulate.guarding_rules, emission, times, options, error);
    if (duties == nullptr)
        simulation.project->diagnostics.report(
            driver::rules::bad_option, {},
            {fmt::format("--monitor {}: {}", diagnostics::escape_for_display(options.simulate.guarding_rules), error)});
    return duties == nullptr ? nullptr : std::make_unique<FollowGuard>(std::move(duties));
}

}  // namespace

namespace {

/// Two guards of the same robots.
class BothGuards final : public simulation::Guard {
public:
    BothGuards(std::unique_ptr<Guard> inner, std::unique_ptr<Guard> claims)
        : inner_(std::move(inner)), claims_(std::move(claims)) {}
    [[nodiscard]] Maker make_observer(Maker other) override {
        return claims_->make_observer(inner_->make_observer(std::move(other)));
    }
    [[nodiscard]] std::string summary_lines() const override {
        return inner_->summary_lines() + claims_->summary_lines();
    }

private:
    std::unique_ptr<Guard> inner_;
    std::unique_ptr<Guard> claims_;
};

std::unique_ptr<simulation::Guard> make_monitors(Simulation& simulation, const Options& options);

}  // namespace

std::unique_ptr<simulation::Guard> make_guard(Simulation& simulation, const Options& options) {
    auto monitors = make_monitors(simulation, options);
    if (!simulation.project->diagnostics.ok()) return nullptr;
    std::vector<FollowedKind> kinds;
    for (std::size_t kind = 0; kind < simulation.scenario.kind_count(); ++kind)
        kinds.push_back({&simulation.project_of(kind), &simulation.emission_of(kind)});
    auto duties = find_claim_duties(simulation.scenario, std::move(kinds), *simulation.project, options);
    if (duties == nullptr) return monitors;
    auto claims = std::make_unique<FollowGuard>(std::move(duties));
    if (monitors == nullptr) return claims;
    return std::make_unique<BothGuards>(std::move(monitors), std::move(claims));
}

namespace {

/// Makes the monitors of the model or of rules.
std::unique_ptr<simulation::Guard> make_monitors(Simulation& simulation, const Options& options) {
    if (!options.simulate.monitor || options.simulate.guarding_rules.ends_with(".claims")) return nullptr;
    const simulation::Scenario& scenario = simulation.scenario;
    std::vector<std::unique_ptr<simulation::Guard>> guards;
    for (std::size_t kind = 0; kind < scenario.kind_count(); ++kind) {
        driver::Project& project = kind == 0 ? *simulation.project : *simulation.others[kind - 1].project;
        guards.push_back(guard_of(simulation, project, simulation.emission_of(kind),
                                  scenario.kind_at(kind).component.text, options));
        if (guards.back() == nullptr) return nullptr;
    }
    if (!scenario.has_others()) return std::move(guards.front());
    return std::make_unique<KindGuards>(scenario, std::move(guards));
}

/// Writes the monitor of one rule file. Returns false, after printing the error, if there is none.
bool write_rule_monitor(const std::string& file, driver::Project& output, const Options& options, Report& report) {
    driver::LoadedRules loaded;
    loaded.diagnostics.set_budget(&options.run->budget());
    for (const std::string& code : options.load.allowed) loaded.diagnostics.allow_code(code);
    load_rules(file, loaded);
    record_rules(loaded, options);
    show_rule_findings(loaded, options);
    if (!loaded.rules || (options.load.deny_warnings && loaded.diagnostics.warning_count() > 0)) return false;
    try {
        const std::string below = fmt::format("monitor/{}/", sleec::monitor_name(file));
        const auto files = sleec::monitor_files(*loaded.rules, file, loaded.sources, sleec::WithoutLimit::eventually);
        return write_all(below, files, report.monitor_files, options, output);
    } catch (const sleec::NotDecided& error) {
        output.diagnostics.report(driver::rules::bad_option, {},
                                  {fmt::format("{}: {}", diagnostics::escape_for_display(file), error.what())});
        return false;
    }
}

}  // namespace

bool write_rule_monitors(const Options& options, Report& report) {
    if (!options.load.component.empty() || options.code.cycle_given || options.output.phase != Phase::none)
        throw UsageError("--component, --cycle and --print apply to models, not to rules");
    driver::Project output;
    output.diagnostics.set_budget(&options.run->budget());
    bool written = true;
    for (const std::string& file : options.load.inputs)
        written = write_rule_monitor(file, output, options, report) && written;
    show_findings(output, options);
    return written;
}

bool write_monitors(driver::Project& project, const Options& options, Report& report) {
    const auto components = driver::code_components(project.system, options.load.component, options.load.robosim);
    if (components.empty())
        project.diagnostics.report(rules::no_component, model_place(project),
                                   {options.load.component.empty() ? "the model" : options.load.component});
    for (const ir::ComponentRef& component : components) {
        const auto made = build_monitor(project, options, component, control_cycle(project, component, options));
        if (made == nullptr) return false;
        const std::string below = fmt::format("monitor/{}{}/", project.folder, file_name(project, component));
        const auto files = conformance::monitor_files(made->tables(), file_name(project, component));
        if (!write_all(below, files, report.monitor_files, options, project)) return false;
        const auto edit = options.run->edit();
        report.remarks.push_back(fmt::format("{}{}: {} states, {} columns, {} bytes of table", project.label,
                                             component.path, made->tables().states, made->tables().columns,
                                             with_commas(made->table_bytes())));
    }
    return project.diagnostics.ok();
}

}  // namespace robochart::app
