// SPDX-License-Identifier: Apache-2.0
// Makes the system of a component in control cycles, by its notation.
#pragma once

#include <cstdint>
#include <memory>

#include "conformance/model/cycle_system.hpp"
#include "conformance/model/model_graph.hpp"

namespace robochart::conformance {

/// NF_c(M) of a RoboChart component, S(M) of a RoboSim component. The model and the alphabet must outlive it.
[[nodiscard]] std::unique_ptr<CycleSystem> component_in_cycles(ModelGraph&, const Alphabet&,
                                                               std::uint32_t cycle_length);

}  // namespace robochart::conformance
