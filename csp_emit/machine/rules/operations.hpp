// SPDX-License-Identifier: Apache-2.0
// Applies the rules for calls (semantics 3.8). If the context does not define the operation, a call is one event
// `opCall.args`. Otherwise the operation's machine runs and then returns to its caller. All calls share the operation's
// code (call_sharing.hpp), unless another thread runs concurrently with the call. In that case the code is inlined, and
// the operation's parameters and variables become parameters of the inlined points.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// Runs the operation that the statement calls, then `rest`.
[[nodiscard]] Next call_operation(MachineTables&, const RunningThread&, const ir::Stmt&, const Program& rest,
                                  const Values&);
/// Performs the call as an event.
[[nodiscard]] Branch call_event(const MachineTables&, const RunningThread&, const ir::Stmt&,
                                const std::vector<cspm::ExprPtr>& arguments);

}  // namespace robochart::csp_emit
