// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/choice_graph.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <unordered_set>

namespace robochart::refine {

using lts::StateIndex;
using process::Event;
using process::EventSet;

namespace {

constexpr int most_nested = 100;  // maximal nesting of choices in operands of choices; limits the recursion

bool is_shorter(const EventSet& a, const EventSet& b) {
    return a.size() != b.size() ? a.size() < b.size() : a < b;
}

bool is_termination(const EventSet& acceptance) {
    return !acceptance.empty() && acceptance.front() == process::tick;
}

std::span<const LazyGraph::Edge> with_event(std::span<const LazyGraph::Edge> edges, Event event) {
    const auto first = std::ranges::lower_bound(edges, event, {}, &LazyGraph::Edge::event);
    const auto last =
        std::find_if(first, edges.end(), [&](const LazyGraph::Edge& edge) { return edge.event != event; });
    return {first, last};
}

void sort_without_duplicates(std::vector<LazyGraph::Edge>& edges) {
    const auto key = [](const LazyGraph::Edge& edge) { return std::pair(edge.event, edge.target); };
    std::ranges::sort(edges, {}, key);
    edges.erase(std::unique(edges.begin(), edges.end(), [&](const auto& a, const auto& b) { return key(a) == key(b); }),
                edges.end());
}

/// Forms the union of each of `sets` with each of `others`. Returns the minimal ones among these unions.
std::vector<EventSet> unions(const std::vector<EventSet>& sets, const std::vector<EventSet>& others, Budget& budget) {
    std::vector<EventSet> result;
    for (const EventSet& one : sets)
        for (const EventSet& other : others) {
            budget.charge();
            std::ranges::set_union(one, other, std::back_inserter(result.emplace_back()));
        }
    return minimal_sets(std::move(result), budget);
}

}  // namespace

std::vector<EventSet> minimal_sets(std::vector<EventSet> sets, Budget& budget) {
    std::ranges::sort(sets, is_shorter);
    sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
    std::vector<EventSet> minimal;
    for (EventSet& set : sets) {
        budget.charge();
        const bool contains_smaller =
            std::ranges::any_of(minimal, [&](const EventSet& smaller) { return std::ranges::includes(set, smaller); });
        if (!contains_smaller) minimal.push_back(std::move(set));
    }
    return minimal;
}

ChoiceGraph::Form& ChoiceGraph::form_of(StateIndex state) {
    if (state >= forms_.size()) forms_.resize(state + 1U, Form::unknown);
    return forms_[state];
}

/// Counts, during its lifetime, one more choice that is being examined.
class ChoiceGraph::Depth {
public:
    explicit Depth(int& depth) : depth_(depth) { ++depth_; }
    ~Depth() { --depth_; }
    Depth(const Depth&) = delete;
    Depth& operator=(const Depth&) = delete;

private:
    int& depth_;
};

/// Returns the data of a choice that is a single state (see choice_graph.hpp). Returns null if the state is no choice,
/// or if the choice is resolved like any other state. A choice is resolved if taus of its operands lead back to it,
/// because the operands cannot be examined before the choice itself.
ChoiceGraph::Whole* ChoiceGraph::whole_choice(StateIndex state) {
    if (form_of(state) == Form::being_examined) form_of(state) = Form::resolved;
    if (form_of(state) == Form::unknown) examine(state);
    return form_of(state) == Form::whole ? &wholes_.at(state) : nullptr;
}

void ChoiceGraph::examine(StateIndex state) {
    form_of(state) = Form::resolved;
    if (depth_ == most_nested || graph_.edges(state, process::tau).empty()) return;
    const std::vector<StateIndex> operands = graph_.choice_operands(state);
    if (operands.empty()) return;
    form_of(state) = Form::being_examined;
    const Depth depth(depth_);
    Whole whole;
    for (const StateIndex operand : operands) {
        whole.operands.push_back({process::tau, operand});
        whole.reached.push_back(tau_closure(operand));
    }
    if (form_of(state) == Form::resolved) return;
    for (const std::vector<StateIndex>& members : whole.reached)
        for (const StateIndex member : members) {
            std::ranges::copy_if(edges(member), std::back_inserter(whole.edges),
                                 [](const Edge& edge) { return edge.event != process::tau; });
            if (const Whole* const inner = whole_choice(member))
                whole.nesting = std::max(whole.nesting, 1 + inner->nesting);
        }
    if (whole.nesting > most_nested) {
        form_of(state) = Form::resolved;
        return;
    }
    sort_without_duplicates(whole.edges);
    wholes_.emplace(state, std::move(whole));
    form_of(state) = Form::whole;
}

std::vector<StateIndex> ChoiceGraph::tau_closure(StateIndex operand) {
    std::vector<StateIndex> members{operand};
    std::unordered_set<StateIndex> known{operand};
    for (std::size_t next = 0; next < members.size(); ++next)
        for (const Edge& edge : edges(members[next], process::tau))
            if (known.insert(edge.target).second) members.push_back(edge.target);
    return members;
}

/// Computes the acceptances of a choice by rule 3 at the head of choice_graph.hpp. The minimal acceptances of an
/// operand do not show whether it can tick, because another of its states may have the empty acceptance, which is a
/// part of {tick}.
std::vector<EventSet> ChoiceGraph::choice_acceptances(const Whole& whole) {
    std::vector<EventSet> joint{{}};
    for (const std::vector<StateIndex>& members : whole.reached) {
        std::vector<EventSet> own;
        for (const StateIndex member : members) std::ranges::move(acceptances(member), std::back_inserter(own));
        std::erase_if(own, is_termination);
        joint = unions(joint, minimal_sets(std::move(own), budget_), budget_);
    }
    if (!with_event(whole.edges, process::tick).empty()) joint.push_back({process::tick});
    return minimal_sets(std::move(joint), budget_);
}

std::span<const ChoiceGraph::Edge> ChoiceGraph::edges(StateIndex state) {
    const Whole* const whole = whole_choice(state);
    return whole != nullptr ? std::span<const Edge>(whole->edges) : graph_.edges(state);
}

std::span<const ChoiceGraph::Edge> ChoiceGraph::edges(StateIndex state, Event event) {
    return with_event(edges(state), event);
}

std::vector<EventSet> ChoiceGraph::acceptances(StateIndex state) {
    if (Whole* const whole = whole_choice(state)) {
        if (!whole->acceptances) whole->acceptances = choice_acceptances(*whole);
        return *whole->acceptances;
    }
    const std::optional<EventSet> own = acceptance(graph_.state_offer(state));
    return own ? std::vector<EventSet>{*own} : std::vector<EventSet>{};
}

std::span<const ChoiceGraph::Edge> ChoiceGraph::taus_or_operands(StateIndex state) {
    if (const Whole* const whole = whole_choice(state)) return whole->operands;
    return graph_.edges(state, process::tau);
}

}  // namespace robochart::refine
