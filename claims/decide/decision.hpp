// SPDX-License-Identifier: Apache-2.0
// A claim as processes and assertions in the timed script of its component (docs/claims.md, "How a claim is decided").
#pragma once

#include <string>
#include <vector>

#include "checker/cspm/syntax/syntax.hpp"
#include "claims/decide/automaton.hpp"
#include "claims/decide/letters.hpp"

namespace robochart::claims {

/// The declarations of one claim. Let M be its monitor as a process, with `tock` and the events of its letters, which
/// refuses what breaks the claim; P the timed process of the component, in which only these events are visible.
///     holds:      M [T= P   (for `possible`: not)
///     asked:      not M' [T= P, where M' is M without the states that ask something
///     happens:    not SKIP [T= P |\ X, where X are the events that the claim restricts
///     waiting:    for `leads to` without limit, P in which a time unit that passes while something is owed is
///                 `claims__waiting`, beside M; no run may have it infinitely often
///     standstill: (P [| letters, tock |] M with `tock` added to the states that owe nothing), with outputs taken at
///                 once, can always let time pass
struct Decision {
    std::vector<cspm::DeclPtr> declarations;  ///< processes
    cspm::DeclPtr holds;
    cspm::DeclPtr asked;       ///< null: something is asked from the start
    cspm::DeclPtr happens;     ///< null: the claim restricts no events of its own
    cspm::DeclPtr standstill;  ///< null: the claim owes nothing
    cspm::ExprPtr waiting;     ///< a process; null: every demand has a limit
    static constexpr const char* waiting_event = "claims__waiting";
};

/// `number`: of the claim, for the names of the processes. `outputs`: events that the environment takes at once.
[[nodiscard]] Decision decide_by_processes(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                           const Automaton& automaton, std::size_t number, const cspm::ExprPtr& process,
                                           const std::vector<cspm::ExprPtr>& outputs);

/// An assumption as a process beside the component, which refuses what breaks it and may always end. Where it refuses
/// to let time pass, the environment has to make an answer: the answer is then the event `due`, which is taken at once
/// where it is hidden. Otherwise the component would look as if it stopped time.
struct Assumed {
    /// An answer that the assumption demands.
    struct Due {
        std::string event;     ///< "P::M::clear.in"
        cspm::ExprPtr prefix;  ///< the same as an expression
        std::string due;       ///< its other name
    };
    std::vector<cspm::DeclPtr> declarations;
    std::vector<Due> due;
    cspm::ExprPtr process;  ///< the component with the assumption
};
/// Throws NotDecided if the assumption demands an event with values.
[[nodiscard]] Assumed assume_by_processes(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                          const Automaton& automaton, std::size_t number, cspm::ExprPtr component);

/// The declaration of the channels that the processes of all claims share.
[[nodiscard]] cspm::DeclPtr shared_channels();

}  // namespace robochart::claims
