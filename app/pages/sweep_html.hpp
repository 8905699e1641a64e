// SPDX-License-Identifier: Apache-2.0
// Renders a sweep as one page: the answers, the table of points, plots, and the world.
#pragma once

#include <string>

#include "app/command/run_record.hpp"
#include "simulation/sweep/sweep_plot.hpp"

namespace robochart::app {

[[nodiscard]] std::string render_sweep_html(const simulation::Scenario&, const simulation::SweepResult&,
                                            const std::vector<simulation::SweepPlot>&, const RunRecord&);

}  // namespace robochart::app
