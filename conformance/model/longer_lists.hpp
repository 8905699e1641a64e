// SPDX-License-Identifier: Apache-2.0
// Introduces separate types for lists that a component builds. For example, the list in `setShots ! (all ^ <s>)` may be
// longer than every list that the component receives. So this list gets a type with a larger carrier
// (docs/conformance.md, "Lists that are built").
#pragma once

#include <cstdint>
#include <map>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Maps the number of a list type to the length of its longest list.
using ListBounds = std::map<std::uint32_t, std::int64_t>;

/// Finds the variables, events and parameters whose lists may be longer than `sequence_bound`, and replaces their types
/// by separate copies of these types. Returns the bounds of the new types. If a list grows in a loop, it has no bound,
/// and its type does not change.
[[nodiscard]] ListBounds separate_longer_lists(ir::System& system, const ir::Instantiation& instantiation);

/// Extends the carriers of these types, so that they contain all lists up to the bounds. If a carrier would have more
/// than `most` values, it does not change.
void extend_carriers(ir::Instantiation& instantiation, const ir::System& system, const ListBounds& bounds,
                     std::size_t most);

}  // namespace robochart::conformance
