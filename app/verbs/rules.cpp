// SPDX-License-Identifier: Apache-2.0
// The verb `rules`: finds conflicts and redundancies of SLEEC rules, and decides whether a model obeys them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "app/command/answer.hpp"
#include "app/command/findings.hpp"
#include "app/command/output.hpp"
#include "app/command/recording.hpp"
#include "app/command/run.hpp"
#include "app/report/rules_report.hpp"
#include "app/rules/record_rules.hpp"
#include "app/rules/show_findings.hpp"
#include "app/verbs/verbs.hpp"
#include "checker/cspm/session.hpp"
#include "claims/sleec/analysis/explain.hpp"
#include "claims/sleec/analysis/properties.hpp"
#include "claims/sleec/analysis/suggest.hpp"
#include "claims/sleec/published/encoding.hpp"
#include "driver/model/claim_files.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/rules/model_rules.hpp"
#include "driver/rules/rule_claims.hpp"
#include "semantics/lower/lower.hpp"

namespace robochart::app {
namespace {

void print_report(const RulesReport& report, const Options& options) {
    output_document(options, [&](Format) { return rules_json(report); });
    if (options.output.format == Format::text) print_text(rules_text(report, options));
}

/// Decides everything, and keeps the report up to date for the last word.
class RulesVerb {
public:
    RulesVerb(const Options& options, std::shared_ptr<RulesReport> report)
        : options_(options), report_(std::move(report)) {
        loaded_.diagnostics.set_budget(&options.run->budget());
        for (const std::string& code : options.load.allowed) loaded_.diagnostics.allow_code(code);
    }

    Exit operator()() {
        const diagnostics::Budget::Phase phase(options_.run->budget(), "reading " + options_.load.inputs.front());
        read_unit();
        load_rules(options_.load.inputs.front(), loaded_, report_->unit);
        record_rules(loaded_, options_);
        show_rule_findings(loaded_, options_);
        if (!loaded_.rules || (options_.load.deny_warnings && loaded_.diagnostics.warning_count() > 0))
            return end_refused(loaded_.diagnostics, loaded_.sources, Exit::bad_input);
        describe_rules();
        if (options_.load.inputs.size() > 1) {
            if (const auto exit = judge_model()) return *exit;
        } else if (options_.rules.as_sleec_tk)
            compare_rules();
        else
            analyse_rules();
        options_.run->finish();
        print_report(*report_, options_);
        return exit_of(*report_);
    }

private:
    /// Reads the time unit. Rules alone are compared second by second. With a model, its time unit determines the
    /// length of a second.
    void read_unit() {
        if (options_.load.inputs.size() < 2) return;
        const auto unit = driver::unit_beside(options_.load.inputs, loaded_.sources, loaded_.diagnostics);
        const auto edit = options_.run->edit();
        if (unit) report_->unit = unit->nanoseconds;
    }

    /// Ends the run for a rejected file. The findings have already been printed as text, and are added to the documents
    /// for programs.
    Exit end_refused(const diagnostics::Diagnostics& findings, const diagnostics::SourceManager& sources, Exit exit) {
        options_.run->finish();
        for (const diagnostics::Diagnostic& finding : findings.sorted_findings())
            if (finding.rule->severity != diagnostics::Severity::note)
                report_->errors.push_back(fmt::format("{}{}{}", sources.path_and_line(finding.span),
                                                      finding.span.is_known() ? ": " : "", finding.message()));
        output_document(options_, [&](Format) { return rules_json(*report_); });
        return exit;
    }

    void describe_rules() {
        const auto edit = options_.run->edit();
        report_->dialect = sleec::dialect_name(rules().file->dialect);
        for (const sleec::CheckedRule& rule : rules().rules)
            report_->rules.push_back({rule.written->name.text, loaded_.sources.path_and_line(rule.written->span)});
    }

    // The default analysis.

    void analyse_rules() {
        const diagnostics::Budget::Phase phase(options_.run->budget(), "comparing the rules");
        sleec::AnalysisOptions analysis;
        analysis.without_limit = options_.rules.without_limit;
        analysis.limits = limits(options_);
        analysis.budget = &options_.run->budget();
        sleec::for_each_question(rules(), analysis,
                                 [&](const sleec::ConflictAnswer& answer) { note_conflict(answer, analysis); });
        find_redundancies(analysis);
        for (const sleec::CheckedProperty& concern : rules().concerns) ask_property(concern, true, analysis);
        for (const sleec::CheckedProperty& purpose : rules().purposes) ask_property(purpose, false, analysis);
    }

