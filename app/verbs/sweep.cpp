// SPDX-License-Identifier: Apache-2.0
// Runs `simulate` with a scenario that has variations: decides its claims at every point, one after another. The
// results of a point are stored in the cache, so a run continues after the last finished point of an earlier run.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/progress.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/pages/sweep_html.hpp"
#include "app/verbs/monitor.hpp"
#include "app/verbs/simulate.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "driver/settings/rules.hpp"
#include "semantics/rules.hpp"
#include "simulation/report/report.hpp"
#include "simulation/scenario/rules.hpp"
#include "simulation/sweep/comparison.hpp"

namespace robochart::app {
namespace {

constexpr std::size_t most_points = 2000;

/// The controllers that all points of the sweep with the same values of the model's constants share.
struct Prepared {
    std::vector<std::string> constants;
    std::unique_ptr<Simulation> simulation;
    std::unique_ptr<simulation::Controller> controller;
    std::unique_ptr<simulation::Guard> monitors;
};

class Sweep {
public:
    Sweep(const Options& options, const OtherStage& stage, std::unique_ptr<driver::Project> project,
          simulation::Scenario scenario)
        : options_(options), stage_(stage), project_(std::move(project)), scenario_(std::move(scenario)) {}

    Exit run() {
        check_options();
        if (!project_->diagnostics.ok()) return show_refusal(*project_);
        for (const simulation::Point& point : simulation::points_of(scenario_)) result_.points.push_back({point, {}});
        for (simulation::PointResult& point : result_.points) {
            if (result_.interrupted || !is_wanted(point)) continue;
            if (const auto refusal = run_point(point)) return *refusal;
        }
        redraw_progress("");
        compared_ = simulation::compare_tables(scenario_, result_, table_);
        result_.seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        return write_report();
    }

private:
    using Clock = std::chrono::steady_clock;

    void check_options() {
        const auto missing = [&](const char* what) {
            project_->diagnostics.report(simulation::rules::missing, scenario_.name.span, {what});
        };
        if (scenario_.claims.empty())
            missing("what is claimed (accept probability) or estimated (estimate probability)");
        if (until_proved() &&
            std::ranges::all_of(scenario_.claims, [](const simulation::Claim& claim) { return claim.estimate; }))
            missing("what is to be proved (accept probability)");
        if (!options_.simulate.compare.empty()) read_table();
        if (!options_.simulate.guarding_rules.empty()) read_rules();
        std::size_t points = 1;
        for (const simulation::Variation& variation : scenario_.variations) points *= variation.values.size();
        if (points > most_points)
            project_->diagnostics.report(simulation::rules::out_of_range, scenario_.variations.back().span,
                                         {fmt::format("{} points are more than {}", points, most_points)});
    }

    /// Reads the table of `--compare`. Errors are reported at their place in the table.
    void read_table() {
        std::string error;
        const auto source = project_->sources.load_file(options_.simulate.compare, error);
        if (source) {
            auto table = simulation::read_table(project_->sources.source_text(*source), scenario_, error);
            if (table) table_ = std::move(*table);
        }
        const bool estimates =
            std::ranges::any_of(scenario_.claims, [](const simulation::Claim& claim) { return claim.estimate; });
        if (error.empty() && !estimates) error = "the scenario has no estimate";
        if (!error.empty())
            project_->diagnostics.report(
                driver::rules::bad_option, {},
                {fmt::format("--compare {}: {}", diagnostics::escape_for_display(options_.simulate.compare), error)});
    }

    /// Reads the text of the rule file of `--monitor`. Errors in it are reported when the rules are used.
    void read_rules() {
        std::string error;
        if (const auto source = project_->sources.load_file(options_.simulate.guarding_rules, error))
            rules_text_ = project_->sources.source_text(*source);
    }

    Exit show_refusal(driver::Project& project) const {
        show_diagnostics(project, options_);
        return refusal_code(project);
    }

    [[nodiscard]] bool until_proved() const { return scenario_.variations.front().until_proved; }

    /// True if the point has to be computed. If values are tried until one is proved, a point has to be computed only
    /// if it can still change a least value.
    [[nodiscard]] bool is_wanted(const simulation::PointResult& point) const {
        if (!until_proved()) return true;
        const std::optional<double> second = point.point.size() > 1 ? std::optional(point.point[1]) : std::nullopt;
        for (std::size_t c = 0; c < scenario_.claims.size(); ++c)
            if (!scenario_.claims[c].estimate && !simulation::least_value(result_.points, c, second).ended) return true;
        return false;
    }

