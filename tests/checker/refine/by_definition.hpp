// SPDX-License-Identifier: Apache-2.0
// Compares counterexamples with the definitions. The run must exist in the naive graph, and the violation must occur at
// its end. If a shortest run is promised, no run may be shorter.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "checker/refine/verdict/verdict.hpp"
#include "tests/checker/processes/questions.hpp"

namespace robochart::refine {

/// Describes the error in a violation of the question, or returns nullopt if the violation is correct. `letter` maps
/// events, including tau and tick. If `exactly`, the searched system has the same taus as the naive graph. Otherwise
/// only traces are compared.
[[nodiscard]] std::optional<std::string> wrong_by_definition(
    const Counterexample& counterexample, const Question& question, const Graphs& graphs, bool exactly,
    const std::function<naive::Letter(process::Event)>& letter);

}  // namespace robochart::refine
