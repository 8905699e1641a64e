// Small models as tests write and change them.
#pragma once

#include <string>
#include <vector>

#include "checker/markov/model/model.hpp"

namespace robochart::markov {

struct Branch {
    State target;
    Rational weight;  ///< its share of the weights of the choice is the probability
};

struct Choice {
    std::vector<Branch> branches;  ///< targets in any order, each once
    Rational reward = 0;
};

struct Description {
    Kind kind = Kind::dtmc;
    std::vector<std::vector<Choice>> states;
    std::vector<Rational> rewards;  ///< of states; empty: all 0
    StateSet left;
    StateSet right;
};

/// left and right are empty sets.
[[nodiscard]] Description dtmc(const std::vector<std::vector<Branch>>& rows);
[[nodiscard]] Description mdp(std::vector<std::vector<Choice>> states);

[[nodiscard]] StateSet set_of(std::size_t states, const std::vector<State>& members);

/// Neighbouring doubles that enclose it, or twice the double that it is.
[[nodiscard]] Number enclosing(const Rational& value);

/// With exact numbers.
[[nodiscard]] Model model_of(const Description& description);
[[nodiscard]] Rewards rewards_of(const Description& description);

[[nodiscard]] std::string text(const Description& description);

}  // namespace robochart::markov
