// SPDX-License-Identifier: Apache-2.0
// Normalises a specification on demand. A node is a tau-closed set of states of the specification and represents its
// behaviour after a trace (UCS 10.4.2, "normalisation"). An external choice whose operands have taus is one state
// (choice_graph.hpp).
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "checker/refine/verdict/choice_graph.hpp"

namespace robochart::refine {

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
    /// Returns the node after one more visible event or tick. Returns no value if the specification cannot perform the
    /// event.
    std::optional<Node> node_after(Node node, process::Event event);
    /// Returns the events that the specification can perform in this node, ascending.
    process::EventSet initials(Node node);
    /// Returns the minimal acceptances of the node's states, sorted by size, then by events. Every stable behaviour in
    /// this node accepts at least one of these sets. The result is empty if the node has no stable state.
    const std::vector<process::EventSet>& acceptances(Node node);
    /// Returns true if the specification can perform taus forever in this node.
    bool diverges(Node node);
    /// Returns true if all states of `smaller` are states of `larger`.
    [[nodiscard]] bool includes(Node larger, Node smaller) const;
    /// Returns the specification's states in a node. If a choice is whole (choice_graph.hpp), the states that its taus
    /// reach are not listed.
    [[nodiscard]] std::vector<lts::StateView> states(Node node) const;
    [[nodiscard]] std::size_t size() const { return nodes_.size(); }
    /// After this call, functions throw SpecificationGrows if there are far more nodes than states.
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

    ChoiceGraph graph_;
    Budget& budget_;
    std::unordered_map<Members, Node, Hash> ids_;
    std::deque<NodeData> nodes_;
    std::vector<std::uint32_t> mark_;  // by state: the last closure to which it was added
    std::uint32_t closure_ = 0;
    bool may_grow_ = true;
    std::vector<std::uint8_t> divergence_;  // by state: the result of state_diverges, if known
};

}  // namespace robochart::refine
