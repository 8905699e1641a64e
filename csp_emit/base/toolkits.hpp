// SPDX-License-Identifier: Apache-2.0
// Defines the functions of the toolkit libraries in CSPM.
#pragma once

#include <string>

namespace robochart::csp_emit {

/// Returns the CSPM text of all functions of the toolkits.
[[nodiscard]] std::string toolkit_text();

}  // namespace robochart::csp_emit
