// SPDX-License-Identifier: Apache-2.0
// Chooses the order of variables. Variables that change together should be close to each other in the order. Otherwise
// the diagram needs many nodes on the levels between them.
#pragma once

#include <cstdint>
#include <vector>

#include "base/diagnostics/pollable.hpp"

namespace robochart::symbolic {

/// Returns an order in which the variables of each group are close to each other. It is the best of three: the given
/// order, FORCE (Aloul, Markov and Sakallah, GLSVLSI 2003), and a breadth-first order as in Cuthill and McKee (1969).
/// `domains`: the numbers of values. `groups`: variables that change together. Polls the budget.
[[nodiscard]] std::vector<std::uint32_t> order_variables(const std::vector<std::uint32_t>& domains,
                                                         const std::vector<std::vector<std::uint32_t>>& groups,
                                                         diagnostics::Pollable& budget);

}  // namespace robochart::symbolic
