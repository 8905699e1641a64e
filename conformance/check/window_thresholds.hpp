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

/// Completes a result for all values with the outcome `conforms`. For each threshold, tries its nearest double and the
/// doubles on both sides as the least or greatest number of a window. If a comparison has another answer in the code
/// for the nearest double, changes the outcome to `rounds`, unless `rounding_allowed`. A difference for the other two
/// is only reported, because all code with doubles has it.
void test_window_thresholds(Result& result, const ir::System& system, const ir::ValueModel& values,
                            const diagnostics::SourceManager& sources, bool rounding_allowed);

}  // namespace robochart::conformance
