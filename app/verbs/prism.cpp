// SPDX-License-Identifier: Apache-2.0
// The verb `prism`: explores or samples PRISM models and decides their properties, for one or more sets of constants.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>

#include "app/command/answer.hpp"
#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/prism/prism_model.hpp"
#include "app/report/prism_report.hpp"
#include "app/report/value_plot.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/files.hpp"
#include "base/diagnostics/render.hpp"
#include "base/threads/threads.hpp"
#include "prism/emit/emit.hpp"
#include "prism/explore/rules.hpp"
#include "prism/session/export.hpp"
#include "prism/session/session.hpp"
#include "prism/session/simulation.hpp"
#include "prism/syntax/printer.hpp"

namespace robochart::app {
namespace {

void show_findings(const LoadedModel& loaded, const Options& options) {
    const diagnostics::TextStyle style = findings_style(options);
    print_error_styled(diagnostics::render_text(loaded.sources, loaded.diagnostics, style));
}

void print_report(const PrismReport& report, const Options& options) {
    output_document(options,
                    [&](Format format) { return format == Format::csv ? prism_csv(report) : prism_json(report); });
    if (options.output.format == Format::text) print_text(prism_text(report, options));
}

NamedValues named_values(const prism::Values& values) {
    NamedValues result;
    for (const auto& [name, value] : values) result.emplace_back(name, value.text());
    return result;
}

/// Thrown if the model is wrong for a set of constants; the findings state why.
class WrongModel : public std::exception {
public:
    explicit WrongModel(std::size_t number) : number_(number) {}
    /// Returns the index of the set of constants.
    [[nodiscard]] std::size_t number() const { return number_; }

private:
    std::size_t number_;
};

/// Decides all properties, and keeps the report up to date for the last word.
class PrismVerb {
public:
    PrismVerb(const Options& options, std::shared_ptr<PrismReport> report)
        : options_(options), report_(std::move(report)) {
        loaded_.diagnostics.set_budget(&options.run->budget());
        for (const std::string& code : options.load.allowed) loaded_.diagnostics.allow_code(code);
    }

    Exit operator()() {
        {
            const diagnostics::Budget::Phase phase(options_.run->budget(), "reading " + options_.load.inputs.front());
            load_model(options_, loaded_);
            if (!loaded_.diagnostics.ok()) return end_refused();
        }
        begin_report();
        const Experiment experiment = make_experiment(loaded_, options_);
        if (options_.prism.exported != SpaceExport::none) return export_result(experiment);
        run_all(experiment);
        options_.run->finish();
        show_findings(loaded_, options_);
        if (!loaded_.diagnostics.ok() && report_->errors.empty()) note_errors();
        print_report(*report_, options_);
        return options_.prism.plot.empty() ? exit_of(*report_) : write_plot();
    }

private:
    Exit write_plot() {
        const std::string picture = value_plot(*report_);
        if (picture.empty())
            throw UsageError("--plot: there is no number for several values of a constant: --const NAME=LOW:HIGH");
        const std::string error = diagnostics::replace_file(options_.prism.plot, picture, &options_.run->budget());
        if (error.empty()) return exit_of(*report_);
        print_error("robochart-verify: {}\n", error);
        return Exit::bad_input;
    }

    void note_errors() {
        const auto edit = options_.run->edit();
        for (const diagnostics::Diagnostic& finding : loaded_.diagnostics.sorted_findings())
            if (finding.rule->severity == diagnostics::Severity::error)
                report_->errors.push_back(fmt::format("{}{}{}", loaded_.sources.path_and_line(finding.span),
                                                      finding.span.is_known() ? ": " : "", finding.message()));
    }

    Exit end_refused() {
        options_.run->finish();
        show_findings(loaded_, options_);
        note_errors();
        note_kind();
        output_document(options_, [&](Format format) { return format == Format::csv ? "" : prism_json(*report_); });
        return Exit::bad_input;
    }

