// SPDX-License-Identifier: Apache-2.0
// Compares counterexamples with the definitions: the run exists in the naive graph, the violation occurs at its end,
// and if a shortest run is promised, no run is shorter.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "checker/refine/verdict/verdict.hpp"
#include "tests/checker/processes/questions.hpp"

namespace robochart::refine {

/// Describes an error in a violation of the question; nullopt if it is correct. `letter` maps events, including tau and
/// tick. `exactly`: the searched system has the same taus as the naive graph. Otherwise only traces are compared.
[[nodiscard]] std::optional<std::string> wrong_by_definition(
    const Counterexample& counterexample, const Question& question, const Graphs& graphs, bool exactly,
    const std::function<naive::Letter(process::Event)>& letter);

}  // namespace robochart::refine
