// SPDX-License-Identifier: Apache-2.0
// Types for lists that a component builds. The list in `setShots ! (all ^ <s>)` may be longer than each list that the
// component receives, so it gets a type with a larger carrier (docs/conformance.md, "Lists that are built").
#pragma once

#include <cstdint>
#include <map>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Maps the number of each type of lists to the length of its longest list.
using ListBounds = std::map<std::uint32_t, std::int64_t>;

/// Gives variables, events and parameters whose lists may be longer than `sequence_bound` types of their own, which are
/// copies of the old ones. Returns the bounds of these types. Lists without a bound, which grow in a loop, keep their
/// types.
[[nodiscard]] ListBounds separate_longer_lists(ir::System& system, const ir::Instantiation& instantiation);

/// Extends the carriers of these types to all lists up to the bounds. A carrier that would have more than `most` values
/// is not changed.
void extend_carriers(ir::Instantiation& instantiation, const ir::System& system, const ListBounds& bounds,
                     std::size_t most);

}  // namespace robochart::conformance
