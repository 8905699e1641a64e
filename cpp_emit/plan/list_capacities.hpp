// SPDX-License-Identifier: Apache-2.0
// The capacities of the lists in deployed code: how many items a sequence, or a set of numbers, can have. A type has
// one capacity in the whole component, so that values pass between events, variables and expressions without
// conversion.
#pragma once

#include <optional>
#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "cpp_emit/plan/component.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::cpp_emit {

/// Whether the component has an event or variable of this name whose values contain lists, so that a capacity can be
/// given for it (Options::capacities).
[[nodiscard]] bool has_capacity(const ir::System&, const Component&, const std::string& name);

/// The model with capacities in the types of its lists (Type::sizes): the given ones, raised to the number of elements
/// of the longest literal of the type. No value if all lists have the usual capacity.
[[nodiscard]] std::optional<ir::System> with_capacities(const ir::System&, const Component&, const Options&);

/// Whether code for the expression builds a list, or receives one from the platform, that may have more items than its
/// capacity. False if the list is stored, is written as a literal, or consists of elements of a list of the same type.
[[nodiscard]] bool may_overflow(const ir::System&, const ir::Expr&);

/// The number of elements of the longest literal, constant or initial value among the lists with the usual capacity.
/// `Types::longest` must not be less.
[[nodiscard]] std::size_t least_longest(const ir::System&, const Component&);

/// Reports the events whose lists have the usual capacity, and the variables whose lists an assignment may make longer
/// in every cycle (RC-G16).
void report_capacities(const ir::System&, const Component&, const Options&, diagnostics::Diagnostics&);

}  // namespace robochart::cpp_emit
