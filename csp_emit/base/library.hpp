// What every script starts with: directions of events, bounded data types, and for timed scripts the operators that
// hand-written specifications use. The names are RoboTool's (semantics 3.10, 3.13), so that users' CSP blocks run.
#pragma once

#include <set>
#include <string>

#include "csp_emit/base/emission.hpp"
#include "semantics/ir/ir.hpp"

namespace robochart::csp_emit {

/// The library of one time, as CSPM text in our own wording.
[[nodiscard]] std::string library_text(Time);
/// With what the system's CSP blocks and assertions name of RoboTool's library beyond that.
[[nodiscard]] std::string library_text(const ir::System&, Time);

/// Everything that the libraries of both times declare at the top, the toolkits and the tick-tock model included.
[[nodiscard]] const std::set<std::string>& library_names();

}  // namespace robochart::csp_emit
