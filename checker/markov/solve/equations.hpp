// Values of states by equations over the whole model, solved component by component, those that others lead to first.
#pragma once

#include <string>
#include <vector>

#include "checker/markov/graph/graph.hpp"
#include "checker/markov/solve/earnings.hpp"
#include "checker/markov/solve/interval.hpp"
#include "checker/markov/solve/optimum.hpp"

namespace robochart::markov {

/// What is to be solved. The conditions of Optimum hold once the end components are states of their own.
template <class Value>
struct Equations {
    const Graph& graph;
    StateSet open;                        ///< states whose values are unknown
    std::vector<bool> admitted;           ///< choices; each open state has one
    std::vector<EndComponent> collapsed;  ///< of open states: where staying earns nothing, and is not worth anything
    Earnings<Value> earnings;
    std::vector<Value> values;  ///< of each state; filled in where open
    Optimum asked;
    bool probabilities = false;  ///< no value is above 1
};

/// Fills in the values of open states, and their choices: a strategy for them, if asked for (of the others 0). Adds to
/// `shortfall` why some value is less precise than asked for.
template <class Value>
void solve(Equations<Value>& equations, std::vector<std::uint32_t>& strategy, std::string& shortfall);

}  // namespace robochart::markov
