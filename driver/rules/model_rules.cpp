// SPDX-License-Identifier: Apache-2.0
// See model_rules.hpp.
#include "driver/rules/model_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "checker/cspm/syntax/build.hpp"
#include "checker/refine/verdict/verdict.hpp"
#include "claims/decide/letters.hpp"
#include "claims/sleec/analysis/explain.hpp"
#include "claims/sleec/obligations/open.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "counterexample/interpreter.hpp"
#include "csp_emit/assertion_forms.hpp"
#include "csp_emit/showing.hpp"
#include "driver/rules/endless_counterexample.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {
namespace {

/// Explains a run of the component in terms of the rule. It follows the obligation that the rule's process has
/// selected.
class BrokenRule {
public:
    BrokenRule(const RulesOf& of, const sleec::Watch& watch, const sleec::Linking& linking, std::size_t rule)
        : of_(of), watch_(watch), linking_(linking), rule_(rule) {}

    void replay_event(const std::string& event) {
        const bool second = event == "tock" || event == sleec::Watch::waiting;
        if (const auto way = sleec::Watch::way_of(event)) begin(*way);
        if (second) ++now_;
        if (!way_ || effect_ == sleec::Effect::broken) return;
        const sleec::Obligation& obligation = watch_.obligations()[watch_.ways()[*way_].obligation];
        const std::optional<std::size_t> known = second ? std::nullopt : event_of(event);
        if (second)
            effect_ = sleec::take_tock(obligation, progress_);
        else if (known)
            effect_ = sleec::take_event(obligation, progress_, *known);
        if (effect_ != sleec::Effect::broken) return;
        breaking_ = event;
        at_ = second ? now_ - 1 : now_;
    }

    /// Returns one line for each demand, with the clause of the rule that contains the demand.
    [[nodiscard]] std::vector<std::string> demand_lines() const {
        std::vector<std::string> lines;
        const sleec::Asked& way = watch_.ways()[way_.value()];
        for (const sleec::Demand& demand : watch_.obligations()[way.obligation].any)
            lines.push_back(sleec::side_text({rule_, began_, way.values, demand}, of_.rules, of_.sources));
        return lines;
    }
    /// The event that broke the rule; "" if the rule was broken by the end of a second without an event.
    [[nodiscard]] std::string breaking_event() const { return event_of(breaking_) ? breaking_ : ""; }
    [[nodiscard]] std::string break_text(const std::string& place) const {
        const auto event = event_of(breaking_);
        const std::string instant = sleec::instant_text(of_.rules, at_);
        return event ? fmt::format("{} comes at {}{}", of_.rules.event_name(*event), instant, place)
                     : fmt::format("{} ends without it", instant);
    }
    [[nodiscard]] std::int64_t current_second() const { return now_; }
    [[nodiscard]] std::optional<std::size_t> event_of(const std::string& name) const {
        for (std::size_t i = 0; i < linking_.events.size(); ++i)
            if (linking_.events[i] && std::ranges::any_of(linking_.events[i]->events, [&](const std::string& event) {
                    return name == event || name.starts_with(event + ".");
                }))
                return i;
        return std::nullopt;
    }

private:
    void begin(std::size_t way) {
        way_ = way;
        began_ = now_;
    }

    RulesOf of_;
    const sleec::Watch& watch_;
    const sleec::Linking& linking_;
    std::size_t rule_;
    std::int64_t now_ = 0, began_ = 0, at_ = 0;
    std::optional<std::size_t> way_;
    sleec::Progress progress_;
    sleec::Effect effect_ = sleec::Effect::open;
    std::string breaking_;
};

}  // namespace

/// Decides one rule for the component.
class ModelRules::Question {
public:
    Question(const ModelRules& of, std::size_t rule, sleec::Readings readings)
        : of_(of),
          emission_(of.emission_for(rule)),
          rule_(rule),
          watch_(of.of_.rules, rule, of.linking_.linking, of.process_in(emission_), readings),
          session_(of.make_session(make_script())) {}

    /// Decides whether a demand can be broken, and whether a demand without time limit can stay open forever. Returns
    /// false if a limit of the search is reached.
    bool decide_rule(JudgedRule& judged) {
        const refine::Verdict found = session_->check(*obeyed_, limits_of_check(of_.search_)).verdict;
        RuleVerdict& verdict = judged.verdict;
        verdict.states = std::max(verdict.states, found.statistics.states);
        if (found.outcome == refine::Outcome::inconclusive) {
            verdict.kind = RuleVerdict::Kind::not_decided;
            verdict.reason = found.reason;
            return false;
        }
        verdict.kind = RuleVerdict::Kind::obeyed;
        if (found.outcome == refine::Outcome::fails)
            report_broken(*found.counterexample, judged);
        else if (watch_.has_demand_without_limit())
            check_waiting(judged);
        return verdict.kind != RuleVerdict::Kind::not_decided;
    }

