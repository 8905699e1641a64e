// The report of a run as one page: verdicts, diagrams, and each counterexample as steps on the diagrams. It needs no
// network and no other file, can be read without script, and lets nothing run but its own script, by hash
// (Content Security Policy Level 3).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/report/report.hpp"

namespace robochart::app {

/// The text of app/report/page/`path`.
[[nodiscard]] std::string page_part(std::string_view path);

/// The page; `parts`: of the run, whose diagrams are drawn.
[[nodiscard]] std::string render_html(const Report&, const std::vector<Part>& parts, const Options&);

}  // namespace robochart::app
