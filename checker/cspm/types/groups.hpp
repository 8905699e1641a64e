// SPDX-License-Identifier: Apache-2.0
// Sorts the declarations of a list by dependency.
#pragma once

#include <vector>

#include "checker/cspm/types/terms.hpp"

namespace robochart::cspm::types {

/// Returns groups of mutually dependent declarations. Each group comes after the groups on which it depends. The
/// members of a group are in the order of the list.
[[nodiscard]] std::vector<std::vector<Declaration*>> dependency_groups(DeclarationList& list);

}  // namespace robochart::cspm::types
