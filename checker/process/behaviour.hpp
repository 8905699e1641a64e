// A run of a process taken apart: what each operand of its operators did in it, down to the sequential components, as
// FDR's debug tree has it. Works by the firing rules read backwards (firing_rules.cpp, composition_rules.cpp).
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

/// The entry of a trace for a step in which a part does nothing.
inline constexpr Event no_event = std::numeric_limits<Event>::max();

/// What one part of a process did in a run of the whole.
struct Behaviour {
    std::string name;             ///< the part where it begins, as people read it
    std::string op;               ///< the operator above `parts` as CSPM writes it; "" for a component
    std::vector<Event> trace;     ///< of every step of the whole, this part's event or no_event
    std::vector<Event> revealed;  ///< the same with hidden events by their names
    std::string state;            ///< the part where it ends
    EventSet offered;             ///< what it offers there: visible events and tick
    bool stable = true;           ///< it can do no tau there
    bool own_run = false;         ///< what was compressed: its trace counts the steps of a run of its own
    bool left = false;            ///< it ended before the whole did: another part took over, or it terminated
    std::vector<Behaviour> parts;
    TermId initial{};             ///< the part where it begins
    std::vector<TermId> reached;  ///< of every step that it took part in, the part behind it
    std::size_t begins = 0;       ///< the first step in which it is there
    std::size_t ends = std::numeric_limits<std::size_t>::max();  ///< the first step after it was left
    /// The part of a compression has a run of its own: of each of its steps, the step of the whole that shows it, or,
    /// for one that the compression does not show, the one before which (at the end: behind which) it is done.
    std::vector<std::size_t> shown_by;

    /// The events the part took part in, taus only where asked for.
    [[nodiscard]] std::vector<Event> events(bool with_taus) const;
};

/// Takes a run of `initial` apart. Each step's transition must be one of the semantics. A run that is large beyond
/// reading (parts, nesting) is taken apart only so far.
/// Without `offers` what the parts offer at the end is left out, and no state behind the run's is looked into.
[[nodiscard]] Behaviour behaviour(OperationalSemantics& semantics, TermId initial, const std::vector<Transition>& run,
                                  bool offers = true);

/// What one component does in a step of the whole.
struct Move {
    TermId part;      ///< the component in front of it
    Transition step;  ///< its own
};
/// One transition of a term taken apart. Looks at no state behind it.
[[nodiscard]] std::vector<Move> moves(OperationalSemantics& semantics, TermId term, const Transition& step);

}  // namespace robochart::process
