// The verb `prism`: models of PRISM explored, their properties decided, for one set of constants or for many.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <chrono>
#include <memory>

#include "app/command/output.hpp"
#include "app/command/run.hpp"
#include "app/report/prism_report.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/prism/checks/check.hpp"
#include "checker/prism/experiment.hpp"
#include "checker/prism/explore/rules.hpp"
#include "checker/prism/export.hpp"
#include "checker/prism/session.hpp"
#include "checker/prism/syntax/printer.hpp"
#include "checker/prism/syntax/reader.hpp"
#include "checker/prism/syntax/rules.hpp"
#include "diagnostics/escape.hpp"
#include "diagnostics/files.hpp"
#include "diagnostics/render.hpp"

namespace robochart::app {
namespace {

/// The files with the findings about them.
struct LoadedModel {
    diagnostics::SourceManager sources;
    diagnostics::Diagnostics diagnostics;
    std::optional<prism::CheckedModel> model;
    prism::CheckedProperties properties;
};

std::optional<diagnostics::SourceId> load_text(const std::string& path, LoadedModel& loaded) {
    std::string error;
    std::optional<diagnostics::SourceId> source;
    if (path == "-") {
        std::string text = diagnostics::standard_input(diagnostics::SourceManager::max_bytes, error);
        if (error.empty()) source = loaded.sources.add("standard input", std::move(text));
    } else {
        source = loaded.sources.load(path, error);
    }
    if (!source) loaded.diagnostics.report(prism::rules::unreadable, {}, {diagnostics::shown(path), error});
    return source;
}

void add(prism::PropertyFile& all, prism::PropertyFile more) {
    all.constants.insert(all.constants.end(), more.constants.begin(), more.constants.end());
    all.labels.insert(all.labels.end(), more.labels.begin(), more.labels.end());
    all.properties.insert(all.properties.end(), more.properties.begin(), more.properties.end());
}

void load(const Options& options, LoadedModel& loaded) {
    const auto source = load_text(options.inputs.front(), loaded);
    if (!source) return;
    const prism::ModelFile model = prism::read_model(loaded.sources, *source, loaded.diagnostics);
    prism::PropertyFile properties;
    for (std::size_t i = 1; i < options.inputs.size(); ++i)
        if (const auto file = load_text(options.inputs[i], loaded))
            add(properties, prism::read_properties(loaded.sources, *file, loaded.diagnostics));
    for (const std::string& text : options.properties) {
        const auto id = loaded.sources.add("--property", text);
        add(properties, prism::read_properties(loaded.sources, id, loaded.diagnostics));
    }
    if (!loaded.diagnostics.ok()) return;
    loaded.model = prism::check_model(model, loaded.diagnostics);
    if (loaded.model) loaded.properties = prism::check_properties(*loaded.model, properties, loaded.diagnostics);
}

void show_findings(const LoadedModel& loaded, const Options& options) {
    diagnostics::TextStyle style;
    style.color = color_wanted(options.color, STDERR_FILENO);
    print_error_styled(diagnostics::render_text(loaded.sources, loaded.diagnostics, style));
}

std::string output(const PrismReport& report, const Options& options) {
    if (options.format == Format::json) return prism_json(report);
    return options.format == Format::csv ? prism_csv(report) : prism_text(report, options);
}

void print_report(const PrismReport& report, const Options& options) {
    if (options.format == Format::text)
        print_text(output(report, options));
    else
        print_exact(output(report, options));
}

NamedValues named(const prism::Values& values) {
    NamedValues result;
    for (const auto& [name, value] : values) result.emplace_back(name, value.text());
    return result;
}

/// Values asked for on the command line: of the model's constants, and of those of the properties.
struct Experiment {
    std::vector<prism::Values> of_model, of_properties;
};

Experiment experiment(const LoadedModel& loaded, const Options& options) {
    const std::vector<prism::Constant> of_model = prism::open_constants(loaded.model->constants);
    std::vector<prism::Constant> open = prism::open_constants(loaded.properties.constants);
    open.insert(open.end(), of_model.begin(), of_model.end());
    std::vector<prism::Series> model, properties;
    try {
        for (const std::string& text : options.constants)
            for (prism::Series& each : prism::read_series(text, open)) {
                const auto same = [&](const auto& other) { return other.name == each.name; };
                if (std::any_of(model.begin(), model.end(), same) ||
                    std::any_of(properties.begin(), properties.end(), same))
                    throw prism::BadValue(fmt::format("'{}' is given twice", each.name));
                const bool in_model = std::any_of(of_model.begin(), of_model.end(),
                                                  [&](const auto& c) { return c.name.text == each.name; });
                (in_model ? model : properties).push_back(std::move(each));
            }
        return {prism::combinations(model), prism::combinations(properties)};
    } catch (const prism::BadValue& error) {
        throw UsageError(fmt::format("--const {}", error.what()));
    }
}

/// Decides everything, and keeps the report up to date for the last word.
class PrismVerb {
public:
    PrismVerb(const Options& options, std::shared_ptr<PrismReport> report)
        : options_(options), report_(std::move(report)) {
        loaded_.diagnostics.within(&options.run->budget());
        for (const std::string& code : options.allowed) loaded_.diagnostics.allow(code);
    }