    /// Computes a point; returns an exit code if this is impossible.
    std::optional<Exit> run_point(simulation::PointResult& point) {
        if (const auto refusal = prepare_controller(simulation::constants_at(scenario_, point.point))) return refusal;
        const simulation::Scenario scenario = simulation::scenario_at(prepared_.simulation->scenario, point.point);
        const diagnostics::Digest key = key_of(point.point);
        diagnostics::Cache* const cache = options_.run->cache();
        const auto earlier = cache == nullptr ? std::nullopt : cache->find(key);
        if (earlier)
            if (auto known = simulation::claims_from_text(*earlier, scenario.claims.size())) {
                point.claims = std::move(*known);
                ++result_.earlier;
                return std::nullopt;
            }
        simulation::Plan plan = prepared_.simulation->plan;
        plan.scenario = &scenario;
        driver::Project& project = *prepared_.simulation->project;
        const simulation::RunResult found =
            simulation::run_trials(plan, drives_of(*prepared_.simulation, *prepared_.controller),
                                   run_options(point.point), project.diagnostics);
        result_.cpu_seconds += found.cpu_seconds;
        if (!project.diagnostics.ok()) return show_refusal(project);
        point.claims = found.claims;
        result_.interrupted = found.interrupted;
        if (result_.watched && !found.watched) unwatched_ = prepared_.monitors->summary_lines();
        result_.watched = result_.watched && found.watched;
        // A point that was not completely monitored is not stored, so that the next run repeats the message.
        if (!found.interrupted && found.watched && cache != nullptr)
            cache->store_entry(key, simulation::claims_to_text(found.claims));
        return std::nullopt;
    }

    /// Reports each varied constant that the model does not have as an error, at its place in the scenario.
    void find_unknown(const driver::Project& refused) {
        for (const simulation::Variation& variation : scenario_.variations) {
            if (variation.what != simulation::Varied::constant) continue;
            const auto address = simulation::find_constant_address(scenario_, variation.constant);
            for (const diagnostics::Diagnostic& finding : refused.diagnostics.sorted_findings())
                if (address && finding.rule == &ir::rules::unknown_constant_option &&
                    finding.arguments.front() == address->constant)
                    project_->diagnostics.report(simulation::rules::unknown_part, variation.span,
                                                 {"constant of the model", variation.constant});
        }
    }

    std::optional<Exit> prepare_controller(const std::vector<std::string>& constants) {
        if (prepared_.controller != nullptr && prepared_.constants == constants) return std::nullopt;
        Options options = options_;
        options.instantiation.constants.insert(options.instantiation.constants.end(), constants.begin(),
                                               constants.end());
        prepared_ = {constants, load_simulation(options), nullptr, nullptr};
        driver::Project& project = *prepared_.simulation->project;
        if (!is_acceptable(project, options.load)) {
            find_unknown(project);
            return show_refusal(project_->diagnostics.ok() ? project : *project_);
        }
        if (!shown_) show_all_diagnostics(*prepared_.simulation, options);
        shown_ = true;
        prepared_.controller = build_controller(*prepared_.simulation, options);
        if (prepared_.controller != nullptr) prepared_.monitors = make_guard(*prepared_.simulation, options);
        if (project.diagnostics.ok()) return std::nullopt;
        show_diagnostics(project, options);
        return Exit::bad_input;
    }

    /// Returns the hash of all data that an answer depends on.
    [[nodiscard]] diagnostics::Digest key_of(const simulation::Point& point) const {
        const Simulation& simulation = *prepared_.simulation;
        diagnostics::Hasher hasher;
        hasher.add("point of a sweep");
        add_trials(simulation, hasher);
        for (std::size_t v = 0; v < point.size(); ++v)
            hasher.add(simulation::value_text(scenario_.variations[v], point[v]));
        hasher.add(simulation.scenario.seed);
        hasher.add(simulation.scenario.trials);
        hasher.add(result_.points.size());
        hasher.add(std::uint64_t{options_.simulate.monitor ? 1U : 0U});
        hasher.add(rules_text_);
        hasher.add(stage_.name);
        return hasher.finish();
    }

    [[nodiscard]] simulation::RunOptions run_options(const simulation::Point& point) {
        simulation::RunOptions options;
        options.threads = stage_.parallel ? options_.limits.threads : 1;
        options.stage = stage_.make;
        options.record = false;
        options.comparisons = static_cast<std::uint32_t>(result_.points.size());
        if (prepared_.monitors != nullptr) options.trace = prepared_.monitors->make_observer({});
        options.interrupted = when_a_limit_is_reached(options_);
        const std::string where = simulation::point_text(scenario_, point);
        options.progress = [this, where](const simulation::RunProgress& now) {
            redraw_progress(fmt::format("{} ({} points): {} trials", where, result_.points.size(), now.trials_done));
        };
        return options;
    }

    void redraw_progress(const std::string& line) const {
        if (options_.output.progress != ProgressMode::json && progress_line_wanted(options_.output))
            redraw_error_line(line);
    }

