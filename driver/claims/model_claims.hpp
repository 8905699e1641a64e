// SPDX-License-Identifier: Apache-2.0
// Decides the claims of a model.
#pragma once

#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// Decides the claims that the settings select, in the selected semantics, and adds the answers to the results. Errors
/// in CSP blocks and preferences are added to the project's diagnostics.
void check_assertions(Project&, const SearchContext&, ClaimResults&);

}  // namespace robochart::driver
