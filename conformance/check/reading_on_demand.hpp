// SPDX-License-Identifier: Apache-2.0
// Checks the conformance of code with many inputs. The search tries all readings of a register only where the code
// reads this register. It follows the model along runs that are possible for all contents of the other registers
// (docs/conformance.md, "Reading on demand").
#pragma once

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/model/model_graph.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// Checks NF_c(M) [FD= L(code) for a schedulable M, like `refined_by` (conformance_check.hpp). Throws NotProbed
/// (cycle_graph.hpp) if this search cannot decide. The outcome is `inconclusive` if a limit is reached.
[[nodiscard]] Result refined_on_demand(ModelGraph&, const Alphabet&, const rc_interface& code,
                                       std::uint32_t cycle_length, const refine::Limits&, const EventPlaces& = {});

}  // namespace robochart::conformance
