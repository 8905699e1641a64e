// SPDX-License-Identifier: Apache-2.0
// Computes the values of states by equations over the whole model, which are solved component by component, in reverse
// topological order.
#pragma once

#include <string>
#include <vector>

#include "prism/markov/graph/graph.hpp"
#include "prism/markov/solve/earnings.hpp"
#include "prism/markov/solve/interval.hpp"
#include "prism/markov/solve/optimum.hpp"

namespace robochart::markov {

/// The equations to solve. After each end component has been replaced by one state, the conditions of Optimum must
/// hold.
template <class Value>
struct Equations {
    const Graph& graph;
    StateSet open;                        ///< states with unknown values
    std::vector<bool> admitted;           ///< by choice; each open state has an admitted choice
    std::vector<EndComponent> collapsed;  ///< end components of open states in which staying earns nothing and has no
                                          ///< value
    Earnings<Value> earnings;
    std::vector<Value> values;  ///< by state; computed for open states
    Optimum goal;
    bool probabilities = false;  ///< no value exceeds 1
};

/// Computes the values of open states and, if requested, their choices as a strategy (0 for other states). Appends to
/// `shortfall` the reason if some value is less precise than requested.
template <class Value>
void solve(Equations<Value>& equations, std::vector<std::uint32_t>& strategy, std::string& shortfall);

}  // namespace robochart::markov
