// `check --sizes`: how many states and transitions the components of a script have.
#pragma once

#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"
#include "checker/cspm/session.hpp"
#include "csp_emit/emit.hpp"

namespace robochart::app {

/// Explores D__ and O__ of each component, up to a million states, with the run's limits; added to the report.
void measure_sizes(const Project&, cspm::Session&, const csp_emit::Emission&, csp_emit::Time, const Options&, Report&);

}  // namespace robochart::app
