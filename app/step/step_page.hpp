// SPDX-License-Identifier: Apache-2.0
// Renders the page of `step --html`, which contains the reachable states of a process, for stepping in a browser.
#pragma once

#include <string>
#include <vector>

#include "app/command/run_record.hpp"
#include "app/step/step_files.hpp"
#include "counterexample/exploration.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// Returns "17 states, all that can be reached", or a text with the limit that ended the exploration.
[[nodiscard]] std::string counts_text(const runs::Exploration&);
/// Renders the page. `parts` are those of the model, whose machines are drawn; empty for a process of a script.
[[nodiscard]] std::string step_page(const runs::Exploration&, const Stepped&, const std::vector<driver::Part>& parts,
                                    const RunRecord&);

}  // namespace robochart::app
