// Compiled processes put together rule by rule, as no script would combine them.
#pragma once

#include <utility>
#include <vector>

#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// A rule of a region before it has its place there: what the participants do, what the region does then.
struct DraftRule {
    Event event;
    std::vector<Requirement> parts;  ///< the first one leads; events are places in the participants' alphabets
    std::vector<Assignment> assignments;
};

/// A region with these rules. `alphabets`: of each participant. `levels`: by event, the level of its priority or
/// `no_level`; events beyond the end have none.
[[nodiscard]] Region region_of(std::vector<Participant> participants, std::vector<EventSet> alphabets,
                               std::vector<DraftRule> drafts, const std::vector<std::uint32_t>& levels);

/// A component whose states have these transitions: of each state, events and targets.
[[nodiscard]] ComponentPtr component_of(const std::vector<std::vector<std::pair<Event, Local>>>& rows, TermId meaning);

}  // namespace robochart::machine
