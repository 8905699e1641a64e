// The report of a run as one page: verdicts, diagrams, and each counterexample as steps on the diagrams. It needs no
// network and no other file (page.hpp), and can be read without script.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"

namespace robochart::app {

/// The page; `parts`: of the run, whose diagrams are drawn within the budget. Throws LimitReached.
[[nodiscard]] std::string render_html(const Report&, const std::vector<Part>& parts, diagnostics::Budget&);

/// A page of a run that has ended early, made by `page`. `may_draw`: nobody changes the parts; then it has diagrams if
/// they are drawn in a moment.
[[nodiscard]] std::string last_page(
    const std::vector<Part>& parts, bool may_draw,
    const std::function<std::string(const std::vector<Part>&, diagnostics::Budget&)>& page);

}  // namespace robochart::app
