// SPDX-License-Identifier: Apache-2.0
// Declares sparse Markov chains and Markov decision processes, as data. They do not depend on the language of models.
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

/// A number of the model, as an enclosure of its exact value; low == high if the double is exact.
struct Number {
    double low = 0;
    double high = 0;
    friend bool operator==(const Number&, const Number&) = default;
};

/// A sparse model. State s has the choices first_choice[s] .. first_choice[s+1]; a dtmc has one choice in each state,
/// an mdp one or more. Choice c has the branches first_branch[c] .. first_branch[c+1]; their targets ascend without
/// duplicates. Every probability is above 0, and the probabilities of a choice sum to exactly 1. That is, the
/// enclosures contain numbers with this sum, and `exact` contains one such solution. Graph algorithms and elimination
/// (which computes 1 - p as the sum of the other probabilities) rely on this.
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
    /// For each choice, whether step bounds count it because time passes. If the vector is empty, step bounds count
    /// every choice.
    std::vector<bool> counted;

    [[nodiscard]] std::size_t states() const { return first_choice.empty() ? 0 : first_choice.size() - 1; }
    [[nodiscard]] std::size_t choices() const { return first_branch.empty() ? 0 : first_branch.size() - 1; }
};

/// The rewards of states and choices; an empty vector means that all rewards are 0. In a dtmc, several commands form
/// the single choice of a state. Its reward is then the expectation over its transitions, the sum of probability *
/// reward.
struct Rewards {
    std::string name;
    std::vector<Number> state;
    std::vector<Number> choice;
    std::vector<Rational> exact_state;   ///< parallel to state; empty unless requested
    std::vector<Rational> exact_choice;  ///< parallel to choice; empty unless requested
};

}  // namespace robochart::markov
