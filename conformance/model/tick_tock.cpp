// SPDX-License-Identifier: Apache-2.0
// See tick_tock.hpp. The search is breadth-first over pairs: a state of the implementation, and the set of states that
// the specification may have reached after the same observation, including refusals before tocks. Only the largest
// refusal of each state is followed, because the model is closed under smaller refusals (its healthiness condition
// TT1).
#include "conformance/model/tick_tock.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/diagnostics/containers.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/normal_form.hpp"

namespace robochart::conformance {

namespace {

using lts::StateIndex;
using process::Event;
using process::EventSet;
using Members = std::vector<StateIndex>;
using SetNumber = std::uint32_t;

/// Numbers sets of states that the specification may have reached. The sets are closed under τ.
class Sets {
public:
    Sets(lts::TransitionSystem& system, refine::Budget& budget, Event tock)
        : graph_(system, budget), budget_(budget), tock_(tock) {}

    SetNumber initial_set() { return tau_closure({graph_.initial()}); }
    /// Returns the set after an event other than tock; empty if the specification does not have the event.
    SetNumber set_after(SetNumber set, Event event) {
        Members next;
        for (const StateIndex state : Members(set_members(set)))
            for (const auto& edge : graph_.edges(state, event)) next.push_back(edge.target);
        return tau_closure(next);
    }
    /// Returns the set after a tock. Only states that refuse every event outside `offered` take part.
    SetNumber after_tock(SetNumber set, const EventSet& offered) {
        Members next;
        for (const StateIndex state : Members(set_members(set))) {
            const refine::Offer offer = graph_.state_offer(state);
            if (offer.tau || offer.can_tick() || !is_subset(offer.events, offered)) continue;
            for (const auto& edge : graph_.edges(state, tock_)) next.push_back(edge.target);
        }
        return tau_closure(next);
    }
    /// Returns whether some state refuses everything except `offered`.
    bool refuses(SetNumber set, const EventSet& offered) {
        for (const EventSet& accepted : acceptances(set))
            if (is_subset(accepted, offered)) return true;
        return false;
    }
    std::vector<EventSet> acceptances(SetNumber set) {
        std::vector<EventSet> all;
        for (const StateIndex state : Members(set_members(set)))
            if (auto accepted = refine::acceptance(graph_.state_offer(state))) all.push_back(std::move(*accepted));
        diagnostics::sort_unique(all);
        return all;
    }
    /// Returns the initial events of the specification, including tocks that maximal progress allows.
    EventSet initial_events(SetNumber set) {
        EventSet all;
        for (const StateIndex state : Members(set_members(set))) {
            const refine::Offer offer = graph_.state_offer(state);
            for (const Event event : offer.events)
                if (event != tock_ || (!offer.tau && !offer.can_tick())) all.push_back(event);
        }
        diagnostics::sort_unique(all);
        return all;
    }
    [[nodiscard]] bool empty(SetNumber set) const { return set_members(set).empty(); }
    [[nodiscard]] std::size_t size() const { return sets_.size(); }

private:
    static bool is_subset(const EventSet& small, const EventSet& large) { return std::ranges::includes(large, small); }
    [[nodiscard]] const Members& set_members(SetNumber set) const { return *sets_[set]; }

    void add_state(Members& states, StateIndex state) {
        if (mark_.size() <= state) mark_.resize(state + 1);
        if (mark_[state] == round_) return;
        mark_[state] = round_;
        states.push_back(state);
    }

    /// Returns the states reachable by τ from the seeds.
    SetNumber tau_closure(const Members& seeds) {
        ++round_;
        Members states;
        for (const StateIndex state : seeds) add_state(states, state);
        for (std::size_t at = 0; at < states.size(); ++at) {
            for (const auto& edge : graph_.edges(states[at], process::tau)) add_state(states, edge.target);
            budget_.charge();
        }
        std::ranges::sort(states);
        const auto [place, fresh] = ids_.emplace(std::move(states), static_cast<SetNumber>(sets_.size()));
        if (fresh) sets_.push_back(&place->first);
        return place->second;
    }

    refine::LazyGraph graph_;
    refine::Budget& budget_;
    Event tock_;
    std::map<Members, SetNumber> ids_;
    std::vector<const Members*> sets_;
    std::vector<std::uint32_t> mark_;  ///< by state: the round in which it was last added
    std::uint32_t round_ = 0;
};

class Search {
public:
    Search(lts::TransitionSystem& specification, lts::TransitionSystem& implementation, Event tock,
           const refine::Limits& limits)
        : budget_(limits),
          sets_(specification, budget_, tock),
          system_(implementation),
          graph_(implementation, budget_),
          tock_(tock) {}

