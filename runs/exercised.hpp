// Which elements of the model the reachable states of a process exercise: the transitions that fire, the statements
// that are done. A breadth-first search over the states of the operational semantics, whose steps tell what each
// component does.
#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "checker/process/term.hpp"
#include "runs/step_reader.hpp"

namespace robochart::runs {

/// What a search has met.
struct Exercised {
    /// Elements, as element_in has them, that may be behind a step: where it does not tell which of several, all of
    /// them. An element that is missing is behind no step.
    std::set<std::string> possible;
    /// Those of them that alone can be behind some step.
    std::set<std::string> certain;
    std::uint64_t states = 0;  ///< that have been looked into
    bool all = true;           ///< no state is left
};

/// Looks into `most` states at most; `poll` is called for each and may throw. Throws what cspm::Session::transitions
/// throws.
[[nodiscard]] Exercised exercised(StepReader&, process::TermId process, std::uint64_t most,
                                  const std::function<void()>& poll);

}  // namespace robochart::runs
