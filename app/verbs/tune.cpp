// SPDX-License-Identifier: Apache-2.0
// The verb `tune`: finds values of a model's constants that optimise the claims of a scenario, by iterated racing. With
// the best values, it checks the model, compares the generated code with the model, and evaluates the claims in trials
// with unused seeds. The result is a certificate, which can be verified again.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>

#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/progress.hpp"
#include "app/command/rules.hpp"
#include "app/command/run.hpp"
#include "app/rules/claim_duties.hpp"
#include "app/verbs/simulate.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/json_values.hpp"
#include "driver/settings/rules.hpp"
#include "semantics/instantiate/given_constants.hpp"
#include "semantics/ir/query.hpp"
#include "simulation/scenario/rules.hpp"
#include "simulation/tuning/race.hpp"
#include "simulation/tuning/trials.hpp"

namespace robochart::app {

namespace {

/// Returns the test's name in certificates and on the command line.
std::string name_of(simulation::Elimination test) {
    return test == simulation::Elimination::t_test ? "t-test" : "friedman";
}

using simulation::Candidate;
using simulation::Parameter;
using Pairs = std::vector<std::pair<std::string, std::string>>;

/// Returns the NAME and VALUE of `--const`; without `=`, the whole text is the name.
std::pair<std::string, std::string> split_constant(const std::string& option) {
    const std::size_t equal = option.find('=');
    return {option.substr(0, equal), equal == std::string::npos ? "" : option.substr(equal + 1)};
}

std::string with_constants(const Pairs& constants) {
    std::vector<std::string> words;
    for (const auto& [name, value] : constants)
        words.push_back(diagnostics::escape_for_display(fmt::format("{}={}", name, value)));
    return fmt::format("{}", fmt::join(words, " "));
}

/// Returns a text such as "12 of 13 hold".
std::string counted(const std::vector<driver::DecidedItem>& items, const std::string& good) {
    const auto count =
        std::ranges::count_if(items, [&](const driver::DecidedItem& decided) { return decided.answer == good; });
    return fmt::format("{} of {}", count, items.size());
}

bool has_any_answer(const std::vector<driver::DecidedItem>& items, std::initializer_list<const char*> answers) {
    return std::ranges::any_of(items, [&](const driver::DecidedItem& decided) {
        return std::ranges::find(answers, decided.answer) != answers.end();
    });
}

/// Returns the exit code for the decisions: 1 if one is negative, otherwise 3 if one is open.
Exit exit_of(const driver::Evidence& evidence) {
    const bool fails = has_any_answer(evidence.assertions, {"fails", "error"}) ||
                       has_any_answer(evidence.conformance, {"differs", "not schedulable", "not generated", "error"});
    const bool open =
        has_any_answer(evidence.assertions, {"inconclusive"}) || has_any_answer(evidence.conformance, {"inconclusive"});
    const auto claim = [&](const char* answer) {
        return std::ranges::any_of(evidence.claims,
                                   [&](const driver::DecidedClaim& decided) { return decided.answer == answer; });
    };
    if (fails || claim("fails")) return Exit::failed;
    return open || claim("open") ? Exit::inconclusive : Exit::success;
}

/// Returns why an exit code is not `success`.
const char* shortcoming(Exit exit) {
    return exit == Exit::failed ? "something fails" : "something is open";
}

/// Returns the decisions as text, one per line.
std::string evidence_text(const driver::Evidence& evidence) {
    std::string out = fmt::format("checked\n  {} assertions hold\n", counted(evidence.assertions, "holds"));
    for (const driver::DecidedItem& assertion : evidence.assertions)
        if (assertion.answer != "holds" && assertion.answer != "no check")
            out += fmt::format("  {:<12} {}\n", assertion.answer, diagnostics::escape_for_display(assertion.subject));
    for (const driver::DecidedItem& component : evidence.conformance)
        out += fmt::format("  {:<12} {}\n", component.answer, diagnostics::escape_for_display(component.subject));
    out += fmt::format("claims, on seeds from {} on\n", evidence.seed);
    for (const driver::DecidedClaim& decided_claim : evidence.claims)
        out += fmt::format("  {:<12} {}\n               {} of {} trials; between {:.3f} % and {:.3f} %\n",
                           decided_claim.answer, diagnostics::escape_for_display(decided_claim.claim),
                           decided_claim.successes, decided_claim.trials, 100 * decided_claim.low,
                           100 * decided_claim.high);
    return out;
}

/// The candidates of a search, with their controllers.
class Subject final : public simulation::RaceSubject {
public:
    Subject(const Options& options, const std::vector<Parameter>& parameters, const simulation::Scenario& scenario,
            std::uint64_t search)
        : options_(options), parameters_(parameters), scenario_(scenario), search_(search) {}

