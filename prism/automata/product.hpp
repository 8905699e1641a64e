// SPDX-License-Identifier: Apache-2.0
// The product of a model with an automaton that reads its states, and the states in which a scheduler can satisfy a
// condition.
#pragma once

#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/automata/automaton.hpp"
#include "prism/markov/model/model.hpp"

namespace robochart::prism::automata {

struct Product {
    markov::Model model;
    std::vector<Automaton::State> automaton;  ///< by state, after the automaton has read it
    std::vector<markov::State> begin;         ///< by state of the model: the initial state of paths from it
};

/// Contains the paths from every state of the model. `letters` has one element for each state. Throws NotDecided and
/// LimitReached.
[[nodiscard]] Product product(const markov::Model& model, const std::vector<Letter>& letters, Automaton& automaton,
                              diagnostics::Budget* budget);

/// The states in which a part that is not `always` holds for all continuations.
[[nodiscard]] markov::StateSet done_states(const Product& product, const Automaton& automaton, std::size_t part);

/// The states of the end components in which a scheduler that never leaves the component can satisfy the condition.
[[nodiscard]] markov::StateSet winning_states(const Product& product, const Automaton& automaton,
                                              const Condition& condition, diagnostics::Budget* budget);

}  // namespace robochart::prism::automata
