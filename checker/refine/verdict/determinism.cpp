// SPDX-License-Identifier: Apache-2.0
// Decides determinism by its definition (UCS 10.5): P is deterministic if it is divergence free [FD only] and there are
// no trace s and event a such that s^<a> is a trace of P and P can refuse {a} after s. The decision takes up to three
// steps:
//   * If no visited state has a tau or two transitions with the same event, P is deterministic.
//   * Otherwise FDR's method is used (Lazic's; UCS 10.5 and 20). A process P' resolves every choice of P by the first
//     transition. It is a deterministic process whose nodes are single states of P, and P is deterministic iff P
//     refines P'. The reason is as follows. Let s be a shortest trace after which P both accepts and refuses an event.
//     Before the end of s, all stable states agree. So P' has a stable state after s. Another state of P after s
//     contradicts it: it accepts an event that the state of P' refuses, or refuses an event that the state of P'
//     accepts.
//   * In F, if the resolution finds a divergence, the normal form is used: P is deterministic iff every acceptance of
//     every node contains all events that the node can perform. A divergent state contributes no acceptance.
#include <algorithm>
#include <stdexcept>

#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/counterexample.hpp"
#include "checker/refine/verdict/level_strategy.hpp"
#include "checker/refine/verdict/monitors.hpp"
#include "checker/refine/verdict/question.hpp"
#include "checker/refine/verdict/reduction.hpp"
#include "checker/refine/verdict/reference.hpp"