    bool is_usable(const Candidate& candidate) override {
        options_.run->budget().check();
        Built built;
        const Options options = options_with(candidate);
        built.simulation = load_simulation(options);
        driver::Project& project = *built.simulation->project;
        if (is_acceptable(project, options.load)) built.controller = build_controller(*built.simulation, options);
        const bool good = built.controller != nullptr && project.diagnostics.ok();
        if (good && !shown_) show_all_diagnostics(*built.simulation, options_);
        shown_ = shown_ || good;
        if (!good) note_unusable(candidate, project);
        if (good) built.digest = digest_of(*built.simulation);
        if (good) built.drives.emplace(drives_of(*built.simulation, *built.controller));
        // The models are freed to save memory, because only the plan is needed from now on.
        if (good) built.simulation->project.reset();
        for (OtherController& other : built.simulation->others)
            if (good) other.project.reset();
        built_.push_back(good ? std::move(built) : Built{});
        return good;
    }

    bool admits_candidate(const Candidate& candidate) override {
        driver::Evidence found;
        decide_assertions(options_with(candidate), scenario_, found);
        const auto bad = std::ranges::find_if(found.assertions, [](const driver::DecidedItem& assertion) {
            return assertion.answer == "fails" || assertion.answer == "error";
        });
        if (bad == found.assertions.end()) return true;
        if (refusal_.empty())
            refusal_ = fmt::format("{}: {}: {}", simulation::candidate_text(parameters_, candidate), bad->answer,
                                   bad->subject);
        return false;
    }

    std::vector<double> trial_costs(const std::vector<simulation::RaceTrial>& race_trials) override {
        std::vector<double> result(race_trials.size());
        std::vector<std::size_t> missing;
        std::vector<simulation::TuningTrial> trials;
        for (std::size_t t = 0; t < race_trials.size(); ++t) {
            if (const auto known = earlier_cost(race_trials[t])) {
                result[t] = *known;
                continue;
            }
            const Built& built = built_.at(race_trials[t].candidate);
            missing.push_back(t);
            trials.push_back({&built.simulation->plan, &*built.drives, seed_of(race_trials[t])});
        }
        // Trials run in portions, so that an interrupted search has the results of finished portions.
        constexpr std::size_t portion = 64;
        for (std::size_t begin = 0; begin < trials.size(); begin += portion) {
            const std::size_t end = std::min(trials.size(), begin + portion);
            redraw_progress(fmt::format("{} trials", done_));
            const std::vector<double> costs =
                simulation::trial_costs({trials.begin() + static_cast<std::ptrdiff_t>(begin),
                                         trials.begin() + static_cast<std::ptrdiff_t>(end)},
                                        options_.limits.threads, [&] { options_.run->budget().check(); });
            for (std::size_t t = begin; t < end; ++t) {
                result[missing[t]] = costs[t - begin];
                keep_cost(race_trials[missing[t]], costs[t - begin]);
            }
        }
        done_ += race_trials.size();
        redraw_progress("");
        return result;
    }

    /// The reason why a candidate could not be used; "" if all could be used.
    [[nodiscard]] const std::string& unusable_reason() const { return unusable_; }
    /// The reason why one of the best candidates was rejected; "" if none was.
    [[nodiscard]] const std::string& refusal_reason() const { return refusal_; }
    [[nodiscard]] std::uint64_t earlier_trials() const { return earlier_; }

