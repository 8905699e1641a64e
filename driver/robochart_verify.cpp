// SPDX-License-Identifier: Apache-2.0
// The public functions convert their options to settings, call the pipeline, and convert its results to plain data.
#include "driver/robochart_verify.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <exception>
#include <new>
#include <set>
#include <utility>

#include "base/diagnostics/render.hpp"
#include "counterexample/text.hpp"
#include "driver/claims/model_claims.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/settings/claim_selection.hpp"
#include "driver/settings/rules.hpp"
#include "driver/settings/run_limits.hpp"
#include "driver/settings/services.hpp"

namespace robochart::verify {
namespace {

using driver::Part;
using driver::Project;

/// The services of one call. No thread watches the limits; the phases poll them.
class CallServices final : public driver::Services {
public:
    explicit CallServices(diagnostics::Limits limits) : budget_(std::move(limits)) {}
    [[nodiscard]] diagnostics::Budget& budget() override { return budget_; }

private:
    diagnostics::Budget budget_;
};

// ---------------------------------------------------------------- results as plain data

std::optional<Place> plain(const std::optional<runs::Place>& place) {
    if (!place) return std::nullopt;
    return Place{place->file, place->line, place->column, place->end_line, place->end_column};
}

std::optional<Place> place_of(const diagnostics::SourceManager& sources, diagnostics::Span span) {
    return plain(driver::region_of(sources, span));
}

Severity severity_of(diagnostics::Severity severity) {
    switch (severity) {
        case diagnostics::Severity::note:
            return Severity::note;
        case diagnostics::Severity::warning:
            return Severity::warning;
        case diagnostics::Severity::error:
            break;
    }
    return Severity::error;
}

Finding plain(const diagnostics::SourceManager& sources, const diagnostics::Diagnostic& finding) {
    return {severity_of(finding.rule->severity), std::string(finding.rule->code), finding.message(),
            place_of(sources, finding.span)};
}

/// Returns a finding about the settings, without a place.
Finding wrong_setting(std::string message) {
    return {Severity::error, std::string(driver::rules::bad_option.code), std::move(message), std::nullopt};
}

Finding internal_error(const std::exception& error) {
    return {Severity::error, "", fmt::format("an internal error: {}", error.what()), std::nullopt};
}

Verdict verdict_of(driver::Answer answer) {
    switch (answer) {
        case driver::Answer::holds:
            return Verdict::holds;
        case driver::Answer::fails:
            return Verdict::fails;
        case driver::Answer::inconclusive:
            return Verdict::inconclusive;
        case driver::Answer::no_check:
            return Verdict::no_check;
        case driver::Answer::error:
            return Verdict::error;
        case driver::Answer::unchecked:
            return Verdict::not_checked;
        case driver::Answer::computed:
            return Verdict::value;
    }
    return Verdict::error;
}

Machine plain(const runs::Machine& machine) {
    Machine result{machine.component, machine.text, machine.active, {}};
    for (const runs::Variable& variable : machine.variables)
        if (variable.value && variable.kind != runs::VariableKind::constant)
            result.variables.push_back({variable.name, *variable.value});
    return result;
}

std::vector<Machine> plain(const std::vector<runs::Machine>& machines) {
    std::vector<Machine> result;
    for (const runs::Machine& machine : machines) result.push_back(plain(machine));
    return result;
}

Step plain(const runs::Step& step) {
    Step result;
    result.text = runs::text_of(step.event, step.with);
    result.component = step.event.component;
    result.element = step.event.element;
    for (const runs::Value& value : step.event.values) result.values.push_back(value.text);
    result.hidden = step.hidden;
    result.notable = runs::is_news(step);
    result.time = step.time;
    result.place = plain(step.event.place);
    result.machines = plain(step.machines);
    return result;
}

Run plain(const runs::Run& run) {
    Run result{run.timed, plain(run.initial), {}, run.loop_start, run.end.why};
    for (const runs::Step& step : run.steps) result.steps.push_back(plain(step));
    return result;
}

Value plain(const probability::Row& row, const prism::Result& found) {
    Value value;
    value.constants.insert(row.constants.begin(), row.constants.end());
    value.sampled = found.estimate.has_value();
    switch (found.kind) {
        case prism::Result::Kind::truth:
            value.truth = found.truth;
            break;
        case prism::Result::Kind::number:
            value.low = found.low.bounds().low;
            value.high = found.low.bounds().high;
            break;
        case prism::Result::Kind::range:
            value.low = found.low.bounds().low;
            value.high = found.high.bounds().high;
            break;
        case prism::Result::Kind::states:
        case prism::Result::Kind::unknown:
            value.unknown = found.reason.empty() ? "not decided" : found.reason;
            break;
    }
    return value;
}

std::vector<Value> plain(const driver::ProbabilityReport& report) {
    std::vector<Value> values;
    for (const probability::Row& row : report.rows) {
        for (const prism::Result& found : row.results) values.push_back(plain(row, found));
        if (row.error.empty()) continue;
        Value& failed = values.emplace_back();
        failed.constants.insert(row.constants.begin(), row.constants.end());
        failed.unknown = row.error;
    }
    return values;
}

Answer plain(const driver::AssertionReport& report) {
    constexpr std::string_view indent = "  ";
    Answer answer;
    answer.title = report.core ? fmt::format("{}: {}", report.core->component, report.core->property) : report.title;
    answer.place = plain(report.region);
    answer.verdict = verdict_of(report.answer);
    answer.reason = report.reason;
    for (const driver::Ground& ground : report.basis)
        answer.basis.push_back({ground.text, plain(ground.region), ground.remedy});
    if (report.run) {
        answer.run = plain(*report.run);
        answer.text = runs::text_of(*report.run, indent);
    }
    if (report.probability) answer.values = plain(*report.probability);
    answer.information = report.core && report.core->information;
    answer.states = report.statistics.states;
    answer.transitions = report.statistics.transitions;
    answer.seconds = report.statistics.seconds;
    return answer;
}

// ---------------------------------------------------------------- options as settings

driver::Settings settings_of(const LoadOptions& options) {
    driver::Settings settings;
    settings.load.allowed = options.allowed_warnings;
    settings.load.deny_warnings = options.deny_warnings;
    for (const auto& [name, value] : options.constants)
        settings.instantiation.constants.push_back(fmt::format("{}={}", name, value));
    for (const auto& [type, range] : options.ranges)
        settings.instantiation.ranges.push_back(fmt::format("{}={}..{}", type, range.first, range.second));
    return settings;
}

driver::Times times_of(Semantics semantics) {
    switch (semantics) {
        case Semantics::both:
            break;
        case Semantics::untimed:
            return driver::Times::untimed;
        case Semantics::timed:
            return driver::Times::timed;
    }
    return driver::Times::both;
}

void take(const CheckOptions& options, driver::Settings& settings) {
    settings.claims.times = times_of(options.semantics);
    settings.claims.core = options.core_properties;
    settings.limits.timeout_seconds = options.limits.seconds;
    settings.limits.assertion_seconds = options.limits.seconds_of_claim;
    settings.limits.memory_bytes = options.limits.memory_bytes;
    settings.limits.max_states = options.limits.states;
    settings.limits.threads = options.limits.threads;
}

/// Sets the budget that all phases of this part poll.
void use(Project& project, diagnostics::Budget* budget) {
    project.diagnostics.set_budget(budget);
    project.instantiation.budget = budget;
}

/// Runs a phase. Returns the reason if a limit ended it early. If it failed, adds a finding.
std::string guarded(std::vector<Finding>& findings, const std::function<void()>& phase) {
    try {
        phase();
    } catch (const diagnostics::LimitReached& limit) {
        return limit.what();
    } catch (const std::bad_alloc&) {
        return "there is no more memory";
    } catch (const std::exception& error) {
        findings.push_back(internal_error(error));
    }
    return "";
}

/// Adds the findings of a part that were not known before.
void add_new(const Project& project, const std::vector<diagnostics::Diagnostic>& known,
             std::vector<Finding>& findings) {
    for (const diagnostics::Diagnostic& found : project.diagnostics.sorted_findings()) {
        const bool old = std::ranges::any_of(known, [&](const diagnostics::Diagnostic& other) {
            return other.rule == found.rule && other.span == found.span && other.arguments == found.arguments;
        });
        if (!old) findings.push_back(plain(project.sources, found));
    }
}

/// Lists the selected claims of a part as claims without an answer.
void list_claims(const Project& project, const driver::ClaimSettings& settings, Verdict verdict,
                 const std::string& reason, std::vector<Answer>& answers) {
    for (const driver::ClaimName& claim : driver::all_claims_of(project)) {
        if (!is_selected(settings, claim.name)) continue;
        Answer& answer = answers.emplace_back();
        answer.title = project.label + claim.name;
        answer.place = place_of(project.sources, claim.span);
        answer.verdict = verdict;
        answer.reason = reason;
    }
}

}  // namespace

// ---------------------------------------------------------------- the model

struct Model::Impl {
    driver::Settings settings;
    std::vector<Part> parts;
    std::vector<Claim> claims;

