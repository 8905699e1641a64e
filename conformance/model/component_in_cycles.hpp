// SPDX-License-Identifier: Apache-2.0
// Makes the transition system of a component in control cycles, for components in RoboChart and in RoboSim.
#pragma once

#include <cstdint>
#include <memory>

#include "conformance/model/cycle_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// Returns NF_c(M) for a RoboChart component, and S(M) for a RoboSim component. The model and the alphabet must outlive
/// the result.
[[nodiscard]] std::unique_ptr<CycleSystem> component_in_cycles(ModelGraph&, const Alphabet&,
                                                               std::uint32_t cycle_length);

}  // namespace robochart::conformance
