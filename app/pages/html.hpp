// The report of a run as one page: verdicts, diagrams, and each counterexample as steps on the diagrams. It needs no
// network and no other file (page.hpp), and can be read without script.
#pragma once

#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"

namespace robochart::app {

/// The page; `parts`: of the run, whose diagrams are drawn.
[[nodiscard]] std::string render_html(const Report&, const std::vector<Part>& parts, const Options&);

}  // namespace robochart::app
