// SPDX-License-Identifier: Apache-2.0
// The rules of swarms (docs/rules/RC-V*.md).
#pragma once

#include <vector>

#include "base/diagnostics/diagnostic.hpp"

namespace robochart::csp_emit::swarm_rules {

extern const diagnostics::Rule syntax;        ///< RC-V01
extern const diagnostics::Rule unknown_name;  ///< RC-V02
extern const diagnostics::Rule no_fit;        ///< RC-V03

[[nodiscard]] std::vector<const diagnostics::Rule*> all();

}  // namespace robochart::csp_emit::swarm_rules
