// SPDX-License-Identifier: Apache-2.0
// Defines the functions of the toolkit libraries in CSPM.
#pragma once

#include <string>

namespace robochart::csp_emit {

/// Every function of the toolkits, as CSPM text.
[[nodiscard]] std::string toolkit_text();

}  // namespace robochart::csp_emit
