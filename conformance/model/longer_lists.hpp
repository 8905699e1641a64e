// SPDX-License-Identifier: Apache-2.0
// Gives their own types to lists that a component builds. The list in `setShots ! (all ^ <s>)` may be longer than each
// list that the component receives, so it gets a type with a larger carrier (docs/conformance.md, "Lists that are
// built").
#pragma once

#include <cstdint>
#include <map>

#include "semantics/ir/instantiation.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::conformance {

/// Maps the number of a list type to the length of its longest list.
using ListBounds = std::map<std::uint32_t, std::int64_t>;

/// Gives own types, which are copies of the old ones, to variables, events and parameters whose lists may be longer
/// than `sequence_bound`. Returns the bounds of these types. Lists that grow in a loop have no bound and keep their
/// types.
[[nodiscard]] ListBounds separate_longer_lists(ir::System& system, const ir::Instantiation& instantiation);

/// Extends the carriers of these types to all lists up to the bounds. A carrier stays as it is if it would get more
/// than `most` values.
void extend_carriers(ir::Instantiation& instantiation, const ir::System& system, const ListBounds& bounds,
                     std::size_t most);

}  // namespace robochart::conformance