    Exit operator()() {
        const diagnostics::Budget::Phase phase(options_.run->budget(), "reading " + options_.inputs.front());
        load(options_, loaded_);
        if (!loaded_.diagnostics.ok()) return refused();
        {
            const auto edit = options_.run->edit();
            report_->mdp = loaded_.model->kind == prism::ModelKind::mdp;
            for (const prism::Property& each : loaded_.properties.properties)
                report_->properties.push_back({each.name.text, prism::print(each.expression)});
        }
        const Experiment wanted = experiment(loaded_, options_);
        if (!options_.exported_space.empty() && wanted.of_model.size() != 1)
            throw UsageError("--export writes one model: give each constant one value");
        for (const prism::Values& constants : wanted.of_model)
            if (!run(constants, wanted.of_properties)) break;
        options_.run->finish();
        show_findings(loaded_, options_);
        if (!loaded_.diagnostics.ok() && report_->errors.empty()) note_errors();
        if (options_.exported_space.empty()) print_report(*report_, options_);
        return exit_of(*report_);
    }

private:
    void note_errors() {
        const auto edit = options_.run->edit();
        for (const diagnostics::Diagnostic& each : loaded_.diagnostics.sorted())
            if (each.rule->severity == diagnostics::Severity::error)
                report_->errors.push_back(fmt::format("{}{}{}", loaded_.sources.place(each.span),
                                                      each.span.known() ? ": " : "", each.message()));
    }

    Exit refused() {
        options_.run->finish();
        show_findings(loaded_, options_);
        note_errors();
        if (options_.format == Format::json) print_exact(prism_json(*report_));
        return Exit::bad_input;
    }

    /// False where the model is wrong.
    bool run(const prism::Values& constants, const std::vector<prism::Values>& of_properties) {
        {
            const auto edit = options_.run->edit();
            report_->runs.push_back({});
            report_->runs.back().constants = named(constants);
        }
        prism::ExploreOptions explore{options_.max_states, options_.exact, &options_.run->budget()};
        const auto begin = std::chrono::steady_clock::now();
        try {
            const diagnostics::Budget::Phase phase(options_.run->budget(), "exploring " + options_.inputs.front());
            const prism::StateSpace space(*loaded_.model, constants, explore, loaded_.diagnostics);
            note_size(space, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
            if (!options_.exported_space.empty()) return export_space(space), true;
            decide(space, of_properties);
        } catch (const prism::EvaluationError& error) {
            error.report(loaded_.diagnostics);
            return false;
        }
        return true;
    }

    void note_size(const prism::StateSpace& space, double seconds) {
        const auto edit = options_.run->edit();
        PrismRun& run = report_->runs.back();
        run.explored = true;
        run.states = space.chain().states();
        run.choices = space.chain().choices();
        run.transitions = space.transitions();
        run.initial = space.chain().initial.size();
        run.deadlocks = space.deadlock_count();
        run.seconds = seconds;
    }

    void export_space(const prism::StateSpace& space) {
        options_.run->finish();
        const prism::TextSink sink = [](std::string_view text) { print_exact(text); };
        if (options_.exported_space == "tra") prism::export_transitions(space, sink);
        if (options_.exported_space == "sta") prism::export_states(space, sink);
        if (options_.exported_space == "lab") prism::export_labels(space, sink);
        if (options_.exported_space == "dot") prism::export_graph(space, sink);
    }

    void decide(const prism::StateSpace& space, const std::vector<prism::Values>& of_properties) {
        prism::Session session(space, loaded_.properties, {options_.epsilon, options_.exact, &options_.run->budget()});
        for (std::size_t i = 0; i < loaded_.properties.properties.size(); ++i)
            for (const prism::Values& constants : of_properties) {
                PrismAnswer answer = decided(session, i, constants);
                const auto edit = options_.run->edit();
                report_->runs.back().answers.push_back(std::move(answer));
            }
    }

    PrismAnswer decided(prism::Session& session, std::size_t property, const prism::Values& constants) {
        PrismAnswer answer;
        answer.property = property;
        answer.constants = named(constants);
        const diagnostics::Budget::Phase phase(options_.run->budget(),
                                               "deciding " + report_->properties[property].text);
        try {
            answer.result = session.check(property, constants);
        } catch (const prism::EvaluationError& error) {
            diagnostics::Diagnostics one;
            error.report(one);
            error.report(loaded_.diagnostics);
            answer.error = one.sorted().front().message();
        }
        return answer;
    }

    const Options& options_;
    std::shared_ptr<PrismReport> report_;
    LoadedModel loaded_;
};

}  // namespace

Exit run_prism(const Options& options) {
    const auto report = std::make_shared<PrismReport>();
    report->model = options.inputs.front();
    options.run->last_word([report, &options](const std::string& why) {
        report->limit = why;
        print_report(*report, options);
        print_error("robochart-verify: {}\n", why);
        return exit_of(*report);
    });
    return PrismVerb(options, report)();
}

}  // namespace robochart::app
