// SPDX-License-Identifier: Apache-2.0
// Describes small models in a form that tests can write and change.
#pragma once

#include <string>
#include <vector>

#include "prism/markov/model/model.hpp"

namespace robochart::markov {

struct Branch {
    State target;
    Rational weight;  ///< the probability is its share of the weights of the choice
};

struct Choice {
    std::vector<Branch> branches;  ///< targets in any order, without duplicates
    Rational reward = 0;
};

struct Description {
    Kind kind = Kind::dtmc;
    std::vector<std::vector<Choice>> states;
    std::vector<Rational> rewards;  ///< of states; if empty, all are 0
    StateSet left;
    StateSet right;
};

/// Makes a dtmc. The sets left and right are empty.
[[nodiscard]] Description dtmc(const std::vector<std::vector<Branch>>& rows);
[[nodiscard]] Description mdp(std::vector<std::vector<Choice>> states);

[[nodiscard]] StateSet set_of(std::size_t states, const std::vector<State>& members);

/// Encloses a value in adjacent doubles. If the value is a double, both bounds are equal to it.
[[nodiscard]] Number enclosing(const Rational& value);

/// Returns the model with exact numbers.
[[nodiscard]] Model model_of(const Description& description);
[[nodiscard]] Rewards rewards_of(const Description& description);

[[nodiscard]] std::string description_text(const Description& description);

}  // namespace robochart::markov
