// Calls (semantics 3.8). Not defined in the context: one event `opCall.args`. Defined: the operation's machine runs
// and then returns to its caller: written once for all calls (call_sharing.hpp), or inlined where it is called
// concurrently with something else; its parameters and variables are then parameters of those points too.
#pragma once

#include <vector>

#include "csp_emit/machine/rules/statements.hpp"

namespace robochart::csp_emit {

/// The operation that the statement calls runs, `rest` behind it.
[[nodiscard]] Next call(MachineTables&, const RunningThread&, const ir::Stmt&, const Program& rest, const Values&);
/// The call as an event.
[[nodiscard]] Branch call_event(const MachineTables&, const RunningThread&, const ir::Stmt&,
                                const std::vector<cspm::ExprPtr>& arguments);

}  // namespace robochart::csp_emit