namespace robochart::refine {
namespace {

using process::Event;
using process::EventSet;

struct Ambiguity {
    std::vector<Event> trace;
    Event event;
};

/// Returns an event that is possible in this node and missing in some acceptance.
std::optional<Event> refusable_event(NormalForm& normal, NormalForm::Node node) {
    const EventSet initials = normal.initials(node);
    for (const EventSet& accepted : normal.acceptances(node))
        for (Event event : initials)
            if (!std::ranges::binary_search(accepted, event)) return event;
    return std::nullopt;
}

std::optional<Ambiguity> first_ambiguity(NormalForm& normal) {
    struct Arrival {
        NormalForm::Node from;
        Event event;
    };
    std::vector<Arrival> arrivals{
        {0, process::tau}};  // by node: how it was first reached, in the order of the nodes' numbers
    normal.initial();
    for (NormalForm::Node node = 0; node < arrivals.size(); ++node) {
        if (const std::optional<Event> event = refusable_event(normal, node)) {
            Ambiguity ambiguity{{}, *event};
            for (NormalForm::Node at = node; at != 0; at = arrivals[at].from)
                ambiguity.trace.push_back(arrivals[at].event);
            std::ranges::reverse(ambiguity.trace);
            return ambiguity;
        }
        for (Event event : normal.initials(node))
            if (normal.node_after(node, event).value() == arrivals.size()) arrivals.push_back({node, event});
    }
    return std::nullopt;
}

/// Returns the shortest run with the trace of the ambiguity to a state that can refuse the event of the ambiguity.
Violation refusing_run(lts::TransitionSystem& system, const Ambiguity& ambiguity, Budget& budget) {
    TraceMonitor monitor(ambiguity.trace, ambiguity.trace.size(), ambiguity.event);
    Search search(system, monitor, budget);
    Violation violation = violation_of(search, system, search.first_violation().value());
    violation.event = ambiguity.event;
    return violation;
}

std::optional<Violation> divergence_of(lts::TransitionSystem& system, Budget& budget, Statistics& statistics,
                                       const Violation* known) {
    if (LevelStrategy* const by_levels = budget.limits().by_levels) {
        LevelQuestion question;
        question.divergence = true;
        question.events_until = events_until(known);
        return by_levels->search(system, question, budget, statistics);
    }
    StateMonitor monitor(false);
    Search search(system, monitor, budget, true);
    const Tally tally(search, statistics);
    search.first_violation(events_until(known));
    return first_divergence(search);
}

/// Counts nodes while they are created and reports them, even if a limit ends the normalisation.
class Normalising {
public:
    Normalising(const NormalForm& normal, Budget& budget, Statistics& statistics)
        : normal_(normal), budget_(budget), statistics_(statistics) {
        budget_.report_by([&normal](Progress& progress) { progress.states = normal.size(); });
    }
    Normalising(const Normalising&) = delete;
    Normalising& operator=(const Normalising&) = delete;
    ~Normalising() {
        budget_.report_by({});
        statistics_.spec_nodes = normal_.size();
        if (statistics_.states == 0) statistics_.states = normal_.size();
    }

private:
    const NormalForm& normal_;
    Budget& budget_;
    Statistics& statistics_;
};

bool leaves_no_choice(lts::TransitionSystem& system, Budget& budget, Statistics& statistics) {
    if (LevelStrategy* const by_levels = budget.limits().by_levels) {
        LevelQuestion question;
        question.kind = LevelQuestion::Kind::choice;
        return !by_levels->search(system, question, budget, statistics);
    }
    ChoiceMonitor monitor;
    Search search(system, monitor, budget);
    const Tally tally(search, statistics);
    return !search.first_violation();
}

/// Thrown if the resolution finds an infinite sequence of taus.
class Unresolved : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

/// The process P'. Its nodes are the states that are reached by following first taus as long as there are any.
/// Termination comes before any other event (stability.hpp).
class Resolution final : public Monitor {
public:
    Resolution(lts::TransitionSystem& system, Budget& budget) : graph_(system, budget) {}
    Node start() override { return node_after_taus(graph_.initial()); }
    Advance advance(Node node, Event event) override {
        const bool terminates = !graph_.edges(node, process::tick).empty();
        const auto edges = graph_.edges(node, event);
        if (edges.empty() || (terminates && event != process::tick)) return {Effect::violation};
        return {Effect::follow, node_after_taus(edges.front().target)};
    }
    std::optional<ViolationKind> examine(Node node, const Offer& offer) override {
        return refused_event(node, offer) ? std::optional(ViolationKind::nondeterminism) : std::nullopt;
    }
    /// Returns an event of the node that a state with this offer may refuse.
    std::optional<Event> refused_event(Node node, const Offer& offer) {
        const std::optional<EventSet> accepted = acceptance(offer);
        if (!accepted) return std::nullopt;
        const EventSet required = acceptance(graph_.state_offer(node)).value();
        for (Event event : required)
            if (!std::ranges::binary_search(*accepted, event)) return event;
        return std::nullopt;
    }

private:
    Node node_after_taus(lts::StateIndex state) {
        if (state < settled_.size() && settled_[state] != lts::no_state) return settled_[state];
        lts::StateIndex end = state;
        for (std::size_t steps = 0;; ++steps) {
            const auto taus = graph_.edges(end, process::tau);
            if (taus.empty()) break;
            const lts::StateIndex next = taus.front().target;
            if (!graph_.edges(end, process::tick).empty()) break;
            if (steps > graph_.size()) throw Unresolved("taus without end");
            end = next;
        }
        if (state >= settled_.size())
            settled_.resize(std::max<std::size_t>(state + 1U, 2 * settled_.size()), lts::no_state);
        return settled_[state] = end;
    }

