// SPDX-License-Identifier: Apache-2.0
// Counts the states and transitions of the components of a script, for `check --sizes`.
#pragma once

#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// Explores the processes D__ and O__ of each component and adds their sizes to the results. Each exploration ends at a
/// million states, or at a limit of the run.
void measure_sizes(const Project&, cspm::Session&, const csp_emit::Emission&, csp_emit::Time, const SearchContext&,
                   ClaimResults&);

}  // namespace robochart::driver
