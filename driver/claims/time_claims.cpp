// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/time_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <new>
#include <set>

#include "checker/refine/verdict/recurrence.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "counterexample/exercised.hpp"
#include "counterexample/failing_run.hpp"
#include "counterexample/interpreter.hpp"
#include "counterexample/text.hpp"
#include "driver/claims/causes.hpp"
#include "driver/claims/certificates.hpp"
#include "driver/claims/claim_answers.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/component_processes.hpp"
#include "driver/claims/related_values.hpp"
#include "driver/claims/sizes.hpp"
#include "driver/model/claim_scripts.hpp"
#include "driver/model/project_claims.hpp"

namespace robochart::driver {
namespace {

using csp_emit::Time;

/// Returns the context for converting counterexamples and steps to runs of the model.
runs::Context reading_context(const ClaimContext& context) {
    return {context.emission.provenance, context.project.system, context.project.instantiation,
            context.project.sources,     context.session,        context.project.unit};
}

void add(refine::Statistics& sum, const refine::Statistics& one) {
    if (sum.states == 0) sum.decided_by = one.decided_by;
    sum.states += one.states;
    sum.transitions += one.transitions;
    sum.depth = std::max(sum.depth, one.depth);
    sum.spec_nodes += one.spec_nodes;
    sum.seconds += one.seconds;
    sum.chased += one.chased;
    sum.replicas = std::max(sum.replicas, one.replicas);
    sum.distinguished = std::max(sum.distinguished, one.distinguished);
}

void add_verdict(const ClaimContext& context, const csp_emit::Obligation& obligation, const refine::Verdict& verdict,
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
        show_related_values(*report.run, context.project.related);
        if (!verdict.counterexample->shortest) report.reason = not_shortest;
    }
}

/// Returns the basis of the answer to an assertion. If the answer has a run, the basis consists of the entries for the
/// steps of this run, even if the run shows that the assertion holds.
Basis basis_of(const ClaimContext& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
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

/// Returns the evaluation error with its place and its element of the model.
std::string failure_text(const Project& project, const cspm::EvaluationError& error) {
    return runs::placed_failure(error, project.system, project.sources) + cause_of(project, error);
}

/// Sets the answer of a claim that cannot be evaluated. A value outside its carrier is not a fault of the model.
void set_failure(const Project& project, const cspm::EvaluationError& error, AssertionReport& report) {
    report.answer = Answer::error;
    report.reason = failure_text(project, error);
    if (!runs::leaves_carriers(error.what()) || is_about_large_set(error.what())) return;
    report.answer = Answer::inconclusive;
}

/// The budget of the run, which also ends with the claim's turn.
class TurnBudget final : public diagnostics::Pollable {
public:
    explicit TurnBudget(const SearchContext& search) : search_(search) {}
    void poll() override {
        search_.services.budget().poll();
        if (search_.turn.is_over()) throw diagnostics::LimitReached("the time limit was reached");
    }

private:
    const SearchContext& search_;
};

/// The number of states is limited, because the evaluation of a term takes much longer than a step of a compiled
/// machine.
constexpr std::uint64_t most_states_for_failure = 20'000;

/// Returns the assertion with the processes of components that are not compressed.
cspm::Decl plain_assertion(const cspm::Decl& assertion) {
    cspm::Decl result = assertion;
    for (cspm::ExprPtr* side : {&result.assertion.specification, &result.assertion.implementation})
        *side = without_compression(*side);
    return result;
}

/// Adds a run after which an expression has no value. It uses `VS__`, which compresses nothing: `D__` of a large
/// component compresses parts of the component, and these fail before the first step.
void add_failing_run(const ClaimContext& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
                     AssertionReport& report) {
    const bool refinement = assertion.assertion.kind == cspm::AssertionKind::refinement;
    const cspm::ExprPtr& side = refinement ? assertion.assertion.implementation : assertion.assertion.specification;
    const bool of_block = obligation.property == ir::no_id && obligation.component.empty();
    TurnBudget budget(context.search);
    const auto find = [&](const std::string& variant) {
        return runs::find_failing_run(reading_context(context), obligation.time,
                                      context.session.process(with_variant(side, variant)), most_states_for_failure,
                                      budget);
    };
    auto found = find("D__");
    if (found && found->run.steps.empty()) found = of_block ? std::nullopt : find("VS__");
    if (!found) return;
    report.reason = std::move(found->failure);
    report.run = std::move(found->run);
}

/// Decides the assertion without compiling components. Returns false if the search reaches a state that cannot be
/// evaluated, or a limit.
bool decide_with_terms(const ClaimContext& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
                       AssertionReport& report) {
    constexpr std::uint64_t most_states = 100'000;
    constexpr std::chrono::seconds longest{10};
    refine::Limits limits = limits_of_check(context.search, obligation.title);
    limits.max_states = std::min(limits.max_states, most_states);
    const auto end = std::chrono::steady_clock::now() + longest;
    limits.deadline = limits.deadline ? std::min(*limits.deadline, end) : end;
    try {
        const auto verdict = context.session.check_with_terms(assertion, limits).verdict;
        if (verdict.outcome == refine::Outcome::inconclusive) return false;
        report.answer = Answer::holds;
        report.reason.clear();
        add_verdict(context, obligation, verdict, report);
        report.basis = basis_of(context, obligation, assertion, verdict, report);
        return true;
    } catch (const cspm::EvaluationError&) {
        return false;
    }
}

/// Handles a compilation that failed because a state of some component cannot be evaluated. Decides the assertion if
/// the runs of the whole process do not reach such a state before a violation. Otherwise, if an expression of the model
/// has no value, searches for a run that reaches this expression.
void look_at_failure(const ClaimContext& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
                     AssertionReport& report) {
    if (decide_with_terms(context, obligation, plain_assertion(assertion), report)) return;
    if (report.answer != Answer::error) return;
    try {
        add_failing_run(context, obligation, assertion, report);
    } catch (const cspm::EvaluationError&) {
    } catch (const process::SemanticsError&) {
    } catch (const diagnostics::LimitReached&) {  // the error is reported without a run
    }
}

/// Decides one assertion of an obligation: the answer, the counterexample if it fails, and the basis.
void decide_one(const ClaimContext& context, const csp_emit::Obligation& obligation, const cspm::Decl& assertion,
                AssertionReport& report) {
    report.answer = Answer::holds;
    try {
        const auto verdict =
            context.session.check(assertion, limits_of_check(context.search, obligation.title)).verdict;
        add_verdict(context, obligation, verdict, report);
        report.basis = basis_of(context, obligation, assertion, verdict, report);
    } catch (const cspm::EvaluationError& error) {
        set_failure(context.project, error, report);
        if (!is_about_large_set(error.what())) look_at_failure(context, obligation, assertion, report);
    } catch (const std::bad_alloc&) {
        report.answer = Answer::inconclusive;
        report.reason = "out of memory";
    }
}

/// The number of states is limited, because the evaluation of a term takes much longer than a step of a compiled
/// machine.
constexpr std::uint64_t most_states_for_firing = 20'000;

using Transitions = std::vector<csp_emit::TransitionInside>;

/// Returns the transitions of the question whose names are not in `elements`.
Transitions missing_transitions(const csp_emit::FiringQuestion& question, const std::set<std::string>& elements) {
    Transitions result;
    for (const csp_emit::TransitionInside& transition : question.transitions)
        if (!elements.contains(runs::element_in(transition.component, transition.origin.element)))
            result.push_back(transition);
    return result;
}

/// Returns a list such as "t1: S1 -> S2 (model.rct:12), ...".
std::string transition_list(const Project& project, const Transitions& transitions) {
    std::vector<std::string> texts;
    for (const csp_emit::TransitionInside& transition : transitions)
        texts.push_back(fmt::format("{} ({})", transition.text, project.sources.path_and_line(transition.origin.span)));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// Returns the transitions that never fire in any instance of their machine.
std::vector<std::string> unexercised_transitions(const csp_emit::FiringQuestion& question, const Transitions& never) {
    std::map<std::string, std::size_t> instances;
    for (const csp_emit::TransitionInside& transition : question.transitions) ++instances[transition.origin.element];
    for (const csp_emit::TransitionInside& transition : never) --instances[transition.origin.element];
    std::vector<std::string> result;
    for (const auto& [element, firing] : instances)
        if (firing == 0) result.push_back(element);
    return result;
}

/// Writes the answer to the question which transitions fire. If several transitions of one state have the same trigger
/// and target, a step may not show which of them fired. So some of them may never fire although one does.
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
void decide_firing(const ClaimContext& context, const csp_emit::FiringQuestion& question, AssertionReport& report) {
    const runs::Context read_with = reading_context(context);
    runs::StepReader reader(read_with);
    TurnBudget budget(context.search);
    try {
        const auto found =
            runs::find_exercised(reader, context.session.process(question.process), most_states_for_firing, budget);
        report.statistics.states = found.states;
        report.searched = true;
        answer_firing(context.project, question, found, report);
    } catch (const cspm::EvaluationError& error) {
        set_failure(context.project, error, report);
    }
}

/// Printed if a recurrence claim holds. Without probabilities, the claim only states a possibility.
const char* const fair_draws =
    "it happens again and again with probability 1 only if every choice between steps is a draw, each with a chance "
    "above 0";

/// Decides whether the goal remains reachable from every reachable state, by a backward search through all states.
void decide_recurrence(const ClaimContext& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
    const refine::Limits bounds = limits_of_check(context.search, obligation.title);
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
        set_failure(context.project, error, report);
    }
}

/// A RoboSim component that is deadlock-free may still stop time. If it does, adds the inputs after which time stops to
/// the report.
void note_time_stop(const ClaimContext& context, const csp_emit::Obligation& claim, AssertionReport& report) {
    csp_emit::Obligation obligation;
    obligation.kind = ir::PropertyKind::refines;
    obligation.title = claim.title + ": time goes on";
    obligation.property = claim.property;
    obligation.time = claim.time;
    obligation.recurrence = claim.time_goes_on;
    AssertionReport found;
    decide_recurrence(context, obligation, found);
    if (found.answer == Answer::inconclusive) report.reason = "whether it can stop time is not known: " + found.reason;
    if (found.answer != Answer::fails) return;
    const std::string cycles = found.run ? runs::short_text_of(*found.run) : "";
    report.reason = "it can stop time, which is no deadlock in this sense: " +
                    (cycles.empty() ? "no cycle ever ends" : "after " + cycles + ", no cycle ends any more");
}

/// Decides a claim that consists of several assertions. If all of them must hold, the first that fails ends the check.
/// If one assertion suffices, the first that holds ends the check, and the claim fails only if all fail. If none holds
/// and one is inconclusive, the claim is inconclusive. Returns the assertions on which a positive answer is based.
std::vector<cspm::DeclPtr> decide_claim(const ClaimContext& context, const csp_emit::Obligation& obligation,
                                        AssertionReport& report) {
    std::optional<std::string> unknown;  // the reason of the first inconclusive assertion
    Basis before;                        // basis of the assertions that do not decide the claim on their own
    std::vector<cspm::DeclPtr> all;
    for (const cspm::DeclPtr& assertion : obligation.assertions) {
        all.push_back(assertion);
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
    return obligation.one_suffices && !all.empty() ? std::vector{all.back()} : all;
}

AssertionReport decide_premise(const ClaimContext& context, const csp_emit::Obligation& claim) {
    csp_emit::Obligation obligation;
    obligation.kind = ir::PropertyKind::timelock_free;
    obligation.title = fmt::format("{}: {}", claim.title, claim.premise->text);
    obligation.origin = claim.origin;
    obligation.time = claim.time;
    obligation.reason = claim.premise->reason;
    obligation.assertions = claim.premise->assertions;
    AssertionReport report;
    report.answer = Answer::holds;
    (void)decide_claim(context, obligation, report);
    if (report.answer != Answer::holds || !claim.premise->recurrence.process) return report;
    obligation.kind = ir::PropertyKind::refines;
    obligation.recurrence = claim.premise->recurrence;
    decide_recurrence(context, obligation, report);
    return report;
}

/// Returns the name of the claim for --assertion; "" if it has none.
std::string name_of(const ir::System& system, const csp_emit::Obligation& obligation) {
    if (!obligation.component.empty()) return core_name(obligation);
    return obligation.property == ir::no_id ? obligation.name : system.properties[obligation.property].name;
}

bool is_wanted(const ClaimContext& context, const csp_emit::Obligation& obligation) {
    if (!context.takes(obligation)) return false;
    const ClaimSettings& settings = context.search.settings.claims;
    const std::string name = name_of(context.project.system, obligation);
    if (obligation.component.empty()) return is_selected(settings, name);
    if (settings.core_names.empty()) return settings.names.empty() || settings.core;
    return std::ranges::find(settings.core_names, name) != settings.core_names.end();
}

/// Returns the transitions or states for which the obligation asks whether runs exercise them.
std::vector<std::string> elements_of(const csp_emit::Obligation& obligation) {
    std::vector<std::string> result;
    if (obligation.firing)
        for (const csp_emit::TransitionInside& transition : obligation.firing->transitions)
            result.push_back(transition.origin.element);
    else if (obligation.kind == ir::PropertyKind::reachable)
        result.push_back(obligation.origin.element);
    return result;
}

/// Returns the declaration of a component such as "state machine P::S".
diagnostics::Span declaration_span(const ir::System& system, const std::string& component) {
    const std::string name = component.substr(component.rfind(' ') + 1);
    const auto is_it = [&](const std::string& package, const std::string& path) {
        return name == (package.empty() ? path : package + "::" + path);
    };
    for (const ir::Module& module : system.modules)
        if (is_it(module.package, module.name)) return module.origin.span;
    for (const ir::Controller& controller : system.controllers)
        if (is_it(controller.package, controller.path)) return controller.origin.span;
    for (const ir::Machine& machine : system.machines)
        if (is_it(machine.package, machine.path)) return machine.origin.span;
    return {};
}

/// Lists all claims as undecided in the results, before any is decided.
void announce_claims(const ClaimContext& context, ClaimResults& results) {
    const auto edit = context.search.services.edit();
    for (const csp_emit::Obligation& obligation : context.emission.obligations) {
        if (!is_wanted(context, obligation)) continue;
        AssertionReport one;
        one.title = context.project.label + obligation.title;
        one.name = name_of(context.project.system, obligation);
        if (obligation.property != ir::no_id)
            set_place(context.project.sources, context.project.system.properties[obligation.property].origin.span, one);
        if (!obligation.component.empty()) {
            one.core = CoreReport{context.project.label + obligation.component, obligation.property_text,
                                  obligation.information, elements_of(obligation)};
        }
        if (obligation.origin.span.is_known()) set_place(context.project.sources, obligation.origin.span, one);
        if (one.core && !one.region)
            one.region =
                region_of(context.project.sources, declaration_span(context.project.system, obligation.component));
        const bool of_rule = obligation.kind == ir::PropertyKind::conforms;
        const bool decidable = obligation.firing || obligation.recurrence || of_rule ||
                               claim_of(context.project, obligation) || !obligation.assertions.empty();
        one.answer = decidable ? Answer::inconclusive : Answer::no_check;
        one.reason = decidable ? undecided_at_limit : obligation.reason;
        results.assertions.push_back(std::move(one));
    }
}

/// Opens the session of a script. An undefined name in the script is reported once for all its claims.
std::unique_ptr<cspm::Session> start_session(const Project& project, const csp_emit::Emission& emission, Time time,
                                             const SearchContext& search, ClaimResults& results) {
    try {
        auto session = std::make_unique<cspm::Session>(emission.script, &search.services.budget());
        if (diagnostics::Cache* const cache = search.services.cache()) session->set_cache(*cache);
        return session;
    } catch (const cspm::EvaluationError& error) {
        AssertionReport one;
        one.title = fmt::format("{}the {} script", project.label, time == Time::timed ? "timed" : "untimed");
        one.answer = Answer::error;
        one.reason = failure_text(project, error);
        const auto edit = search.services.edit();
        results.assertions.push_back(std::move(one));
        return nullptr;
    }
}

/// Adds the bounds to the basis of an answer. An answer from the cache contains no information about bounds, so nothing
/// is added to it.
void add_bounds(ReachedBounds& reached, const BoundWatch& bounds, const csp_emit::Obligation& claim,
                AssertionReport& report) {
    const bool answered = report.answer == Answer::holds || report.answer == Answer::fails;
    if (answered && !report.run)
        for (Ground& ground : reached.comparisons_in(claim)) add(report.basis, std::move(ground));
    if (!answered || (bounds.met_bounds().empty() && report.searched)) return;
    for (Ground& ground : reached.basis_of_claim(claim, bounds.met_bounds())) add(report.basis, std::move(ground));
}

/// Merges these bounds with those of other claims and of the other semantics.
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

/// Ranks the claims of the model before the core properties, and core properties of small components before those of
/// large ones. Informative properties are last, so that they do not use the time of other claims.
int rank_of(const csp_emit::Obligation& obligation) {
    constexpr int of_information = 4;
    if (obligation.component.empty()) return 0;
    const int information = obligation.information ? of_information : 0;
    if (obligation.component.starts_with("controller ")) return information + 2;
    return information + (obligation.component.starts_with("module ") ? 3 : 1);
}

}  // namespace

void Premises::apply_premise(const ClaimContext& context, const csp_emit::Obligation& obligation,
                             AssertionReport& report) {
    if (obligation.premise == nullptr) return;
    // For a claim of a claims file, the premise states that the component does not stop time under the assumptions. It
    // is decided even if the claim fails.
    const bool of_failures = claim_of(context.project, obligation).has_value();
    if (report.answer != Answer::holds && !(of_failures && report.answer == Answer::fails)) return;
    const AssertionReport premise = answer_premise(context, obligation);
    if (premise.answer == Answer::holds) return;
    const csp_emit::Premise& emitted_premise = *obligation.premise;
    report.answer = premise.answer == Answer::error ? Answer::error : Answer::inconclusive;
    report.reason = premise.answer == Answer::fails
                        ? "not decided: " + emitted_premise.otherwise
                        : fmt::format("not decided whether {}: {}", emitted_premise.text, premise.reason);
    report.run = premise.run;
}

AssertionReport Premises::answer_premise(const ClaimContext& context, const csp_emit::Obligation& claim) {
    for (const auto& [premise, report] : decided_)
        if (premise == claim.premise) return report;
    AssertionReport report = decide_premise(context, claim);
    if (report.answer != Answer::inconclusive) decided_.emplace_back(claim.premise, report);
    return report;
}

TimeClaims::TimeClaims(Project& project, const csp_emit::Emission& emission, const SearchContext& search, Time time,
                       ClaimFilter takes, Values values, ClaimResults& results)
    : project_(project),
      search_(search),
      time_(time),
      takes_(std::move(takes)),
      values_(values),
      emission_(emission),
      results_(results),
      watch_(project, emission_, project.instantiation),
      reached_(project, emission_, project.instantiation, search),
      guards_(project, emission_, time),
      rules_(project, emission_, search) {
    if (!project.diagnostics.ok() || (emission_.obligations.empty() && !search.settings.claims.sizes)) return;
    if (!open_session()) return;
    first_ = results.assertions.size();
    const ClaimContext context{project, search, emission_, *session_, guards_, takes_};
    announce_claims(context, results);
    announced_.assign(results.assertions.begin() + static_cast<std::ptrdiff_t>(first_), results.assertions.end());
    for (const csp_emit::Obligation& obligation : emission_.obligations)
        if (is_wanted(context, obligation)) claims_.push_back({&obligation, claims_.size()});
}

WaitingClaim TimeClaims::waiting(const ListedClaim& claim, std::function<bool(const Turn&)> decide) {
    return {claim.obligation->title, std::move(decide), rank_of(*claim.obligation)};
}

void TimeClaims::give_back() {
    second_look_.reset();
    given_back_ = session_ != nullptr || given_back_;
    session_.reset();
}

void TimeClaims::measure_if_asked() {
    if (is_in_carriers()) return;  // the sizes are measured only for the other claims
    if (search_.settings.claims.sizes && given_back_ && !session_) (void)open_session();
    if (session_ && search_.settings.claims.sizes)
        measure_sizes(project_, *session_, emission_, time_, search_, results_);
}

bool TimeClaims::open_session() {
    session_ = start_session(project_, emission_, time_, search_, results_);
    if (!session_) return false;
    session_->set_observer(watch_.observer());
    second_look_.emplace(project_, emission_, *session_, search_);
    return true;
}

std::string TimeClaims::stopped_evaluation() const {
    if (!session_) return "";
    const std::optional<cspm::EvaluationError> stopped = session_->take_stopped_evaluation();
    return stopped ? "; " + runs::placed_failure(*stopped, project_.system, project_.sources) : "";
}

AssertionReport TimeClaims::decide(const Turn& turn, const ListedClaim& claim) {
    SearchContext search{search_.settings, search_.services, turn};
    search.turn.on_progress = [&](const refine::Progress& progress) { note_progress(progress, claim.number); };
    AssertionReport one = undecided(claim);
    try {
        if (!session_ && !open_session()) return one;  // open_session has added the reason to the results
        const auto assertions =
            decide_whole({project_, search, emission_, *session_, guards_, takes_}, *claim.obligation, one);
        if (certifies_ && one.answer == Answer::holds) one.certificate = certificate_of(claim, one, assertions, search);
    } catch (const diagnostics::LimitReached& limit) {
        if (run_is_over(search_.services.budget())) throw;
        one = undecided(claim);
        one.reason = limit.what();
    }
    const std::string stopped = stopped_evaluation();
    if (one.answer == Answer::inconclusive) one.reason = ended_turn(one.reason, search) + stopped;
    return one;
}

bool TimeClaims::store(AssertionReport report, const ListedClaim& claim) {
    const bool decided = report.answer != Answer::inconclusive;
    const auto edit = search_.services.edit();
    add_bounds(report.basis, time_, results_.bounds);
    results_.assertions[first_ + claim.number] = std::move(report);
    return decided;
}

CertificateReport TimeClaims::certificate_of(const ListedClaim& claim, const AssertionReport& one,
                                             const std::vector<cspm::DeclPtr>& assertions,
                                             const SearchContext& search) {
    const csp_emit::Obligation& obligation = *claim.obligation;
    const bool recurrence_alone = obligation.recurrence && obligation.assertions.empty();
    if (assertions.empty() && !recurrence_alone) return {{}, "there are no certificates for this kind of claim"};
    CertifiedClaim certified{std::to_string(first_ + claim.number + 1), one.title, one.place, {}, {}};
    const auto add_assertions = [&](const std::vector<cspm::DeclPtr>& all) {
        for (const cspm::DeclPtr& assertion : all) certified.assertions.push_back(assertion.get());
    };
    const auto add_recurrence = [&](const csp_emit::RecurrenceQuestion& question) {
        certified.possible.push_back({question.process, question.goal});
    };
    add_assertions(assertions);
    if (obligation.recurrence) add_recurrence(*obligation.recurrence);
    if (obligation.premise != nullptr) {
        add_assertions(obligation.premise->assertions);
        if (obligation.premise->recurrence.process) add_recurrence(obligation.premise->recurrence);
    }
    return driver::write_certificates(*session_, certified, search);
}

std::vector<cspm::DeclPtr> TimeClaims::decide_whole(const ClaimContext& context, const csp_emit::Obligation& obligation,
                                                    AssertionReport& one) {
    std::vector<cspm::DeclPtr> assertions;
    const std::optional<std::size_t> claim = claim_of(context.project, obligation);
    if (obligation.firing) {
        one.reason.clear();
        decide_firing(context, *obligation.firing, one);
    } else if (obligation.kind == ir::PropertyKind::conforms) {
        one.reason.clear();
        rules_.decide_property(project_.system.properties[obligation.property], context.search, one);
    } else if (claim && obligation.assertions.empty()) {
        one.reason = "not decided: " + obligation.reason;
    } else if (!obligation.assertions.empty()) {
        one.reason.clear();
        assertions = decide_claim(context, obligation, one);
        if (claim) {
            complete_answer(context.project, reading_context(context), context.search, obligation, *claim, one);
            const claims::Decision& decision = context.project.claims->scripted.at(*claim).decision;
            if (decision.standstill) assertions.push_back(decision.standstill);
            if (decision.waiting) assertions.clear();  // this claim also excludes endless runs
        }
        if (one.core && one.answer == Answer::fails) one.core->unexercised = one.core->elements;
    }
    if (obligation.recurrence && (obligation.assertions.empty() || one.answer == Answer::holds)) {
        one.reason.clear();
        decide_recurrence(context, obligation, one);
    }
    if (obligation.time_goes_on && one.answer == Answer::holds) note_time_stop(context, obligation, one);
    const bool decided = one.answer == Answer::holds || one.answer == Answer::fails;
    if (decided && is_open_in_classes(project_, obligation, one.answer)) {
        one.answer = Answer::inconclusive;
        one.reason =
            "inputs or outputs of different values have one name here; --concrete decides it for finite carriers";
    }
    premises_.apply_premise(context, obligation, one);
    // A script in which machines show their states contains additional moments at which no time passes, although the
    // model does not stop time there. So the second look would report wrong facts.
    const bool shows = claim && !context.project.claims->checked.claims[*claim].facts.empty();
    if (!shows) second_look_->add_to(obligation, one);
    if (is_in_carriers() && (one.answer == Answer::holds || one.answer == Answer::fails))
        add(one.basis,
            {GroundKind::carriers, "this claim compares values, those of the finite instantiation", {}, {}, {}, {}});
    add_bounds(reached_, watch_, obligation, one);
    return assertions;
}

/// Stores the current knowledge about a claim, in case the run ends now.
void TimeClaims::note_progress(const refine::Progress& progress, std::size_t at) {
    const auto edit = search_.services.edit();
    AssertionReport& known = results_.assertions[first_ + at];
    if (progress.phase != refine::Progress::Phase::searching || progress.states < known.statistics.states) return;
    known.searched = true;
    known.statistics.states = progress.states;
    known.statistics.transitions = progress.transitions;
    known.statistics.depth = progress.depth;
    known.statistics.seconds = progress.seconds;
}

}  // namespace robochart::driver
