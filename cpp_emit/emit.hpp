// SPDX-License-Identifier: Apache-2.0
// Converts the shared IR to C++ controllers. They have the founding paper's classes (Li et al., 2017) over a core with
// value-type state and a step function that runs to quiescence. The generator does not use the CSP semantics.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Emits the controller of one state machine, controller or module. `component` is the path as in ir::ComponentRef
/// ("AggregationFSM", "AggregationModule"). Constructs that have no translation to C++ are rejected by name.
[[nodiscard]] Emission emit(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                            const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
