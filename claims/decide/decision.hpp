// SPDX-License-Identifier: Apache-2.0
// Expresses a claim by processes and assertions in the timed script of its component (docs/claims.md, "How a claim is
// decided").
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "claims/decide/automaton.hpp"
#include "claims/decide/letters.hpp"

namespace robochart::claims {

/// The declarations for one claim. Let M be the claim's monitor as a process over `tock` and the events of its letters.
/// M refuses every event that breaks the claim. Let P be the timed process of the component, in which only these events
/// are visible.
///     holds:      M [T= P   (for `possible`: not)
///     asked:      not M' [T= P, where M' is M without the states in which the claim can be broken
///     happens:    not SKIP [T= P |\ X, where X are the events that the claim restricts
///     waiting:    for `leads to` without a time limit: P in parallel with M, where M may select a pending response.
///                 Time units that pass while this response stays pending are `claims__waiting`. The claim fails iff
///                 some run contains `claims__waiting` infinitely often.
///     standstill: (P [| letters, tock |] M'') can always let time pass. M'' is M with `tock` added to the states in
///                 which no response is pending. The environment takes outputs at once.
struct Decision {
    std::vector<cspm::DeclPtr> declarations;  ///< processes
    cspm::DeclPtr holds;
    cspm::DeclPtr asked;       ///< null if the claim can already be broken in the initial state
    cspm::DeclPtr happens;     ///< null if this kind of claim does not restrict its events
    cspm::DeclPtr standstill;  ///< null if the claim never demands an event
    cspm::ExprPtr waiting;     ///< the process of `waiting`; null if every demand has a time limit
    static constexpr const char* waiting_event = "claims__waiting";
};

/// Makes the declarations for a claim. `number` is the number of the claim, which the names of the processes contain.
/// `outputs` are the events that the environment takes at once.
[[nodiscard]] Decision decide_by_processes(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                           const Automaton& automaton, std::size_t number, const cspm::ExprPtr& process,
                                           const std::vector<cspm::ExprPtr>& outputs);

/// An assumption as a process in parallel with the component. The process refuses every event that would break the
/// assumption, and may always terminate. If it refuses to let time pass, the environment must perform the demanded
/// response. This response is then a separate event `due`, which happens at once when it is hidden. Without this event,
/// the component would appear to stop time.
struct Assumed {
    /// A response that the assumption demands.
    struct Due {
        std::string event;     ///< "P::M::clear.in"
        cspm::ExprPtr prefix;  ///< the same event as an expression
        std::string due;       ///< the event that replaces it when it is due
    };
    std::vector<cspm::DeclPtr> declarations;
    std::vector<Due> due;
    cspm::ExprPtr process;  ///< the component with the assumption
};
/// Throws NotDecided if the assumption demands an event with values.
[[nodiscard]] Assumed assume_by_processes(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                          const Automaton& automaton, std::size_t number, cspm::ExprPtr component);

/// Returns the declaration of the channels that the processes of all claims share.
[[nodiscard]] cspm::DeclPtr shared_channels();

}  // namespace robochart::claims
