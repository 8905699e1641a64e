// SPDX-License-Identifier: Apache-2.0
// Sorts the declarations of a list by dependency.
#pragma once

#include <vector>

#include "checker/cspm/types/terms.hpp"

namespace robochart::cspm::types {

/// Returns the groups of declarations that depend on each other. A group comes after all groups on which it depends.
/// Inside a group, the order is that of the list.
[[nodiscard]] std::vector<std::vector<Declaration*>> dependency_groups(DeclarationList& list);

}  // namespace robochart::cspm::types
