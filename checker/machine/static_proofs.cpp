// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/static_proofs.hpp"

#include <algorithm>
#include <numeric>
#include <set>

#include "checker/lts/strong_components.hpp"

namespace robochart::machine {

using process::tau;

namespace {

/// The graph of one component. Its vertices are the states and "off". It has an edge for each way in which a remaining
/// rule changes the state. A rule that sets the state without an event of the component can do so in every state. So
/// that the number of edges stays linear, another vertex represents "any state": every state has an edge to it, and the
/// edges of such rules start there.
class LocalGraph {
public:
    LocalGraph(const Component& component, const std::vector<const Part*>& parts)
        : component_(component),
          performed_(component.alphabet().size()),
          set_after_(component.alphabet().size()),
          number_of_(component.size() + 2) {
        for (const Part* part : parts) {
            if (!part->event)
                set_anywhere_.push_back(vertex_of(*part->assigned));
            else if (part->assigned)
                set_after_[*part->event].push_back(vertex_of(*part->assigned));
            else
                performed_[*part->event] = 1;
        }
        find_components();
        find_performed_on_cycles();
    }

    /// Returns true if this part of a rule causes an edge on a cycle.
    [[nodiscard]] bool is_on_cycle(const Part& part) const {
        if (!part.event) return true;  // after the rule has set the state, it can set the same state again
        if (!part.assigned) return on_cycle_[*part.event] != 0;
        const lts::StateIndex target = vertex_of(*part.assigned);
        for (Local local = 0; local < component_.size(); ++local)
            if (number_of_[local] == number_of_[target] && !component_.edges(local, *part.event).empty()) return true;
        return false;
    }

private:
    [[nodiscard]] lts::StateIndex off() const { return static_cast<lts::StateIndex>(component_.size()); }
    [[nodiscard]] lts::StateIndex anywhere() const { return off() + 1; }
    [[nodiscard]] lts::StateIndex vertex_of(Local local) const { return std::min<lts::StateIndex>(local, off()); }

    void add_successors(lts::StateIndex vertex, std::vector<lts::StateIndex>& targets) const {
        if (vertex == anywhere()) {
            targets.insert(targets.end(), set_anywhere_.begin(), set_anywhere_.end());
            return;
        }
        if (!set_anywhere_.empty()) targets.push_back(anywhere());
        for (const Component::Edge& edge : component_.edges(vertex)) {
            if (performed_[edge.event] != 0) targets.push_back(edge.target);
            targets.insert(targets.end(), set_after_[edge.event].begin(), set_after_[edge.event].end());
        }
    }

    void find_components() {
        const lts::GraphView graph{
            number_of_.size(),
            [this](lts::StateIndex vertex, std::vector<lts::StateIndex>& targets) { add_successors(vertex, targets); }};
        std::vector<lts::StateIndex> roots(number_of_.size());
        std::iota(roots.begin(), roots.end(), lts::StateIndex{0});
        std::uint32_t next = 0;
        lts::strong_components(graph, roots, [&](std::span<const lts::StateIndex> members, bool /*cyclic*/) {
            for (const lts::StateIndex member : members) number_of_[member] = next;
            ++next;
        });
    }

    void find_performed_on_cycles() {
        on_cycle_.resize(performed_.size());
        for (Local local = 0; local < component_.size(); ++local)
            for (const Component::Edge& edge : component_.edges(local))
                if (performed_[edge.event] != 0 && number_of_[local] == number_of_[edge.target])
                    on_cycle_[edge.event] = 1;
    }

    const Component& component_;
    std::vector<char> performed_;                          // by event: whether a rule performs it and assigns no state
    std::vector<std::vector<lts::StateIndex>> set_after_;  // by event: states that rules set after it
    std::vector<lts::StateIndex> set_anywhere_;            // states that rules set in any state
    std::vector<std::uint32_t> number_of_;                 // by vertex: the number of its strong component
    std::vector<char> on_cycle_;                           // by event: whether performing it may lie on a cycle
};

/// Removes rules until each part of each remaining rule is on a cycle of its component's graph.
class CycleRules {
public:
    CycleRules(const Supercombinator& combined, const WholeRules& rules, diagnostics::Pollable& budget)
        : combined_(combined), rules_(rules), budget_(budget), of_slot_(combined.components.size()) {
        for (std::uint32_t number = 0; number < rules.rules.size(); ++number) {
            left_.push_back(rules.rules[number].event == tau);
            if (!left_.back()) continue;
            for (const Part& part : rules.rules[number].parts) of_slot_[part.slot].push_back(number);
        }
    }

    std::vector<bool> run() {
        std::set<std::uint32_t> open;
        for (std::uint32_t slot = 0; slot < of_slot_.size(); ++slot) open.insert(slot);
        while (!open.empty()) {
            const std::uint32_t slot = *open.begin();
            open.erase(open.begin());
            for (const std::uint32_t rule : remove_rules(slot))
                for (const Part& part : rules_.rules[rule].parts) open.insert(part.slot);
        }
        return std::move(left_);
    }

private:
    /// Removes the rules whose part in this component is on no cycle. Returns the removed rules.
    std::vector<std::uint32_t> remove_rules(std::uint32_t slot) {
        budget_.poll();
        std::vector<std::uint32_t>& rules = of_slot_[slot];
        std::erase_if(rules, [this](std::uint32_t rule) { return !left_[rule]; });
        std::vector<std::uint32_t> removed;
        if (rules.empty()) return removed;
        std::vector<const Part*> parts;
        for (const std::uint32_t rule : rules) parts.push_back(rules_.rules[rule].find_part(slot));
        const LocalGraph graph(*combined_.components[slot], parts);
        for (std::size_t i = 0; i < rules.size(); ++i) {
            if (graph.is_on_cycle(*parts[i])) continue;
            left_[rules[i]] = false;
            removed.push_back(rules[i]);
        }
        return removed;
    }

    const Supercombinator& combined_;
    const WholeRules& rules_;
    diagnostics::Pollable& budget_;
    std::vector<bool> left_;                           // by rule: whether it remains
    std::vector<std::vector<std::uint32_t>> of_slot_;  // by slot: the remaining rules with a part in it
};

/// Returns true if no state has two transitions with the event to different states.
bool is_deterministic(const Component& component, std::uint32_t event) {
    for (Local local = 0; local < component.size(); ++local) {
        const Component::Edges edges = component.edges(local, event);
        if (edges.size() > 1) return false;
    }
    return true;
}

}  // namespace

std::vector<bool> rules_on_tau_cycles(const Supercombinator& combined, const WholeRules& rules,
                                      diagnostics::Pollable& budget) {
    return CycleRules(combined, rules, budget).run();
}

bool exclude_choices(const Supercombinator& combined, const WholeRules& rules) {
    std::set<Event> events;
    for (const WholeRule& rule : rules.rules) {
        if (rule.event == tau || !events.insert(rule.event).second) return false;
        if (rule.event == process::tick && rules.rules.size() > 1) return false;
    }
    for (std::uint32_t slot = 0; slot < rules.asking.size(); ++slot)
        for (std::uint32_t event = 0; event < rules.asking[slot].size(); ++event)
            if (!rules.asking[slot][event].empty() && !is_deterministic(*combined.components[slot], event))
                return false;
    return true;
}

}  // namespace robochart::machine
