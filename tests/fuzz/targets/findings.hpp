// SPDX-License-Identifier: Apache-2.0
// Checks properties of findings that hold for every text.
#pragma once

#include <string>

#include "base/diagnostics/diagnostic.hpp"
#include "base/diagnostics/source.hpp"

namespace robochart::fuzz {

/// Prints all findings as text and as JSON, and checks their places. Returns the first violated property, or "" if
/// there is none.
[[nodiscard]] std::string check_findings(const diagnostics::SourceManager& sources,
                                         const diagnostics::Diagnostics& findings);

}  // namespace robochart::fuzz
