// `conform --traces --html`: logs as a page, the first run of each stepped through on the diagrams of its machines.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/command/pipeline.hpp"
#include "conformance/traces/trace_check.hpp"

namespace robochart::app {

/// A log that was compared with its component.
struct ComparedLog {
    std::string path;
    Project* project = nullptr;
    std::string component;  ///< qualified
    conformance::LogReport counts;
    std::optional<conformance::RunReport> wrong;  ///< the first run that is not accepted
};

/// The page. `limit`: why not all logs were compared, and none is stepped through then; "" if all were. A run is shown
/// as far as the model can go its way; of many logs the first ones are stepped through. Polls the budget; throws what
/// runs::Stepper throws.
[[nodiscard]] std::string trace_page(const std::vector<ComparedLog>& logs, const std::vector<Part>& parts,
                                     const Options& options, const std::string& limit);

}  // namespace robochart::app
