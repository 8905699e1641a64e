// SPDX-License-Identifier: Apache-2.0
// Decides whether a component can be run in cycles, without generating code.
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/model/cyclic_model.hpp"

namespace robochart::conformance {

/// Checks that a component can be run in cycles. The outcome is `conforms`, `not_schedulable` or `inconclusive`.
/// Explains the cause with the names and places of the model. `sources` contains the texts of the model. The function
/// also decides whether some cycle makes an output twice, and whether a deadline on an input can pass
/// (`register_cycles` and `deadlines` of the result).
[[nodiscard]] Result run_in_cycles(CyclicModel&, const diagnostics::SourceManager& sources, const refine::Limits&);

}  // namespace robochart::conformance
