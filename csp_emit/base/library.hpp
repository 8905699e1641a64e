// SPDX-License-Identifier: Apache-2.0
// Writes the beginning of every script: directions of events, bounded data types and, in timed scripts, operators for
// hand-written specifications. Names are those of RoboTool (semantics 3.10, 3.13), because the CSP blocks of users
// contain them.
#pragma once

#include <set>
#include <string>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// Returns the library for untimed or timed scripts as CSPM text. The text is not RoboTool's.
[[nodiscard]] std::string library_text(Time);
/// Returns the library. Adds definitions of RoboTool's library if a CSP block or an assertion of the system mentions
/// them.
[[nodiscard]] std::string library_text(const ir::System&, Time);

/// Returns all top-level names that the untimed and the timed library declare, including the toolkits and the tick-tock
/// model.
[[nodiscard]] const std::set<std::string>& library_names();

}  // namespace robochart::csp_emit
