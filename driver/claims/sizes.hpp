// SPDX-License-Identifier: Apache-2.0
// `check --sizes`: the numbers of states and transitions of the components of a script.
#pragma once

#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"
#include "driver/model/pipeline.hpp"
#include "driver/results/results.hpp"
#include "driver/settings/search_context.hpp"

namespace robochart::driver {

/// Explores D__ and O__ of each component, up to a million states, within the run's limits, and adds the sizes to the
/// results.
void measure_sizes(const Project&, cspm::Session&, const csp_emit::Emission&, csp_emit::Time, const SearchContext&,
                   ClaimResults&);

}  // namespace robochart::driver
