// SPDX-License-Identifier: Apache-2.0
// Converts the monitor of a claim to an explicit finite automaton over letters.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "claims/decide/letters.hpp"

namespace robochart::claims {

/// A state of the automaton. A missing successor breaks the claim, or satisfies a claim with `possible`.
struct AutomatonState {
    std::vector<std::optional<std::size_t>> by_letter;
    std::optional<std::size_t> by_tock;
    bool may_end = true;
    bool owes = false;              ///< true if the claim demands an event that has not occurred yet
    bool judges = false;            ///< true if the claim restricts states or variables in this state
    std::vector<bool> serves = {};  ///< for each letter, whether it is a response or an exception
    /// True if the claim can be broken in this state: by an event, by the passing of time, or by the end of the
    /// component.
    [[nodiscard]] bool asks() const;
};

/// The reachable states; the first is the initial state.
using Automaton = std::vector<AutomatonState>;

/// Throws NotDecided if there are too many states or a condition cannot be computed.
[[nodiscard]] Automaton make_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                       diagnostics::Budget* budget);

/// The channels of two inputs. In a cycle in which `event` is raised, `dropped` is ignored.
struct DroppedChannel {
    std::size_t event = 0, dropped = 0;
};

/// Makes the automaton of a claim about control cycles. The inputs that are raised in one cycle are simultaneous
/// (Monitor::order_raised). Therefore, the automaton collects them, and observes them when an output, a time unit or
/// the end follows.
[[nodiscard]] Automaton make_cycle_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                             const std::vector<DroppedChannel>& drops, diagnostics::Budget* budget);

}  // namespace robochart::claims
