// SPDX-License-Identifier: Apache-2.0
// Finds a run after which an expression of the model has no value, such as a division by zero. It searches the states
// of the operational semantics breadth-first, so the run is a shortest one.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "base/diagnostics/pollable.hpp"
#include "checker/process/term.hpp"
#include "counterexample/run.hpp"
#include "counterexample/step_reader.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::runs {

struct FailingRun {
    Run run;              ///< its end has the kind `undefined`
    std::string failure;  ///< "m.rct:8: division by zero, in P::S::t1"
};

/// Explores at most `most` states. No value if none of them fails. Polls the budget for each state.
[[nodiscard]] std::optional<FailingRun> find_failing_run(const Context& context, csp_emit::Time time,
                                                         process::TermId process, std::uint64_t most,
                                                         diagnostics::Pollable& budget);

}  // namespace robochart::runs
