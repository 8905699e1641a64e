// SPDX-License-Identifier: Apache-2.0
// Builds the graph of a model: its reverse edges, and its strongly connected components.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "prism/markov/model/model.hpp"

namespace robochart::markov {

/// Returns the targets of a choice's branches.
[[nodiscard]] std::span<const State> targets(const Model& model, std::uint32_t choice);

/// The model with its edges reversed. Stores a reference to the model, and four bytes for each branch.
class Graph {
public:
    explicit Graph(const Model& model);

    [[nodiscard]] const Model& model() const { return model_; }
    [[nodiscard]] std::size_t states() const { return model_.states(); }
    /// Returns the choices that have a branch to this state, ascending.
    [[nodiscard]] std::span<const std::uint32_t> choices_to(State state) const;
    /// Returns the state to which a choice belongs.
    [[nodiscard]] State source(std::uint32_t choice) const { return source_[choice]; }

private:
    const Model& model_;
    std::vector<State> source_;                  // by choice
    std::vector<std::uint64_t> first_incoming_;  // states + 1 elements
    std::vector<std::uint32_t> incoming_;        // choices
};

/// A subset of the states, and a subset of their choices.
struct SubModel {
    StateSet states;
    std::vector<bool> choices;  ///< one element for each choice
};

/// A set of states in which a scheduler can stay forever, visiting each of them infinitely often with probability 1.
struct EndComponent {
    std::vector<State> states;           ///< ascending
    std::vector<std::uint32_t> choices;  ///< choices that stay inside, ascending
};

/// Returns the maximal end components whose states and choices are in `within` (de Alfaro, Formal Verification of
/// Probabilistic Systems, 1997). They are disjoint, and sorted by their first state.
[[nodiscard]] std::vector<EndComponent> end_components(const Graph& graph, const SubModel& within);
/// Returns the maximal end components of the whole model.
[[nodiscard]] std::vector<EndComponent> end_components(const Graph& graph);

/// Returns the strongly connected components of a dtmc that no branch leaves. States are ascending, and components are
/// sorted by their first state.
[[nodiscard]] std::vector<std::vector<State>> bottom_components(const Model& model);

}  // namespace robochart::markov
