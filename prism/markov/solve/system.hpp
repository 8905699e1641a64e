// SPDX-License-Identifier: Apache-2.0
// Declares the equations of one strongly connected component: x(i) is the optimum, over the choices of i, of constant +
// sum of p * x(j).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

/// The equations for the unknowns 0 .. size-1. For each choice, the probability to leave and the entries sum to exactly
/// 1. No choice has entries only for its own unknown. Constants are not negative.
template <class Value>
struct System {
    std::vector<std::uint32_t> first_choice{0};  ///< unknowns + 1 elements
    std::vector<std::uint64_t> first_entry{0};   ///< choices + 1 elements
    std::vector<std::uint32_t> unknown;          ///< by entry
    std::vector<std::uint32_t> number;           ///< by entry: index into numbers
    std::vector<Value> constant;                 ///< by choice: its reward plus the values that it reaches outside
    std::vector<Value> outside;                  ///< by choice: the probability to leave
    std::span<const Value> numbers;

    [[nodiscard]] std::size_t size() const { return first_choice.size() - 1; }
    [[nodiscard]] std::size_t choices() const { return first_entry.size() - 1; }
};

/// One choice for each unknown.
using Policy = std::vector<std::uint32_t>;

/// Returns a policy that leaves the component with probability 1 from every state. Some choice must lead outside.
template <class Value>
[[nodiscard]] Policy leaving_policy(const System<Value>& system);

/// Returns whether this policy leaves the component with probability 1 from every state.
template <class Value>
[[nodiscard]] bool always_leaves(const System<Value>& system, const Policy& policy);

/// The values of unknowns, and the choices that attain them.
template <class Value>
struct SystemSolution {
    std::vector<Value> values;
    Policy policy;
};

}  // namespace robochart::markov
