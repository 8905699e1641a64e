// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/relations.hpp"

#include <algorithm>
#include <set>

#include "base/diagnostics/containers.hpp"
#include "checker/symbolic/order.hpp"

namespace robochart::symbolic {

using machine::Part;
using machine::Passage;
using machine::WholeRule;

LocalRelation::LocalRelation(std::vector<std::pair<Value, Value>> pairs) {
    diagnostics::sort_unique(pairs);
    for (const auto& [source, target] : pairs) {
        if (sources_.empty() || sources_.back() != source) {
            sources_.push_back(source);
            first_.push_back(targets_.size());
        }
        targets_.push_back(target);
    }
    first_.push_back(targets_.size());
}

std::span<const Value> LocalRelation::targets(Value value) const {
    const auto found = std::ranges::lower_bound(sources_, value);
    if (found == sources_.end() || *found != value) return {};
    const auto place = static_cast<std::size_t>(found - sources_.begin());
    return std::span(targets_).subspan(first_[place], first_[place + 1] - first_[place]);
}

bool LocalRelation::is_identity(Value domain) const {
    return sources_.size() == domain && targets_ == sources_;
}

std::vector<std::pair<Value, Value>> LocalRelation::pairs() const {
    std::vector<std::pair<Value, Value>> result;
    for (const Value source : sources_)
        for (const Value target : targets(source)) result.emplace_back(source, target);
    return result;
}

Variables make_variables(const machine::Supercombinator& combined, const std::vector<std::uint32_t>& order) {
    Variables variables;
    variables.level_of.resize(order.size());
    variables.slot_at.push_back(0);
    variables.domains.push_back(0);
    for (const std::uint32_t slot : order) {
        variables.level_of[slot] = static_cast<Level>(variables.slot_at.size());
        variables.slot_at.push_back(slot);
        // The last value means that the component is off.
        variables.domains.push_back(static_cast<Value>(combined.components[slot]->size()) + 1);
    }
    return variables;
}

Variables make_variables(const machine::Supercombinator& combined, const RegionRules& rules,
                         diagnostics::Pollable& budget) {
    std::vector<Value> domains;
    for (const machine::ComponentPtr& component : combined.components)
        domains.push_back(static_cast<Value>(component->size()));
    std::vector<std::vector<std::uint32_t>> groups;
    for (const WholeRule& rule : rules.back()) {
        budget.poll();
        std::vector<std::uint32_t>& group = groups.emplace_back();
        for (const Part& part : rule.parts) group.push_back(part.slot);
    }
    return make_variables(combined, order_variables(domains, groups, budget));
}

Relations::Relations(const machine::Supercombinator& combined, const RegionRules& rules, const Variables& variables,
                     Diagrams& diagrams, diagnostics::Pollable& budget)
    : combined_(combined), rules_(rules), variables_(variables), diagrams_(diagrams), budget_(budget) {
    for (const WholeRule& rule : rules_.back())
        steps_.push_back({chain_of(rule), diagrams_.keep_always(guard_of(rule, std::nullopt))});
}

Value Relations::value_of(std::uint32_t slot, machine::Local local) const {
    return std::min(local, static_cast<Value>(combined_.components[slot]->size()));
}

Level Relations::highest_level(Node set) const {
    return set <= everything ? 0 : diagrams_.level_of(set);
}

Level Relations::level_of(const Step& step) const {
    return std::max(level_of(step.chain), highest_level(step.guard));
}

/// Returns the relation on the variable of a part. If the part has an event, the component performs it. If the part
/// assigns a state, the component is then in this state.
std::uint32_t Relations::relation_of(const Part& part) {
    constexpr std::uint32_t none = 0xffffffffU;
    const auto key = std::tuple(part.slot, part.event.value_or(none), part.assigned.value_or(none));
    const auto [place, is_new] = relation_numbers_.try_emplace(key, static_cast<std::uint32_t>(relations_.size()));
    if (!is_new) return place->second;
    const machine::Component& component = *combined_.components[part.slot];
    std::vector<std::pair<Value, Value>> pairs;
    for (Value value = 0; value <= component.size(); ++value) {
        if (!part.event) {
            pairs.emplace_back(value, value_of(part.slot, *part.assigned));
            continue;
        }
        budget_.poll();
        for (const machine::Component::Edge& edge : component.edges(value, *part.event))
            pairs.emplace_back(value, value_of(part.slot, part.assigned.value_or(edge.target)));
    }
    relations_.emplace_back(std::move(pairs));
    return place->second;
}

Chain Relations::chain_of(const WholeRule& rule) {
    std::vector<std::pair<Level, std::uint32_t>> parts;
    for (const Part& part : rule.parts) parts.emplace_back(variables_.level_of[part.slot], relation_of(part));
    std::ranges::sort(parts);
    Chain chain = no_link;
    for (const auto& [level, relation] : parts) chain = chain_from({level, relation, chain});
    return chain;
}

/// Returns the number of the list that begins with this link.
Chain Relations::chain_from(const Link& link) {
    budget_.poll();
    const auto key = std::tuple(link.level, link.relation, link.next);
    const auto [place, is_new] = chain_numbers_.try_emplace(key, static_cast<Chain>(links_.size()));
    if (is_new) links_.push_back(link);
    return place->second;
}

Step Relations::extend(const Step& step, Level level, const LocalRelation& relation) {
    assert(level > level_of(step));
    const auto number = static_cast<std::uint32_t>(relations_.size());
    relations_.push_back(relation);
    return {chain_from({level, number, step.chain}), step.guard};
}

/// Returns the states in which no region except `except` prevents the rule.
Node Relations::guard_of(const WholeRule& rule, std::optional<std::uint32_t> except) {
    Diagrams::Kept guard(diagrams_, everything);
    for (const Passage& passage : rule.prevented) {
        if (passage.region == except) continue;
        const Node own = region_guard(passage.region, passage.level);
        const Level level = std::max(highest_level(guard.get()), highest_level(own));
        guard.set(diagrams_.lift(guard.get(), level));
        const Diagrams::Kept lifted(diagrams_, diagrams_.lift(own, level));
        guard.set(diagrams_.intersect(level, guard.get(), lifted.get()));
    }
    return strip(guard.get());
}

/// Returns the states in which no rule of the region with a level before `level` is possible. To decide whether such a
/// rule is possible, only the priorities of inner regions are considered. The region's own priorities can be ignored:
/// if they prevent the rule, another rule of a still lower level is possible.
Node Relations::region_guard(std::uint32_t region, std::uint32_t level) {
    if (const auto known = guards_.find({region, level}); known != guards_.end()) return known->second;
    std::vector<Step> better;
    for (const WholeRule& rule : rules_[region])
        if (rule.level < level) better.push_back({chain_of(rule), diagrams_.keep_always(guard_of(rule, region))});
    const Node guard = diagrams_.keep_always(none_possible(std::move(better)));
    guards_[{region, level}] = guard;
    return guard;
}

/// Removes the highest levels of a set, as far as the set does not depend on them.
Node Relations::strip(Node guard) const {
    while (guard > everything) {
        const Level level = diagrams_.level_of(guard);
        const std::size_t count = diagrams_.entry_count(level, guard);
        if (count < diagrams_.domain(level)) return guard;
        const Node first = diagrams_.entry(guard, 0).child;
        for (std::size_t i = 1; i < count; ++i)
            if (diagrams_.entry(guard, i).child != first) return guard;
        guard = first;
    }
    return guard;
}

/// Returns the states in which none of the steps is possible. The steps are applied in the order of their levels, the
/// lowest first, so that each step is applied to a set that has only the level of the step.
Node Relations::none_possible(std::vector<Step> steps) {
    std::ranges::sort(steps, [&](const Step& a, const Step& b) {
        const Level level_a = level_of(a), level_b = level_of(b);
        return level_a != level_b ? level_a < level_b : a < b;
    });
    diagnostics::erase_repeated(steps);
    Diagrams::Kept result(diagrams_, everything);
    for (const Step& step : steps) {
        budget_.poll();
        if (step.guard == nothing) continue;
        const Level level = level_of(step);
        if (level == 0) return nothing;
        result.set(diagrams_.lift(result.get(), level));
        result.set(disable(level, result.get(), step.chain, step.guard));
        if (result.get() == nothing) return nothing;
    }
    return strip(result.get());
}

/// Returns the states of this set in which the step is not possible.
Node Relations::disable(Level level, Node states, Chain chain, Node guard) {
    if (states == nothing || guard == nothing) return states;
    if (chain == no_link && guard == everything) return nothing;
    Node result = nothing;
    if (diagrams_.find_result(Diagrams::Operation::disable, level, states, chain, guard, result)) return result;
    const bool here = level_of(chain) == level;
    const std::size_t begun = diagrams_.begin_node();
    for (std::size_t i = 0; i < diagrams_.entry_count(level, states); ++i) {
        const auto [value, child] = diagrams_.entry(states, i);
        if (here && relations_[links_[chain].relation].targets(value).empty())
            diagrams_.push(value, child);
        else
            diagrams_.push(
                value, disable(level - 1, child, here ? links_[chain].next : chain, guard_below(guard, level, value)));
    }
    result = diagrams_.end_node(level, begun);
    diagrams_.store_result(Diagrams::Operation::disable, level, states, chain, guard, result);
    return result;
}

/// Returns the states from which the step can lead into `states`.
Node Relations::precede(Level level, Node states, Chain chain, Node guard) {
    if (states == nothing || guard == nothing) return nothing;
    if (chain == no_link && guard == everything) return states;
    Node result = nothing;
    if (diagrams_.find_result(Diagrams::Operation::precede, level, states, chain, guard, result)) return result;
    const std::size_t begun = diagrams_.begin_node();
    if (level_of(chain) == level) {
        const Link link = links_[chain];
        for (const Value value : relations_[link.relation].sources()) {
            Diagrams::Kept sum(diagrams_, nothing);
            for (const Value target : relations_[link.relation].targets(value)) {
                const Diagrams::Kept more(diagrams_, precede(level - 1, diagrams_.child(states, target), link.next,
                                                             guard_below(guard, level, value)));
                sum.set(diagrams_.unite(level - 1, sum.get(), more.get()));
            }
            diagrams_.push(value, sum.get());
        }
    } else {
        for (std::size_t i = 0; i < diagrams_.entry_count(level, states); ++i) {
            const auto [value, child] = diagrams_.entry(states, i);
            diagrams_.push(value, precede(level - 1, child, chain, guard_below(guard, level, value)));
        }
    }
    result = diagrams_.end_node(level, begun);
    diagrams_.store_result(Diagrams::Operation::precede, level, states, chain, guard, result);
    return result;
}

}  // namespace robochart::symbolic
