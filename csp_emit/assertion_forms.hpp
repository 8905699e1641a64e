// SPDX-License-Identifier: Apache-2.0
// Writes the CSPM forms of assertions about one process, as RoboTool generates them and FDR decides them.
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/syntax/build.hpp"
#include "csp_emit/base/component.hpp"
#include "csp_emit/base/names.hpp"

namespace robochart::csp_emit {

/// Asserts `P :[deadlock free]`, which counts a terminated process as deadlocked. In the timed semantics, with
/// Ev = A \ {tock, tock'}, asserts that the following process is divergence-free:
///     prioritise(P[[tock <- tock, tock <- tock']], <Ev, {tock}>) \ {tock}
/// A hidden tock is performed only if P offers no other event than tock'. So a divergence is a run in which, from some
/// point on, time passes forever and P offers nothing else. `alphabet` is A, which contains all events of P; null:
/// Events.
[[nodiscard]] cspm::DeclPtr deadlock_free(const cspm::ExprPtr& process, bool timed, cspm::Model, bool negated = false,
                                          const cspm::ExprPtr& alphabet = nullptr);
/// Asserts `RUN({tock}) ||| CHAOS(Events \ {tock}) [F= P`: every stable state of P accepts tock.
[[nodiscard]] cspm::DeclPtr timelock_free(const cspm::ExprPtr& process, bool negated = false);
/// Asserts `STOP [T= (P; r__ -> STOP) |\ {r__}`: no ✓ is reachable, because r__ would follow it.
[[nodiscard]] cspm::DeclPtr never_terminates(const cspm::ExprPtr& process);
/// Returns `P; RUN({event})`: after P has terminated, `event` stays possible forever.
[[nodiscard]] cspm::ExprPtr running_on(const cspm::ExprPtr& process, const std::string& event);
/// Asserts `SKIP [T= P`: P performs no event except ✓. If `negated`, asserts that P performs one. RoboTool's
/// specification STOP also forbids ✓; with it, every state of a terminating machine seems to be reachable.
[[nodiscard]] cspm::DeclPtr never_performs(const cspm::ExprPtr& process, bool negated);

/// Returns the effects of a component on its platform: its calls, outputs, and writes of variables that others share.
[[nodiscard]] std::vector<cspm::ExprPtr> outputs_of(const Provenance&, const std::string& path);

/// RoboSim: returns the channels of a component's registers, and the end of its execution. Returns an empty list for
/// components of RoboChart.
[[nodiscard]] std::vector<cspm::ExprPtr> cycle_events_of(const Provenance&, const std::string& path);

/// A copy of a machine that an assertion watches.
struct WatchedCopy {
    cspm::DeclPtr module;
    std::string name;       ///< name of the module
    std::size_t reads = 0;  ///< clock_watch: number of guards that read the clock

    [[nodiscard]] cspm::ExprPtr copy_process(const std::vector<cspm::ExprPtr>& arguments) const;
    [[nodiscard]] std::string event_of_copy(const std::string& own) const { return name + "::" + own; }
    /// Returns the copy with these arguments, in which all events except one are hidden.
    [[nodiscard]] cspm::ExprPtr only_event(const std::string& event, const std::vector<cspm::ExprPtr>& arguments) const;
};
/// Returns a copy of an emitted machine that performs `reset__` when a clock is reset, and `unset__` when a guard reads
/// a clock before its first reset. `machine` is the path of the machine. The name of the copy's module ends in
/// `purpose`. Adds the meaning of the new names to the provenance of `emitted`.
[[nodiscard]] WatchedCopy clock_watch(const Project&, NameManager&, Emitted& emitted, const std::string& machine,
                                      const std::string& clock, const std::string& purpose);
/// Returns a copy of a machine. When it offers an event, it shows whether it is in `state` (MachineContext::offered).
/// If `state` is null, the machine counts as inside until it ends.
[[nodiscard]] WatchedCopy offer_watch(const Project&, NameManager&, Emitted& emitted, const std::string& machine,
                                      const std::string& event, const ir::Node* state, const std::string& purpose);
/// Returns a process that performs `missed__` if and only if `event` can be missed for `units` time units by a copy
/// with these arguments. `name` is the name of a function that is added to `preparation`. Let W be the copy and O its
/// calls, outputs and writes:
///     L = prioritise(prioritise(W[[inside__ <- inside__, inside__ <- refused__]], <O, {tock}>), <{| E.in |},
///     {refused__}>)
/// L lets no time pass while the platform could accept an event of O, and performs `refused__` only if W is inside and
/// refuses E. The process is (L [| {| inside__, outside__, refused__, E.in, tock |} |] R(n + 1)) |\ {missed__}, where R
/// counts the tocks since the first refusal that has been followed only by `refused__`:
///     R(k) = inside__ -> R(n + 1) [] outside__ -> R(n + 1) [] E.in -> R(n + 1) [] refused__ -> R(min(k, n))
///            [] tock -> (if k > n then R(k) else if k > 1 then R(k - 1) else missed__ -> STOP)
[[nodiscard]] cspm::ExprPtr missing_process(const WatchedCopy&, const Emitted&, const std::string& event,
                                            std::int64_t units, const std::vector<cspm::ExprPtr>& arguments,
                                            const std::string& name, std::vector<cspm::DeclPtr>& preparation);

}  // namespace robochart::csp_emit
