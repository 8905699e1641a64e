// SPDX-License-Identifier: Apache-2.0
// Solves the linear equations of a policy by eliminating one unknown after the other.
//
// 1 - p(i,i) is computed as the sum of all other probabilities, so nothing is ever subtracted. In floating point each
// value keeps its relative precision, even if the chain mixes slowly (Grassmann, Taksar and Heyman, 1985), and
// intervals stay narrow. Unknowns with few neighbours are eliminated first.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "prism/markov/solve/system.hpp"

namespace robochart::markov {

/// The maximal amount of work of an elimination.
struct EliminationLimit {
    std::uint64_t operations = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t entries = std::numeric_limits<std::uint64_t>::max();  ///< number of entries stored at the same time
    diagnostics::Budget* budget = nullptr;
};

/// The eliminated equations of a policy, with which further right sides can be solved.
template <class Value>
class Factors {
public:
    struct Entry {
        std::uint32_t unknown;
        Value factor;
    };
    struct Row {
        std::vector<Entry> entries;  ///< entries of the unknowns that are eliminated later
        Value outside{};
        Value pivot{};  ///< 1 minus the unknown's own factor
    };

    /// The result of an elimination. `rows` has one row per unknown, and `order` is the order of elimination.
    /// `shares[k]` contains the other rows to which the row of unknown order[k] was added, with the factors.
    Factors(std::vector<Row> rows, std::vector<std::uint32_t> order, std::vector<std::vector<Entry>> shares)
        : rows_(std::move(rows)), order_(std::move(order)), shares_(std::move(shares)) {}

    /// Replaces the right side by the solution.
    void solve(std::vector<Value>& side) const;
    /// Computes the solution for a right side that was transformed together with the rows.
    void substitute(std::vector<Value>& side) const;
    [[nodiscard]] std::uint64_t entries() const;

private:
    std::vector<Row> rows_;
    std::vector<std::uint32_t> order_;
    std::vector<std::vector<Entry>> shares_;
};

/// Eliminates the equations of a policy. Returns no value if the limit is reached, or if the policy may stay in the
/// component forever.
template <class Value>
[[nodiscard]] std::optional<Factors<Value>> factorize(const System<Value>& system, const Policy& policy,
                                                      const EliminationLimit& limit);

/// Solves x = right side + A x for each right side, which has a value for each unknown. Row i of A is the row of the
/// choice that the policy makes for unknown i. Returns no value if the limit is reached, or if the policy may stay in
/// the component forever.
template <class Value>
[[nodiscard]] std::optional<std::vector<std::vector<Value>>> eliminate(const System<Value>& system,
                                                                       const Policy& policy,
                                                                       std::vector<std::vector<Value>> right_sides,
                                                                       const EliminationLimit& limit);

}  // namespace robochart::markov
