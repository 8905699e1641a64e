// SPDX-License-Identifier: Apache-2.0
// Computes the coarsest stable partition of the states. All states of a block have the same signature: the set of the
// events of their transitions, each with the block of the target. For the branching equivalence, a tau inside the
// block is inert. Such a tau itself is not in the signature, but the signature of its target is. When states move to
// another block, the signatures of the states that lead to them are computed again, and their block is split. Its
// largest part keeps the block's number, so a state moves at most log n times. Parts are ordered by their first
// states.
#include "checker/lts/bisimulation.hpp"

#include <algorithm>
#include <cassert>
#include <deque>
#include <limits>
#include <unordered_map>
#include <utility>

#include "base/diagnostics/containers.hpp"
#include "checker/lts/tau_components.hpp"

namespace robochart::lts {
namespace {

using Block = std::uint32_t;
using Signature = std::vector<Edge>;  // the targets are blocks; ascending
using States = std::vector<StateIndex>;

/// In a signature, this target shows that the state can perform taus forever.
constexpr StateIndex endless = no_state;

/// States of one block that have the same signature.
struct Part {
    Signature signature;
    States states;
};

std::uint64_t hash_of(const Signature& signature) {
    std::uint64_t hash = signature.size();
    for (const Edge& edge : signature) {
        hash ^= std::uint64_t{edge.event} << 32U | edge.target;
        hash *= 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

/// The parts of a block, in the order in which they were added. Adding a part does not invalidate references to other
/// parts.
class Parts {
public:
    Part& with_signature(Signature signature) {
        const std::uint64_t hash = hash_of(signature);
        const auto [first, last] = by_hash_.equal_range(hash);
        for (auto entry = first; entry != last; ++entry)
            if (parts_[entry->second].signature == signature) return parts_[entry->second];
        by_hash_.emplace(hash, parts_.size());
        return parts_.emplace_back(Part{std::move(signature), {}});
    }
    [[nodiscard]] std::deque<Part>& list() { return parts_; }

private:
    std::deque<Part> parts_;
    std::unordered_multimap<std::uint64_t, std::size_t> by_hash_;  // only searched by key, so its order has no effect
};

/// Sorts edges by target and removes duplicates. The edges must already be sorted by event.
void sort_by_target(Signature& signature) {
    for (auto first = signature.begin(); first != signature.end();) {
        const auto last =
            std::find_if(first, signature.end(), [&](const Edge& edge) { return edge.event != first->event; });
        if (last - first > 1) std::sort(first, last);
        first = last;
    }
    signature.erase(std::unique(signature.begin(), signature.end()), signature.end());
}

class Refinement {
public:
    Refinement(const Graph& graph, Equivalence equivalence, diagnostics::Pollable& budget)
        : graph_(graph),
          branching_(equivalence == Equivalence::branching_with_divergence),
          budget_(budget),
          block_(graph.size(), 0) {}

    void run();
    [[nodiscard]] Block block(StateIndex state) const { return block_[state]; }
    [[nodiscard]] std::size_t block_count() const { return members_.size(); }
    [[nodiscard]] const Signature& signature(Block block) const { return signatures_[block]; }

private:
    void reverse_edges();
    void mark_dirty(StateIndex state);
    [[nodiscard]] bool is_alone(StateIndex state) const { return members_[block_[state]].size() == 1; }
    void refine(Block block);
    [[nodiscard]] Signature signature_of(StateIndex state) const;
    void split(Block block, Parts& parts, bool clean_states);
    void add_clean_states(Block block, Parts& parts, Part& with_clean);
    void move_states(const States& states, Block to);
    void leave_block(StateIndex state);
    States take_dirty(Block block);

    const Graph& graph_;
    bool branching_;
    diagnostics::Pollable& budget_;
    std::vector<Block> block_;
    std::vector<States> members_;
    std::vector<std::size_t> place_;  // index in its block's members
    std::vector<Signature> signatures_;
    std::vector<const Signature*> fresh_;  // by state: the signature that `refine` has just computed; or null
    std::vector<States> dirty_;            // by block: its marked states
    std::vector<bool> is_dirty_;
    std::vector<bool> is_stale_;  // by block: it has one state, and its signature may have changed
    std::deque<Block> work_;
    std::vector<std::uint64_t> first_source_;
    std::vector<std::pair<StateIndex, Event>> sources_;
};

void Refinement::reverse_edges() {
    first_source_.assign(graph_.size() + 1, 0);
    for (StateIndex state = 0; state < graph_.size(); ++state)
        for (const Edge& edge : graph_.edges(state)) ++first_source_[edge.target + 1U];
    for (std::size_t i = 1; i < first_source_.size(); ++i) first_source_[i] += first_source_[i - 1];
    sources_.resize(graph_.edge_count());
    assert(first_source_.back() == sources_.size());
    std::vector<std::uint64_t> next(first_source_.begin(), first_source_.end() - 1);
    for (StateIndex state = 0; state < graph_.size(); ++state)
        for (const Edge& edge : graph_.edges(state)) sources_[next[edge.target]++] = {state, edge.event};
}

void Refinement::run() {
    reverse_edges();
    members_.resize(1);
    dirty_.resize(1);
    signatures_.resize(1);
    is_stale_.resize(1);
    is_dirty_.assign(graph_.size(), true);
    fresh_.assign(graph_.size(), nullptr);
    for (StateIndex state = 0; state < graph_.size(); ++state) {
        place_.push_back(state);
        members_[0].push_back(state);
        dirty_[0].push_back(state);
    }
    work_.push_back(0);
    while (!work_.empty()) {
        const Block block = work_.front();
        work_.pop_front();
        refine(block);
    }
    for (Block block = 0; block < members_.size(); ++block) {
        if (!is_stale_[block]) continue;
        budget_.poll();
        signatures_[block] = signature_of(members_[block].front());
    }
}

/// Marks a state whose signature may have changed, and the states that lead to it by inert taus. A block with one state
/// cannot be split, and no other state leads to this state by inert taus. Its signature is recomputed at the end.
void Refinement::mark_dirty(StateIndex state) {
    if (is_dirty_[state]) return;  // the usual case, so the list below is not needed
    if (is_alone(state)) {
        is_stale_[block_[state]] = true;
        return;
    }
    States pending{state};
    while (!pending.empty()) {
        const StateIndex next = pending.back();
        pending.pop_back();
        if (is_dirty_[next]) continue;
        is_dirty_[next] = true;
        States& list = dirty_[block_[next]];
        if (list.empty()) work_.push_back(block_[next]);
        list.push_back(next);
        if (!branching_) continue;
        for (std::uint64_t i = first_source_[next]; i < first_source_[next + 1U]; ++i)
            if (sources_[i].second == tau && block_[sources_[i].first] == block_[next])
                pending.push_back(sources_[i].first);
    }
}

/// Returns the marked states of the block in ascending order. `minimise` numbers states so that a tau leads to a lower
/// number. So the target of an inert tau comes before its source.
States Refinement::take_dirty(Block block) {
    States states = std::exchange(dirty_[block], {});
    std::erase_if(states, [&](StateIndex state) { return block_[state] != block || !is_dirty_[state]; });
    std::ranges::sort(states);
    for (StateIndex state : states) is_dirty_[state] = false;
    assert(std::ranges::adjacent_find(states) == states.end());  // no state is marked twice
    return states;
}

void Refinement::refine(Block block) {
    const States dirty = take_dirty(block);
    if (dirty.empty()) return;
    Parts parts;
    for (StateIndex state : dirty) {
        budget_.poll();
        Part& part = parts.with_signature(signature_of(state));
        part.states.push_back(state);
        fresh_[state] = &part.signature;
    }
    for (StateIndex state : dirty) fresh_[state] = nullptr;
    split(block, parts, dirty.size() < members_[block].size());
}

Signature Refinement::signature_of(StateIndex state) const {
    Signature result;
    const Block own = block_[state];
    bool by_event = true;
    for (const Edge& edge : graph_.edges(state)) {
        const bool inert = branching_ && edge.event == tau && block_[edge.target] == own;
        if (!inert) {
            by_event = by_event && (result.empty() || result.back().event <= edge.event);
            result.push_back({edge.event, block_[edge.target]});
        } else if (edge.target == state) {
            by_event = by_event && result.empty();
            result.push_back({tau, endless});
        } else {
            assert(edge.target < state);  // so its new signature is already known
            const Signature& through = fresh_[edge.target] != nullptr ? *fresh_[edge.target] : signatures_[own];
            by_event = by_event && result.empty();
            result.insert(result.end(), through.begin(), through.end());
        }
    }
    if (by_event)
        sort_by_target(result);
    else
        diagnostics::sort_unique(result);
    return result;
}

/// Adds the states without a mark to `with_clean`. Their signature is still the old one of the block.
void Refinement::add_clean_states(Block block, Parts& parts, Part& with_clean) {
    std::vector<bool> computed(members_[block].size(), false);
    for (const Part& part : parts.list())
        for (StateIndex state : part.states) computed[place_[state]] = true;
    for (std::size_t i = 0; i < members_[block].size(); ++i)
        if (!computed[i]) with_clean.states.push_back(members_[block][i]);
    std::ranges::sort(with_clean.states);
}

void Refinement::split(Block block, Parts& parts, bool clean_states) {
    std::size_t clean = members_[block].size();
    for (const Part& part : parts.list()) clean -= part.states.size();
    assert(clean_states == (clean > 0));
    Part* const with_clean = clean_states ? &parts.with_signature(signatures_[block]) : nullptr;
    const auto weight = [&](const Part& part) { return part.states.size() + (&part == with_clean ? clean : 0); };
    const auto largest = std::ranges::max_element(parts.list(), {}, weight);
    if (with_clean != nullptr && &*largest != with_clean) add_clean_states(block, parts, *with_clean);
    assert(weight(*largest) > 0);
    signatures_[block] = std::move(largest->signature);
    for (Part& part : parts.list()) {
        if (&part == &*largest) continue;
        const auto to = static_cast<Block>(members_.size());
        members_.emplace_back();
        dirty_.emplace_back();
        is_stale_.push_back(false);
        signatures_.push_back(std::move(part.signature));
        move_states(part.states, to);
    }
    assert(dirty_.size() == members_.size() && signatures_.size() == members_.size());
    for (const Part& part : parts.list()) {
        if (&part == &*largest) continue;
        for (StateIndex state : part.states) {
            if (branching_) mark_dirty(state);
            for (std::uint64_t i = first_source_[state]; i < first_source_[state + 1U]; ++i)
                mark_dirty(sources_[i].first);
        }
    }
}

void Refinement::leave_block(StateIndex state) {
    States& from = members_[block_[state]];
    assert(from[place_[state]] == state);
    const StateIndex last = from.back();
    from[place_[state]] = last;
    place_[last] = place_[state];
    from.pop_back();
}

void Refinement::move_states(const States& states, Block to) {
    for (StateIndex state : states) {
        assert(block_[state] != to);
        leave_block(state);
        block_[state] = to;
        place_[state] = members_[to].size();
        members_[to].push_back(state);
    }
}

/// Builds the quotient. Numbers the reachable blocks in breadth-first order, from the block of the initial state.
class QuotientBuilder {
public:
    QuotientBuilder(const Refinement& refinement, StateIndex initial)
        : refinement_(refinement), numbers_(refinement.block_count(), no_state) {
        number_block(refinement.block(initial));
        for (std::size_t next = 0; next < order_.size(); ++next) add_edges(order_[next]);
    }
    Graph graph;
    [[nodiscard]] StateIndex number_of(Block block) const { return numbers_[block]; }
    [[nodiscard]] std::size_t size() const { return order_.size(); }

private:
    StateIndex number_block(Block block) {
        if (numbers_[block] == no_state) {
            numbers_[block] = static_cast<StateIndex>(order_.size());
            order_.push_back(block);
        }
        return numbers_[block];
    }
    void add_edges(Block block) {
        std::vector<Edge> edges;
        for (const Edge& edge : refinement_.signature(block))
            edges.push_back({edge.event, number_block(edge.target == endless ? block : edge.target)});
        std::ranges::sort(edges);
        for (const Edge& edge : edges) graph.add_edge(edge);
        graph.finish_state();
    }
    const Refinement& refinement_;
    std::vector<StateIndex> numbers_;  // by block
    std::vector<Block> order_;
};

}  // namespace

Quotient minimise(const Graph& graph, Equivalence equivalence, diagnostics::Pollable& budget) {
    // Branching equivalence: all states on a tau cycle are equivalent, so they become one state with a tau loop. Other
    // taus remain. The states are numbered so that each of these taus leads to a lower number.
    assert(graph.size() > 0);
    const bool branching = equivalence == Equivalence::branching_with_divergence;
    const TauComponents components = branching ? tau_components(graph) : every_state_alone(graph);
    const Graph contracted = branching ? contract_components(graph, components) : Graph();
    Refinement refinement(branching ? contracted : graph, equivalence, budget);
    refinement.run();
    QuotientBuilder builder(refinement, components.component[0]);
    Quotient result{std::move(builder.graph), std::vector<StateIndex>(builder.size(), no_state), {}};
    for (StateIndex state = 0; state < graph.size(); ++state) {
        const StateIndex number = builder.number_of(refinement.block(components.component[state]));
        result.state_of.push_back(number);
        if (number != no_state && result.representative[number] == no_state) result.representative[number] = state;
    }
    return result;
}

}  // namespace robochart::lts