    void note_kind() { report_->kind = loaded_.kind; }

    void begin_report() {
        const auto edit = options_.run->edit();
        note_kind();
        report_->scheduler = loaded_.scheduled ? "uniform" : "";
        report_->sources = &loaded_.sources;
        for (const prism::Property& property : loaded_.properties.properties)
            report_->properties.push_back({property.name.text, prism::print(property.expression)});
    }

    /// Processes several sets of the model's constants in parallel. For a single set, computes its answers in parallel.
    void run_all(const Experiment& experiment) {
        const std::size_t count = experiment.of_model.size();
        {
            const auto edit = options_.run->edit();
            report_->runs.resize(count);
            for (std::size_t i = 0; i < count; ++i) report_->runs[i].constants = named_values(experiment.of_model[i]);
        }
        std::vector<diagnostics::Diagnostics> findings(count);
        threads_ = diagnostics::threads_wanted(options_.limits.threads);
        const diagnostics::Budget::Phase phase(
            options_.run->budget(),
            count == 1 ? "deciding " + options_.load.inputs.front()
                       : fmt::format("deciding {} for {} sets of constants", options_.load.inputs.front(), count));
        std::size_t done = count;
        try {
            diagnostics::in_parallel(count, threads_, [&](std::size_t number, unsigned) {
                if (!run_for_constants(number, experiment, findings[number])) throw WrongModel(number);
            });
        } catch (const WrongModel& first) {
            done = first.number() + 1;
            const auto edit = options_.run->edit();
            report_->runs.resize(done);
        }
        for (std::size_t i = 0; i < done; ++i) loaded_.diagnostics.add(findings[i]);
    }

