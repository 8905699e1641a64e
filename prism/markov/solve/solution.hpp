// SPDX-License-Identifier: Apache-2.0
// Declares the options and results of the numeric and the exact operators.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "prism/markov/model/model.hpp"
#include "prism/markov/solve/enclosure.hpp"

namespace robochart::markov {

/// Which scheduler of an mdp a query selects: the one with the least or the greatest value. A dtmc has only one
/// scheduler.
enum class Direction { minimum, maximum };

struct Precision {
    double relative = 1e-6;                 ///< maximal relative width of the enclosures
    std::uint64_t most_sweeps = 1'000'000;  ///< limit for each strongly connected component
    diagnostics::Budget* budget = nullptr;  ///< polled; may be null
    bool strategy = false;                  ///< compute Solution::strategy
};

/// The value of every state.
struct Solution {
    std::vector<Enclosure> values;        ///< always valid enclosures
    std::vector<std::uint32_t> strategy;  ///< by state: an optimal choice, as an index into the model's choices; empty
                                          ///< unless requested
    std::string shortfall;                ///< the reason why an enclosure is wider than requested; empty if none is
};

/// Thrown if the query is not supported; the message contains the reason.
class Unsupported : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

}  // namespace robochart::markov
