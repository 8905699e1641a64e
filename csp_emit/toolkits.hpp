// The functions of the toolkit libraries in CSPM, as far as the model uses them.
#pragma once

#include "csp_emit/project.hpp"

namespace robochart::csp_emit {

/// Definitions of the toolkit functions that the model calls and of those that these call, in a fixed order.
[[nodiscard]] std::vector<cspm::DeclPtr> toolkit_definitions(const Project&);
/// All of them, as CSPM text.
[[nodiscard]] std::string toolkit_text();

}  // namespace robochart::csp_emit
