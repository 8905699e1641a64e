// `step --html`: a process as one page that embeds what can be reached, on which one steps in a browser.
#pragma once

#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "app/step/step_files.hpp"
#include "runs/exploration.hpp"

namespace robochart::app {

/// "17 states, all that can be reached", or the limit that was reached.
[[nodiscard]] std::string counts_text(const runs::Exploration&);
/// The page; `parts`: of the model, whose machines are drawn; none for a process of a script.
[[nodiscard]] std::string step_page(const runs::Exploration&, const Stepped&, const std::vector<Part>& parts);

}  // namespace robochart::app