    refine::Verdict run() {
        try {
            add_pair({graph_.initial(), sets_.initial_set()}, 0, process::tau);
            for (std::size_t at = 0; at < pairs_.size() && !found_; ++at) expand_pair(at);
            verdict_.outcome = found_ ? refine::Outcome::fails : refine::Outcome::holds;
        } catch (const process::Interrupted& limit) {
            verdict_.reason = limit.what();
        }
        refine::Statistics& statistics = verdict_.statistics;
        statistics.states = pairs_.size();
        statistics.transitions = transitions_;
        statistics.depth = depth_;
        statistics.spec_nodes = sets_.size();
        statistics.seconds = budget_.seconds();
        return std::move(verdict_);
    }

private:
    struct Pair {
        StateIndex state;
        SetNumber set;
    };
    struct Origin {
        std::size_t parent;
        Event event;
        std::uint64_t depth;
    };

    void add_pair(Pair pair, std::size_t parent, Event event) {
        const std::uint64_t key = (std::uint64_t{pair.set} << 32U) | static_cast<std::uint32_t>(pair.state);
        if (!known_.emplace(key, pairs_.size()).second) return;
        const std::uint64_t depth = origins_.empty() ? 0 : origins_[parent].depth + 1;
        depth_ = std::max(depth_, depth);
        pairs_.push_back(pair);
        origins_.push_back({parent, event, depth});
        budget_.states(pairs_.size());
    }

    void expand_pair(std::size_t at) {
        const Pair pair = pairs_[at];
        const refine::Offer offer = graph_.state_offer(pair.state);
        const auto accepted = refine::acceptance(offer);
        if (accepted && !sets_.refuses(pair.set, *accepted)) return report_refusal(at, *accepted);
        const std::span<const refine::LazyGraph::Edge> now = graph_.edges(pair.state);
        for (const auto& edge : std::vector<refine::LazyGraph::Edge>(now.begin(), now.end())) {
            ++transitions_;
            const bool waits = edge.event == tock_;
            if (waits && (offer.tau || offer.can_tick())) continue;  // maximal progress
            SetNumber next = pair.set;
            if (edge.event != process::tau)
                next = waits ? sets_.after_tock(pair.set, offer.events) : sets_.set_after(pair.set, edge.event);
            if (sets_.empty(next)) return report_forbidden_event(at, edge);
            add_pair({edge.target, next}, at, edge.event);
        }
    }

    void report_refusal(std::size_t at, const EventSet& accepted) {
        refine::Counterexample& found = start_counterexample(at);
        found.kind = refine::ViolationKind::refusal;
        found.offered = accepted;
        found.required = sets_.acceptances(pairs_[at].set);
    }

    void report_forbidden_event(std::size_t at, const refine::LazyGraph::Edge& edge) {
        refine::Counterexample& found = start_counterexample(at);
        found.kind = refine::ViolationKind::trace;
        found.event = edge.event;
        found.required = {sets_.initial_events(pairs_[at].set)};
        found.steps.push_back({edge.event, edge.event, system_.describe(graph_.state(edge.target))});
    }

    refine::Counterexample& start_counterexample(std::size_t at) {
        found_ = true;
        refine::Counterexample& found = verdict_.counterexample.emplace();
        for (; at != 0; at = origins_[at].parent)
            found.steps.push_back(
                {origins_[at].event, origins_[at].event, system_.describe(graph_.state(pairs_[at].state))});
        std::ranges::reverse(found.steps);
        found.initial = system_.describe(graph_.state(pairs_.front().state));
        return found;
    }

    refine::Budget budget_;
    Sets sets_;
    lts::TransitionSystem& system_;
    refine::LazyGraph graph_;
    Event tock_;
    std::unordered_map<std::uint64_t, std::size_t> known_;  ///< never iterated
    std::vector<Pair> pairs_;
    std::vector<Origin> origins_;
    std::uint64_t transitions_ = 0, depth_ = 0;
    bool found_ = false;
    refine::Verdict verdict_;
};

}  // namespace

refine::Verdict tick_tock_refines(lts::TransitionSystem& specification, lts::TransitionSystem& implementation,
                                  process::Event tock, const refine::Limits& limits) {
    return Search(specification, implementation, tock, limits).run();
}

}  // namespace robochart::conformance
