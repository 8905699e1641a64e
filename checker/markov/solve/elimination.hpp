// Linear equations of a policy, solved by eliminating one unknown after the other.
//
// 1 - p(i,i) is computed as the sum of all other probabilities, so nothing is ever subtracted: in floating point each
// value keeps its relative precision, however slowly the chain mixes (Grassmann, Taksar and Heyman, 1985), and
// intervals stay narrow. Unknowns with few neighbours are eliminated first.
#pragma once

#include <limits>
#include <optional>

#include "checker/markov/solve/system.hpp"

namespace robochart::markov {

/// What an elimination may cost.
struct EliminationLimit {
    std::uint64_t operations = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t entries = std::numeric_limits<std::uint64_t>::max();  ///< kept at a time
    diagnostics::Budget* budget = nullptr;
};

/// For each of the right sides (a value for each unknown) the solution of x = right side + A x, where A has the rows of
/// the policy. Nothing where the limit is reached, or where the policy may stay for ever.
template <class Value>
[[nodiscard]] std::optional<std::vector<std::vector<Value>>> eliminate(const System<Value>& system,
                                                                       const Policy& policy,
                                                                       std::vector<std::vector<Value>> right_sides,
                                                                       const EliminationLimit& limit);

}  // namespace robochart::markov
