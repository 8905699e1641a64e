// SPDX-License-Identifier: Apache-2.0
// Splits a run of a process into the behaviours of its operands, down to sequential components, as FDR's debug tree
// does. To do this, applies the firing rules backwards (firing_rules.cpp, composition_rules.cpp).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

/// In the trace of a part: the part performs no event in this step of the process.
inline constexpr Event no_event = std::numeric_limits<Event>::max();

/// What one part of a process does in a run of the whole process.
struct Behaviour {
    std::string name;             ///< description of the part's initial state
    std::string op;               ///< the operator above `parts` in CSPM's notation; "" for a component
    std::vector<Event> trace;     ///< for every step of the whole process: the event of this part, or no_event
    std::vector<Event> revealed;  ///< as `trace`, but with the names of hidden events
    std::string state;            ///< description of the part's last state
    EventSet offered;             ///< visible events and tick that the last state offers
    bool stable = true;           ///< true if the last state has no tau
    bool own_run = false;         ///< true for the operand of a compression, whose trace is that of a separate run
    bool left = false;  ///< true if the part ended before the whole process: another part replaced it, or it terminated
    std::vector<Behaviour> parts;
    TermId initial{};             ///< the part's initial term
    std::vector<TermId> reached;  ///< for every step in which the part participated: its next term
    std::size_t begins = 0;       ///< the first step in which the part is active
    std::size_t ends = std::numeric_limits<std::size_t>::max();  ///< the first step after the part ended
    /// The operand of a compression has a separate run. For each step of that run, this list contains the step of the
    /// whole process in which its event is visible. If the event is not visible, the list contains the next step of the
    /// whole process, or the last step if there is no next one.
    std::vector<std::size_t> shown_by;
};

/// Splits a run of `initial`. Each step must be a transition of the semantics. The parts of a very large run, and their
/// nesting, are split only up to a limit. Without `offers`, the result lacks the offers of the parts at the end, and no
/// state after the run is computed.
[[nodiscard]] Behaviour behaviour(OperationalSemantics& semantics, TermId initial, const std::vector<Transition>& run,
                                  bool offers = true);

/// The move of one component in a step of the whole process.
struct Move {
    TermId part;      ///< the component before the step
    Transition step;  ///< the component's own step
};
/// Splits one transition of a term into the moves of its components. Does not compute the states after it.
[[nodiscard]] std::vector<Move> split_transition(OperationalSemantics& semantics, TermId term, const Transition& step);

}  // namespace robochart::process