    void list() {
        std::set<std::pair<std::string, std::uint32_t>> known;  // parts with broken claims have separate texts
        for (const Part& part : parts)
            for (const driver::ClaimName& claim : driver::all_claims_of(*part.project)) {
                const std::string& path = part.project->sources.path(claim.span.source);
                if (known.emplace(path, claim.span.begin).second)
                    claims.push_back({claim.name, place_of(part.project->sources, claim.span)});
            }
    }

    /// Replaces the words by the names of claims. If a word selects no claim, adds a finding and returns false.
    bool select(const std::vector<std::string>& words, driver::ClaimSettings& selected,
                std::vector<Finding>& findings) const {
        std::vector<std::string> names;
        for (const Claim& claim : claims)
            if (std::ranges::find(names, claim.name) == names.end()) names.push_back(claim.name);
        const driver::ClaimSelection selection = driver::select_claims(words, names);
        for (const std::string& word : selection.lost)
            findings.push_back(wrong_setting(fmt::format("{}: {}", word, driver::why_lost(word, names, "the model"))));
        for (const std::size_t place : selection.chosen) selected.names.push_back(names[place]);
        return selection.lost.empty();
    }

    /// Decides the claims of one part. Returns the reason if a limit ended the check early.
    std::string check(const Part& part, const driver::Settings& call_settings, CallServices& services,
                      CheckResult& result) {
        Project& project = *part.project;
        if (!is_acceptable(project, call_settings.load)) {
            list_claims(project, call_settings.claims, Verdict::error, "its text has errors, or depends on errors",
                        result.answers);
            return "";
        }
        use(project, &services.budget());
        project.scripts.clear();  // the scripts depend on the settings of the check
        const diagnostics::Diagnostics before = project.diagnostics;
        driver::Settings of_part = call_settings;
        of_part.claims.core = core_wanted(part, call_settings);
        driver::ClaimResults found;
        const std::string limit = guarded(result.findings, [&] {
            check_assertions(project, {of_part, services}, found);
        });
        for (const driver::AssertionReport& report : found.assertions) result.answers.push_back(plain(report));
        add_new(project, before.sorted_findings(), result.findings);
        project.diagnostics = before;
        use(project, nullptr);
        return limit;
    }