    /// Checks a concern or a purpose. If the rules are satisfied, a concern must be impossible, and a purpose must be
    /// possible.
    void ask_property(const sleec::CheckedProperty& property, bool concern, const sleec::AnalysisOptions& analysis) {
        const sleec::PropertyAnswer answer = sleec::check_possible(rules(), property, analysis);
        const sleec::Answer expected = concern ? sleec::Answer::no : sleec::Answer::yes;
        RuleProperty found{concern,
                           property.written->name.text,
                           loaded_.sources.path_and_line(property.written->span),
                           answer.possible != sleec::Answer::not_decided,
                           answer.reason,
                           {},
                           {}};
        if (found.decided && answer.possible != expected && concern)
            found.lines = sleec::history_lines(answer.history, property, rules());
        if (found.decided && answer.possible != expected && !concern)
            found.excluded = sleec::excluding_rules(rules(), property, analysis);
        const auto edit = options_.run->edit();
        ++(concern ? report_->concerns : report_->purposes);
        if (answer.possible != expected) report_->properties.push_back(std::move(found));
    }

    void note_conflict(const sleec::ConflictAnswer& answer, const sleec::AnalysisOptions& analysis) {
        RuleConflict conflict{answer.rules, answer.conflict == sleec::Answer::yes, answer.reason, {}, {},
                              answer.states};
        if (answer.example) conflict.lines = sleec::explain_conflict(*answer.example, rules(), loaded_.sources);
        if (answer.example && options_.rules.suggest)
            for (const sleec::Suggestion& suggestion : sleec::suggest_defeaters(rules(), answer.rules, analysis))
                conflict.suggested.push_back(fmt::format("{} ... {}", rules().name(suggestion.rule), suggestion.text));
        const auto edit = options_.run->edit();
        ++report_->questions;
        if (answer.conflict != sleec::Answer::no) report_->conflicts.push_back(std::move(conflict));
    }

    void find_redundancies(const sleec::AnalysisOptions& analysis) {
        for (std::size_t i = 0; i < rules().rules.size(); ++i) {
            try {
                if (sleec::makes_no_demand(rules(), i, analysis)) {
                    const auto edit = options_.run->edit();
                    report_->asking_nothing.push_back(i);
                    continue;
                }
                if (!rules().rules[i].assumed) redundancies_of(i, analysis);
            } catch (const sleec::NotDecided&) {  // the check of this rule's conflicts has reported this
            }
        }
    }

    /// Reports each rule that alone implies this rule. If there is none, checks whether the other rules imply it
    /// together.
    void redundancies_of(std::size_t rule, const sleec::AnalysisOptions& analysis) {
        bool alone = false;
        for (std::size_t by = 0; by < rules().rules.size(); ++by) {
            if (by == rule || !sleec::is_redundant(rules(), rule, by, analysis)) continue;
            alone = true;
            const auto edit = options_.run->edit();
            report_->redundant.push_back({rule, {by}});
        }
        if (alone || rules().rules.size() < 3) return;
        const sleec::Implication found = sleec::check_implied(rules(), rule, analysis);
        const auto edit = options_.run->edit();
        if (found.implied != sleec::Answer::no) report_->redundant.push_back({rule, found.by, found.reason});
    }

    // The analysis in SLEEC-TK's semantics.

    /// Returns the rules that the published encoding supports. Reports the names of the others.
    std::vector<std::size_t> encodable_rules(const sleec::Encoding& encoding) {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < rules().rules.size(); ++i) {
            try {
                (void)encoding.process_declarations({i});
                result.push_back(i);
            } catch (const sleec::NotDecided& error) {
                const auto edit = options_.run->edit();
                report_->not_read.push_back(fmt::format("{}: {}", report_->rules[i].name, error.what()));
            }
        }
        return result;
    }

    void note_ranges(const sleec::Encoding& encoding) {
        const auto edit = options_.run->edit();
        for (std::size_t i = 0; i < rules().measures.size(); ++i)
            if (rules().measure(i).type == sleec::MeasureType::numeric)
                report_->ranges.push_back(fmt::format("{} in {{{}}}", rules().measure(i).name.text,
                                                      fmt::join(encoding.measure_values(i), ", ")));
    }

    void compare_rules() {
        const diagnostics::Budget::Phase phase(options_.run->budget(), "comparing the rules as SLEEC-TK has it");
        std::optional<sleec::Encoding> encoding;
        try {
            encoding.emplace(rules());
        } catch (const sleec::NotDecided& error) {
            const auto edit = options_.run->edit();
            report_->not_read.emplace_back(error.what());
            return;
        }
        note_ranges(*encoding);
        const std::vector<std::size_t> encodable = encodable_rules(*encoding);
        std::vector<std::pair<std::size_t, std::size_t>> pairs;
        for (std::size_t i = 0; i < encodable.size(); ++i)
            for (std::size_t k = i + 1; k < encodable.size(); ++k)
                if (encoding->are_related(encodable[i], encodable[k])) pairs.emplace_back(encodable[i], encodable[k]);
        {
            const auto edit = options_.run->edit();
            for (const auto& [first, second] : pairs) report_->pairs.push_back({first, second, {}, {}, {}, {}});
        }
        if (!pairs.empty()) decide_pairs(*encoding, pairs);
    }

