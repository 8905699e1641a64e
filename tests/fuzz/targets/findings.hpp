// What every finding promises, whatever the text.
#pragma once

#include <string>

#include "diagnostics/diagnostic.hpp"
#include "diagnostics/source.hpp"

namespace robochart::fuzz {

/// Draws all findings, as text and as JSON, and looks at their places. Returns the first broken promise, "" if none.
[[nodiscard]] std::string check_findings(const diagnostics::SourceManager& sources,
                                         const diagnostics::Diagnostics& findings);

}  // namespace robochart::fuzz
