// SPDX-License-Identifier: Apache-2.0
// Decides whether a model can run in control cycles. The check does not try all readings of the registers. It reads a
// register only where the model receives its input (docs/conformance.md, "Reading on demand").
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// Gives the same answer as check_schedulability (conformance_check.hpp), but perhaps with a longer run. The outcome is
/// `conforms` if M can be run in cycles. Throws diagnostics::LimitReached.
[[nodiscard]] Result schedulable_on_demand(ModelGraph&, const Alphabet&, std::uint32_t cycle_length,
                                           const refine::Limits&);

}  // namespace robochart::conformance
