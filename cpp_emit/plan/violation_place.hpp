// SPDX-License-Identifier: Apache-2.0
// Lists the places at which generated code stays because a precondition of an operation is false.
#pragma once

#include <string>
#include <vector>

#include "base/diagnostics/source.hpp"
#include "cpp_emit/plan/options.hpp"
#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// A place of a machine or operation.
struct ViolationPlace {
    std::string place;      ///< as the state is printed: "outside_turn_1"
    std::string operation;  ///< the operation that is called
    diagnostics::Span condition;
    diagnostics::Span call;
};

/// Returns the places in the code that `emit` generates for the same arguments.
[[nodiscard]] std::vector<ViolationPlace> violation_places(const ir::System&, const ir::Instantiation&,
                                                           const ir::ComponentRef& component, const Options&);

}  // namespace robochart::cpp_emit
