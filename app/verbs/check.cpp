// SPDX-License-Identifier: Apache-2.0
// The verb `check`: decides assertions.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <algorithm>

#include <chrono>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "app/claims/turns.hpp"
#include "app/command/limits.hpp"
#include "app/command/run.hpp"
#include "app/report/bounds.hpp"
#include "app/report/causes.hpp"
#include "app/report/second_look.hpp"
#include "app/report/sizes.hpp"
#include "app/report/taken_guards.hpp"
#include "app/rules/rule_claims.hpp"
#include "app/verbs/verbs.hpp"
#include "base/diagnostics/escape.hpp"
#include "checker/cspm/session.hpp"
#include "checker/refine/verdict/recurrence.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "counterexample/exercised.hpp"
#include "counterexample/interpreter.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::app {
namespace {

using csp_emit::Time;

struct Context {
    Project& project;
    const Options& options;
    const csp_emit::Emission& emission;
    cspm::Session& session;
    const TakenGuards& guards;
};

/// The data for reading counterexamples and steps.
runs::Context reading_context(const Context& context) {
    return {context.emission.provenance, context.project.system, context.project.instantiation, context.project.sources,
            context.session};
}

void add(refine::Statistics& sum, const refine::Statistics& one) {
    sum.states += one.states;
    sum.transitions += one.transitions;
    sum.depth = std::max(sum.depth, one.depth);
    sum.spec_nodes += one.spec_nodes;
    sum.seconds += one.seconds;
    sum.chased += one.chased;
    sum.replicas = std::max(sum.replicas, one.replicas);
    sum.distinguished = std::max(sum.distinguished, one.distinguished);
}

void add_verdict(const Context& context, const csp_emit::Obligation& obligation, const refine::Verdict& verdict,
                 AssertionReport& report) {
    add(report.statistics, verdict.statistics);
    report.searched = report.searched || !verdict.known;
    if (verdict.outcome == refine::Outcome::inconclusive) {
        report.answer = Answer::inconclusive;
        report.reason = verdict.reason;
    } else if (verdict.outcome == refine::Outcome::fails) {
        report.answer = Answer::fails;
        if (!verdict.counterexample) return;
        report.run = runs::interpret_counterexample(reading_context(context), obligation, *verdict.counterexample);
        if (!verdict.counterexample->shortest) report.reason = not_shortest;
    }
}

/// The basis of the answer to an assertion. If there is a run, it is that of its steps, even if the run shows that the
/// assertion holds.
Basis basis_of(const Context& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
               const refine::Verdict& verdict, const AssertionReport& report) {
    Basis basis;
    const bool holds = verdict.outcome == refine::Outcome::holds;
    if (verdict.outcome == refine::Outcome::inconclusive || obligation.information) return basis;
    if (!verdict.counterexample)
        context.guards.add_of_assertion(assertion, holds, basis);
    else if (report.run && !holds)
        context.guards.add_of_run(*report.run, basis);
    else if (context.guards.has_guards())
        context.guards.add_of_run(
            runs::interpret_counterexample(reading_context(context), obligation, *verdict.counterexample), basis);
    return basis;
}

/// The evaluation error with its place and its element of the model.
std::string failure_text(const Project& project, const cspm::EvaluationError& error) {
    return runs::placed_failure(error, project.system, project.sources) + cause_of(project, error);
}

/// Decides one assertion of an obligation: the answer, the counterexample if it fails, and the basis.
void decide_one(const Context& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
                AssertionReport& report) {
    report.answer = Answer::holds;
    try {
        const auto verdict =
            context.session.check(assertion, limits_of_check(context.options, obligation.title)).verdict;
        add_verdict(context, obligation, verdict, report);
        report.basis = basis_of(context, obligation, assertion, verdict, report);
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = failure_text(context.project, error);
    } catch (const std::bad_alloc&) {
        report.answer = Answer::inconclusive;
        report.reason = "out of memory";
    }
}

/// Throws LimitReached if the run or the claim's turn is over.
void poll_turn(const Options& turn) {
    turn.run->budget().poll();
    if (turn.turn_ends && std::chrono::steady_clock::now() >= *turn.turn_ends)
        throw diagnostics::LimitReached("the time limit was reached");
}

/// Limited, because a state of a term takes much longer than one of a compiled machine.
constexpr std::uint64_t most_states_for_firing = 20'000;

using Transitions = std::vector<csp_emit::TransitionInside>;

/// The transitions that are not among the elements.
Transitions missing_transitions(const csp_emit::FiringQuestion& question, const std::set<std::string>& elements) {
    Transitions result;
    for (const csp_emit::TransitionInside& each : question.transitions)
        if (!elements.contains(runs::element_in(each.component, each.origin.element))) result.push_back(each);
    return result;
}

/// "t1: S1 -> S2 (model.rct:12), ..."
std::string transition_list(const Project& project, const Transitions& transitions) {
    std::vector<std::string> texts;
    for (const csp_emit::TransitionInside& each : transitions)
        texts.push_back(fmt::format("{} ({})", each.text, project.sources.path_and_line(each.origin.span)));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// The transitions that fire in no instance of their machine.
std::vector<std::string> unexercised_transitions(const csp_emit::FiringQuestion& question, const Transitions& never) {
    std::map<std::string, std::size_t> instances;
    for (const csp_emit::TransitionInside& each : question.transitions) ++instances[each.origin.element];
    for (const csp_emit::TransitionInside& each : never) --instances[each.origin.element];
    std::vector<std::string> result;
    for (const auto& [element, firing] : instances)
        if (firing == 0) result.push_back(element);
    return result;
}

/// A step may not distinguish several transitions of one state with the same trigger and target. If one of them fires,
/// the others may still never fire.
void answer_firing(const Project& project, const csp_emit::FiringQuestion& question, const runs::Exercised& found,
                   AssertionReport& report) {
    const Transitions never = missing_transitions(question, found.possible);
    const Transitions open = missing_transitions(question, found.certain);
    report.answer = Answer::inconclusive;
    if (!never.empty() && found.all) {
        report.answer = Answer::fails;
        report.reason = "never taken: " + transition_list(project, never);
        report.core->unexercised = unexercised_transitions(question, never);
    } else if (!never.empty()) {
        report.reason = fmt::format("{} has not been taken in the first {} states",
                                    transition_list(project, {never.front()}), found.states);
    } else if (!open.empty()) {
        report.reason = "the steps do not tell which of these are taken: " + transition_list(project, open);
    } else {
        report.answer = Answer::holds;
    }
}

/// Decides which transitions fire, by exploring all states.
void decide_firing(const Context& context, const csp_emit::FiringQuestion& question, AssertionReport& report) {
    const runs::Context read_with = reading_context(context);
    runs::StepReader reader(read_with);
    try {
        const auto found = runs::find_exercised(reader, context.session.process(question.process),
                                                most_states_for_firing, [&] { poll_turn(context.options); });
        report.statistics.states = found.states;
        report.searched = true;
        answer_firing(context.project, question, found, report);
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = failure_text(context.project, error);
    }
}

/// Printed if the claim holds: without probabilities it states only a possibility.
const char* const fair_draws =
    "it happens again and again with probability 1 only if every choice between steps is a draw, each with a chance "
    "above 0";

/// Decides whether something can always happen again, by a backward search through all states.
void decide_recurrence(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
    const refine::Limits bounds = limits_of_check(context.options, obligation.title);
    report.answer = Answer::holds;
    try {
        const process::EventSet goal = context.session.events(obligation.recurrence->goal);
        const auto system = context.session.system(obligation.recurrence->process, bounds);
        add_verdict(context, obligation, refine::recurrent(*system, goal, bounds), report);
        const bool claimed = obligation.kind != ir::PropertyKind::deadlock_free;
        if (report.answer == Answer::holds && claimed) report.reason = fair_draws;
    } catch (const process::Interrupted& limit) {
        report.answer = Answer::inconclusive;
        report.reason = limit.what();
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = failure_text(context.project, error);
    }
}

/// If all assertions must hold, the first that fails ends the check. If one suffices, the first that holds decides, and
/// the claim fails only if all of them fail. If none holds and one of them is unknown, the claim is inconclusive.
void decide_claim(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
    std::optional<std::string> unknown;  // why the first inconclusive one is inconclusive
    Basis before;                        // basis of assertions that do not decide the claim alone
    for (const cspm::DeclPtr& assertion : obligation.assertions) {
        for (Ground& ground : std::exchange(report.basis, {})) add(before, std::move(ground));
        decide_one(context, obligation, *assertion, report);
        if (report.answer == Answer::inconclusive && !unknown) unknown = report.reason;
        if (report.answer == Answer::error || (report.answer == Answer::holds) == obligation.one_suffices) break;
        if (&assertion != &obligation.assertions.back()) continue;
        for (Ground& ground : before) add(report.basis, std::move(ground));
    }
    if (report.answer == Answer::holds) {
        report.reason.clear();
        report.run.reset();
    } else if (unknown) {
        report.answer = Answer::inconclusive;
        report.reason = *unknown;
        report.run.reset();
        report.basis.clear();
    }
    if (report.answer == Answer::fails && !report.run) report.reason = obligation.reason;
}

/// The premises of claims; each is decided once.
class Premises {
public:
    /// A claim that holds becomes inconclusive if its premise does not hold, and the run that refutes the premise is
    /// shown.
    void apply_premise(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
        if (obligation.premise == nullptr || report.answer != Answer::holds) return;
        const AssertionReport premise = answer_premise(context, obligation);
        if (premise.answer == Answer::holds) return;
        const csp_emit::Premise& asked = *obligation.premise;
        report.answer = premise.answer == Answer::error ? Answer::error : Answer::inconclusive;
        report.reason = premise.answer == Answer::fails
                            ? "not decided: " + asked.otherwise
                            : fmt::format("not decided whether {}: {}", asked.text, premise.reason);
        report.run = premise.run;
    }

private:
    AssertionReport answer_premise(const Context& context, const csp_emit::Obligation& claim) {
        for (const auto& [premise, report] : decided_)
            if (premise == claim.premise) return report;
        AssertionReport report = decide_premise(context, claim);
        if (report.answer != Answer::inconclusive) decided_.emplace_back(claim.premise, report);
        return report;
    }
    static AssertionReport decide_premise(const Context& context, const csp_emit::Obligation& claim) {
        csp_emit::Obligation asked;
        asked.kind = ir::PropertyKind::timelock_free;
        asked.title = fmt::format("{}: {}", claim.title, claim.premise->text);
        asked.origin = claim.origin;
        asked.time = claim.time;
        asked.reason = claim.premise->reason;
        asked.assertions = claim.premise->assertions;
        AssertionReport report;
        report.answer = Answer::holds;
        decide_claim(context, asked, report);
        if (report.answer != Answer::holds) return report;
        asked.kind = ir::PropertyKind::refines;
        asked.recurrence = claim.premise->recurrence;
        decide_recurrence(context, asked, report);
        return report;
    }

    std::vector<std::pair<std::shared_ptr<const csp_emit::Premise>, AssertionReport>> decided_;
};

bool is_wanted(const Context& context, const csp_emit::Obligation& obligation) {
    if (!obligation.name.empty()) return is_claim_selected(context.options, obligation.name);
    const bool core = obligation.property == ir::no_id;
    const bool asked = context.options.core && !obligation.component.empty();
    return core ? context.options.claims.empty() || asked
                : is_claim_selected(context.options, context.project.system.properties[obligation.property].name);
}

/// The transitions or states of which the obligation finds out whether runs exercise them.
std::vector<std::string> elements_of(const csp_emit::Obligation& obligation) {
    std::vector<std::string> result;
    if (obligation.firing)
        for (const csp_emit::TransitionInside& each : obligation.firing->transitions)
            result.push_back(each.origin.element);
    else if (obligation.kind == ir::PropertyKind::reachable)
        result.push_back(obligation.origin.element);
    return result;
}

/// The declaration of the component of a core property: "state machine P::S".
diagnostics::Span declaration_span(const ir::System& system, const std::string& component) {
    const std::string name = component.substr(component.rfind(' ') + 1);
    const auto is_it = [&](const std::string& package, const std::string& path) {
        return name == (package.empty() ? path : package + "::" + path);
    };
    for (const ir::Module& each : system.modules)
        if (is_it(each.package, each.name)) return each.origin.span;
    for (const ir::Controller& each : system.controllers)
        if (is_it(each.package, each.path)) return each.origin.span;
    for (const ir::Machine& each : system.machines)
        if (is_it(each.package, each.path)) return each.origin.span;
    return {};
}

/// Lists all claims as undecided in the report, before any is decided.
void announce_claims(const Context& context, Report& report) {
    const auto edit = context.options.run->lock_for_edit();
    for (const csp_emit::Obligation& obligation : context.emission.obligations) {
        if (!is_wanted(context, obligation)) continue;
        AssertionReport one;
        one.title = context.project.label + obligation.title;
        if (obligation.property != ir::no_id)
            set_place(context.project, context.project.system.properties[obligation.property].origin.span, one);
        if (!obligation.component.empty()) {
            one.core = CoreReport{context.project.label + obligation.component, obligation.property_text,
                                  obligation.information, elements_of(obligation)};
        }
        if (obligation.origin.span.is_known()) set_place(context.project, obligation.origin.span, one);
        if (one.core && !one.region)
            one.region = region_of(context.project, declaration_span(context.project.system, obligation.component));
        const bool of_rule = obligation.kind == ir::PropertyKind::conforms;
        const bool decidable = obligation.firing || obligation.recurrence || of_rule || !obligation.assertions.empty();
        one.answer = decidable ? Answer::inconclusive : Answer::no_check;
        one.reason = decidable ? undecided_at_limit : obligation.reason;
        report.assertions.push_back(std::move(one));
    }
}

/// If a script uses an undefined name, the input is wrong; this is reported once for all claims of the script.
std::unique_ptr<cspm::Session> start_session(const Project& project, const csp_emit::Emission& emission, Time time,
                                             const Options& options, Report& report) {
    try {
        auto session = std::make_unique<cspm::Session>(emission.script, &options.run->budget());
        if (diagnostics::Cache* const cache = options.run->cache()) session->set_cache(*cache);
        return session;
    } catch (const cspm::EvaluationError& error) {
        AssertionReport one;
        one.title = fmt::format("{}the {} script", project.label, time == Time::timed ? "timed" : "untimed");
        one.answer = Answer::error;
        one.reason = failure_text(project, error);
        const auto edit = options.run->lock_for_edit();
        report.assertions.push_back(std::move(one));
        return nullptr;
    }
}

/// An answer from the cache contains no information about bounds.
void add_bounds(ReachedBounds& reached, const BoundWatch& bounds, const csp_emit::Obligation& claim,
                AssertionReport& report) {
    const bool answered = report.answer == Answer::holds || report.answer == Answer::fails;
    if (!answered || (bounds.met_bounds().empty() && report.searched)) return;
    for (Ground& ground : reached.basis_of_claim(claim, bounds.met_bounds())) add(report.basis, std::move(ground));
}

/// Adds these bounds to those of other claims and of the other semantics.
void add_bounds(const Basis& basis, Time time, std::vector<BoundReport>& bounds) {
    const std::string name = time == Time::timed ? "timed" : "untimed";
    for (const Ground& ground : basis) {
        if (ground.kind != GroundKind::bound) continue;
        const auto same = std::ranges::find_if(bounds, [&](const BoundReport& other) {
            return other.place == ground.place && other.element == ground.element && other.text == ground.text;
        });
        if (same == bounds.end())
            bounds.push_back({ground.element, ground.place, ground.text, name});
        else if (same->time != name)
            same->time = "untimed, timed";
    }
}

/// The claims in one semantics.
class TimeClaims {
public:
    /// Lists the claims in the report.
    TimeClaims(Project& project, const Options& options, Time time, Report& report)
        : project_(project),
          options_(options),
          time_(time),
          emission_(emit_csp(project, options, time)),
          report_(report),
          watch_(project, emission_),
          reached_(project, emission_, options),
          guards_(project, emission_, time),
          rules_(project, emission_, options) {
        if (!project.diagnostics.ok() || (emission_.obligations.empty() && !options.sizes)) return;
        if (!open_session()) return;
        first_ = report.assertions.size();
        announce_claims({project, options, emission_, *session_, guards_}, report);
        announced_.assign(report.assertions.begin() + static_cast<std::ptrdiff_t>(first_), report.assertions.end());
    }

    void add_to(std::vector<WaitingClaim>& claims) {
        if (!session_) return;
        const Context context{project_, options_, emission_, *session_, guards_};
        std::size_t number = 0;
        for (const csp_emit::Obligation& obligation : emission_.obligations)
            if (is_wanted(context, obligation))
                claims.push_back({obligation.title, [this, &obligation, at = number++](const Options& turn) {
                                      return decide_in(turn, obligation, at);
                                  }});
    }

    /// Frees what claims share. The next one opens the script again.
    void give_back() {
        second_look_.reset();
        given_back_ = session_ != nullptr || given_back_;
        session_.reset();
    }

    void measure_if_asked() {
        if (options_.sizes && given_back_ && !session_) (void)open_session();
        if (session_ && options_.sizes) measure_sizes(project_, *session_, emission_, time_, options_, report_);
    }

private:
    bool open_session() {
        session_ = start_session(project_, emission_, time_, options_, report_);
        if (!session_) return false;
        session_->set_observer(watch_.observer());
        second_look_.emplace(project_, emission_, *session_, options_);
        return true;
    }

    bool decide_in(const Options& given, const csp_emit::Obligation& obligation, std::size_t at) {
        Options turn = given;
        turn.on_progress = [&](const refine::Progress& progress) { note_progress(progress, at); };
        AssertionReport one = announced_[at];
        try {
            if (!session_ && !open_session()) return true;  // said in the report
            decide_whole({project_, turn, emission_, *session_, guards_}, obligation, one);
        } catch (const diagnostics::LimitReached& limit) {
            if (run_is_over(options_.run->budget())) throw;
            one = announced_[at];
            one.reason = limit.what();
        }
        const bool decided = one.answer != Answer::inconclusive;
        if (!decided) one.reason = ended_turn(one.reason, turn);
        const auto edit = options_.run->lock_for_edit();
        add_bounds(one.basis, time_, report_.bounds);
        report_.assertions[first_ + at] = std::move(one);
        return decided;
    }

    void decide_whole(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& one) {
        if (obligation.firing) {
            one.reason.clear();
            decide_firing(context, *obligation.firing, one);
        } else if (obligation.kind == ir::PropertyKind::conforms) {
            one.reason.clear();
            rules_.decide_property(project_.system.properties[obligation.property], context.options, one);
        } else if (!obligation.assertions.empty()) {
            one.reason.clear();
            decide_claim(context, obligation, one);
            if (one.core && one.answer == Answer::fails) one.core->unexercised = one.core->elements;
        }
        if (obligation.recurrence && (obligation.assertions.empty() || one.answer == Answer::holds)) {
            one.reason.clear();
            decide_recurrence(context, obligation, one);
        }
        premises_.apply_premise(context, obligation, one);
        second_look_->add_to(obligation, one);
        add_bounds(reached_, watch_, obligation, one);
    }

    /// Stores the current knowledge about a claim, in case the run ends now.
    void note_progress(const refine::Progress& progress, std::size_t at) {
        const auto edit = options_.run->lock_for_edit();
        AssertionReport& known = report_.assertions[first_ + at];
        if (progress.phase != refine::Progress::Phase::searching || progress.states < known.statistics.states) return;
        known.searched = true;
        known.statistics.states = progress.states;
        known.statistics.transitions = progress.transitions;
        known.statistics.depth = progress.depth;
        known.statistics.seconds = progress.seconds;
    }

    Project& project_;
    const Options& options_;
    Time time_;
    const csp_emit::Emission& emission_;
    Report& report_;
    BoundWatch watch_;
    ReachedBounds reached_;
    TakenGuards guards_;
    RuleClaims rules_;
    Premises premises_;
    std::unique_ptr<cspm::Session> session_;
    bool given_back_ = false;
    std::optional<SecondLook> second_look_;
    std::size_t first_ = 0;                   ///< index of the first claim in the report
    std::vector<AssertionReport> announced_;  ///< the claims before anything was known about them
};

/// Lists the claims for other tools; none of them counts as a success.
void report_unchecked(const Project& project, const Options& options, Report& report) {
    const auto unchecked = [&](const std::string& name, diagnostics::Span span, const std::string& why) {
        if (!is_claim_selected(options, name)) return;
        AssertionReport one;
        one.title = project.label + name;
        set_place(project, span, one);
        one.answer = Answer::unchecked;
        one.reason = fmt::format("{}: not checked: {}", diagnostics::escape_for_display(one.place), why);
        const auto edit = options.run->lock_for_edit();
        report.assertions.push_back(std::move(one));
    };
    for (const auto& file : project.model->files) {
        for (const frontend::KeptPart& part : file->kept)
            if (part.claims) unchecked(part.name, part.span, fmt::format("`{}` is of another tool", part.form));
    }
}

}  // namespace

void set_place(const Project& project, diagnostics::Span span, AssertionReport& report) {
    report.place = project.sources.path_and_line(span);
    report.region = region_of(project, span);
}

std::optional<runs::Place> region_of(const Project& project, diagnostics::Span span) {
    if (!span.is_known()) return std::nullopt;
    const diagnostics::Position begin = project.sources.position(span.source, span.begin);
    const diagnostics::Position end = project.sources.position(span.source, span.end);
    return runs::Place{project.sources.path(span.source), begin.line, begin.column, end.line, end.column};
}

void check_assertions(Project& project, const Options& options, Report& report) {
    std::vector<WaitingClaim> claims;
    std::unique_ptr<ProbabilityClaims> probabilities;
    if (options.swarm.empty()) {
        probabilities = std::make_unique<ProbabilityClaims>(project, options, report);
        report_unchecked(project, options, report);
    }
    std::vector<std::unique_ptr<TimeClaims>> times;
    for (const Time time : {Time::untimed, Time::timed}) {
        const bool left_out = options.times == (time == Time::timed ? Times::untimed : Times::timed);
        if (left_out || !project.diagnostics.ok()) continue;
        times.push_back(std::make_unique<TimeClaims>(project, options, time, report));
        times.back()->add_to(claims);
    }
    if (probabilities) probabilities->add_to(claims);
    if (!project.diagnostics.ok()) return;
    decide_in_turns(claims, options, [&] {
        for (const auto& time : times) time->give_back();
        if (probabilities) probabilities->give_back();
    });
    for (const auto& time : times) time->measure_if_asked();
}

}  // namespace robochart::app
