// SPDX-License-Identifier: Apache-2.0
// Whether a component can be run in cycles, without generated code for it.
#pragma once

#include "conformance/check/result.hpp"
#include "conformance/model/cyclic_model.hpp"

namespace robochart::conformance {

/// Checks that a component can be run in cycles. The outcome is `conforms`, `not_schedulable` or `inconclusive`. The
/// causes are explained in the terms of the model, whose texts are in `sources`. Also decides whether some cycle makes
/// an output twice, and whether a deadline on an input can pass (`register_cycles` and `deadlines` of the result).
[[nodiscard]] Result run_in_cycles(CyclicModel&, const diagnostics::SourceManager& sources, const refine::Limits&);

}  // namespace robochart::conformance
