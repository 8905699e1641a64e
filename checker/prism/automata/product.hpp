// A model with an automaton that reads its states, and what a scheduler of the two can do about a condition.
#pragma once

#include <vector>

#include "checker/markov/model/model.hpp"
#include "checker/prism/automata/automaton.hpp"
#include "diagnostics/budget.hpp"

namespace robochart::prism::automata {

struct Product {
    markov::Model model;
    std::vector<Automaton::State> automaton;  ///< of each state, which the automaton has read
    std::vector<markov::State> begin;         ///< of each state of the model: where a path from it begins
};

/// Paths from every state of the model. `letters` has one element a state. Throws NotDecided, LimitReached.
[[nodiscard]] Product product(const markov::Model& model, const std::vector<Letter>& letters, Automaton& automaton,
                              diagnostics::Budget* budget);

/// The states where a part that is not `always` holds whatever follows.
[[nodiscard]] markov::StateSet done(const Product& product, const Automaton& automaton, std::size_t part);

/// The states of end components in which the condition holds, under a scheduler that stays there.
[[nodiscard]] markov::StateSet winning(const Product& product, const Automaton& automaton, const Condition& condition,
                                       diagnostics::Budget* budget);

}  // namespace robochart::prism::automata
