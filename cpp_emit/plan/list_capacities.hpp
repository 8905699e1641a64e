// SPDX-License-Identifier: Apache-2.0
// Determines the capacities of the lists in deployed code: how many items a sequence, or a set of numbers, can have. A
// type has one capacity in the whole component, so that values pass between events, variables and expressions without
// conversion.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Returns whether an event or variable of the component with this name has values that contain lists. A capacity can
/// then be given for the name (Options::capacities).
[[nodiscard]] bool has_capacity(const ir::System&, const Component&, const std::string& name);

/// Returns the model with capacities in the types of its lists (Type::sizes). These are the given ones, raised to the
/// number of elements of the longest literal of the type if necessary. Returns no value if all lists have the usual
/// capacity.
[[nodiscard]] std::optional<ir::System> with_capacities(const ir::System&, const Component&, const Options&);

/// Returns whether code for the expression builds a list that may have more items than its capacity, or receives such a
/// list from the platform. False if the list is stored, is written as a literal, or consists of elements of a list of
/// the same type.
[[nodiscard]] bool may_overflow(const ir::System&, const ir::Expr&);

/// Returns the number of elements of the longest literal, constant or initial value among the lists with the usual
/// capacity. `Types::longest` must be at least this number.
[[nodiscard]] std::size_t least_longest(const ir::System&, const Component&);

/// Reports the events whose lists have the usual capacity, and the variables whose lists an assignment may make longer
/// in every cycle (RC-G16).
void report_capacities(const ir::System&, const Component&, const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
