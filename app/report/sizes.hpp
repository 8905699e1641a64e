// SPDX-License-Identifier: Apache-2.0
// `check --sizes`: the numbers of states and transitions of the components of a script.
#pragma once

#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"
#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::app {

/// Explores D__ and O__ of each component, up to a million states, within the run's limits, and adds the sizes to the
/// report.
void measure_sizes(const Project&, cspm::Session&, const csp_emit::Emission&, csp_emit::Time, const Options&, Report&);

}  // namespace robochart::app
