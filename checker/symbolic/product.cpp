// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/product.hpp"

#include <algorithm>

namespace robochart::symbolic {

using process::Event;
using process::EventSet;

Product::Product(const refine::NormalTable& table, const std::vector<machine::WholeRule>& rules, Relations& relations,
                 Diagrams& diagrams, diagnostics::Pollable& budget)
    : table_(table), relations_(relations), diagrams_(diagrams), budget_(budget) {
    for (std::size_t i = 0; i < rules.size(); ++i) by_event_[rules[i].event].push_back(relations.steps()[i]);
    for (const auto& [event, steps] : by_event_) {
        const LocalRelation relation = event == process::tau ? LocalRelation({}) : relation_of(event);
        const bool changes_node = event != process::tau && !relation.is_identity(diagrams.domain(diagrams.levels()));
        for (const Step& step : steps) {
            budget_.poll();
            steps_.push_back(changes_node ? relations.extend(step, diagrams.levels(), relation) : step);
        }
    }
}

/// Returns the relation from each node that allows the event to the node after the event. Leaves out nodes after which
/// the specification diverges.
LocalRelation Product::relation_of(Event event) const {
    std::vector<std::pair<Value, Value>> pairs;
    for (Value node = 0; node < table_.nodes.size(); ++node) {
        budget_.poll();
        const auto& arcs = table_.nodes[node].arcs;
        const auto arc = std::ranges::lower_bound(arcs, event, {}, &std::pair<Event, Value>::first);
        if (arc != arcs.end() && arc->first == event && !table_.nodes[arc->second].diverges)
            pairs.emplace_back(node, arc->second);
    }
    return LocalRelation(std::move(pairs));
}

/// Returns the states in which none of the steps is possible, as a set of the level below the node.
Node Product::none_possible(std::vector<Step> steps) {
    const Diagrams::Kept states(diagrams_, relations_.none_possible(std::move(steps)));
    return diagrams_.keep_always(diagrams_.lift(states.get(), diagrams_.levels() - 1));
}

Node Product::none_possible_of(const std::vector<Event>& events) {
    if (const auto known = not_possible_.find(events); known != not_possible_.end()) return known->second;
    std::vector<Step> steps;
    for (const Event event : events)
        if (const auto found = by_event_.find(event); found != by_event_.end())
            steps.insert(steps.end(), found->second.begin(), found->second.end());
    return not_possible_[events] = none_possible(std::move(steps));
}

/// Returns the events of the implementation's rules that the node does not allow.
std::vector<Event> Product::forbidden_events(Value node) const {
    std::vector<Event> events;
    const auto& arcs = table_.nodes[node].arcs;
    for (const auto& [event, steps] : by_event_)
        if (event != process::tau && !std::ranges::binary_search(arcs, event, {}, &std::pair<Event, Value>::first))
            events.push_back(event);
    return events;
}

Node Product::forbidden(Node pairs) {
    const Level top = diagrams_.levels();
    const std::size_t begun = diagrams_.begin_node();
    for (std::size_t i = 0; i < diagrams_.entry_count(top, pairs); ++i) {
        budget_.poll();
        const auto [node, states] = diagrams_.entry(pairs, i);
        diagrams_.push(node, diagrams_.subtract(top - 1, states, none_possible_of(forbidden_events(node))));
    }
    return diagrams_.end_node(top, begun);
}

Node Product::refusing(Node pairs) {
    const Level top = diagrams_.levels();
    const Node stable = none_possible_of({process::tau, process::tick});
    const Node without_tick = none_possible_of({process::tick});
    const std::size_t begun = diagrams_.begin_node();
    for (std::size_t i = 0; i < diagrams_.entry_count(top, pairs); ++i) {
        budget_.poll();
        const auto [node, states] = diagrams_.entry(pairs, i);
        diagrams_.push(node, refusing(table_.nodes[node].acceptances, states, stable, without_tick));
    }
    return diagrams_.end_node(top, begun);
}

/// Returns the states whose acceptance includes none of `acceptances`. A state with tick has the acceptance that
/// contains only tick, even if it also offers other events. A stable state accepts what it offers.
Node Product::refusing(const std::vector<EventSet>& acceptances, Node states, Node stable, Node without_tick) {
    const Level level = diagrams_.levels() - 1;
    const bool may_only_tick = std::ranges::any_of(
        acceptances, [](const EventSet& set) { return set.empty() || set == EventSet{process::tick}; });
    const Diagrams::Kept ticking(diagrams_, may_only_tick ? nothing : diagrams_.subtract(level, states, without_tick));
    Diagrams::Kept others(diagrams_, diagrams_.intersect(level, states, stable));
    for (const EventSet& acceptance : acceptances) others.set(lacking(acceptance, others.get()));
    return diagrams_.unite(level, ticking.get(), others.get());
}

/// Returns the states of this set in which some event of the acceptance is impossible. The caller must keep the set.
Node Product::lacking(const EventSet& acceptance, Node states) {
    const Level level = diagrams_.levels() - 1;
    Diagrams::Kept sum(diagrams_, nothing);
    for (const Event event : acceptance) {
        if (sum.get() == states) break;
        const Diagrams::Kept more(diagrams_, diagrams_.intersect(level, states, none_possible_of({event})));
        sum.set(diagrams_.unite(level, sum.get(), more.get()));
    }
    return sum.get();
}

}  // namespace robochart::symbolic
