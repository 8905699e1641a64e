// SPDX-License-Identifier: Apache-2.0
// Renders the report of a run as one page: verdicts, diagrams, and each counterexample as steps on the diagrams. The
// page needs no network and no other file (page.hpp), and is readable without scripts.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/command/run_record.hpp"
#include "app/report/report.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// Renders the page. It contains the diagrams of `parts`, which are drawn within the budget. Throws LimitReached.
[[nodiscard]] std::string render_html(const Report&, const std::vector<driver::Part>& parts, const RunRecord&,
                                      diagnostics::Budget&);

/// Returns the page of a run that ended early, rendered by `page`. `may_draw` is true if no other thread changes the
/// parts. The page then contains the diagrams, if they can be drawn quickly.
[[nodiscard]] std::string last_page(
    const std::vector<driver::Part>& parts, bool may_draw,
    const std::function<std::string(const std::vector<driver::Part>&, diagnostics::Budget&)>& page);

}  // namespace robochart::app
