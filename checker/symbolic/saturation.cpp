// SPDX-License-Identifier: Apache-2.0
#include "checker/symbolic/saturation.hpp"

#include <algorithm>
#include <map>

#include "base/diagnostics/containers.hpp"

namespace robochart::symbolic {

Saturation::Saturation(const Relations& relations, const std::vector<Step>& steps, Diagrams& diagrams,
                       diagnostics::Pollable& budget)
    : relations_(relations),
      diagrams_(diagrams),
      rows_(diagrams.levels() + std::size_t{1}),
      steps_(diagrams.levels() + std::size_t{1}) {
    for (Level level = 1; level <= diagrams_.levels(); ++level) {
        rows_[level].children.resize(diagrams_.domain(level), nothing);
        rows_[level].waits.resize(diagrams_.domain(level));
    }
    list_steps(steps, budget);
    diagrams_.set_users([this](std::vector<Node>& used) {
        for (const Row& row : rows_)
            for (const Value value : row.values) used.push_back(row.children[value]);
    });
}

void Saturation::list_steps(const std::vector<Step>& steps, diagnostics::Pollable& budget) {
    constexpr std::uint32_t unchanged = 0xffffffffU;  // the step does not change this variable; only its guard reads it
    std::map<std::tuple<Level, Chain, Node>, std::vector<std::uint32_t>> groups;
    for (const Step& step : steps) {
        budget.poll();
        const Level level = relations_.level_of(step);
        if (level == 0 || step.guard == nothing) continue;
        const bool changes = relations_.level_of(step.chain) == level;
        const Chain rest = changes ? relations_.link(step.chain).next : step.chain;
        groups[{level, rest, step.guard}].push_back(changes ? relations_.link(step.chain).relation : unchanged);
    }
    for (auto& [key, locals] : groups) {
        const auto [level, rest, guard] = key;
        diagnostics::sort_unique(locals);
        std::vector<std::pair<Value, Value>> pairs;
        for (const std::uint32_t local : locals) {
            if (local == unchanged) {
                for (Value value = 0; value < diagrams_.domain(level); ++value) pairs.emplace_back(value, value);
            } else {
                budget.poll();
                const auto more = relations_.relation(local).pairs();
                pairs.insert(pairs.end(), more.begin(), more.end());
            }
        }
        steps_[level].push_back({LocalRelation(std::move(pairs)), rest, guard});
    }
}

Node Saturation::reachable(const std::vector<Value>& initial) {
    Diagrams::Kept states(diagrams_, everything);
    for (Level level = 1; level <= diagrams_.levels(); ++level) {
        clear(level);
        add(level, initial[level], states.get());
        states.set(saturate(level));
    }
    for (Level level = 1; level <= diagrams_.levels(); ++level) clear(level);
    return states.get();
}

void Saturation::clear(Level level) {
    for (const Value value : rows_[level].values) rows_[level].children[value] = nothing;
    rows_[level].values.clear();
}

/// Adds tuples to a child. The caller must keep `more`. Returns true if this has changed the child.
bool Saturation::add(Level level, Value value, Node more) {
    Row& row = rows_[level];
    const Node before = row.children[value];
    if (more == nothing) return false;
    if (before == nothing) {
        row.values.push_back(value);
        row.children[value] = more;
        return true;
    }
    row.children[value] = diagrams_.unite(level - 1, before, more);
    return row.children[value] != before;
}

Node Saturation::pack(Level level) {
    Row& row = rows_[level];
    std::ranges::sort(row.values);
    const std::size_t begun = diagrams_.begin_node();
    for (const Value value : row.values) diagrams_.push(value, row.children[value]);
    return diagrams_.end_node(level, begun);
}

/// Saturates the row of a level. Its children must already be saturated.
Node Saturation::saturate(Level level) {
    const Diagrams::Kept before(diagrams_, pack(level));
    Node result = nothing;
    if (diagrams_.find_result(Diagrams::Operation::saturate, level, before.get(), 0, 0, result)) return result;
    Row& row = rows_[level];
    std::deque<Value> queue(row.values.begin(), row.values.end());
    for (const Value value : queue) row.waits[value] = true;
    while (!queue.empty()) {
        const Value value = queue.front();
        queue.pop_front();
        row.waits[value] = false;
        fire_steps(level, value, queue);
    }
    result = pack(level);
    diagrams_.store_result(Diagrams::Operation::saturate, level, before.get(), 0, 0, result);
    return result;
}

/// Fires the steps whose highest level is this level, from the states with this value of its variable.
void Saturation::fire_steps(Level level, Value value, std::deque<Value>& queue) {
    Row& row = rows_[level];
    for (const TopSteps& step : steps_[level]) {
        const std::span<const Value> targets = step.local.targets(value);
        if (targets.empty()) continue;
        const Node guard = relations_.guard_below(step.guard, level, value);
        const Diagrams::Kept reached(diagrams_, fire(level - 1, row.children[value], step.rest, guard));
        for (const Value target : targets) {
            if (!add(level, target, reached.get()) || row.waits[target]) continue;
            row.waits[target] = true;
            queue.push_back(target);
        }
    }
}

/// Applies the lower part of a step to a set. Returns the states that it reaches, as a saturated set.
Node Saturation::fire(Level level, Node states, Chain chain, Node guard) {
    if (states == nothing || guard == nothing) return nothing;
    if (chain == no_link && guard == everything) return states;
    Node result = nothing;
    if (diagrams_.find_result(Diagrams::Operation::fire, level, states, chain, guard, result)) return result;
    clear(level);
    const bool here = relations_.level_of(chain) == level;
    const Chain rest = here ? relations_.link(chain).next : chain;
    for (std::size_t i = 0; i < diagrams_.entry_count(level, states); ++i) {
        const auto [value, child] = diagrams_.entry(states, i);
        const std::span<const Value> targets =
            here ? relations_.relation(relations_.link(chain).relation).targets(value) : std::span<const Value>();
        if (here && targets.empty()) continue;
        const Diagrams::Kept reached(diagrams_,
                                     fire(level - 1, child, rest, relations_.guard_below(guard, level, value)));
        if (!here) add(level, value, reached.get());
        for (const Value target : targets) add(level, target, reached.get());
    }
    result = rows_[level].values.empty() ? nothing : saturate(level);
    diagrams_.store_result(Diagrams::Operation::fire, level, states, chain, guard, result);
    return result;
}

}  // namespace robochart::symbolic
