// SPDX-License-Identifier: Apache-2.0
// For systems that are too large for a search: random walks of the compiled code along the model's normal form, guided
// by coverage (after AFL's queue: walks continue from cycles that led to something new). They find differences and
// never prove that there are none.
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/code/code_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// Returns `differs` or `not_schedulable` with a minimised witness, otherwise `inconclusive` with the coverage.
/// `limits.deadline` is ignored; `walks.seconds` applies.
[[nodiscard]] Result walk(ModelGraph&, const Alphabet&, const rc_interface& code, std::uint32_t cycle_length,
                          const refine::Limits&, const WalkOptions&);

}  // namespace robochart::conformance
