// SPDX-License-Identifier: Apache-2.0
// Builds the product of a model with an automaton that reads the model's states. Also finds the states of the product
// in which a scheduler can satisfy a condition.
#pragma once

#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/automata/automaton.hpp"
#include "prism/markov/model/model.hpp"

namespace robochart::prism::automata {

struct Product {
    markov::Model model;
    std::vector<Automaton::State> automaton;  ///< by product state, after reading its state of the model
    std::vector<markov::State> begin;         ///< by state of the model: the initial state of paths from it
};

/// Builds the product for paths that begin in any state of the model. `letters` has one element for each state. Throws
/// NotDecided and LimitReached.
[[nodiscard]] Product product(const markov::Model& model, const std::vector<Letter>& letters, Automaton& automaton,
                              diagnostics::Budget* budget);

/// Returns the states in which a part without `always` holds for all continuations.
[[nodiscard]] markov::StateSet done_states(const Product& product, const Automaton& automaton, std::size_t part);

/// Returns the states of the end components that a scheduler can use to satisfy the condition without leaving the
/// component.
[[nodiscard]] markov::StateSet winning_states(const Product& product, const Automaton& automaton,
                                              const Condition& condition, diagnostics::Budget* budget);

}  // namespace robochart::prism::automata