    [[nodiscard]] Options options_with(const Candidate& candidate) const {
        Options options = options_;
        for (const std::string& constant : simulation::constants_of(parameters_, candidate))
            options.instantiation.constants.push_back(constant);
        return options;
    }

private:
    struct Built {
        std::unique_ptr<Simulation> simulation;
        std::unique_ptr<simulation::Controller> controller;
        std::optional<simulation::Drives> drives;
        diagnostics::Digest digest{};
    };

    void note_unusable(const Candidate& candidate, const driver::Project& project) {
        if (!unusable_.empty()) return;
        for (const diagnostics::Diagnostic& finding : project.diagnostics.sorted_findings())
            if (finding.rule->severity == diagnostics::Severity::error && unusable_.empty())
                unusable_ =
                    fmt::format("{}: {}", simulation::candidate_text(parameters_, candidate), finding.message());
    }

    /// Returns the hash of all data that a trial's cost depends on, except its seed.
    static diagnostics::Digest digest_of(const Simulation& simulation) {
        diagnostics::Hasher hasher;
        hasher.add("trial of a search");
        add_trials(simulation, hasher);
        return hasher.finish();
    }

    [[nodiscard]] std::uint64_t seed_of(const simulation::RaceTrial& trial) const {
        return simulation::tuning_seed(scenario_, search_, trial.seed);
    }

    [[nodiscard]] diagnostics::Digest key_of(const simulation::RaceTrial& trial) const {
        diagnostics::Hasher hasher;
        hasher.add(built_.at(trial.candidate).digest);
        hasher.add(seed_of(trial));
        return hasher.finish();
    }

    std::optional<double> earlier_cost(const simulation::RaceTrial& trial) {
        diagnostics::Cache* const cache = options_.run->cache();
        const auto text = cache == nullptr ? std::nullopt : cache->find(key_of(trial));
        if (!text) return std::nullopt;
        const diagnostics::Json value = diagnostics::Json::parse(*text, nullptr, false);
        if (!value.is_number()) return std::nullopt;
        ++earlier_;
        return value.get<double>();
    }

    void keep_cost(const simulation::RaceTrial& trial, double cost) const {
        if (diagnostics::Cache* const cache = options_.run->cache())
            cache->store_entry(key_of(trial), diagnostics::json_text(diagnostics::Json(cost)));
    }

    void redraw_progress(const std::string& line) const {
        if (options_.output.progress != ProgressMode::json && progress_line_wanted(options_.output))
            redraw_error_line(line);
    }

    const Options& options_;
    const std::vector<Parameter>& parameters_;
    const simulation::Scenario& scenario_;
    std::uint64_t search_;
    std::vector<Built> built_;
    std::string unusable_, refusal_;
    std::uint64_t earlier_ = 0;
    std::uint64_t done_ = 0;
    bool shown_ = false;
};

/// A run of the verb.
class Tuning {
public:
    explicit Tuning(const Options& options) : given_options_(options), options_(options) {
        options_.instantiation.constants.clear();
        for (const std::string& constant : options.instantiation.constants) {
            const auto [name, value] = split_constant(constant);
            if (simulation::is_varied(value))
                varied_.emplace_back(name, value);
            else
                options_.instantiation.constants.push_back(constant);
        }
    }

    Exit run() {
        if (!given_options_.tune.certificate.empty()) return verify_certificate();
        if (!begin()) return show_refusal();
        const std::uint64_t search = options_.tune.seed;
        options_.run->recorder().set_seed(search);
        const simulation::RaceOptions race_options{options_.tune.trials, search, options_.tune.elimination};
        Subject subject(options_, parameters_, scenario_, search);
        simulation::Race race(parameters_, race_options, subject);
        if (!is_quiet()) print("{}", beginning_text(race_options));
        try {
            race.run([&](const simulation::Race& now) { show_iteration(now); });
            if (!race.elites().empty()) decide_winner(race, subject);
        } catch (const diagnostics::LimitReached& limit) {
            options_.run->finish();
            limit_ = limit.what();
        }
        if (!limit_.empty() || race.elites().empty())
            options_.run->recorder().forget_values();  // the values of the candidates are not results of the run
        if (!limit_.empty()) return end_interrupted(race);
        if (race.elites().empty()) return without_winner(race, subject);
        if (!project_->diagnostics.ok()) return show_refusal();
        return write_results(race, subject);
    }

private:
    [[nodiscard]] bool is_quiet() const { return options_.output.quiet || options_.output.format == Format::json; }

