// SPDX-License-Identifier: Apache-2.0
// Converts the shared IR to C++ controllers without the CSP semantics. Users see the classes of Li et al., 2017 (the
// founding paper) over a core, whose state is a value and whose step function runs to quiescence.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Emits the controller of one state machine, controller or module. `component` is a path as in ir::ComponentRef
/// ("AggregationFSM", "AggregationModule"). Rejects constructs that have no translation to C++, and names each of them.
[[nodiscard]] Emission emit(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                            const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
