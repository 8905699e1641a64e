// SPDX-License-Identifier: Apache-2.0
// Tests comparisons of windows of sequences with thresholds that the code computes (docs/conformance.md, "Numbers on
// the robot"). The least or greatest number in a window is one of the numbers of the sequence, so only the threshold is
// rounded.
#pragma once

#include "base/diagnostics/source.hpp"
#include "conformance/check/result.hpp"
#include "semantics/data/value_model.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Completes a result for all values with the outcome `conforms`. For each threshold, the function tries three doubles
/// as the least or greatest number of a window: the double nearest to the threshold, and the next doubles on both
/// sides. Suppose that a comparison has different answers in code and model. If this happens for the nearest double,
/// the outcome becomes `rounds`, unless `rounding_allowed` is true. If it happens for another of the three doubles, the
/// result only reports the difference, because all code with doubles has this difference.
void test_window_thresholds(Result& result, const ir::System& system, const ir::ValueModel& values,
                            const diagnostics::SourceManager& sources, bool rounding_allowed);

}  // namespace robochart::conformance
