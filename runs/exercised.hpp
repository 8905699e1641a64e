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
    /// As exercised_element has them. Where a step does not tell which of several elements is behind it, all of them:
    /// an element that is missing is behind no step.
    std::set<std::string> elements;
    std::uint64_t states = 0;  ///< that have been looked into
    bool all = true;           ///< no state is left
};

/// An element of the resolved model in an instance of its machine: "P::M::c::s P::S::t1".
[[nodiscard]] std::string exercised_element(const std::string& component, const std::string& element);

/// Looks into `most` states at most; `poll` is called for each and may throw. Throws what cspm::Session::transitions
/// throws.
[[nodiscard]] Exercised exercised(StepReader&, process::TermId process, std::uint64_t most,
                                  const std::function<void()>& poll);

}  // namespace robochart::runs
