// SPDX-License-Identifier: Apache-2.0
// Runs `simulate` with a scenario that defines a chain. Trials estimate the chain, the timed semantics of the model
// excludes impossible transitions, and fresh trials may refute the chain.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/rules/claim_duties.hpp"
#include "app/verbs/simulate.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "driver/settings/rules.hpp"
#include "prism/assertions/experiments/encoding.hpp"
#include "prism/assertions/process/following.hpp"
#include "simulation/chain/chain_report.hpp"
#include "simulation/scenario/rules.hpp"

namespace robochart::app {
namespace {

class ChainStudy {
public:
    ChainStudy(Simulation& simulation, const Options& options, const OtherStage& stage)
        : simulation_(simulation), project_(*simulation.project), options_(options), stage_(stage) {}

    Exit run() {
        for (const auto& [given, option] :
             {std::pair(!options_.output.html.empty(), "--html"), std::pair(!options_.simulate.log.empty(), "--log"),
              std::pair(options_.simulate.monitor, "--monitor")})
            if (given)
                project_.diagnostics.report(driver::rules::bad_option, {},
                                            {fmt::format("{} takes a scenario without a chain", option)});
        refuse_followed_claims(simulation_.scenario, project_);
        if (!project_.diagnostics.ok()) return show_refusal();
        controller_ = build_controller(simulation_, options_);
        if (controller_ == nullptr || !project_.diagnostics.ok()) return show_refusal();
        scenario_ = simulation_.scenario;
        if (!find_states()) return show_refusal();
        const auto questions = simulation::find_chain_questions(scenario_, *states_, project_.diagnostics);
        if (!project_.diagnostics.ok()) return show_refusal();
        result_.questions = questions.size();
        run_trials();
        const bool stopped = !project_.diagnostics.ok();  // true if trials stopped
        if (stopped || (!result_.interrupted && !answer_questions(questions))) {
            show_diagnostics(project_, options_);
            return Exit::failed;
        }
        return write_report();
    }

private:
    Exit show_refusal() const {
        show_diagnostics(project_, options_);
        return refusal_code(project_);
    }

    bool find_states() {
        try {
            states_.emplace(scenario_, steps_of_robots());
        } catch (const simulation::TooManyStates& many) {
            project_.diagnostics.report(
                simulation::rules::out_of_range, scenario_.abstraction->span,
                {fmt::format("a chain has at most {} states: {}", simulation::ChainStates::most_states, many.what())});
            return false;
        }
        permitted_ = states_->permitted_transitions(&options_.run->budget());
        for (std::size_t from = 1; from < permitted_.size(); ++from)
            for (std::size_t to = 1; to < permitted_.size(); ++to) {
                ++result_.transitions;
                if (!permitted_[from][to]) ++result_.excluded;
            }
        return true;
    }

    /// Returns the states of the model that the chain distinguishes: its state contains the number of robots in each of
    /// them.
    [[nodiscard]] std::vector<std::string> distinguished_states() const {
        std::vector<std::string> states;
        for (const simulation::Distinction& distinction : scenario_.abstraction->distinctions) {
            const simulation::Measure& measure = scenario_.measures[distinction.measure];
            if (measure.kind == simulation::MeasureKind::in_state) states.push_back(measure.state.text);
        }
        return states;
    }

    /// Returns the steps of one robot that the timed semantics of the model allows. Returns no value if the scenario
    /// does not request them, or if they could not be computed. The reason is stored in the result.
    std::optional<simulation::RobotSteps> steps_of_robots() {
        const std::vector<std::string> states = distinguished_states();
        if (states.empty()) {
            result_.proof = "the states of the chain are not those of the model";
            return std::nullopt;
        }
        if (scenario_.units_per_step > 1) {
            result_.proof =
                "several time units pass in a control step, what the code does in one is not of one of them";
            return std::nullopt;
        }
        for (const simulation::Failure& failure : scenario_.failures)
            if (failure.kind == simulation::FailureKind::whole) {
                result_.proof = "robots that fail leave the model's semantics";
                return std::nullopt;
            }
        try {
            return proved_steps(states);
        } catch (const probability::Wrong& wrong) {
            result_.proof = fmt::format("not decided: {}", wrong.what());
        } catch (const diagnostics::LimitReached& limit) {
            options_.run->budget().check();
            result_.proof = fmt::format("not decided: {}", limit.what());
        }
        return std::nullopt;
    }

    simulation::RobotSteps proved_steps(const std::vector<std::string>& states) {
        constexpr std::uint64_t most_states = 1'000'000;
        diagnostics::Budget& budget = options_.run->budget();
        const diagnostics::Budget::Phase phase(budget, "finding what robots may do between two states of the chain");
        const std::uint64_t units = scenario_.steps_between_samples() * scenario_.units_per_step;
        const ir::ComponentRef component =
            driver::code_components(project_.system, scenario_.component.text, true).front();
        probability::check_finite(project_.system, component);
        const auto process =
            probability::explore_process(project_.system, component, project_.instantiation, {}, project_.sources,
                                         {std::min(options_.limits.max_states, most_states), most_states, &budget});
        const probability::Following found =
            probability::find_following(*process, project_.system, component, states, units, budget);
        result_.proof = fmt::format("what {} time units of {} admit, by {} states of its semantics", units,
                                    scenario_.component.text, process->exploration->size());
        return {found.classes, found.first, found.after};
    }