    Exit show_refusal() const {
        show_diagnostics(*project_, options_);
        return refusal_code(*project_);
    }

    void report_option(const std::string& what) { project_->diagnostics.report(driver::rules::bad_option, {}, {what}); }

    /// Reads everything except the candidates; returns false with diagnostics if there is an error.
    bool begin() {
        // The model is first read with the first value of each constant, which reports wrong names and values.
        Options first = options_;
        for (const auto& [name, value] : varied_) {
            const std::size_t end = std::min(value.find(".."), value.find(','));
            first.instantiation.constants.push_back(fmt::format("{}={}", name, value.substr(0, end)));
        }
        auto simulation = load_simulation(first);
        scenario_ = simulation->scenario;
        refuse_followed_claims(scenario_, *simulation->project);
        project_ = std::move(simulation->project);
        others_ = std::move(simulation->others);
        if (!is_acceptable(*project_, options_.load)) return false;
        if (varied_.empty())
            report_option("tune takes constants with values to try: --const NAME=LOW..HIGH or NAME=A,B,C");
        if (!scenario_.variations.empty()) report_option("tune takes a scenario in which nothing varies");
        if (scenario_.claims.empty())
            project_->diagnostics.report(simulation::rules::missing, scenario_.name.span,
                                         {"what is claimed (accept probability) or estimated (estimate probability)"});
        for (const auto& [name, value] : varied_) add_parameter(name, value);
        return project_->diagnostics.ok();
    }

    void add_parameter(const std::string& name, const std::string& value) {
        std::string error;
        auto parameter = simulation::read_parameter(name, value, kind_of(name), error);
        if (parameter)
            parameters_.push_back(std::move(*parameter));
        else
            report_option(fmt::format("--const {}={}: {}", diagnostics::escape_for_display(name),
                                      diagnostics::escape_for_display(value), error));
    }

    /// Returns the model of a controller as it was first read, before the candidates were built.
    [[nodiscard]] const driver::Project& project_of(std::size_t controller) const {
        return controller == 0 ? *project_ : *others_.at(controller - 1).project;
    }

    /// Returns the constants that do not vary: those of `--const`, and those of the scenario that are not searched.
    [[nodiscard]] Pairs fixed_constants() const {
        Pairs result;
        for (const std::string& constant : options_.instantiation.constants) result.push_back(split_constant(constant));
        for (std::size_t number = 0; number < scenario_.controller_count(); ++number) {
            ir::GivenConstants left = project_of(number).asked.constants;
            for (const std::string& constant : given_options_.instantiation.constants)
                if (const auto address = simulation::find_constant_address(scenario_, split_constant(constant).first);
                    address && address->controller == number)
                    left.erase(address->constant);
            const std::string name = number == 0 ? "" : scenario_.controller_name(number) + ".";
            for (const auto& [constant, value] : left) result.emplace_back(name + constant, value);
        }
        return result;
    }

    [[nodiscard]] simulation::ParameterKind kind_of(const std::string& name) const {
        using simulation::ParameterKind;
        const auto address = simulation::find_constant_address(scenario_, name);
        if (!address) return ParameterKind::other;
        const ir::System& system = project_of(address->controller).system;
        for (const ir::NamedConstant& constant : ir::named_constants(system)) {
            if (!ir::is_named_by(constant.path, address->constant)) continue;
            const ir::TypeKind kind = system.type(constant.type).kind;
            if (kind == ir::TypeKind::real) return ParameterKind::real;
            const bool whole = kind == ir::TypeKind::nat || kind == ir::TypeKind::integer;
            return whole ? ParameterKind::whole : ParameterKind::other;
        }
        return ParameterKind::other;
    }

    [[nodiscard]] std::string beginning_text(const simulation::RaceOptions& race_options) const {
        std::string out = fmt::format("tuning of {}: at most {} trials, seed {}, {}\n", scenario_.name.text,
                                      race_options.budget, race_options.seed, name_of(options_.tune.elimination));
        for (const Parameter& parameter : parameters_)
            out += fmt::format("  {} in {}: {} values\n", parameter.name, parameter.text, parameter.size());
        return out + "\n";
    }

