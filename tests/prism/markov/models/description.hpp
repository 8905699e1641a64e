// SPDX-License-Identifier: Apache-2.0
// Small models in a form that tests can write and change.
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
    std::vector<Rational> rewards;  ///< of states; empty: all 0
    StateSet left;
    StateSet right;
};

/// The sets left and right are empty.
[[nodiscard]] Description dtmc(const std::vector<std::vector<Branch>>& rows);
[[nodiscard]] Description mdp(std::vector<std::vector<Choice>> states);

[[nodiscard]] StateSet set_of(std::size_t states, const std::vector<State>& members);

/// Encloses a value in adjacent doubles, or in twice the same double if the value is one.
[[nodiscard]] Number enclosing(const Rational& value);

/// A model with exact numbers.
[[nodiscard]] Model model_of(const Description& description);
[[nodiscard]] Rewards rewards_of(const Description& description);

[[nodiscard]] std::string description_text(const Description& description);

}  // namespace robochart::markov
