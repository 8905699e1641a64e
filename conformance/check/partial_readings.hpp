// Conformance with the readings of a cycle tried only as far as something depends on them: for components with so many
// registers that all of their valuations in all states of the model are too many (docs/conformance.md, "Partial
// readings").
#pragma once

#include "conformance/check/places_in_state.hpp"
#include "conformance/check/result.hpp"
#include "conformance/code/interface.hpp"
#include "conformance/model/model_graph.hpp"
#include "cpp_emit/runtime/explore_abi.h"

namespace robochart::conformance {

/// `conforms`, `differs` and `not_schedulable` as by the search over all valuations; of a model that cannot be run in
/// cycles only what the code comes to is found. Inconclusive at a limit.
[[nodiscard]] Result judge_partially(ModelGraph& model, const Alphabet& alphabet, const rc_interface& code,
                                     std::uint32_t cycle_length, const refine::Limits&, const EventPlaces& = {});

}  // namespace robochart::conformance
