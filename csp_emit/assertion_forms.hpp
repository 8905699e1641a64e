// The CSPM forms of what is asserted of one process, as RoboTool generates them and FDR decides them.
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// `P :[deadlock free]`, a terminated process being deadlocked. Timed, with Ev = Events \ {tock, tock'}:
///     prioritise(P[[tock <- tock, tock <- tock']], <Ev, {tock}>) \ {tock} is divergence-free.
/// A hidden tock is performed only where P offers no other event but tock', so a divergence is a run in which, from
/// some point on, time passes for ever and nothing else is on offer.
[[nodiscard]] cspm::DeclPtr deadlock_free(const cspm::ExprPtr& process, bool timed, cspm::Model, bool negated = false);
/// `RUN({tock}) ||| CHAOS(Events \ {tock}) [F= P`, that is, every stable state of P accepts tock.
[[nodiscard]] cspm::DeclPtr timelock_free(const cspm::ExprPtr& process, bool negated = false);
/// `STOP [T= (P; r__ -> STOP) |\ {r__}`, so no ✓ is reachable, after which r__ would follow.
[[nodiscard]] cspm::DeclPtr never_terminates(const cspm::ExprPtr& process);
/// P; RUN({event}): P, which goes on with the event for ever where it has terminated.
[[nodiscard]] cspm::ExprPtr running_on(const cspm::ExprPtr& process, const std::string& event);
/// `SKIP [T= P`: P performs no event but ✓; negated: it performs one. RoboTool's specification is STOP, which forbids ✓
/// as well, so that every state of a terminating machine seems reachable.
[[nodiscard]] cspm::DeclPtr never(const cspm::ExprPtr& process, bool negated);

/// A copy of a machine that performs `unset__` where a guard reads the clock before its first reset, and `reset__` at a
/// reset.
struct ClockWatch {
    cspm::DeclPtr module;
    std::string name;       ///< of the module
    std::size_t reads = 0;  ///< guards that read the clock

    /// The copy with these arguments, of which one of the two events alone is seen.
    [[nodiscard]] cspm::ExprPtr only(const std::string& event, const std::vector<cspm::ExprPtr>& arguments) const;
};
/// `machine`: the path of one that has been emitted. `purpose`: what the module's name ends in. What its names mean is
/// added to the provenance of `emitted`.
[[nodiscard]] ClockWatch clock_watch(const Project&, NameManager&, Emitted& emitted, const std::string& machine,
                                     const std::string& clock, const std::string& purpose);

}  // namespace robochart::csp_emit