    CheckResult check(const std::vector<std::string>& words, bool all, const CheckOptions& options) {
        CheckResult result;
        driver::Settings call_settings = settings;
        take(options, call_settings);
        if (!all && !select(words, call_settings.claims, result.findings)) return result;
        diagnostics::Limits limits = driver::run_limits(call_settings.limits);
        limits.interrupted = options.interrupted;
        CallServices services(std::move(limits));
        for (const Part& part : parts) {
            if (result.limit.empty())
                result.limit = check(part, call_settings, services, result);
            else
                list_claims(*part.project, call_settings.claims, Verdict::inconclusive, driver::undecided_at_limit,
                            result.answers);
        }
        return result;
    }
};

Model::Model(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Model::Model(Model&&) noexcept = default;
Model& Model::operator=(Model&&) noexcept = default;
Model::~Model() = default;

const std::vector<Claim>& Model::claims() const {
    return impl_->claims;
}

CheckResult Model::check(const CheckOptions& options) {
    return impl_->check({}, true, options);
}

CheckResult Model::check(const std::vector<std::string>& words, const CheckOptions& options) {
    return impl_->check(words, false, options);
}

bool CheckResult::all_hold() const {
    bool some = false;
    for (const Answer& answer : answers) {
        if (answer.information || answer.verdict == Verdict::no_check) continue;
        if (answer.verdict != Verdict::holds && answer.verdict != Verdict::value) return false;
        some = true;
    }
    const auto is_error = [](const Finding& finding) { return finding.severity == Severity::error; };
    return some && limit.empty() && std::ranges::none_of(findings, is_error);
}

// ---------------------------------------------------------------- loading

/// Loads models; the only code that makes objects of Model.
struct Loader {
    static LoadResult load(driver::Settings settings) {
        LoadResult result;
        if (settings.load.inputs.empty()) {
            result.findings.push_back(wrong_setting("no file is given"));
            return result;
        }
        auto impl = std::make_unique<Model::Impl>();
        CallServices services(driver::run_limits({}));
        const std::string limit =
            guarded(result.findings, [&] { impl->parts = load_parts(settings, services.budget()); });
        if (!limit.empty()) result.findings.push_back({Severity::error, "", limit, std::nullopt});
        bool usable = false;
        for (const Part& part : impl->parts) {
            add_new(*part.project, {}, result.findings);
            result.text += diagnostics::render_text(part.project->sources, part.project->diagnostics);
            usable = usable || is_acceptable(*part.project, settings.load);
            use(*part.project, nullptr);
        }
        if (!usable) return result;
        impl->settings = std::move(settings);
        impl->list();
        result.model = Model(std::move(impl));
        return result;
    }
};

LoadResult load_files(const std::vector<std::string>& paths, const LoadOptions& options) {
    driver::Settings settings = settings_of(options);
    settings.load.inputs = paths;
    return Loader::load(std::move(settings));
}

LoadResult load_texts(const std::vector<Text>& texts, const LoadOptions& options) {
    driver::Settings settings = settings_of(options);
    for (const Text& text : texts) settings.load.texts.push_back({text.path, text.text});
    if (!texts.empty()) settings.load.inputs.push_back(texts.front().path);
    return Loader::load(std::move(settings));
}

std::string_view name_of(Verdict verdict) {
    constexpr std::array<std::string_view, 7> names{"holds", "fails",       "inconclusive", "no check",
                                                    "error", "not checked", "value"};
    return names[static_cast<std::size_t>(verdict)];
}

std::string_view version() {
    return ROBOCHART_VERSION;
}

}  // namespace robochart::verify
