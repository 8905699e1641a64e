// SPDX-License-Identifier: Apache-2.0
// Converts the shared IR to C++ controllers. Users see the classes of the founding paper (Li et al., 2017). These call
// a core: its state is a value, and its step runs until no transition is enabled. The CSP semantics are not used.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Emits the controller of one state machine, controller or module. `component` is a path as in ir::ComponentRef
/// ("AggregationFSM", "AggregationModule"). Names each construct that has no translation to C++ and rejects it.
[[nodiscard]] Emission emit(const ir::System&, const ir::Instantiation&, const ir::ComponentRef& component,
                            const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
