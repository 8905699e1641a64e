// SPDX-License-Identifier: Apache-2.0
// The monitor of a claim as an explicit finite automaton over letters.
#pragma once

#include <optional>
#include <vector>

#include "base/diagnostics/budget.hpp"
#include "claims/decide/letters.hpp"

namespace robochart::claims {

/// A state of the automaton. A missing successor breaks the claim; for `possible`, it satisfies it.
struct AutomatonState {
    std::vector<std::optional<std::size_t>> by_letter;
    std::optional<std::size_t> by_tock;
    bool may_end = true;
    bool owes = false;              ///< an event is demanded
    bool judges = false;            ///< the states or variables are judged here
    std::vector<bool> serves = {};  ///< by letter: it is an answer or an exception
    /// Something is asked here: an event, the passing of time or the end would break the claim.
    [[nodiscard]] bool asks() const;
};

/// The reachable states; the initial one is the first.
using Automaton = std::vector<AutomatonState>;

/// Throws NotDecided if there are too many states or a condition cannot be computed.
[[nodiscard]] Automaton make_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                       diagnostics::Budget* budget);

/// Channels of two inputs: where `event` is raised, `dropped` does not count.
struct DroppedChannel {
    std::size_t event = 0, dropped = 0;
};

/// The automaton for cycles, in which inputs are raised: those of one cycle are simultaneous (Monitor::order_raised),
/// so it takes them into account when an output, time or the end follows.
[[nodiscard]] Automaton make_cycle_automaton(const CheckedClaim& claim, const std::vector<Letter>& letters,
                                             const std::vector<DroppedChannel>& drops, diagnostics::Budget* budget);

}  // namespace robochart::claims
