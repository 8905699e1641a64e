// SPDX-License-Identifier: Apache-2.0
#include "driver/claims/model_claims.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/diagnostics/escape.hpp"
#include "checker/cspm/session.hpp"
#include "checker/refine/verdict/recurrence.hpp"
#include "counterexample/evaluation_failure.hpp"
#include "counterexample/exercised.hpp"
#include "counterexample/interpreter.hpp"
#include "driver/claims/bounds.hpp"
#include "driver/claims/causes.hpp"
#include "driver/claims/class_project.hpp"
#include "driver/claims/probability_claims.hpp"
#include "driver/claims/related_values.hpp"
#include "driver/claims/second_look.hpp"
#include "driver/claims/sizes.hpp"
#include "driver/claims/taken_guards.hpp"
#include "driver/claims/turns.hpp"
#include "driver/model/preferences.hpp"
#include "driver/rules/rule_claims.hpp"
#include "frontend/syntax/print.hpp"
#include "frontend/syntax/syntax_rules.hpp"

namespace robochart::driver {
namespace {

using csp_emit::Time;

using ClaimFilter = std::function<bool(const csp_emit::Obligation&)>;

struct Context {
    Project& project;
    const SearchContext& search;
    const csp_emit::Emission& emission;
    cspm::Session& session;
    const TakenGuards& guards;
    const ClaimFilter& takes;  ///< the claims that are decided in this context
};

/// The context for converting counterexamples and steps to runs of the model.
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
        show_related_values(*report.run, context.project.related);
        if (!verdict.counterexample->shortest) report.reason = not_shortest;
    }
}

/// The basis of the answer to an assertion. If the answer has a run, the basis consists of the entries for its steps.
/// This is also true for runs that show that the assertion holds.
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
            context.session.check(assertion, limits_of_check(context.search, obligation.title)).verdict;
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
constexpr std::uint64_t most_states_for_firing = 20'000;

using Transitions = std::vector<csp_emit::TransitionInside>;

/// The transitions of the question whose names are not in `elements`.
Transitions missing_transitions(const csp_emit::FiringQuestion& question, const std::set<std::string>& elements) {
    Transitions result;
    for (const csp_emit::TransitionInside& transition : question.transitions)
        if (!elements.contains(runs::element_in(transition.component, transition.origin.element)))
            result.push_back(transition);
    return result;
}

/// "t1: S1 -> S2 (model.rct:12), ..."
std::string transition_list(const Project& project, const Transitions& transitions) {
    std::vector<std::string> texts;
    for (const csp_emit::TransitionInside& transition : transitions)
        texts.push_back(fmt::format("{} ({})", transition.text, project.sources.path_and_line(transition.origin.span)));
    return fmt::format("{}", fmt::join(texts, ", "));
}

/// The transitions that never fire in any instance of their machine.
std::vector<std::string> unexercised_transitions(const csp_emit::FiringQuestion& question, const Transitions& never) {
    std::map<std::string, std::size_t> instances;
    for (const csp_emit::TransitionInside& transition : question.transitions) ++instances[transition.origin.element];
    for (const csp_emit::TransitionInside& transition : never) --instances[transition.origin.element];
    std::vector<std::string> result;
    for (const auto& [element, firing] : instances)
        if (firing == 0) result.push_back(element);
    return result;
}

/// Answers which transitions fire. If several transitions of one state have the same trigger and target, a step may not
/// show which of them fired. So the others may never fire although one does.
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
    TurnBudget budget(context.search);
    try {
        const auto found =
            runs::find_exercised(reader, context.session.process(question.process), most_states_for_firing, budget);
        report.statistics.states = found.states;
        report.searched = true;
        answer_firing(context.project, question, found, report);
    } catch (const cspm::EvaluationError& error) {
        report.answer = Answer::error;
        report.reason = failure_text(context.project, error);
    }
}

/// This text is printed if a recurrence claim holds, because without probabilities the claim only states a possibility.
const char* const fair_draws =
    "it happens again and again with probability 1 only if every choice between steps is a draw, each with a chance "
    "above 0";

/// Decides whether the goal remains reachable from every reachable state, by a backward search through all states.
void decide_recurrence(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
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
        report.answer = Answer::error;
        report.reason = failure_text(context.project, error);
    }
}

