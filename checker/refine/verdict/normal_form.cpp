// SPDX-License-Identifier: Apache-2.0
// Normalises on demand. Nodes and states are numbered in the order in which the search requests them, so results are
// the same every time.
#include "checker/refine/verdict/normal_form.hpp"

#include <algorithm>
#include <cassert>
#include <limits>
#include <utility>

#include "base/diagnostics/containers.hpp"

namespace robochart::refine {

using lts::StateIndex;
using process::Event;
using process::EventSet;

namespace {

constexpr std::size_t few_nodes = 256;
constexpr NormalForm::Node unresolved = std::numeric_limits<NormalForm::Node>::max();

}  // namespace

std::size_t NormalForm::Hash::operator()(const Members& members) const {
    std::uint64_t hash = members.size();
    for (StateIndex member : members) {
        hash = (hash ^ member) * 0x9E3779B97F4A7C15ULL;
        hash ^= hash >> 29U;
    }
    return static_cast<std::size_t>(hash);
}

NormalForm::NormalForm(lts::TransitionSystem& specification, Budget& budget)
    : graph_(specification, budget), budget_(budget) {}

NormalForm::Node NormalForm::initial() {
    return node_of({graph_.initial()});
}

NormalForm::Node NormalForm::node_of(Members seeds) {
    close_under_tau(seeds);
    if (const auto known = ids_.find(seeds); known != ids_.end()) return known->second;
    // The limit is checked before the node is entered. Otherwise another thread could use the number of a node that
    // does not exist.
    budget_.states(nodes_.size());
    if (!may_grow_ && nodes_.size() > std::max(few_nodes, 2 * graph_.size()))
        throw SpecificationGrows("the specification's normal form is larger than the specification");
    assert(ids_.size() == nodes_.size());
    const Node node = static_cast<Node>(nodes_.size());
    NodeData& data = nodes_.emplace_back();
    data.members = &ids_.emplace(std::move(seeds), node).first->first;
    return node;
}

/// Adds the states that taus reach, and sorts all states.
void NormalForm::close_under_tau(Members& members) {
    ++closure_;
    const auto first_visit = [this](StateIndex state) {
        if (state >= mark_.size()) mark_.resize(state + 1U, 0);
        return std::exchange(mark_[state], closure_) != closure_;
    };
    std::erase_if(members, [&](StateIndex state) { return !first_visit(state); });
    for (std::size_t next = 0; next < members.size(); ++next)
        for (const ChoiceGraph::Edge& edge : graph_.edges(members[next], process::tau))
            if (first_visit(edge.target)) members.push_back(edge.target);
    std::ranges::sort(members);
    assert(std::ranges::adjacent_find(members) == members.end());
}

std::vector<NormalForm::Arc>& NormalForm::arcs_of(Node node) {
    NodeData& data = nodes_[node];
    if (data.arcs) return *data.arcs;
    std::vector<Event> events;
    for (StateIndex member : *data.members)
        for (const ChoiceGraph::Edge& edge : graph_.edges(member))
            if (edge.event != process::tau && (events.empty() || events.back() != edge.event))
                events.push_back(edge.event);
    diagnostics::sort_unique(events);
    data.arcs.emplace();
    for (Event event : events) data.arcs->push_back({event, unresolved});
    return *data.arcs;
}

std::optional<NormalForm::Node> NormalForm::node_after(Node node, Event event) {
    std::vector<Arc>& known = arcs_of(node);
    const auto arc = std::ranges::lower_bound(known, event, {}, &Arc::event);
    if (arc == known.end() || arc->event != event) return std::nullopt;
    if (arc->target == unresolved) {
        Members targets;
        for (StateIndex member : *nodes_[node].members)
            for (const ChoiceGraph::Edge& edge : graph_.edges(member, event)) targets.push_back(edge.target);
        arc->target = node_of(std::move(targets));
    }
    return arc->target;
}

std::vector<lts::StateView> NormalForm::states(Node node) const {
    std::vector<lts::StateView> result;
    for (const StateIndex member : *nodes_[node].members) result.push_back(graph_.state(member));
    return result;
}

EventSet NormalForm::initials(Node node) {
    EventSet events;
    for (const Arc& arc : arcs_of(node)) events.push_back(arc.event);
    return events;
}

bool NormalForm::includes(Node larger, Node smaller) const {
    const Members& all = *nodes_[larger].members;
    const Members& some = *nodes_[smaller].members;
    return some.size() <= all.size() && std::ranges::includes(all, some);
}

const std::vector<EventSet>& NormalForm::acceptances(Node node) {
    NodeData& data = nodes_[node];
    if (data.acceptances) return *data.acceptances;
    std::vector<EventSet> all;
    for (StateIndex member : *data.members)
        for (EventSet& own : graph_.acceptances(member)) all.push_back(std::move(own));
    data.acceptances = minimal_sets(std::move(all), budget_);
    return *data.acceptances;
}

bool NormalForm::diverges(Node node) {
    NodeData& data = nodes_[node];
    if (!data.diverges)
        data.diverges =
            std::ranges::any_of(*data.members, [this](StateIndex member) { return state_diverges(member); });
    return *data.diverges;
}

/// Returns true if taus lead from the state into a cycle of taus. All calls share one depth-first search. A state is
/// finished when the search leaves it. If it has reached neither the current path nor a divergent state, it reaches
/// only finished states of this kind, so its answer is final.
bool NormalForm::state_diverges(StateIndex root) {
    enum : std::uint8_t { unvisited, on_path, finite, infinite };
    struct Frame {
        StateIndex state;
        std::uint32_t next;
    };
    const auto status = [this](StateIndex state) -> std::uint8_t& {
        if (state >= divergence_.size()) divergence_.resize(state + 1U, unvisited);
        return divergence_[state];
    };
    if (status(root) != unvisited) return status(root) == infinite;
    std::vector<Frame> path{{root, 0}};
    status(root) = on_path;
    bool found = false;  // true if everything on the path diverges
    while (!path.empty()) {
        Frame& top = path.back();
        const std::span<const ChoiceGraph::Edge> taus = graph_.taus_or_operands(top.state);
        if (found || top.next == taus.size()) {
            status(top.state) = found ? infinite : finite;
            path.pop_back();
            continue;
        }
        const StateIndex target = taus[top.next++].target;
        const std::uint8_t reached = status(target);
        found = reached == on_path || reached == infinite;
        if (reached == unvisited) {
            status(target) = on_path;
            path.push_back({target, 0});
        }
    }
    assert(status(root) == finite || status(root) == infinite);
    return status(root) == infinite;
}

}  // namespace robochart::refine
