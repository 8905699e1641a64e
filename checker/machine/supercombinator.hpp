// SPDX-License-Identifier: Apache-2.0
// Represents a compiled process: component machines and rules. A rule combines events of components to an event of the
// whole process. FDR calls this a supercombinator (Roscoe, "Understanding Concurrent Systems", 20.4 and 9.2;
// Gibson-Robinson et al., STTT 2016).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/field.hpp"
#include "checker/machine/component.hpp"
#include "checker/machine/not_compiled.hpp"
#include "checker/machine/skeleton.hpp"
#include "checker/process/priority_order.hpp"

namespace robochart::machine {

using lts::Field;
using process::no_level;

/// A participant in the rules of a region: a component, or an inner region.
struct Participant {
    bool is_region = false;
    std::uint32_t index = 0;  ///< number of the slot or region
};

/// The edges of a component whose events begin a rule, that is, rules with this component as the first participant.
struct Leading {
    std::vector<std::uint32_t> first;  ///< by state: its first edge; one more at the end
    std::vector<Component::Edge> edges;
    /// Returns the edges of a state; none if the component is off.
    [[nodiscard]] Component::Edges edges_of(Local state) const {
        if (state + 1U >= first.size()) return {};
        return Component::Edges(edges).subspan(first[state], first[state + 1U] - first[state]);
    }
};

/// A condition of a rule: this participant performs this event.
struct Requirement {
    std::uint32_t participant;
    std::uint32_t event;  ///< index in the participant's alphabet
};

/// Starts a component or turns it off: the rule sets its state, although the component has no part in the rule's
/// event.
struct Assignment {
    std::uint32_t slot;
    Local value;
};

/// A rule: if these participants perform these events together, the region performs this event.
struct Rule {
    Event event;
    /// The event for display. If the rule hides an event, this is the hidden event. If the event is a tau of a
    /// participant, this is the event that the participant reveals. Otherwise this is the event itself.
    Event revealed;
    std::uint32_t place;                               ///< index of the event in the region's alphabet
    std::uint32_t level;                               ///< level of the event in the region's priorities, or no_level
    Requirement lead;                                  ///< requirement for the first participant
    std::uint32_t first_requirement, end_requirement;  ///< requirements for the other participants
    std::uint32_t first_assignment, end_assignment;    ///< several rules may share assignments
};

/// The rules of the operators between one prioritise and the next. Each prioritise needs a region, because the
/// operators above it may only see the events that it allows. The first participant of a rule is the one whose event is
/// possible in the fewest states, so most rules that cannot fire are never examined.
struct Region {
    std::vector<Participant> participants;
    std::vector<Leading> leading;                      ///< by participant, set by list_leading; empty for regions
    std::vector<EventSet> alphabets;                   ///< by participant
    std::vector<Rule> rules;                           ///< sorted by first participant and its event
    std::vector<std::vector<std::uint32_t>> by_event;  ///< by index in the alphabet: the rules
    /// By index in the alphabet: an estimate of how often the event is possible, as a fraction of the states.
    std::vector<double> chance;
    std::vector<std::vector<std::uint32_t>> first_rule;  ///< by participant and event, one more at the end
    std::vector<Requirement> requirements;
    std::vector<Assignment> assignments;
    EventSet alphabet;  ///< events of all rules
};

/// The components of one operand: slots [first, end).
struct SlotRange {
    std::uint32_t first = 0, end = 0;
};

/// The data of a compiled process.
struct Supercombinator {
    std::vector<ComponentPtr> components;  ///< by slot
    std::vector<SlotRange> operands;       ///< ranges of all operators, without duplicates, large ones first
    std::vector<Region> regions;           ///< inner regions first; the last region is the whole process
    std::vector<Local> initial;            ///< by slot
    std::vector<Field> fields;             ///< by slot
    std::uint32_t words = 1;
};

/// Returns the rules of a skeleton with these components. Throws NotCompiled if there are more than `most_rules` rules,
/// or if building them takes too much work. Polls the budget.
[[nodiscard]] Supercombinator combine(const process::TermStore& terms, const Skeleton& skeleton,
                                      std::vector<ComponentPtr> components, std::size_t most_rules,
                                      diagnostics::Pollable& budget);
/// Adds data for a quick start of rules: the edges of their first participants.
void list_leading(Supercombinator& combined, diagnostics::Pollable& budget);

}  // namespace robochart::machine