    /// True if the rule makes no demand in any run.
    bool makes_no_demand() {
        return session_->check(*never_asked_, limits_of_check(of_.search_)).verdict.outcome == refine::Outcome::holds;
    }
    [[nodiscard]] bool reads_measures() const { return watch_.reads_measures(); }

private:
    cspm::Script make_script() {
        cspm::Script script = emission_.script;
        for (const cspm::DeclPtr& declaration : watch_.declarations()) script.decls.push_back(declaration);
        std::vector<std::size_t> ways;
        for (std::size_t i = 0; i < watch_.ways().size(); ++i)
            if (watch_.ways()[i].obligation < watch_.obligations().size()) ways.push_back(i);
        obeyed_ = watch_.obeyed_assertion();
        never_asked_ = watch_.never_asked_assertion(ways);
        script.decls.push_back(obeyed_);
        script.decls.push_back(never_asked_);
        return script;
    }

    void report_broken(const refine::Counterexample& run, JudgedRule& judged) {
        BrokenRule reading(of_.of_, watch_, of_.linking_.linking, rule_);
        for (const refine::Step& step : run.steps) reading.replay_event(session_->event_table().name(step.revealed));
        judged.verdict.kind = RuleVerdict::Kind::broken;
        judged.verdict.lines = reading.demand_lines();
        judged.verdict.lines.push_back(reading.break_text(place_in_model(reading.breaking_event())));
        add_run(run, judged);
    }

    /// Adds the run to the verdict, as a run of the model and as lines of text.
    void add_run(const refine::Counterexample& run, JudgedRule& judged) {
        csp_emit::Obligation claim;
        claim.kind = ir::PropertyKind::conforms;
        claim.time = csp_emit::Time::timed;
        judged.run =
            runs::interpret_counterexample({emission_.provenance, of_.project_.system, of_.project_.instantiation,
                                            of_.project_.sources, *session_, of_.project_.unit},
                                           claim, run);
        // Events of the rule's own process are not steps of the model.
        const auto own = [](const runs::Step& step) { return step.event.text.starts_with("sleec_"); };
        if (std::optional<std::size_t>& loop = judged.run->loop_start) {
            const auto begin = judged.run->steps.begin();
            *loop -= static_cast<std::size_t>(std::count_if(begin, begin + static_cast<std::ptrdiff_t>(*loop), own));
        }
        std::erase_if(judged.run->steps, own);
        std::erase_if(judged.run->end.allowed,
                      [](const runs::Event& event) { return event.text.starts_with("sleec_"); });
        judged.run->end.event.reset();
        judged.run->end.why = judged.verdict.lines.back();
    }

    /// Checks demands without a time limit: searches for an infinite run that never meets the demand.
    void check_waiting(JudgedRule& judged) {
        RuleVerdict& verdict = judged.verdict;
        const refine::Limits bounds = limits_of_check(of_.search_);
        try {
            const auto system = session_->system(watch_.waiting_process(), bounds);
            const auto run = sleec::endless_run(*system, session_->event_table().intern(sleec::Watch::waiting),
                                                [&](std::size_t states) {
                                                    of_.search_.services.budget().poll();
                                                    if (states > bounds.max_states)
                                                        throw process::Interrupted("max-states");
                                                    verdict.states = std::max<std::uint64_t>(verdict.states, states);
                                                });
            if (!run) return;
            report_endless(*run, verdict);
            draw_endless(*system, *run, judged);
        } catch (const process::Interrupted& limit) {
            verdict.kind = RuleVerdict::Kind::not_decided;
            verdict.reason = limit.what();
        }
    }

    void report_endless(const sleec::EndlessRun& run, RuleVerdict& verdict) {
        BrokenRule reading(of_.of_, watch_, of_.linking_.linking, rule_);
        const auto name = [&](lts::Event event) { return session_->event_table().name(event); };
        for (const sleec::EndlessStep& step : run.steps) reading.replay_event(name(step.revealed));
        const std::int64_t from = reading.current_second();
        std::string between;
        for (const sleec::EndlessStep& step : run.loop) {
            reading.replay_event(name(step.revealed));
            if (const auto event = reading.event_of(name(step.revealed)))
                between += (between.empty() ? ", with " : ", ") + of_.of_.rules.event_name(*event);
        }
        verdict.kind = RuleVerdict::Kind::broken;
        verdict.lines = reading.demand_lines();
        const std::int64_t seconds = reading.current_second() - from;
        std::string loop;
        if (seconds != 1 || !between.empty())
            loop = fmt::format(": {} again and again{}", sleec::steps_text(of_.of_.rules, seconds), between);
        verdict.lines.push_back(fmt::format("from {} on time can pass for ever without it{}",
                                            sleec::instant_text(of_.of_.rules, from), loop));
    }

    /// Adds the infinite run to the verdict, if it can be converted to steps of the model.
    void draw_endless(lts::TransitionSystem& system, const sleec::EndlessRun& run, JudgedRule& judged) {
        if (const auto drawn = endless_counterexample(system, run, limits_of_check(of_.search_)))
            add_run(*drawn, judged);
    }