    /// Returns a text such as "farRadius=0.2: cost 412.3 in 15 trials".
    [[nodiscard]] std::string entry_text(const simulation::RaceEntry& entry) const {
        return fmt::format("{}: cost {:.1f} in {} trials", simulation::candidate_text(parameters_, entry.candidate),
                           entry.mean_cost(), entry.trial_count());
    }

    void show_iteration(const simulation::Race& race) const {
        if (is_quiet()) return;
        const simulation::RaceIteration& now = race.iterations().back();
        print("iteration {}: {} new candidates, {} seeds, {} trials ({} in all), {} left{}{}\n",
              race.iterations().size(), now.fresh, now.seeds, now.trials, race.trial_count(), now.left,
              now.unusable > 0 ? fmt::format(", {} unusable", now.unusable) : "",
              now.refused > 0 ? fmt::format(", {} refused by check", now.refused) : "");
        if (!race.elites().empty()) print("  {}\n", entry_text(race.entries()[race.elites().front()]));
    }

    void decide_winner(const simulation::Race& race, const Subject& subject) {
        const Candidate& winner = race.entries()[race.elites().front()].candidate;
        const Options options = subject.options_with(winner);
        certificate_.program = fmt::format("robochart-verify {}", program_version);
        certificate_.build =
            diagnostics::program_identity().empty() ? "" : driver::content_digest(diagnostics::program_identity());
        for (std::size_t p = 0; p < parameters_.size(); ++p)
            certificate_.constants.emplace_back(parameters_[p].name, parameters_[p].value_text(winner[p]));
        const Pairs fixed = fixed_constants();
        certificate_.constants.insert(certificate_.constants.end(), fixed.begin(), fixed.end());
        certificate_.ranges = options_.instantiation.ranges;
        driver::SearchRecord& search = certificate_.search;
        search.parameters = varied_;
        search.budget = options_.tune.trials;
        search.seed = options_.tune.seed;
        search.test = name_of(options_.tune.elimination);
        search.trials = race.trial_count();
        search.candidates = race.entries().size();
        search.first_seed = simulation::tuning_seed(scenario_, search.seed, 0);
        search.seeds = race.seed_count();
        search.cost = race.entries()[race.elites().front()].mean_cost();
        decide_all(options);
    }

    /// Makes all decisions for the certificate.
    void decide_all(const Options& options) {
        options_.run->recorder().forget_values();  // the values of other candidates
        driver::Evidence& evidence = certificate_.evidence;
        decide_assertions(options, scenario_, evidence);
        decide_conformance(options, scenario_, evidence);
        std::unique_ptr<Simulation> simulation;
        if (!decide_claims(options, evidence, simulation)) project_ = std::move(simulation->project);
    }

    /// Prints the results of a search that was interrupted.
    Exit end_interrupted(const simulation::Race& race) const {
        print_json(race, "", Exit::inconclusive);
        if (options_.output.format == Format::json) return Exit::inconclusive;
        print("{}: not finished; the same command goes on where it was\n", limit_);
        for (const std::size_t elite : race.elites()) print("  {}\n", entry_text(race.entries()[elite]));
        return Exit::inconclusive;
    }

    Exit without_winner(const simulation::Race& race, const Subject& subject) const {
        options_.run->finish();
        const bool some = race.trial_count() > 0;
        const Exit exit = some ? Exit::failed : Exit::bad_input;
        std::vector<std::string> reasons;
        if (!subject.refusal_reason().empty()) reasons.push_back("refused: " + subject.refusal_reason());
        if (!subject.unusable_reason().empty()) reasons.push_back("unusable: " + subject.unusable_reason());
        if (some)
            reasons.emplace_back("no values were found with which the model's assertions hold");
        else if (subject.unusable_reason().empty())
            reasons.emplace_back("the trials do not suffice for a search: --budget takes more");
        else
            reasons.emplace_back("no values were found with which the scenario can be run");
        print_json(race, "", exit, reasons);
        if (options_.output.format == Format::json) return exit;
        for (const std::string& reason : reasons) print("{}\n", reason);
        return exit;
    }

