// SPDX-License-Identifier: Apache-2.0
// Stores transition systems as graphs. One array contains the edges, ordered by source state. State 0 is the initial
// state.
#pragma once

#include <cassert>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// A transition of a graph, stored with its source state.
struct Edge {
    Event event;
    StateIndex target;
    friend auto operator<=>(const Edge&, const Edge&) = default;
};

/// A transition system that is stored explicitly as a graph.
class Graph {
public:
    [[nodiscard]] std::size_t size() const { return first_.size() - 1; }
    [[nodiscard]] std::size_t edge_count() const { return edges_.size(); }
    [[nodiscard]] std::span<const Edge> edges(StateIndex state) const {
        assert(state + std::size_t{1} < first_.size());
        return std::span(edges_).subspan(first_[state], first_[state + 1U] - first_[state]);
    }
    /// Adds an edge to the state that is being built. `finish_state` completes this state and begins the next one. An
    /// edge may lead to a state that does not exist yet.
    void add_edge(Edge edge) { edges_.push_back(edge); }
    void finish_state() {
        assert(first_.back() <= edges_.size());
        first_.push_back(edges_.size());
    }

    friend bool operator==(const Graph&, const Graph&) = default;

private:
    std::vector<std::uint64_t> first_{0};
    std::vector<Edge> edges_;
};

/// The graph of an explored system, and the packed state for each state number of the graph.
struct Exploration {
    Graph graph;
    StateStore states;  ///< the packed states, by state number
};

/// Explores the system breadth-first from the initial state. Calls `on_state` with the number of states found so far,
/// before it expands a state. `on_state` may stop the exploration by an exception.
[[nodiscard]] Exploration explore(TransitionSystem& system, const std::function<void(std::size_t states)>& on_state);

/// Returns true if the state has a tau, that is, if it is not stable.
[[nodiscard]] bool has_tau(TransitionSystem& system, StateView state);

/// A transition system whose states and transitions come from a graph.
class GraphSystem final : public TransitionSystem {
public:
    GraphSystem(const Graph& graph, const EventTable& events) : graph_(graph), events_(events) {}
    [[nodiscard]] std::size_t width() const override { return 1; }
    void initial(std::span<Word> state) override { state[0] = 0; }
    void successors(StateView state, SuccessorSink& sink) override;
    [[nodiscard]] std::unique_ptr<TransitionSystem> clone_for_thread() const override {
        return std::make_unique<GraphSystem>(graph_, events_);
    }
    [[nodiscard]] const EventTable& events() const override { return events_; }
    [[nodiscard]] std::string describe(StateView state) const override;

private:
    const Graph& graph_;
    const EventTable& events_;
};

/// Writes the graph in the Aldebaran format that CADP and mCRL2 read. Tau is written "tau", and termination "tick".
void write_aut(const Graph& graph, const EventTable& events, std::ostream& out);
/// Writes CSPM definitions: a process `name`, and one process for each state, called `name` followed by the number of
/// the state. The process `name` equals the graph in T, F and FD. The script must declare the channels. If a state has
/// several taus and another event, the process of this state starts with an additional tau.
void write_csp(const Graph& graph, const EventTable& events, const std::string& name, std::ostream& out);
/// Writes the graph in the format of Graphviz.
void write_dot(const Graph& graph, const EventTable& events, std::ostream& out);

}  // namespace robochart::lts
