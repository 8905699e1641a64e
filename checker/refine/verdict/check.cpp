// SPDX-License-Identifier: Apache-2.0
// Implements the checks of check.hpp. Each check is a search with a monitor. Determinism and `has trace` have their own
// files.
#include "checker/refine/verdict/check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <stdexcept>

#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/counterexample.hpp"
#include "checker/refine/verdict/indifference.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "checker/refine/verdict/monitors.hpp"
#include "checker/refine/verdict/question.hpp"
#include "checker/refine/verdict/reduction.hpp"
#include "checker/refine/verdict/reference.hpp"

namespace robochart::refine {

using lts::StateIndex;
using process::Event;

namespace {

std::string known_so_far(const Statistics& size) {
    if (size.searched_steps < 2) return "";
    const std::uint64_t longest = size.searched_steps - 1;
    return fmt::format("; no violation in runs of up to {} step{}{}", longest, longest == 1 ? "" : "s",
                       size.divergence_open ? ", divergence aside" : "");
}

/// How many states a second search visits to look for divergence. The first search looks for cycles of taus only when
/// it has found all states. If a limit ends it before that, the second search looks for a cycle among these first
/// states. So a divergence can be found even in an infinite state space.
constexpr std::uint64_t first_states = 20'000;
constexpr std::chrono::seconds for_first_states{1};

using Question = std::function<void(Budget&, Verdict&)>;

void search_first_states(const std::vector<lts::TransitionSystem*>& systems, const Limits& limits,
                         const Question& question, Verdict& verdict) {
    const bool open = verdict.statistics.divergence_open && limits.max_states > first_states && !limits.first_of_two;
    if (!open || limits.by_levels != nullptr) return;
    Limits few = limits;
    few.max_states = first_states;
    few.deadline = std::chrono::steady_clock::now() + for_first_states;
    few.progress = {};
    Budget budget(few);
    const PollGuard guard(systems, budget);
    Verdict found;
    try {
        question(budget, found);
    } catch (const process::Interrupted&) {
        return;
    }
    if (found.outcome != Outcome::fails || !found.counterexample) return;
    found.counterexample->shortest = false;
    found.statistics = verdict.statistics;
    verdict = std::move(found);
}

}  // namespace

Verdict decide(const std::vector<lts::TransitionSystem*>& systems, const Limits& limits,
               const std::function<void(Budget&, Verdict&)>& question) {
    Verdict verdict;
    Budget budget(limits);
    const PollGuard guard(systems, budget);
    const auto leave_open = [&](const char* reason) {
        verdict.outcome = Outcome::inconclusive;
        verdict.counterexample.reset();
        verdict.reason = reason + known_so_far(verdict.statistics);
    };
    try {
        question(budget, verdict);
    } catch (const process::Interrupted& limit) {
        leave_open(limit.what());
        search_first_states(systems, limits, question, verdict);
    } catch (const std::bad_alloc&) {
        leave_open("there is no more memory");
    }
    verdict.statistics.seconds = budget.seconds();
    return verdict;
}

std::optional<Violation> reuse_or_search(Earlier earlier, Verdict& verdict,
                                         const std::function<std::optional<Violation>()>& search) {
    if (earlier != nullptr && *earlier) {
        verdict.known = true;
        verdict.statistics = (*earlier)->statistics;
        return (*earlier)->violation;
    }
    std::optional<Violation> violation = search();
    const bool final = !violation || violation->shortest;
    if (earlier != nullptr && final) *earlier = Findings{verdict.statistics, violation};
    return violation;
}

Tally::~Tally() {
    statistics_.states += search_.states();
    statistics_.transitions += search_.transitions();
    statistics_.depth = std::max(statistics_.depth, search_.depth());
    statistics_.chased += search_.chased_state_count();
    if (specification_ != nullptr) statistics_.spec_nodes = specification_->size();
}

namespace {

void set_failure(Verdict& verdict, Counterexample counterexample) {
    verdict.outcome = Outcome::fails;
    verdict.counterexample = std::move(counterexample);
}

/// Returns what the specification allows after the same trace: its acceptances if the violation is a refusal, and its
/// events if the violation is a forbidden event.
std::vector<process::EventSet> required_after(NormalForm& specification, const Violation& violation) {
    std::vector<Event> trace = violation.run.trace();
    if (violation.kind == ViolationKind::divergence) return {};
    if (violation.kind == ViolationKind::trace) trace.pop_back();
    NormalForm::Node node = specification.initial();
    for (Event event : trace) node = specification.node_after(node, event).value();
    if (violation.kind == ViolationKind::refusal) return specification.acceptances(node);
    return {specification.initials(node)};
}

Counterexample violation_counterexample(NormalForm& normal, const Confirmed& confirmed) {
    Counterexample counterexample = make_counterexample(confirmed);
    counterexample.required = required_after(normal, confirmed.violation);
    if (counterexample.kind == ViolationKind::trace) counterexample.event = counterexample.steps.back().event;
    return counterexample;
}

/// Converts a refinement to a query for a search by levels. Returns no value if no such search is wanted. Also returns
/// no value if the normal form cannot be completed, because it is too large or because a part of it that the search may
/// never reach cannot be evaluated.
std::optional<LevelQuestion> refinement_by_levels(NormalForm& normal, Model model, Search::Pairs pairs,
                                                  const Budget& budget) {
    if (budget.limits().by_levels == nullptr || pairs == Search::Pairs::antichain) return std::nullopt;
    try {
        std::optional<NormalTable> table = table_of(normal, model);
        if (!table) return std::nullopt;
        return LevelQuestion{LevelQuestion::Kind::refinement, model,
                             std::make_shared<const NormalTable>(std::move(*table))};
    } catch (const process::Interrupted&) {
        throw;
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

/// Returns the first fault that the search finds. If a limit ends the search, records how far it has searched, provided
/// that `levels_count` is true. If this is the limit of states, a cycle of taus among the states found is a fault, too.
std::optional<Violation> first_fault(Search& search, lts::TransitionSystem& system, const Violation* known,
                                     bool levels_count, bool with_divergence, Budget& budget, Statistics& statistics) {
    try {
        const std::optional<Finding> finding = search.first_violation(events_until(known));
        if (finding) return violation_of(search, system, *finding);
    } catch (const process::Interrupted&) {
        statistics.searched_steps = levels_count ? search.depth() : 0;
        statistics.divergence_open = with_divergence;
        const bool at_states = search.stores_all_pairs() && known == nullptr && !budget.limit_reached();
        std::optional<Violation> violation = with_divergence && at_states ? first_divergence(search) : std::nullopt;
        if (!violation) throw;
        violation->shortest = false;
        return violation;
    }
    return with_divergence ? first_divergence(search) : std::nullopt;
}

/// Decides the refinement of a process that diverges at once: every process refines it. Only the first step of the
/// implementation is computed, in order to detect evaluation errors.
std::optional<Violation> refined_by(lts::TransitionSystem& implementation, Budget& budget) {
    (void)steps_from(implementation, initial_of(implementation), budget);
    return std::nullopt;
}

/// Describes the refinement that is checked.
struct RefinementQuestion {
    NormalForm& normal;
    Model model;
    Search::Pairs pairs;
    bool may_diverge;  ///< whether a divergence would be a violation and is not excluded
};

/// Returns the first fault of the implementation's runs with respect to the normal form.
std::optional<Violation> search_refinement(const RefinementQuestion& refinement, lts::TransitionSystem& implementation,
                                           Budget& budget, Statistics& statistics, const Violation* known) {
    const auto& [normal, model, pairs, may_diverge] = refinement;
    const bool with_divergence = known != nullptr ? known->kind == ViolationKind::divergence : may_diverge;
    const bool spec_may_diverge = known == nullptr && model == Model::failures_divergences;
    if (pairs == Search::Pairs::all) normal.refuse_growth();
    if (std::optional<LevelQuestion> question = refinement_by_levels(normal, model, pairs, budget)) {
        statistics.spec_nodes = question->specification->nodes.size();
        if (spec_may_diverge && question->specification->nodes.front().diverges)
            return refined_by(implementation, budget);
        question->divergence = with_divergence;
        question->events_until = events_until(known);
        return budget.limits().by_levels->search(implementation, *question, budget, statistics);
    }
    RefinementMonitor monitor(normal, model);
    Search search(implementation, monitor, budget, with_divergence, pairs);
    const Tally tally(search, statistics, &normal);
    if (spec_may_diverge && normal.diverges(normal.initial())) return refined_by(implementation, budget);
    const bool levels_count =
        pairs == Search::Pairs::all;  // in an antichain, a pair represents other pairs with possibly shorter runs
    return first_fault(search, implementation, known, levels_count, with_divergence, budget, statistics);
}

void decide_refinement(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Model model,
                       Search::Pairs pairs, Budget& budget, Verdict& verdict, Earlier earlier) {
    NormalForm normal(specification, budget);
    verdict.outcome = Outcome::holds;
    Indifference indifference(specification, model, budget);
    RefinementQuestion refinement{normal, model, pairs, false};
    SearchQuestion question{[&](lts::TransitionSystem& system, Budget& own, Statistics& size, const Violation* known) {
                                return search_refinement(refinement, system, own, size, known);
                            },
                            [&](const lts::EventPermutation& exchange) { return indifference.holds_for(exchange); }};
    const std::optional<Violation> violation = reuse_or_search(earlier, verdict, [&] {
        refinement.may_diverge = model == Model::failures_divergences && !is_tau_acyclic(implementation, budget);
        if (pairs == Search::Pairs::all)
            question.symbolic = SymbolicQuestion{false, refinement.may_diverge, &specification, model};
        return search_reduced(implementation, budget, verdict.statistics, question);
    });
    if (!violation) return;
    const auto judge = [&](lts::TransitionSystem& system, const Violation& shown, Budget& own) {
        const bool by_reference = &system == implementation.reference() && specification.reference() != nullptr;
        confirm_refinement_violation(by_reference ? *specification.reference() : specification, system, model, shown,
                                     own);
    };
    set_failure(verdict,
                violation_counterexample(normal, confirm_violation(implementation, *violation, budget, judge)));
}

std::optional<Violation> search_states(lts::TransitionSystem& system, bool forbid_deadlock, bool forbid_divergence,
                                       Budget& budget, Statistics& statistics, const Violation* known) {
    if (LevelStrategy* const by_levels = budget.limits().by_levels) {
        LevelQuestion question;
        if (forbid_deadlock) question.kind = LevelQuestion::Kind::deadlock;
        question.divergence = forbid_divergence;
        question.events_until = events_until(known);
        return by_levels->search(system, question, budget, statistics);
    }
    StateMonitor monitor(forbid_deadlock);
    Search search(system, monitor, budget, forbid_divergence);
    const Tally tally(search, statistics);
    return first_fault(search, system, known, forbid_deadlock, forbid_divergence, budget, statistics);
}

/// Searches for a deadlock, a divergence or both. If the rules exclude divergence, looks only for deadlocks. Deadlocks
/// do not depend on events, so all confluent steps may then be followed.
std::optional<Violation> find_bad_state(lts::TransitionSystem& system, bool forbid_deadlock, bool forbid_divergence,
                                        Budget& budget, Statistics& statistics) {
    const bool may_diverge = forbid_divergence && !is_tau_acyclic(system, budget);
    if (!forbid_deadlock && !may_diverge) {
        statistics.decided_by = DecidedBy::tau_acyclic;
        return std::nullopt;
    }
    const SearchQuestion question{
        [&](lts::TransitionSystem& searched, Budget& own, Statistics& size, const Violation* known) {
            return search_states(searched, forbid_deadlock, may_diverge, own, size, known);
        },
        [](const lts::EventPermutation&) { return true; }, true,
        may_diverge ? lts::Followed::taus : lts::Followed::steps, SymbolicQuestion{forbid_deadlock, may_diverge}};
    return search_reduced(system, budget, statistics, question);
}

void decide_states(lts::TransitionSystem& system, bool forbid_deadlock, bool forbid_divergence, Budget& budget,
                   Verdict& verdict, Earlier earlier) {
    verdict.outcome = Outcome::holds;
    const std::optional<Violation> violation = reuse_or_search(earlier, verdict, [&] {
        return find_bad_state(system, forbid_deadlock, forbid_divergence, budget, verdict.statistics);
    });
    if (!violation) return;
    set_failure(verdict,
                make_counterexample(confirm_violation(system, *violation, budget, confirm_property_violation)));
}

}  // namespace

Run run_of_prefix(lts::TransitionSystem& system, const std::vector<Event>& trace, std::size_t length, Budget& budget) {
    TraceMonitor monitor(trace, length);
    Search search(system, monitor, budget);
    return search.run_along(search.path_to(search.first_violation().value().pair));
}

Violation violation_of(Search& search, lts::TransitionSystem& system, const Finding& finding) {
    Violation violation{finding.kind, search.run_along(search.path_to(finding.pair)), {}, {}};
    if (finding.kind == ViolationKind::trace) {
        const std::vector<RunStep> steps = steps_from(system, search.state(finding.pair));
        const auto by_it = [&](const RunStep& step) { return step.event == finding.event; };
        const auto step = std::ranges::find_if(steps, by_it);
        if (step == steps.end()) throw std::logic_error("a forbidden event cannot be taken again");
        violation.run.steps.push_back(*step);
    }
    return violation;
}

std::optional<Violation> first_divergence(Search& search) {
    const std::optional<StateIndex> pair = search.first_tau_cycle();
    if (!pair) return std::nullopt;
    std::vector<StateIndex> loop = search.tau_cycle(*pair);
    loop.insert(loop.begin(), *pair);
    return Violation{
        ViolationKind::divergence, search.run_along(search.path_to(*pair)), search.run_along(loop, true), {}};
}

Verdict refines(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Model model,
                const Limits& limits, Earlier earlier) {
    return decide({&specification, &implementation}, limits, [&](Budget& budget, Verdict& verdict) {
        const auto decide_with = [&](Search::Pairs pairs) {
            decide_refinement(specification, implementation, model, pairs, budget, verdict, earlier);
        };
        try {
            decide_with(Search::Pairs::all);
        } catch (const SpecificationGrows&) {
            verdict.statistics = {};
            decide_with(Search::Pairs::antichain);
        }
    });
}

Verdict deadlock_free(lts::TransitionSystem& system, Model model, const Limits& limits, Earlier earlier) {
    return decide({&system}, limits, [&](Budget& budget, Verdict& verdict) {
        decide_states(system, true, model == Model::failures_divergences, budget, verdict, earlier);
    });
}

Verdict divergence_free(lts::TransitionSystem& system, const Limits& limits, Earlier earlier) {
    return decide({&system}, limits, [&](Budget& budget, Verdict& verdict) {
        decide_states(system, false, true, budget, verdict, earlier);
    });
}

}  // namespace robochart::refine