    Exit write_results(const simulation::Race& race, const Subject& subject) {
        const std::string folder = "tuning/" + scenario_.name.text + "/";
        const std::string path = folder + "certificate.json";
        certificate_.run = diagnostics::json_text(run_json(record_of(options_)));
        write(path, certificate_text(certificate_));
        write(folder + "candidates.csv", candidates_csv(race));
        options_.run->finish();
        if (!project_->diagnostics.ok()) return show_refusal();
        const Exit exit = exit_of(certificate_.evidence);
        print_json(race, options_.output.folder + "/" + path, exit);
        if (options_.output.format == Format::json) return exit;
        if (!options_.output.quiet) {
            print("\nwinner: {}\n", with_constants(certificate_.constants));
            if (subject.earlier_trials() > 0)
                print("  {} of {} trials known from earlier runs\n", subject.earlier_trials(), race.trial_count());
            if (!subject.refusal_reason().empty())
                print("  refused by check, among others: {}\n", subject.refusal_reason());
            print("{}in this world\n{}files\n  {}/{}\n  {}/{}candidates.csv\n\n", evidence_text(certificate_.evidence),
                  simulation::world_text(scenario_), diagnostics::escape_for_display(options_.output.folder), path,
                  diagnostics::escape_for_display(options_.output.folder), folder);
        }
        print("{}: {}\n", with_constants(certificate_.constants),
              exit == Exit::success ? "checked, conforming, and no claim fails" : shortcoming(exit));
        return exit;
    }

    void write(const std::string& path, const std::string& text) {
        const std::string error = diagnostics::write_below(options_.output.folder, path, text, &options_.run->budget());
        if (!error.empty()) project_->diagnostics.report(rules::unwritable, {}, {error});
    }

    /// Returns a table with one row per candidate, in the order in which the candidates were drawn.
    [[nodiscard]] std::string candidates_csv(const simulation::Race& race) const {
        std::string out = "candidate";
        for (const Parameter& parameter : parameters_) out += "," + parameter.name;
        out += ",trials,cost,elite\n";
        for (std::size_t c = 0; c < race.entries().size(); ++c) {
            const simulation::RaceEntry& entry = race.entries()[c];
            out += fmt::format("{}", c + 1);
            for (std::size_t p = 0; p < parameters_.size(); ++p)
                out += "," + parameters_[p].value_text(entry.candidate[p]);
            const auto rank = std::ranges::find(race.elites(), c);
            out += fmt::format(",{},{},{}\n", entry.trial_count(),
                               entry.trial_count() > 0 ? fmt::format("{:.3f}", entry.mean_cost()) : "",
                               rank == race.elites().end() ? "" : fmt::format("{}", rank - race.elites().begin() + 1));
        }
        return out;
    }

    /// Prints JSON with the schema "robochart-verify/tuning/1" (docs/cli.md).
    void print_json(const simulation::Race& race, const std::string& certificate, Exit exit,
                    const std::vector<std::string>& reasons = {}) const {
        using diagnostics::Json;
        const auto elite_json = [&](std::size_t elite) -> Json {
            const simulation::RaceEntry& entry = race.entries()[elite];
            Json constants = Json::object();
            for (std::size_t p = 0; p < parameters_.size(); ++p)
                constants[parameters_[p].name] = parameters_[p].value_text(entry.candidate[p]);
            return {{"constants", constants}, {"trials", entry.trial_count()}, {"cost", entry.mean_cost()}};
        };
        const auto iteration_json = [](const simulation::RaceIteration& iteration) -> Json {
            return {{"fresh", iteration.fresh},   {"unusable", iteration.unusable}, {"seeds", iteration.seeds},
                    {"trials", iteration.trials}, {"left", iteration.left},         {"refused", iteration.refused}};
        };
        const Json decided = certificate.empty() ? Json() : Json::parse(certificate_text(certificate_));
        output_json(options_, {{"schema", "robochart-verify/tuning/1"},
                               {"scenario", scenario_.name.text},
                               {"trials", race.trial_count()},
                               {"seeds", race.seed_count()},
                               {"iterations", diagnostics::json_array(race.iterations(), iteration_json)},
                               {"elites", diagnostics::json_array(race.elites(), elite_json)},
                               {"reasons", reasons},
                               {"limit", limit_},
                               {"file", certificate},
                               {"certificate", decided},
                               {"exit", static_cast<int>(exit)}});
    }

