// SPDX-License-Identifier: Apache-2.0
// Declares the operators as templates over the arithmetic. unbounded.hpp, bounded.hpp and long_run.hpp instantiate them
// for intervals, exact.hpp for rationals.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prism/markov/graph/graph.hpp"
#include "prism/markov/solve/interval.hpp"
#include "prism/markov/solve/solution.hpp"

namespace robochart::markov {

template <class Value>
struct Result {
    std::vector<Value> values;
    StateSet infinite;  ///< empty: no state
    std::vector<std::uint32_t> strategy;
    std::string shortfall;
};

// `Value` is Interval or Rational. Intervals need RoundUpward.

template <class Value>
struct UnboundedOperators {
    static Result<Value> until(const Model& model, const StateSet& left, const StateSet& right, Direction direction,
                               const Precision& precision);
    static Result<Value> reachability_reward(const Model& model, const Rewards& rewards, const StateSet& target,
                                             Direction direction, const Precision& precision);
    static Result<Value> total_reward(const Model& model, const Rewards& rewards, Direction direction,
                                      const Precision& precision);
};

template <class Value>
struct BoundedOperators {
    static Result<Value> next(const Model& model, const StateSet& set, Direction direction, const Precision& precision);
    static Result<Value> until(const Model& model, const StateSet& left, const StateSet& right, std::uint64_t from,
                               std::optional<std::uint64_t> to, Direction direction, const Precision& precision);
    static Result<Value> cumulative_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                           Direction direction, const Precision& precision);
    static Result<Value> instantaneous_reward(const Model& model, const Rewards& rewards, std::uint64_t steps,
                                              Direction direction, const Precision& precision);
};

template <class Value>
struct LongRunOperators {
    static Result<Value> probability(const Model& model, const StateSet& set, const Precision& precision);
    static Result<Value> reward(const Model& model, const Rewards& rewards, const Precision& precision);
};

}  // namespace robochart::markov
