// SPDX-License-Identifier: Apache-2.0
// Finds the elements of the model that the reachable states of a process exercise: transitions that fire and statements
// that are executed. It searches breadth first in the operational semantics, where the steps of all components are
// visible.
#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "base/diagnostics/pollable.hpp"
#include "checker/process/term.hpp"
#include "counterexample/step_reader.hpp"

namespace robochart::runs {

/// The elements that a search has found.
struct Exercised {
    /// The elements (see element_in) that may cause a step. If a step has several candidates, all of them are included.
    /// An element that is not in this set causes no step.
    std::set<std::string> possible;
    /// The elements that are the only candidate for the cause of some step.
    std::set<std::string> certain;
    std::uint64_t states = 0;  ///< number of explored states
    bool all = true;           ///< whether every reachable state was explored
};

/// Searches at most `most` states. Polls the budget for each state. Throws the same exceptions as
/// cspm::Session::transitions.
[[nodiscard]] Exercised find_exercised(StepReader&, process::TermId process, std::uint64_t most,
                                       diagnostics::Pollable& budget);

}  // namespace robochart::runs