    // ------------------------------------------------------------ --verify-certificate

    Exit verify_certificate() {
        project_ = std::make_unique<driver::Project>();
        std::string error;
        const auto source = project_->sources.load_file(given_options_.tune.certificate, error);
        std::optional<driver::Certificate> certified;
        if (source) certified = driver::read_certificate(project_->sources.source_text(*source), error);
        if (!certified)
            report_option(fmt::format("--verify-certificate {}: {}",
                                      diagnostics::escape_for_display(given_options_.tune.certificate),
                                      diagnostics::escape_for_display(error)));
        if (!given_options_.instantiation.constants.empty())
            report_option("the constants are those of the certificate: no --const beside it");
        if (!given_options_.instantiation.ranges.empty())
            report_option("the ranges are those of the certificate: no --range beside it");
        scenario_ = read_scenario_of(*project_, options_);
        refuse_followed_claims(scenario_, *project_);
        if (!project_->diagnostics.ok()) return show_refusal();
        options_.run->recorder().set_seed(scenario_.seed);
        for (const auto& [name, value] : certified->constants)
            options_.instantiation.constants.push_back(fmt::format("{}={}", name, value));
        options_.instantiation.ranges = certified->ranges;
        decide_all(options_);
        if (!project_->diagnostics.ok()) return show_refusal();
        options_.run->finish();
        return print_comparison(*certified);
    }

    /// Prints the comparison. A correct certificate that states a failure is not a success.
    Exit print_comparison(const driver::Certificate& certified) const {
        const std::vector<std::string> lines = evidence_differences(certified.evidence, certificate_.evidence);
        const Exit exit = lines.empty() ? exit_of(certificate_.evidence) : Exit::failed;
        const auto constant_json = [](const auto& constant) -> diagnostics::Json {
            return {{"name", constant.first}, {"value", constant.second}};
        };
        output_json(options_, {{"schema", "robochart-verify/certified/1"},
                               {"scenario", scenario_.name.text},
                               {"program", certified.program},
                               {"constants", diagnostics::json_array(certified.constants, constant_json)},
                               {"ranges", certified.ranges},
                               {"differences", lines},
                               {"exit", static_cast<int>(exit)}});
        if (options_.output.format == Format::json) return exit;
        if (!options_.output.quiet) {
            print("certificate of {}: {}\n", scenario_.name.text, with_constants(certified.constants));
            print("  ranges: {}\n  search: as recorded, not repeated\n",
                  certified.ranges.empty()
                      ? "none"
                      : diagnostics::escape_for_display(fmt::format("{}", fmt::join(certified.ranges, " "))));
            print("{}\n", evidence_text(certificate_.evidence));
        }
        for (const std::string& line : lines) print("  differs      {}\n", diagnostics::escape_for_display(line));
        std::string text = lines.empty() ? "the certificate says what is decided here"
                                         : "the certificate does not say what is decided here";
        if (lines.empty() && exit != Exit::success) text += fmt::format(": {}", shortcoming(exit));
        print("{}\n", text);
        return exit;
    }

    const Options& given_options_;
    Options options_;  ///< without the constants that vary
    Pairs varied_;
    std::unique_ptr<driver::Project> project_;
    std::vector<OtherController> others_;  ///< the scenario's other controllers
    simulation::Scenario scenario_;
    std::vector<Parameter> parameters_;
    driver::Certificate certificate_;
    std::string limit_;
};

}  // namespace

Exit run_tune(const Options& options) {
    options.run->last_word([&options](const std::string& why) {
        output_json(
            options,
            {{"schema", "robochart-verify/tuning/1"}, {"limit", why}, {"exit", static_cast<int>(Exit::inconclusive)}});
        if (options.output.format == Format::text) print_text(why + "\n");
        return Exit::inconclusive;
    });
    try {
        return Tuning(options).run();
    } catch (const cpp_emit::NoCompiler& missing) {
        return options.run->end_run(missing.what());
    }
}

}  // namespace robochart::app