    void run_trials() {
        result_.trials = scenario_.trials;
        simulation::Scenario all = scenario_;
        all.claims.clear();
        all.set_trials(2 * scenario_.trials);
        simulation::Plan plan = simulation_.plan;
        plan.scenario = &all;
        simulation::RunOptions run_options;
        run_options.threads = stage_.parallel ? options_.limits.threads : 1;
        run_options.stage = stage_.make;
        run_options.record = false;
        run_options.interrupted = when_a_limit_is_reached(options_);
        run_options.progress = progress_reports(options_, scenario_.name.text);
        simulation::RunResult found =
            simulation::run_trials(plan, drives_of(simulation_, *controller_), run_options, project_.diagnostics);
        result_.cpu_seconds = found.cpu_seconds;
        result_.interrupted = found.interrupted;
        trials_ = std::move(found.trials);
    }

    /// Returns false if trials took transitions that the proof excludes.
    bool answer_questions(const std::vector<simulation::ChainAsked>& questions) {
        std::vector<simulation::Excluded> excluded;
        const auto sequences = simulation::sequences_of(scenario_, *states_, permitted_, trials_, excluded);
        if (!excluded.empty()) {
            const simulation::Excluded& first = excluded.front();
            project_.diagnostics.report(
                simulation::rules::excluded, scenario_.abstraction->span,
                {std::to_string(first.trial + 1), first.from, first.to, fmt::format("{:g}", first.time)});
            return false;
        }
        counts_.emplace(states_->size());
        for (std::size_t i = 0; i < sequences.size() / 2; ++i) counts_->add(sequences[i]);
        for (std::size_t from = 1; from < states_->size(); ++from)
            for (std::size_t to = 1; to < states_->size(); ++to)
                if (counts_->count(from, to) > 0) ++result_.seen;
        try {
            result_.order = simulation::order_finding(questions, permitted_, sequences, &options_.run->budget());
            result_.order_asked = true;
            for (const simulation::ChainAsked& question : questions) {
                result_.answers.push_back(simulation::chain_answer(scenario_, question, permitted_, sequences, trials_,
                                                                   &options_.run->budget()));
                result_.answers.back().of_no_chain = result_.order.has_value();
            }
        } catch (const diagnostics::LimitReached&) {
            result_.interrupted = true;  // the result contains the answers so far
        }
        return true;
    }

    Exit write_report() {
        std::vector<std::string> files;
        if (options_.simulate.pictures && counts_ && !result_.answers.empty()) {
            const double error = (1 - result_.answers.front().asked.confidence) / 2;
            add("chain.csv", simulation::transitions_csv(*states_, permitted_, *counts_, error), files);
            add("chain-checks.csv", simulation::checks_csv(result_), files);
            for (std::size_t q = 0; q < result_.answers.size(); ++q)
                add(fmt::format("chain-{}.svg", q + 1), simulation::answer_svg(result_.answers[q]), files);
        }
        options_.run->finish();
        if (!project_.diagnostics.ok()) {
            show_diagnostics(project_, options_);
            return Exit::bad_input;
        }
        const Exit exit = exit_code();
        app::output_document(options_, [&](Format) {
            return simulation::chain_json(scenario_, *states_, result_, files, static_cast<int>(exit));
        });
        if (options_.output.format == Format::json) return exit;
        show_diagnostics(project_, options_);
        print_text(files);
        return exit;
    }

    [[nodiscard]] Exit exit_code() const {
        if (result_.has_failed()) return Exit::failed;
        return result_.is_complete() ? Exit::success : Exit::inconclusive;
    }

    void add(const std::string& name, const std::string& text, std::vector<std::string>& files) {
        const std::string path = "simulation/" + scenario_.name.text + "/" + name;
        const std::string error = diagnostics::write_below(options_.output.folder, path, text, &options_.run->budget());
        if (!error.empty()) project_.diagnostics.report(rules::unwritable, {}, {error});
        if (error.empty()) files.push_back(options_.output.folder + "/" + path);
    }

    void print_text(const std::vector<std::string>& files) const {
        if (!options_.output.quiet) {
            print("{}\n", simulation::study_text(scenario_, *states_, result_));
            print("answers, if robots in one state behave alike whatever was before\n{}\n",
                  simulation::answers_text(result_));
            print("in this world\n{}\n", simulation::world_text(scenario_));
            if (!files.empty()) print("files\n");
            for (const std::string& file : files) print("  {}\n", diagnostics::escape_for_display(file));
            if (!files.empty()) print("\n");
        }
        if (result_.interrupted) print("{}: the rest is open\n", options_.run->budget().reached_limit());
        print("{}\n", simulation::chain_summary(result_));
    }

    Simulation& simulation_;
    driver::Project& project_;
    const Options& options_;
    const OtherStage& stage_;
    std::unique_ptr<simulation::Controller> controller_;
    simulation::Scenario scenario_;
    std::optional<simulation::ChainStates> states_;
    statistics::Permitted permitted_;
    std::vector<simulation::TrialResult> trials_;
    std::optional<statistics::TransitionCounts> counts_;
    simulation::ChainResult result_;
};

}  // namespace

Exit study_chain(Simulation& simulation, const Options& options, const OtherStage& stage) {
    return ChainStudy(simulation, options, stage).run();
}

}  // namespace robochart::app