/// Decides a claim that consists of several assertions. If all of them must hold, the first that fails ends the check.
/// If one suffices, the first that holds ends the check, and the claim fails only if all of them fail. If none holds
/// and one is inconclusive, the claim is inconclusive.
void decide_claim(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
    std::optional<std::string> unknown;  // the reason of the first inconclusive assertion
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

/// Decides the premises of claims. A premise that several claims share is decided once.
class Premises {
public:
    /// If the premise of a claim that holds does not hold, the claim becomes inconclusive and gets the run that refutes
    /// the premise.
    void apply_premise(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& report) {
        if (obligation.premise == nullptr || report.answer != Answer::holds) return;
        const AssertionReport premise = answer_premise(context, obligation);
        if (premise.answer == Answer::holds) return;
        const csp_emit::Premise& emitted_premise = *obligation.premise;
        report.answer = premise.answer == Answer::error ? Answer::error : Answer::inconclusive;
        report.reason = premise.answer == Answer::fails
                            ? "not decided: " + emitted_premise.otherwise
                            : fmt::format("not decided whether {}: {}", emitted_premise.text, premise.reason);
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
        csp_emit::Obligation obligation;
        obligation.kind = ir::PropertyKind::timelock_free;
        obligation.title = fmt::format("{}: {}", claim.title, claim.premise->text);
        obligation.origin = claim.origin;
        obligation.time = claim.time;
        obligation.reason = claim.premise->reason;
        obligation.assertions = claim.premise->assertions;
        AssertionReport report;
        report.answer = Answer::holds;
        decide_claim(context, obligation, report);
        if (report.answer != Answer::holds) return report;
        obligation.kind = ir::PropertyKind::refines;
        obligation.recurrence = claim.premise->recurrence;
        decide_recurrence(context, obligation, report);
        return report;
    }

    std::vector<std::pair<std::shared_ptr<const csp_emit::Premise>, AssertionReport>> decided_;
};

bool is_wanted(const Context& context, const csp_emit::Obligation& obligation) {
    if (!context.takes(obligation)) return false;
    if (!obligation.name.empty()) return is_selected(context.search.settings.claims, obligation.name);
    const bool core = obligation.property == ir::no_id;
    const bool core_requested = context.search.settings.claims.core && !obligation.component.empty();
    return core ? context.search.settings.claims.names.empty() || core_requested
                : is_selected(context.search.settings.claims,
                              context.project.system.properties[obligation.property].name);
}

/// The transitions or states for which the obligation asks whether runs exercise them.
std::vector<std::string> elements_of(const csp_emit::Obligation& obligation) {
    std::vector<std::string> result;
    if (obligation.firing)
        for (const csp_emit::TransitionInside& transition : obligation.firing->transitions)
            result.push_back(transition.origin.element);
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
    for (const ir::Module& module : system.modules)
        if (is_it(module.package, module.name)) return module.origin.span;
    for (const ir::Controller& controller : system.controllers)
        if (is_it(controller.package, controller.path)) return controller.origin.span;
    for (const ir::Machine& machine : system.machines)
        if (is_it(machine.package, machine.path)) return machine.origin.span;
    return {};
}

/// Lists all claims as undecided in the results, before any is decided.
void announce_claims(const Context& context, ClaimResults& results) {
    const auto edit = context.search.services.edit();
    for (const csp_emit::Obligation& obligation : context.emission.obligations) {
        if (!is_wanted(context, obligation)) continue;
        AssertionReport one;
        one.title = context.project.label + obligation.title;
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
        const bool decidable = obligation.firing || obligation.recurrence || of_rule || !obligation.assertions.empty();
        one.answer = decidable ? Answer::inconclusive : Answer::no_check;
        one.reason = decidable ? undecided_at_limit : obligation.reason;
        results.assertions.push_back(std::move(one));
    }
}

/// Opens the session of a script. If the script uses an undefined name, this is reported once for all its claims.
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

/// Adds the bounds to the basis of an answer. An answer from the cache contains no information about bounds, so it gets
/// none.
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

/// The values that claims are about.
enum class Values {
    of_project,   ///< of all data of the project
    of_carriers,  ///< of the finite instantiation, where other claims are about classes of values
};

/// The claims of the model come first, then the core properties, of small components first. Information that nobody
/// asked for must not use up the time of other claims.
int rank_of(const csp_emit::Obligation& obligation) {
    constexpr int of_information = 4;
    if (obligation.component.empty()) return 0;
    const int information = obligation.information ? of_information : 0;
    if (obligation.component.starts_with("controller ")) return information + 2;
    return information + (obligation.component.starts_with("module ") ? 3 : 1);
}

/// Whether the answer is missing, or rests on carriers without a run that shows it. Other evaluation errors are faults
/// of the model.
bool is_limited_by_carriers(const AssertionReport& one) {
    if (one.answer == Answer::inconclusive) return true;
    if (one.answer == Answer::error) return is_about_large_set(one.reason);
    const bool decided = one.answer == Answer::holds || (one.answer == Answer::fails && !one.run);
    return decided && std::ranges::any_of(one.basis, [](const Ground& ground) {
               return ground.kind == GroundKind::bound || ground.kind == GroundKind::carriers;
           });
}

/// One of these parts of the rest of the turn; of forty seconds if the turn ends with the run.
Turn part_of(const Turn& turn, int parts) {
    constexpr std::chrono::seconds usual{40};
    Turn result = turn;
    const auto now = std::chrono::steady_clock::now();
    result.ends = now + (turn.ends ? (*turn.ends - now) / parts : usual / parts);
    return result;
}

/// Decides claims in the model with free data (docs/data.md, "Computed data").
class FreeClaims {
public:
    virtual ~FreeClaims() = default;
    /// Whether the carriers are so large that the model with free data is decided first.
    [[nodiscard]] virtual bool comes_first() const = 0;
    [[nodiscard]] virtual bool was_tried(const csp_emit::Obligation& obligation) const = 0;
    /// Whether the claim was tried, and fails with free data.
    [[nodiscard]] virtual bool may_fail(const csp_emit::Obligation& obligation) const = 0;
    /// Decides the claim. Returns true if the answer is also true of the model, and writes it to the report.
    virtual bool answer(const Turn& turn, const csp_emit::Obligation& obligation, AssertionReport& report) = 0;
};

/// Decides claims in one semantics, timed or untimed.
class TimeClaims {
public:
    /// Lists the claims that `takes` selects in the results.
    TimeClaims(Project& project, const SearchContext& search, Time time, ClaimFilter takes, Values values,
               ClaimResults& results)
        : project_(project),
          search_(search),
          time_(time),
          takes_(std::move(takes)),
          values_(values),
          emission_(emit_csp(project, search.settings.claims, search.settings.swarm, time)),
          results_(results),
          watch_(project, emission_, project.instantiation),
          reached_(project, emission_, project.instantiation, search),
          guards_(project, emission_, time),
          rules_(project, emission_, search) {
        if (!project.diagnostics.ok() || (emission_.obligations.empty() && !search.settings.claims.sizes)) return;
        if (!open_session()) return;
        first_ = results.assertions.size();
        announce_claims({project, search, emission_, *session_, guards_, takes_}, results);
        announced_.assign(results.assertions.begin() + static_cast<std::ptrdiff_t>(first_), results.assertions.end());
    }

    void add_to(std::vector<WaitingClaim>& claims) {
        if (!session_) return;
        const Context context{project_, search_, emission_, *session_, guards_, takes_};
        std::size_t number = 0;
        for (const csp_emit::Obligation& obligation : emission_.obligations)
            if (is_wanted(context, obligation))
                claims.push_back(
                    {obligation.title,
                     [this, &obligation, at = number++](const Turn& turn) { return decide_in(turn, obligation, at); },
                     rank_of(obligation)});
    }

    /// Frees the session that the claims share. The next claim opens the script again.
    void give_back() {
        second_look_.reset();
        given_back_ = session_ != nullptr || given_back_;
        session_.reset();
    }

    /// Claims that the carriers limit are decided with free data, too.
    void set_free_claims(FreeClaims* free) { free_ = free; }

    [[nodiscard]] bool is_in_carriers() const { return values_ == Values::of_carriers; }

    void measure_if_asked() {
        if (is_in_carriers()) return;  // the sizes are those of the other claims
        if (search_.settings.claims.sizes && given_back_ && !session_) (void)open_session();
        if (session_ && search_.settings.claims.sizes)
            measure_sizes(project_, *session_, emission_, time_, search_, results_);
    }

private:
    bool open_session() {
        session_ = start_session(project_, emission_, time_, search_, results_);
        if (!session_) return false;
        session_->set_observer(watch_.observer());
        second_look_.emplace(project_, emission_, *session_, search_);
        return true;
    }

    /// A claim that carriers may limit gets a part of its turn, then a part with free data, then the rest.
    bool decide_in(const Turn& turn, const csp_emit::Obligation& obligation, std::size_t at) {
        const bool whole = search_.services.continues_searches();  // a search in files is not ended and begun again
        if (whole || free_ == nullptr || free_->was_tried(obligation))
            return store(decide_alone(turn, obligation, at), at);
        const bool first = free_->comes_first();
        AssertionReport one = first ? announced_[at] : decide_alone(part_of(turn, 20), obligation, at);
        if (first || is_limited_by_carriers(one)) {
            if (free_->answer(part_of(turn, 4), obligation, one)) return store(std::move(one), at);
            if (first || (one.answer == Answer::inconclusive && !turn.is_over()))
                one = decide_alone(turn, obligation, at);
        }
        return store(std::move(one), at);
    }

    AssertionReport decide_alone(const Turn& turn, const csp_emit::Obligation& obligation, std::size_t at) {
        SearchContext search{search_.settings, search_.services, turn};
        search.turn.on_progress = [&](const refine::Progress& progress) { note_progress(progress, at); };
        AssertionReport one = announced_[at];
        try {
            if (!session_ && !open_session()) return one;  // the results contain the reason
            decide_whole({project_, search, emission_, *session_, guards_, takes_}, obligation, one);
        } catch (const diagnostics::LimitReached& limit) {
            if (run_is_over(search_.services.budget())) throw;
            one = announced_[at];
            one.reason = limit.what();
        }
        if (one.answer == Answer::inconclusive) {
            one.reason = ended_turn(one.reason, search);
            if (free_ != nullptr && free_->may_fail(obligation))
                one.reason += "; with free values of computed data it fails, which may not be a run of the model";
        }
        return one;
    }

    /// Returns true if the claim is decided.
    bool store(AssertionReport one, std::size_t at) {
        const bool decided = one.answer != Answer::inconclusive;
        const auto edit = search_.services.edit();
        add_bounds(one.basis, time_, results_.bounds);
        results_.assertions[first_ + at] = std::move(one);
        return decided;
    }

    void decide_whole(const Context& context, const csp_emit::Obligation& obligation, AssertionReport& one) {
        if (obligation.firing) {
            one.reason.clear();
            decide_firing(context, *obligation.firing, one);
        } else if (obligation.kind == ir::PropertyKind::conforms) {
            one.reason.clear();
            rules_.decide_property(project_.system.properties[obligation.property], context.search, one);
        } else if (!obligation.assertions.empty()) {
            one.reason.clear();
            decide_claim(context, obligation, one);
            if (one.core && one.answer == Answer::fails) one.core->unexercised = one.core->elements;
        }
        if (obligation.recurrence && (obligation.assertions.empty() || one.answer == Answer::holds)) {
            one.reason.clear();
            decide_recurrence(context, obligation, one);
        }
        const bool decided = one.answer == Answer::holds || one.answer == Answer::fails;
        if (decided && is_open_in_classes(project_, obligation, one.answer)) {
            one.answer = Answer::inconclusive;
            one.reason =
                "inputs or outputs of different values have one name here; --concrete decides it for finite carriers";
        }
        premises_.apply_premise(context, obligation, one);
        second_look_->add_to(obligation, one);
        if (is_in_carriers() && (one.answer == Answer::holds || one.answer == Answer::fails))
            add(one.basis, {GroundKind::carriers,
                            "this claim compares values, those of the finite instantiation",
                            {},
                            {},
                            {},
                            {}});
        add_bounds(reached_, watch_, obligation, one);
    }

    /// Stores the current knowledge about a claim, in case the run ends now.
    void note_progress(const refine::Progress& progress, std::size_t at) {
        const auto edit = search_.services.edit();
        AssertionReport& known = results_.assertions[first_ + at];
        if (progress.phase != refine::Progress::Phase::searching || progress.states < known.statistics.states) return;
        known.searched = true;
        known.statistics.states = progress.states;
        known.statistics.transitions = progress.transitions;
        known.statistics.depth = progress.depth;
        known.statistics.seconds = progress.seconds;
    }

    Project& project_;
    SearchContext search_;
    Time time_;
    ClaimFilter takes_;
    Values values_;
    const csp_emit::Emission& emission_;
    ClaimResults& results_;
    BoundWatch watch_;
    ReachedBounds reached_;
    TakenGuards guards_;
    RuleClaims rules_;
    Premises premises_;
    std::unique_ptr<cspm::Session> session_;
    bool given_back_ = false;
    FreeClaims* free_ = nullptr;  ///< null: none
    std::optional<SecondLook> second_look_;
    std::size_t first_ = 0;                   ///< index of the first claim in the results
    std::vector<AssertionReport> announced_;  ///< the claims before anything was known about them
};

/// Decides claims in the model with free data by a hidden list of results. The model is made for the first claim.
class HiddenClaims final : public FreeClaims {
public:
    HiddenClaims(const FreeProject& free, const SearchContext& search, Time time)
        : free_(free), search_(search), time_(time) {}

    [[nodiscard]] bool comes_first() const override { return free_.has_large_carriers; }

    [[nodiscard]] bool was_tried(const csp_emit::Obligation& obligation) const override {
        return tried_.contains(obligation.title);
    }
    [[nodiscard]] bool may_fail(const csp_emit::Obligation& obligation) const override {
        const auto at = was_tried(obligation) ? index_of(obligation) : std::nullopt;
        return at && results_.assertions[*at].answer == Answer::fails;
    }

    bool answer(const Turn& turn, const csp_emit::Obligation& obligation, AssertionReport& report) override {
        if (!time_claims_) list_claims();
        tried_.insert(obligation.title);
        const auto at = index_of(obligation);
        if (!at) return false;
        AssertionReport& known = results_.assertions[*at];
        (void)claims_[*at].decide(turn);
        if (known.answer != Answer::holds && known.answer != Answer::fails) return false;
        if (!carries_over(obligation, known.answer)) return false;
        report.answer = known.answer;
        report.reason = known.reason;
        if (known.answer == Answer::holds) report.reason = reason();
        report.basis = known.basis;
        // the model may have fewer ends than the model with free data
        std::erase_if(report.basis, [](const Ground& ground) {
            return ground.kind == GroundKind::ended || ground.kind == GroundKind::time_stops;
        });
        report.statistics = known.statistics;
        report.searched = known.searched;
        report.run.reset();
        if (report.core && known.core) report.core->unexercised = known.core->unexercised;
        return true;
    }

    void give_back() {
        if (time_claims_) time_claims_->give_back();
    }

private:
    /// No value if the claim cannot be decided with free data.
    [[nodiscard]] std::optional<std::size_t> index_of(const csp_emit::Obligation& obligation) const {
        const auto found = std::ranges::find(claims_, obligation.title, &WaitingClaim::title);
        if (std::ranges::count(claims_, obligation.title, &WaitingClaim::title) != 1) return std::nullopt;
        return static_cast<std::size_t>(found - claims_.begin());
    }
    void list_claims() {
        const auto takes = [](const csp_emit::Obligation& obligation) {
            return carries_over(obligation, Answer::holds) || carries_over(obligation, Answer::fails);
        };
        time_claims_ =
            std::make_unique<TimeClaims>(*free_.project, search_, time_, takes, Values::of_project, results_);
        time_claims_->add_to(claims_);
    }
    [[nodiscard]] std::string reason() const {
        if (free_.conditions == 0) return "for all values, whatever is computed from them";
        return fmt::format("for all values: {} condition{} on data may have either answer", free_.conditions,
                           free_.conditions == 1 ? "" : "s");
    }

    const FreeProject& free_;
    SearchContext search_;
    Time time_;
    ClaimResults results_;
    std::unique_ptr<TimeClaims> time_claims_;
    std::vector<WaitingClaim> claims_;
    std::set<std::string> tried_;  ///< titles
};

/// Lists the claims that only other tools can check. They do not count as successes.
void report_unchecked(const Project& project, const SearchContext& search, ClaimResults& results) {
    const auto unchecked = [&](const std::string& name, diagnostics::Span span, const std::string& why) {
        if (!is_selected(search.settings.claims, name)) return;
        AssertionReport one;
        one.title = project.label + name;
        set_place(project.sources, span, one);
        one.answer = Answer::unchecked;
        one.reason = fmt::format("{}: not checked: {}", diagnostics::escape_for_display(one.place), why);
        const auto edit = search.services.edit();
        results.assertions.push_back(std::move(one));
    };
    for (const auto& file : project.model->files) {
        for (const frontend::KeptPart& part : file->kept)
            if (part.claims) unchecked(part.name, part.span, fmt::format("`{}` is for another tool", part.form));
        if (file->dialect == frontend::Dialect::robochart) continue;
        for (const frontend::Assertion& claim : file->assertions)
            unchecked(claim.name, claim.span, "it is about RoboSim, whose meaning is not built yet");
    }
}

/// The places in the results of claims in one semantics that are decided in two projects.
struct DividedClaims {
    Time time;
    std::size_t first, end;
};

/// Puts these claims in the order of the project's script.
void order_claims(const Project& project, const csp_emit::Emission& emission, const DividedClaims& divided,
                  std::vector<AssertionReport>& assertions) {
    std::map<std::string, std::size_t> order;
    for (const csp_emit::Obligation& obligation : emission.obligations)
        order.emplace(project.label + obligation.title, order.size());
    const auto at = assertions.begin();
    std::ranges::stable_sort(at + static_cast<std::ptrdiff_t>(divided.first),
                             at + static_cast<std::ptrdiff_t>(divided.end), {}, [&](const AssertionReport& one) {
                                 const auto found = order.find(one.title);
                                 return found == order.end() ? order.size() : found->second;
                             });
}

}  // namespace