    Exit write_report() {
        const std::vector<simulation::SweepPlot> plots = simulation::sweep_plots(scenario_, result_);
        std::vector<std::string> files;
        if (options_.simulate.pictures) {
            add("sweep.csv", simulation::sweep_csv(scenario_, result_), files);
            add("sweep-trials.csv", simulation::sweep_trials_csv(scenario_, result_), files);
            for (const simulation::SweepPlot& plot : plots) add("sweep-" + plot.name + ".svg", plot.svg, files);
        }
        if (!options_.output.html.empty())
            report_unwritable(diagnostics::replace_file(
                options_.output.html, render_sweep_html(scenario_, result_, plots, record_of(options_)),
                &options_.run->budget()));
        options_.run->finish();
        if (!project_->diagnostics.ok()) {
            show_diagnostics(*project_, options_);
            return Exit::bad_input;
        }
        const Exit exit = exit_code();
        output_document(options_, [&](Format) {
            return simulation::sweep_json(scenario_, result_, simulation::comparison_json(scenario_, compared_),
                                          simulation::guard_json(prepared_.monitors.get(), result_.watched), files,
                                          static_cast<int>(exit));
        });
        if (options_.output.format == Format::text) print_text(files);
        return exit;
    }

    void add(const std::string& name, const std::string& text, std::vector<std::string>& files) {
        const std::string path = "simulation/" + scenario_.name.text + "/" + name;
        const std::string error = diagnostics::write_below(options_.output.folder, path, text, &options_.run->budget());
        report_unwritable(error);
        if (error.empty()) files.push_back(options_.output.folder + "/" + path);
    }

    void report_unwritable(const std::string& error) {
        if (!error.empty()) project_->diagnostics.report(rules::unwritable, {}, {error});
    }

    /// Returns success if every point is decided and `--monitor` could follow all trials. If values are tried until one
    /// is proved, only the least values must be decided.
    [[nodiscard]] Exit exit_code() const {
        if (result_.interrupted) return Exit::inconclusive;
        if (std::ranges::any_of(compared_, [&](const simulation::Compared& compared) {
                return simulation::is_rejected(scenario_, compared);
            }))
            return Exit::failed;
        for (std::size_t c = 0; c < scenario_.claims.size(); ++c)
            for (const simulation::PointResult& point : result_.points) {
                if (!until_proved() && simulation::point_word(point, c) == "open") return Exit::inconclusive;
                const std::optional<double> second =
                    point.point.size() > 1 ? std::optional(point.point[1]) : std::nullopt;
                const simulation::Least found = simulation::least_value(result_.points, c, second);
                if (until_proved() && !scenario_.claims[c].estimate && !(found.value && found.certain))
                    return Exit::inconclusive;
            }
        return result_.watched ? Exit::success : Exit::inconclusive;
    }

    void print_text(const std::vector<std::string>& files) const {
        if (!options_.output.quiet) {
            print("sweep of {}: {} points, seed {} and on at each; controller {}\n{:.1f} CPU seconds{}\n\n",
                  scenario_.name.text, result_.points.size(), scenario_.seed, scenario_.component.text,
                  result_.cpu_seconds,
                  result_.earlier > 0 ? fmt::format("; {} points known from earlier runs", result_.earlier) : "");
            print("{}\n", simulation::sweep_text(scenario_, result_));
            if (!compared_.empty()) print("{}\n", simulation::comparison_text(scenario_, compared_));
            if (!scenario_.bands.empty()) print("bands are not asked where something varies\n\n");
            print("in this world, but for what varies\n{}\n", simulation::world_text(scenario_));
            if (!files.empty()) print("files\n");
            for (const std::string& file : files) print("  {}\n", diagnostics::escape_for_display(file));
            if (!files.empty()) print("\n");
        }
        if (result_.interrupted) print("{}: the rest is open\n", options_.run->budget().reached_limit());
        if (!result_.watched) print("{}{}", options_.output.quiet ? "" : unwatched_, not_all_watched);
        for (const std::string& line : simulation::least_lines(scenario_, result_)) print("{}\n", line);
        if (!options_.simulate.compare.empty()) print("{}\n", simulation::comparison_summary(scenario_, compared_));
    }

    const Options& options_;
    const OtherStage& stage_;
    std::unique_ptr<driver::Project> project_;  ///< this project contains only the scenario's text
    simulation::Scenario scenario_;
    Prepared prepared_;
    bool shown_ = false;
    std::string rules_text_;                   ///< text of the rule file of `--monitor RULES.sleec`
    std::string unwatched_;                    ///< the guard's note about the first incomplete observation
    std::vector<simulation::TableRow> table_;  ///< rows of the table of `--compare`
    std::vector<simulation::Compared> compared_;
    simulation::SweepResult result_;
    const Clock::time_point start_ = Clock::now();
};

}  // namespace

Exit sweep(const Options& options, const OtherStage& stage) {
    auto project = std::make_unique<driver::Project>();
    simulation::Scenario scenario = read_scenario_of(*project, options);
    if (!project->diagnostics.ok()) {
        show_diagnostics(*project, options);
        return refusal_code(*project);
    }
    return Sweep(options, stage, std::move(project), std::move(scenario)).run();
}

}  // namespace robochart::app
