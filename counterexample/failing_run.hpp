// SPDX-License-Identifier: Apache-2.0
// Finds a run after which an expression of the model has no value, for example because of a division by zero. It
// searches breadth first in the operational semantics, so the run is a shortest one.
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
    Run run;              ///< the kind of its end is `undefined`
    std::string failure;  ///< such as "m.rct:8: division by zero, in P::S::t1"
};

/// Searches at most `most` states. Returns no value if none of them fails. Polls the budget for each state.
[[nodiscard]] std::optional<FailingRun> find_failing_run(const Context& context, csp_emit::Time time,
                                                         process::TermId process, std::uint64_t most,
                                                         diagnostics::Pollable& budget);

}  // namespace robochart::runs