void check_assertions(Project& project, const SearchContext& search, ClaimResults& results) {
    // A preferences file that cannot be read is an error even if no claim needs it.
    auto preferences = read_preferences(project, search.settings.probability);
    if (!preferences) return;
    std::vector<WaitingClaim> claims;
    std::unique_ptr<ProbabilityClaims> probabilities;
    if (search.settings.swarm.file.empty()) {
        probabilities = std::make_unique<ProbabilityClaims>(project, search, std::move(*preferences), results);
        report_unchecked(project, search, results);
    }
    const ClassProject classes = class_project(project, search.settings);
    Project& decided = classes.project ? *classes.project : project;
    results.data.insert(results.data.end(), classes.data.begin(), classes.data.end());
    const FreeProject free = free_project(project, search.settings, classes);
    std::vector<std::unique_ptr<HiddenClaims>> hidden;
    std::vector<std::unique_ptr<TimeClaims>> times;
    std::vector<DividedClaims> divided;
    for (const Time time : {Time::untimed, Time::timed}) {
        if (!includes_time(search.settings.claims.times, time) || !project.diagnostics.ok() ||
            !decided.diagnostics.ok())
            continue;
        const auto add = [&](Project& of, Values values) {
            const auto takes = [&classes, &of, values](const csp_emit::Obligation& obligation) {
                return is_decided_in_carriers(classes, of.system, obligation) == (values == Values::of_carriers);
            };
            times.push_back(std::make_unique<TimeClaims>(of, search, time, takes, values, results));
            times.back()->add_to(claims);
            if (free.project) times.back()->set_free_claims(hidden.back().get());
        };
        if (free.project) hidden.push_back(std::make_unique<HiddenClaims>(free, search, time));
        const std::size_t first = results.assertions.size();
        add(decided, Values::of_project);
        const bool open = !(decided.outputs_replaced.empty() && decided.related.empty());
        if (classes.project && (has_observers(project.system) || (classes.small_carriers && open)))
            add(project, Values::of_carriers);
        if (times.back()->is_in_carriers()) divided.push_back({time, first, results.assertions.size()});
    }
    if (&decided != &project) project.diagnostics.add(decided.diagnostics);
    if (probabilities) probabilities->add_to(claims);
    if (!project.diagnostics.ok()) return;
    decide_in_turns(claims, search, [&] {
        for (const auto& time : times) time->give_back();
        for (const auto& claims_of_time : hidden) claims_of_time->give_back();
        if (probabilities) probabilities->give_back();
    });
    for (const auto& time : times) time->measure_if_asked();
    for (const DividedClaims& claims_of_time : divided)
        order_claims(project, emit_csp(project, search.settings.claims, search.settings.swarm, claims_of_time.time),
                     claims_of_time, results.assertions);
}

}  // namespace robochart::driver
