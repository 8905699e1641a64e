// Linear equations of a policy, solved by eliminating one unknown after the other.
//
// 1 - p(i,i) is computed as the sum of all other probabilities, so nothing is ever subtracted: in floating point each
// value keeps its relative precision, however slowly the chain mixes (Grassmann, Taksar and Heyman, 1985), and
// intervals stay narrow. Unknowns with few neighbours are eliminated first.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "checker/markov/solve/system.hpp"

namespace robochart::markov {

/// What an elimination may cost.
struct EliminationLimit {
    std::uint64_t operations = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t entries = std::numeric_limits<std::uint64_t>::max();  ///< kept at a time
    diagnostics::Budget* budget = nullptr;
};

/// The equations of a policy after the elimination: for right sides that come later.
template <class Value>
class Factors {
public:
    struct Entry {
        std::uint32_t unknown;
        Value factor;
    };
    struct Row {
        std::vector<Entry> entries;  ///< of unknowns eliminated later
        Value outside{};
        Value pivot{};  ///< 1 - its own factor
    };

    /// `rows` of each unknown; `order` of the elimination; `shares[k]`: how often the row of unknown order[k] went into
    /// which other rows.
    Factors(std::vector<Row> rows, std::vector<std::uint32_t> order, std::vector<std::vector<Entry>> shares)
        : rows_(std::move(rows)), order_(std::move(order)), shares_(std::move(shares)) {}

    /// The right side becomes the solution.
    void solve(std::vector<Value>& side) const;
    /// The same for a right side that went through the elimination with the rows.
    void substitute(std::vector<Value>& side) const;
    [[nodiscard]] std::uint64_t entries() const;

private:
    std::vector<Row> rows_;
    std::vector<std::uint32_t> order_;
    std::vector<std::vector<Entry>> shares_;
};

/// Nothing as with eliminate.
template <class Value>
[[nodiscard]] std::optional<Factors<Value>> factorize(const System<Value>& system, const Policy& policy,
                                                      const EliminationLimit& limit);

/// For each of the right sides (a value for each unknown) the solution of x = right side + A x, where A has the rows of
/// the policy. Nothing where the limit is reached, or where the policy may stay for ever.
template <class Value>
[[nodiscard]] std::optional<std::vector<std::vector<Value>>> eliminate(const System<Value>& system,
                                                                       const Policy& policy,
                                                                       std::vector<std::vector<Value>> right_sides,
                                                                       const EliminationLimit& limit);

}  // namespace robochart::markov
