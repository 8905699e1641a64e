// A compiled process: component machines and the rules by which their events become events of the whole (FDR's
// supercombinators; Roscoe, "Understanding Concurrent Systems", 20.4 and 9.2; Gibson-Robinson et al., STTT 2016).
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "checker/lts/field.hpp"
#include "checker/machine/component.hpp"
#include "checker/machine/not_compiled.hpp"
#include "checker/machine/skeleton.hpp"
#include "checker/process/priority_order.hpp"

namespace robochart::machine {

using lts::Field;
using process::no_level;

/// One that takes part in the rules of a region: a component, or a region inside.
struct Participant {
    bool is_region = false;
    std::uint32_t index = 0;  ///< slot, or region
};

/// Of a component, the edges by events that some rule begins with.
struct Leading {
    std::vector<std::uint32_t> first;  ///< per state, one more at the end
    std::vector<Component::Edge> edges;
    /// None where the component is off.
    [[nodiscard]] Component::Edges of(Local state) const {
        if (state + 1U >= first.size()) return {};
        return Component::Edges(edges).subspan(first[state], first[state + 1U] - first[state]);
    }
};

/// What a rule asks of one component: to do this event.
struct Requirement {
    std::uint32_t participant;
    std::uint32_t event;  ///< place in the participant's alphabet
};

/// Beside what its participants do, a rule puts components into given states: it starts them, or turns them off.
struct Assignment {
    std::uint32_t slot;
    Local value;
};

/// "Where these participants perform these events, the region performs this one."
struct Rule {
    Event event;
    Event revealed;       ///< of a hidden event, its name; tau: that of the participant's tau; else the event
    std::uint32_t place;  ///< of the event in the region's alphabet
    std::uint32_t level;  ///< of the event in the region's priorities, or no_level
    Requirement lead;     ///< of the first participant
    std::uint32_t first_requirement, end_requirement;  ///< of the participants after the first
    std::uint32_t first_assignment, end_assignment;    ///< rules may share them
};

/// The rules between two prioritise operators: what lies above a prioritise sees only what it lets pass. A rule begins
/// with the participant that can do its part in the fewest of its states: rules that cannot fire are seldom looked at.
struct Region {
    std::vector<Participant> participants;
    std::vector<Leading> leading;                        ///< of each participant, once listed; empty for regions
    std::vector<EventSet> alphabets;                     ///< of each participant
    std::vector<Rule> rules;                             ///< ordered by first participant and its event
    std::vector<std::vector<std::uint32_t>> by_event;    ///< per place in the alphabet, the rules
    std::vector<double> chance;                          ///< per place: a guess in which part of the states it happens
    std::vector<std::vector<std::uint32_t>> first_rule;  ///< per participant and event, one more at the end
    std::vector<Requirement> requirements;
    std::vector<Assignment> assignments;
    EventSet alphabet;  ///< of all rules
};

/// The components of one operand: slots [first, end).
struct SlotRange {
    std::uint32_t first = 0, end = 0;
};

/// A compiled process as data.
struct Supercombinator {
    std::vector<ComponentPtr> components;  ///< by slot
    std::vector<SlotRange> operands;       ///< of all operators, each range once, large ones first
    std::vector<Region> regions;           ///< inner ones first; the last is the whole
    std::vector<Local> initial;            ///< by slot
    std::vector<Field> fields;             ///< by slot
    std::uint32_t words = 1;
};

/// The rules of a skeleton whose components are made. Throws NotCompiled beyond `most_rules`, and where the rules say
/// more than so many are worth. `poll` may throw to stop.
[[nodiscard]] Supercombinator combine(const process::TermStore& terms, const Skeleton& skeleton,
                                      std::vector<ComponentPtr> components, std::size_t most_rules,
                                      const std::function<void()>& poll);
/// What a system needs besides: the edges that rules begin with.
void list_leading(Supercombinator& combined, const std::function<void()>& poll);

}  // namespace robochart::machine
