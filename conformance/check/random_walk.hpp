// SPDX-License-Identifier: Apache-2.0
// Walks randomly through the compiled code and the model's normal form, for systems that are too large for a search.
// Coverage guides the walks, as in AFL's queue: they continue from cycles that reached new states. Walks find
// differences; they never prove that there are none.
#pragma once

#include <optional>
#include <vector>

#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// Returns `differs` or `not_schedulable` with a minimised witness, or `inconclusive` with the coverage of the walks.
/// The time limit is `walks.seconds`, not `limits.deadline`. A walk ends if a value of the model leaves its carrier.
[[nodiscard]] Result run_random_walks(lts::TransitionSystem& model, const Alphabet&, const rc_interface& code,
                                      std::uint32_t cycle_length, const refine::Limits&, const WalkOptions&);

/// Runs code and model with these readings of the registers, one list of readings for each cycle. Returns the first
/// difference with a minimised witness, or no value if there is none. Throws process::Interrupted.
[[nodiscard]] std::optional<Result> difference_on(ModelGraph&, const Alphabet&, const rc_interface& code,
                                                  std::uint32_t cycle_length, const refine::Limits&,
                                                  std::vector<std::vector<std::uint32_t>> way);

}  // namespace robochart::conformance
