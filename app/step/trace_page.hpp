// SPDX-License-Identifier: Apache-2.0
// Renders the page of `conform --traces --html`. It shows logs, and replays the first run of each log on the diagrams
// of its machines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "conformance/traces/trace_check.hpp"
#include "driver/model/pipeline.hpp"

namespace robochart::app {

/// A log, and the result of its comparison with a component.
struct ComparedLog {
    std::string path;
    driver::Project* project = nullptr;
    std::string component;  ///< qualified
    conformance::LogReport counts;
    std::optional<conformance::RunReport> wrong;  ///< the first run that is not accepted
};

/// Renders the page. `limit` is the reason why not all logs were compared, or "" if all were compared. If `limit` is
/// not "", no run is replayed. A run is shown as far as the model can follow it. If there are many logs, only the first
/// ones are replayed. Polls the budget. Throws the exceptions of runs::Stepper.
[[nodiscard]] std::string trace_page(const std::vector<ComparedLog>& logs, const std::vector<driver::Part>& parts,
                                     const Options& options, const std::string& limit);

}  // namespace robochart::app
