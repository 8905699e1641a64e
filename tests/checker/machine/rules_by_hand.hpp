// SPDX-License-Identifier: Apache-2.0
// Builds compiled processes rule by rule, in combinations that no script produces.
#pragma once

#include <utility>
#include <vector>

#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// A rule of a region before it has an index in the region: the events of the participants and the event of the region.
struct DraftRule {
    Event event;
    std::vector<Requirement> parts;  ///< the first one leads; events are indexes into the participants' alphabets
    std::vector<Assignment> assignments;
};

/// The components in these slots perform this event together. The assignments set the states of components.
struct Joint {
    Event event;
    std::vector<std::uint32_t> slots;
    std::vector<Assignment> assignments;
};

/// The transitions of a component: events and targets for each state.
using Rows = std::vector<std::vector<std::pair<Event, Local>>>;

/// Returns a region with these rules. `alphabets` has one entry for each participant. `levels` contains the priority
/// level of each event, or `no_level`. Events beyond the end of `levels` have no level.
[[nodiscard]] Region region_of(std::vector<Participant> participants, std::vector<EventSet> alphabets,
                               std::vector<DraftRule> drafts, const std::vector<std::uint32_t>& levels);

/// Returns a component with these transitions.
[[nodiscard]] ComponentPtr component_of(const Rows& rows, TermId meaning);

}  // namespace robochart::machine