    /// Returns the place of the declaration of the event or operation: " (model.rct:12)".
    [[nodiscard]] std::string place_in_model(const std::string& event) const {
        const auto found = emission_.provenance.events.find(event);
        if (found == emission_.provenance.events.end() || !found->second.origin.span.is_known()) return "";
        return fmt::format(" ({})", of_.project_.sources.path_and_line(found->second.origin.span));
    }

    const ModelRules& of_;
    const csp_emit::Emission& emission_;
    std::size_t rule_;
    sleec::Watch watch_;
    cspm::DeclPtr obeyed_, never_asked_;
    std::unique_ptr<cspm::Session> session_;
};

ModelRules::ModelRules(RulesOf of, const Project& project, const csp_emit::Emission& emission,
                       const csp_emit::ComponentProcesses& component, const SearchContext& search)
    : of_(of),
      project_(project),
      emission_(emission),
      component_(component),
      search_(search),
      linking_(sleec::link_rules(of.rules, emission, component.path, project.system, project.instantiation)) {
    if (linking_.shown.empty()) return;
    diagnostics::SourceManager sources = project.sources;
    diagnostics::Diagnostics findings;  // findings about the model are reported with the other script
    findings.set_budget(&search.services.budget());
    const csp_emit::Shown shown = claims::emitted_facts(linking_.shown, project.system, project.instantiation);
    showing_ = std::make_unique<csp_emit::Emission>(
        csp_emit::emit_showing(project.system, project.instantiation, shown, sources, findings));
}

ModelRules::~ModelRules() = default;

const csp_emit::Emission& ModelRules::emission_for(std::size_t rule) const {
    return sleec::reads_states(of_.rules, rule) ? *showing_ : emission_;
}

cspm::ExprPtr ModelRules::process_in(const csp_emit::Emission& emission) const {
    const auto found = std::ranges::find(emission.components, component_.path, &csp_emit::ComponentProcesses::path);
    if (found == emission.components.end())
        throw sleec::NotDecided("the semantics with states does not have the component");
    return found->process;
}

std::unique_ptr<cspm::Session> ModelRules::make_session(cspm::Script script) const {
    auto session = std::make_unique<cspm::Session>(std::move(script), &search_.services.budget());
    if (diagnostics::Cache* const cache = search_.services.cache()) session->set_cache(*cache);
    return session;
}

JudgedRule ModelRules::judge_rule(std::size_t rule) const {
    const diagnostics::Budget::Phase phase(
        search_.services.budget(), fmt::format("asking whether {} obeys {}", component_.path, of_.rules.name(rule)));
    JudgedRule judged;
    judged.verdict.component = component_.path;
    judged.verdict.rule = rule;
    judged.verdict.reason = sleec::not_applicable(of_.rules, rule, linking_);
    if (!judged.verdict.reason.empty()) {
        judged.verdict.kind = RuleVerdict::Kind::not_applicable;
        return judged;
    }
    try {
        follow_rule(judged);
        if (judged.verdict.kind == RuleVerdict::Kind::broken && !linking_.exact &&
            sleec::reads_states(of_.rules, rule)) {
            judged = {};
            judged.verdict.component = component_.path;
            judged.verdict.rule = rule;
            judged.verdict.reason =
                "a run was found, but another machine may have acted in it before the state was seen; the rule about "
                "the machine alone is decided";
        }
    } catch (const sleec::NotDecided& error) {
        judged.verdict.reason = error.what();
    } catch (const cspm::EvaluationError& error) {
        judged.verdict.kind = RuleVerdict::Kind::error;
        judged.verdict.reason = runs::placed_failure(error, project_.system, project_.sources);
    }
    return judged;
}

void ModelRules::follow_rule(JudgedRule& judged) const {
    Question question(*this, judged.verdict.rule, sleec::Readings::one_value);
    if (!question.decide_rule(judged) || judged.verdict.kind != RuleVerdict::Kind::obeyed) return;
    if (question.makes_no_demand()) {
        judged.verdict.kind = RuleVerdict::Kind::never_asked;
        return;
    }
    if (!question.reads_measures()) return;
    JudgedRule changing;
    Question other(*this, judged.verdict.rule, sleec::Readings::any);
    if (other.decide_rule(changing) && changing.verdict.kind == RuleVerdict::Kind::broken)
        judged.verdict.reason = "as long as no measure changes within a second";
}

TimeStops ModelRules::time_stops() const {
    namespace build = cspm::build;
    cspm::Script script = emission_.script;
    const cspm::DeclPtr assertion = csp_emit::timelock_free(
        build::hide(csp_emit::running_on(component_.process, "tock"),
                    build::productions(csp_emit::outputs_of(emission_.provenance, component_.path))));
    script.decls.push_back(assertion);
    try {
        const refine::Verdict verdict =
            make_session(std::move(script))->check(*assertion, limits_of_check(search_)).verdict;
        return {verdict.outcome == refine::Outcome::fails,
                verdict.outcome == refine::Outcome::inconclusive ? verdict.reason : "", false};
    } catch (const cspm::EvaluationError& error) {
        return {false, runs::placed_failure(error, project_.system, project_.sources), true};
    }
}

}  // namespace robochart::driver