    void decide_pairs(const sleec::Encoding& encoding, const std::vector<std::pair<std::size_t, std::size_t>>& pairs) {
        cspm::Session session(encoding.make_script(pairs), &options_.run->budget());
        if (diagnostics::Cache* const cache = options_.run->cache()) session.set_cache(*cache);
        const auto assertions = session.assertions();
        const auto holds = [&](std::size_t i) -> std::optional<bool> {
            const refine::Outcome outcome = session.check(*assertions[i], limits(options_)).verdict.outcome;
            if (outcome == refine::Outcome::inconclusive) return std::nullopt;
            return outcome == refine::Outcome::holds;
        };
        const auto negated = [](std::optional<bool> answer) {
            return answer ? std::optional<bool>(!*answer) : std::nullopt;
        };
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            ComparedPair pair{pairs[i].first,   pairs[i].second, negated(holds(4 * i)), negated(holds(4 * i + 1)),
                              holds(4 * i + 2), holds(4 * i + 3)};
            const auto edit = options_.run->edit();
            report_->pairs[i] = pair;
        }
    }

    // The check whether a model obeys the rules.

    /// Checks the model. Returns an exit code if the model is rejected, or if it has no component with the name of
    /// --component.
    std::optional<Exit> judge_model() {
        driver::Settings of_model = options_;
        of_model.load.inputs.erase(of_model.load.inputs.begin());
        of_model.load.claims = driver::ClaimUse::decide;
        of_model.claims.times = driver::Times::timed;
        const std::unique_ptr<driver::Project> project = driver::load_project(of_model, options_.run->budget());
        record_project(*project, of_model, options_);
        const csp_emit::Emission* emission = nullptr;
        if (project->diagnostics.ok()) ir::leave_out_robosim(project->system, project->diagnostics, false);
        if (project->diagnostics.ok())
            emission = &emit_csp(*project, of_model.claims, of_model.swarm, csp_emit::Time::timed);
        record_block_values(*project, options_);
        app::show_findings(*project, options_);
        if (emission == nullptr || !is_acceptable(*project, of_model.load))
            return end_refused(project->diagnostics, project->sources, refusal_code(*project));
        for (const ir::ComponentRef& code_component : driver::code_components(project->system, options_.load.component))
            for (const csp_emit::ComponentProcesses& component : emission->components)
                if (component.path == code_component.path ||
                    component.path == code_component.package + "::" + code_component.path)
                    judge_component(*project, *emission, component);
        return std::nullopt;
    }

    void judge_component(const driver::Project& project, const csp_emit::Emission& emission,
                         const csp_emit::ComponentProcesses& component) {
        const driver::ModelRules model_rules({rules(), loaded_.sources}, project, emission, component,
                                             search_context(options_));
        for (std::size_t i = 0; i < rules().rules.size(); ++i) {
            if (rules().rules[i].assumed) continue;
            driver::RuleVerdict verdict = model_rules.judge_rule(i).verdict;
            const auto edit = options_.run->edit();
            report_->verdicts.push_back(std::move(verdict));
        }
        const driver::TimeStops time = model_rules.time_stops();
        const auto edit = options_.run->edit();
        if (time.stops) report_->time_stops.push_back(component.path);
        if (time.unknown.empty()) return;
        const std::string why = fmt::format("whether time can stop in {}: {}", component.path, time.unknown);
        (time.error ? report_->errors : report_->time_open).push_back(why);
    }

    [[nodiscard]] const sleec::CheckedRules& rules() const { return *loaded_.rules; }

    const Options& options_;
    std::shared_ptr<RulesReport> report_;
    driver::LoadedRules loaded_;
};

}  // namespace

Exit run_rules(const Options& options) {
    const auto report = std::make_shared<RulesReport>();
    report->file = options.load.inputs.front();
    report->as_sleec_tk = options.rules.as_sleec_tk;
    if (options.load.inputs.size() > 1) report->model = options.load.inputs[1];
    if (options.rules.as_sleec_tk && !report->model.empty())
        throw UsageError("--as-sleec-tk does not apply to a check of a model");
    report->without_limit = options.rules.without_limit == sleec::WithoutLimit::now ? "now" : "eventually";
    options.run->last_word([report, &options](const std::string& why) {
        report->limit = why;
        print_report(*report, options);
        print_error("robochart-verify: {}\n", why);
        return exit_of(*report);
    });
    return RulesVerb(options, report)();
}

}  // namespace robochart::app
