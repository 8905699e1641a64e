// SPDX-License-Identifier: Apache-2.0
// The specification, normalised on demand. A node is a tau-closed set of states of the specification and represents its
// behaviour after a trace (UCS 10.4.2, "normalisation").
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/refine/search/budget.hpp"
#include "checker/refine/search/stability.hpp"

namespace robochart::refine {

/// The states of a system explored on demand, with their transitions sorted by event.
class LazyGraph {
public:
    explicit LazyGraph(lts::TransitionSystem& system, Budget& budget);

    struct Edge {
        process::Event event;
        lts::StateIndex target;
    };
    lts::StateIndex initial();
    /// Valid until the next call.
    std::span<const Edge> edges(lts::StateIndex state);
    std::span<const Edge> edges(lts::StateIndex state, process::Event event);
    [[nodiscard]] Offer state_offer(lts::StateIndex state);
    [[nodiscard]] std::size_t size() const { return states_.size(); }
    /// The packed state with a number.
    [[nodiscard]] lts::StateView state(lts::StateIndex index) const { return states_[index]; }

private:
    struct Extent {
        std::uint64_t first = 0;
        std::uint32_t count = 0;
        bool expanded = false;
    };
    class Collector;
    void expand(lts::StateIndex state);

    lts::TransitionSystem& system_;
    Budget& budget_;
    lts::StateStore states_;
    std::vector<Extent> extents_;
    std::vector<Edge> edges_;
};

/// Thrown if the normal form of a specification has too many nodes to be useful.
class SpecificationGrows : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

class NormalForm {
public:
    using Node = std::uint32_t;

    NormalForm(lts::TransitionSystem& specification, Budget& budget);

    Node initial();
    /// Returns the node after one more visible event or tick. No value if the specification cannot perform it.
    std::optional<Node> node_after(Node node, process::Event event);
    /// Returns the events that the specification can perform in this node, ascending.
    process::EventSet initials(Node node);
    /// Returns the minimal acceptances of the node's states, sorted by size, then by events. Every stable behaviour in
    /// this node accepts at least one of them. Empty if the node has no stable state.
    const std::vector<process::EventSet>& acceptances(Node node);
    /// Whether the specification can perform taus forever in this node.
    bool diverges(Node node);
    /// Whether all states of one node are states of the other.
    [[nodiscard]] bool includes(Node larger, Node smaller) const;
    /// The specification's states in a node.
    [[nodiscard]] std::vector<lts::StateView> states(Node node) const;
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    /// After this call, SpecificationGrows is thrown when there are far more nodes than states.
    void refuse_growth() { may_grow_ = false; }

private:
    using Members = std::vector<lts::StateIndex>;
    struct Arc {
        process::Event event;
        Node target;
    };
    struct NodeData {
        const Members* members = nullptr;
        std::optional<std::vector<Arc>> arcs;
        std::optional<std::vector<process::EventSet>> acceptances;
        std::optional<bool> diverges;
    };
    struct Hash {
        std::size_t operator()(const Members& members) const;
    };

    Node node_of(Members seeds);
    void close_under_tau(Members& members);
    std::vector<Arc>& arcs_of(Node node);
    bool state_diverges(lts::StateIndex state);

    LazyGraph graph_;
    Budget& budget_;
    std::unordered_map<Members, Node, Hash> ids_;
    std::deque<NodeData> nodes_;
    std::vector<std::uint32_t> mark_;  // by state: the closure to which it was last added
    std::uint32_t closure_ = 0;
    bool may_grow_ = true;
    std::vector<std::uint8_t> divergence_;  // by state: the answer of state_diverges, if known
};

}  // namespace robochart::refine
