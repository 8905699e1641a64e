// SPDX-License-Identifier: Apache-2.0
// Sparse Markov chains and Markov decision processes, as data. Independent of the language of models.
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace robochart::markov {

using Rational = boost::multiprecision::cpp_rational;

enum class Kind { dtmc, mdp };
using State = std::uint32_t;
using StateSet = std::vector<bool>;  ///< one element for each state

/// A number of the model: an enclosure of its exact value; low == high if the double is exact.
struct Number {
    double low = 0;
    double high = 0;
    friend bool operator==(const Number&, const Number&) = default;
};

/// A sparse model. Choices of state s: first_choice[s] .. first_choice[s+1]; a dtmc has one choice in each state, an
/// mdp one or more. Branches of choice c: first_branch[c] .. first_branch[c+1]; their targets ascend, and each occurs
/// once. Every probability is above 0, and the probabilities of a choice sum to 1 exactly: the enclosures contain such
/// numbers, and `exact` is one such solution. Graph algorithms and elimination (1 - p as the sum of the others) rely on
/// this.
struct Model {
    Kind kind = Kind::dtmc;
    std::vector<State> initial;               ///< ascending
    std::vector<std::uint32_t> first_choice;  ///< states + 1 elements
    std::vector<std::uint64_t> first_branch;  ///< choices + 1 elements
    std::vector<State> target;                ///< by branch
    std::vector<std::uint32_t> number;        ///< by branch: index into numbers
    std::vector<Number> numbers;              ///< without duplicates
    std::vector<Rational> exact;              ///< parallel to numbers; empty unless requested
    std::vector<std::uint32_t> action;        ///< by choice: index into actions (0: no label); empty for a dtmc
    std::vector<std::string> actions;
    /// For each choice, whether step bounds count the choice because time passes. If it is empty, they count every
    /// choice.
    std::vector<bool> counted;

    [[nodiscard]] std::size_t states() const { return first_choice.empty() ? 0 : first_choice.size() - 1; }
    [[nodiscard]] std::size_t choices() const { return first_branch.empty() ? 0 : first_branch.size() - 1; }
};

/// Rewards of states and choices. In a dtmc, several commands form the single choice of a state; its reward is the
/// expectation over its transitions, the sum of probability * reward. An empty vector: all rewards are 0.
struct Rewards {
    std::string name;
    std::vector<Number> state;
    std::vector<Number> choice;
    std::vector<Rational> exact_state;   ///< parallel to state; empty unless requested
    std::vector<Rational> exact_choice;  ///< parallel to choice; empty unless requested
};

}  // namespace robochart::markov