    /// Returns false if the model is wrong.
    bool run_for_constants(std::size_t number, const Experiment& experiment, diagnostics::Diagnostics& findings) {
        findings.set_budget(&options_.run->budget());
        for (const std::string& code : options_.load.allowed) findings.allow_code(code);
        const prism::Values& constants = experiment.of_model[number];
        const unsigned threads = experiment.of_model.size() == 1 ? threads_ : 1;
        try {
            if (options_.prism.sampling) {
                sample_paths(number, prism::Instance(*loaded_.model, constants), experiment, findings, threads);
                return true;
            }
            std::optional<diagnostics::Budget::Phase> phase;
            if (experiment.of_model.size() == 1)
                phase.emplace(options_.run->budget(), "exploring " + options_.load.inputs.front());
            const auto begin = std::chrono::steady_clock::now();
            const prism::StateSpace space(*loaded_.model, constants, explore_options(), findings);
            phase.reset();
            note_size(space, number, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
            const prism::Session session(space, loaded_.properties, session_options());
            answer_all(
                number, experiment, threads, findings,
                [&](std::size_t property, const prism::Values& values) { return session.check(property, values); },
                [&](std::size_t property, const prism::Values& values) {
                    return find_evidence(session, property, values);
                });
        } catch (const prism::EvaluationError& error) {
            report_error(error, findings);
            return false;
        }
        return true;
    }

    /// Answers the properties by random paths, one property after another, with `threads` paths in parallel.
    void sample_paths(std::size_t number, const prism::Instance& instance, const Experiment& experiment,
                      diagnostics::Diagnostics& findings, unsigned threads) {
        options_.run->recorder().set_seed(options_.probability.seed);
        const prism::SamplingOptions sampling{*options_.prism.sampling, options_.probability.seed, threads,
                                              &options_.run->budget()};
        answer_all(
            number, experiment, 1, findings,
            [&](std::size_t property, const prism::Values& values) {
                return prism::simulate(instance, loaded_.properties, property, values, sampling, findings);
            },
            [](std::size_t, const prism::Values&) { return std::nullopt; });
    }

    static std::optional<prism::Counterexample> find_evidence(const prism::Session& session, std::size_t property,
                                                              const prism::Values& values) {
        try {
            return session.counterexample(property, values);
        } catch (const prism::Undecided&) {
        } catch (const markov::Unsupported&) {
        }
        return std::nullopt;
    }

    using Decide = std::function<prism::Result(std::size_t property, const prism::Values&)>;
    using Explain = std::function<std::optional<prism::Counterexample>(std::size_t property, const prism::Values&)>;

    /// Answers every property for all values of its constants. An answer is added to the report when all earlier
    /// answers are known. A false property is reported before the search for its counterexample.
    void answer_all(std::size_t number, const Experiment& experiment, unsigned threads,
                    diagnostics::Diagnostics& findings, const Decide& decide, const Explain& explain) {
        const std::size_t sets = experiment.of_properties.size();
        std::vector<std::optional<PrismAnswer>> answers(loaded_.properties.properties.size() * sets);
        std::vector<std::optional<prism::EvaluationError>> failures(answers.size());
        diagnostics::in_parallel(answers.size(), threads, [&](std::size_t at, unsigned) {
            const std::size_t property = at / sets;
            const prism::Values& values = experiment.of_properties[at % sets];
            std::optional<diagnostics::Budget::Phase> phase;
            if (answers.size() == 1)
                phase.emplace(options_.run->budget(), "deciding " + report_->properties[property].text);
            PrismAnswer answer{property, named_values(values), {}, {}, {}};
            std::optional<prism::EvaluationError>& failed = failures[at];
            try {
                answer.result = decide(property, values);
            } catch (const prism::EvaluationError& error) {
                failed = error;
                diagnostics::Diagnostics one;
                error.report(one);
                answer.error = one.sorted_findings().front().message();
            }
            const bool violated = !failed && answer.result.kind == prism::Result::Kind::truth && !answer.result.truth;
            std::vector<PrismAnswer>& reported = report_->runs[number].answers;
            {
                const auto edit = options_.run->edit();
                answers[at] = std::move(answer);
                while (reported.size() < answers.size() && answers[reported.size()])
                    reported.push_back(*answers[reported.size()]);
            }
            if (!violated) return;
            std::optional<prism::Counterexample> found = explain(property, values);
            const auto edit = options_.run->edit();
            (reported.size() > at ? reported[at] : *answers[at]).counterexample = std::move(found);
        });
        for (const std::optional<prism::EvaluationError>& failure : failures)
            if (failure) report_error(*failure, findings);
    }

    /// Reports a value outside its range. For a model of `emit prism`, the message explains how to set the range.
    void report_error(const prism::EvaluationError& error, diagnostics::Diagnostics& findings) const {
        diagnostics::Diagnostic& finding = error.report(findings);
        const bool of_robochart = (error.is(prism::rules::out_of_range) || error.is(prism::rules::left_out)) &&
                                  finding.span.is_known() &&
                                  prism_emit::is_of_robochart(loaded_.sources.source_text(finding.span.source));
        if (of_robochart)
            finding.notes.push_back({{},
                                     "the model is of a RoboChart model, with the ranges of its finite instantiation: "
                                     "`emit prism` with --range nat=0..9 (or int, real), or with RoboTool's "
                                     "preferences, --prefs FILE, writes it with others"});
    }

    void note_size(const prism::StateSpace& space, std::size_t number, double seconds) {
        const auto edit = options_.run->edit();
        PrismRun& run = report_->runs[number];
        run.explored = true;
        run.states = space.chain().states();
        run.choices = space.chain().choices();
        run.transitions = space.transitions();
        run.initial = space.chain().initial.size();
        run.deadlocks = space.deadlock_count();
        run.seconds = seconds;
    }

    [[nodiscard]] prism::ExploreOptions explore_options() const {
        return {options_.limits.max_states, options_.probability.exact, &options_.run->budget()};
    }
    [[nodiscard]] prism::SessionOptions session_options() const {
        return {options_.probability.epsilon, options_.probability.exact, &options_.run->budget()};
    }

    /// Returns the reason why nothing could be exported; "" on success.
    std::string export_part(const prism::StateSpace& space, const Experiment& experiment, const prism::TextSink& sink) {
        switch (options_.prism.exported) {
            case SpaceExport::none:
                break;
            case SpaceExport::transitions:
                prism::export_transitions(space, sink);
                break;
            case SpaceExport::states:
                prism::export_states(space, sink);
                break;
            case SpaceExport::labels:
                prism::export_labels(space, sink);
                break;
            case SpaceExport::graph:
                prism::export_graph(space, sink);
                break;
            case SpaceExport::strategy:
            case SpaceExport::counterexample:
                return export_answer(space, experiment.of_properties.front(), sink);
        }
        return "";
    }

    /// Exports the state space, or the result for one property.
    Exit export_result(const Experiment& experiment) {
        if (options_.prism.sampling) throw UsageError("--export and --sim exclude each other");
        const SpaceExport wanted_part = options_.prism.exported;
        const bool of_property = wanted_part == SpaceExport::strategy || wanted_part == SpaceExport::counterexample;
        if (experiment.of_model.size() != 1 || (of_property && experiment.of_properties.size() != 1))
            throw UsageError("--export needs one value for each constant");
        if (of_property && loaded_.properties.properties.size() != 1)
            throw UsageError(fmt::format("--export {} needs exactly one property",
                                         wanted_part == SpaceExport::strategy ? "strategy" : "counterexample"));
        std::string nothing;
        try {
            const diagnostics::Budget::Phase phase(options_.run->budget(), "exploring " + options_.load.inputs.front());
            const prism::StateSpace space(*loaded_.model, experiment.of_model.front(), explore_options(),
                                          loaded_.diagnostics);
            const prism::TextSink sink = [this](std::string_view text) {
                options_.run->finish();
                print_exact(text);
            };
            nothing = export_part(space, experiment, sink);
        } catch (const prism::EvaluationError& error) {
            report_error(error, loaded_.diagnostics);
        }
        options_.run->finish();
        show_findings(loaded_, options_);
        if (!loaded_.diagnostics.ok()) return Exit::bad_input;
        if (nothing.empty()) return Exit::success;
        print_error("robochart-verify: {}\n", nothing);
        return Exit::inconclusive;
    }

    /// Returns the reason why nothing could be written; "" on success.
    std::string export_answer(const prism::StateSpace& space, const prism::Values& values,
                              const prism::TextSink& sink) {
        const prism::Session session(space, loaded_.properties, session_options());
        try {
            if (options_.prism.exported == SpaceExport::strategy) {
                prism::export_strategy(space, session.best_choices(0, values), loaded_.sources, sink);
                return "";
            }
            const prism::Result result = session.check(0, values);
            const bool violated = result.kind == prism::Result::Kind::truth && !result.truth;
            const std::optional<prism::Counterexample> found =
                violated ? session.counterexample(0, values) : std::nullopt;
            if (!found) return violated ? "no set of paths shows that" : "the property is not a violated bound";
            prism::export_counterexample(*found, loaded_.sources, sink);
            return "";
        } catch (const prism::Undecided& why) {
            return why.what();
        } catch (const markov::Unsupported& why) {
            return why.what();
        }
    }

    const Options& options_;
    std::shared_ptr<PrismReport> report_;
    LoadedModel loaded_;
    unsigned threads_ = 1;
};

}  // namespace

Exit run_prism(const Options& options) {
    const auto report = std::make_shared<PrismReport>();
    report->model = options.load.inputs.front();
    options.run->last_word([report, &options](const std::string& why) {
        report->limit = why;
        print_report(*report, options);
        print_error("robochart-verify: {}\n", why);
        return exit_of(*report);
    });
    return PrismVerb(options, report)();
}

}  // namespace robochart::app
