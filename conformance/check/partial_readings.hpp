// SPDX-License-Identifier: Apache-2.0
// Checks conformance, but tries the readings of a register only if the code or the model depends on them. `conform`
// uses this search after the complete search, which tries every valuation of the registers in every state of the model,
// has reached a limit (docs/conformance.md, "Partial readings").
#pragma once

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/model/model_graph.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// Returns `conforms`, `differs` and `not_schedulable` like the search over all valuations. It detects that the model
/// cannot be run in cycles only on paths that the code takes. Returns `inconclusive` if a limit is reached.
[[nodiscard]] Result judge_partially(ModelGraph& model, const Alphabet& alphabet, const rc_interface& code,
                                     std::uint32_t cycle_length, const refine::Limits&, const EventPlaces& = {});

}  // namespace robochart::conformance
