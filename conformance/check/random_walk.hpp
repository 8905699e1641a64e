// SPDX-License-Identifier: Apache-2.0
// Random walks of the compiled code along the model's normal form, for systems that are too large for a search.
// Coverage guides the walks, as in AFL's queue: they continue from cycles that reached new states. Walks find
// differences; they never prove that there are none.
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// Returns `differs` or `not_schedulable` with a minimised witness, otherwise `inconclusive` with the coverage.
/// `limits.deadline` is ignored; `walks.seconds` applies.
[[nodiscard]] Result run_random_walks(ModelGraph&, const Alphabet&, const rc_interface& code,
                                      std::uint32_t cycle_length, const refine::Limits&, const WalkOptions&);

}  // namespace robochart::conformance
