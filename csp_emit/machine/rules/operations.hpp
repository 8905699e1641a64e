// SPDX-License-Identifier: Apache-2.0
// Calls (semantics 3.8). If the operation is not defined in the context, a call is one event `opCall.args`. If it is
// defined, the operation's machine runs and then returns to its caller. Its code is written once for all calls
// (call_sharing.hpp), or inlined if it is called concurrently with something else; its parameters and variables are
// then parameters of those points too.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Runs the operation that the statement calls, then `rest`.
[[nodiscard]] Next call(MachineTables&, const RunningThread&, const ir::Stmt&, const Program& rest, const Values&);
/// The call as an event.
[[nodiscard]] Branch call_event(const MachineTables&, const RunningThread&, const ir::Stmt&,
                                const std::vector<cspm::ExprPtr>& arguments);

}  // namespace robochart::csp_emit