    LazyGraph graph_;
    std::vector<lts::StateIndex> settled_;
};

/// Finds a trace after which P performs an event that P' does not perform, or refuses an event that P' performs.
std::optional<Ambiguity> against_resolution(lts::TransitionSystem& system, Budget& budget, Statistics& statistics) {
    Resolution resolution(system, budget);
    Search search(system, resolution, budget);
    const Tally tally(search, statistics);
    const std::optional<Finding> finding = search.first_violation();
    if (!finding) return std::nullopt;
    const std::vector<Event> trace = search.run_along(search.path_to(finding->pair)).trace();
    if (finding->kind == ViolationKind::trace) return Ambiguity{trace, finding->event};
    const Offer offer = offer_of(steps_from(system, search.state(finding->pair)));
    return Ambiguity{trace, resolution.refused_event(search.node(finding->pair), offer).value()};
}

std::optional<Ambiguity> on_normal_form(lts::TransitionSystem& system, Budget& budget, Statistics& statistics) {
    NormalForm normal(system, budget);
    const Normalising normalising(normal, budget, statistics);
    return first_ambiguity(normal);
}

std::optional<Ambiguity> ambiguity_of(lts::TransitionSystem& system, Budget& budget, Statistics& statistics) {
    try {
        return against_resolution(system, budget, statistics);
    } catch (const Unresolved&) {
        return on_normal_form(system, budget, statistics);
    }
}

/// Returns true if the rules exclude every tau, and every choice between transitions with the same event.
bool is_choice_free(const lts::TransitionSystem& system, Budget& budget) {
    return budget.limits().reduction && system.excludes_choices(budget);
}

std::optional<Violation> search_choice(lts::TransitionSystem& system, bool may_diverge, Budget& budget,
                                       Statistics& statistics, const Violation* known) {
    if (known == nullptr && leaves_no_choice(system, budget, statistics)) return std::nullopt;
    statistics = {};
    std::optional<Violation> violation;
    if (known != nullptr) may_diverge = known->kind == ViolationKind::divergence;
    if (may_diverge) violation = divergence_of(system, budget, statistics, known);
    if (!violation)
        if (const std::optional<Ambiguity> ambiguity = ambiguity_of(system, budget, statistics))
            violation = refusing_run(system, *ambiguity, budget);
    return violation;
}

/// Adds a run that accepts the event. If a limit ends the search for this run, the verdict is reported without it.
void add_accepting_run(lts::TransitionSystem& system, const Violation& refusing, Budget& budget,
                       Counterexample& counterexample) {
    std::vector<Event> trace = refusing.run.trace();
    trace.push_back(refusing.event.value());
    const auto judge = [&](lts::TransitionSystem& judged, const Violation& shown, Budget& own) {
        confirm_trace(judged, trace, shown.run, own);
    };
    try {
        const Run run = run_of_prefix(system, trace, trace.size(), budget);
        tell_accepting(confirm_violation(system, {ViolationKind::no_trace, run, {}, {}}, budget, judge),
                       counterexample);
    } catch (const process::Interrupted&) {
        counterexample.accepting.clear();
    }
}

std::optional<Violation> find_choice(lts::TransitionSystem& system, Model model, Budget& budget,
                                     Statistics& statistics) {
    if (is_choice_free(system, budget)) {
        statistics.decided_by = DecidedBy::choice_free;
        return std::nullopt;
    }
    const bool may_diverge = model == Model::failures_divergences && !is_tau_acyclic(system, budget);
    const SearchQuestion question{
        [&](lts::TransitionSystem& searched, Budget& own, Statistics& size, const Violation* known) {
            return search_choice(searched, may_diverge, own, size, known);
        },
        // No symmetry may be used: a state and its image may have resolutions with different choices.
        [](const lts::EventPermutation&) { return false; }};
    return search_reduced(system, budget, statistics, question);
}

void decide_determinism(lts::TransitionSystem& system, Model model, Budget& budget, Verdict& verdict, Earlier earlier) {
    verdict.outcome = Outcome::holds;
    const std::optional<Violation> violation =
        reuse_or_search(earlier, verdict, [&] { return find_choice(system, model, budget, verdict.statistics); });
    if (!violation) return;
    const Confirmed refusing = confirm_violation(system, *violation, budget, confirm_property_violation);
    verdict.counterexample = make_counterexample(refusing);
    verdict.outcome = Outcome::fails;
    if (violation->kind == ViolationKind::nondeterminism)
        add_accepting_run(system, refusing.violation, budget, *verdict.counterexample);
}

}  // namespace

Verdict deterministic(lts::TransitionSystem& system, Model model, const Limits& limits, Earlier earlier) {
    return decide({&system}, limits, [&](Budget& budget, Verdict& verdict) {
        decide_determinism(system, model, budget, verdict, earlier);
    });
}

}  // namespace robochart::refine
