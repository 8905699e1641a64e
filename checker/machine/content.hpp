// SPDX-License-Identifier: Apache-2.0
// The content of a compiled process: the data on which its transitions depend, independent of the session that compiled
// it. If two compiled processes have equal content, their searches are equal and have equal packed states. The content
// does not include the terms of states.
#pragma once

#include "base/cache/digest.hpp"
#include "checker/lts/graph.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Numbers events by their indices in an ascending list. Two sessions may give the events different numbers. They still
/// compute the same content if the order of the numbers is the same.
class EventPlaces {
public:
    /// `named`: ascending.
    explicit EventPlaces(EventSet named);
    [[nodiscard]] const EventSet& named_events() const { return named_; }
    /// The index of an event in the list.
    [[nodiscard]] std::uint32_t index_of(Event event) const { return places_[event]; }

private:
    EventSet named_;
    std::vector<std::uint32_t> places_;  ///< by event
};

/// Adds the events of the process or graph, unsorted and possibly with duplicates.
void add_events(const Supercombinator&, EventSet& events);
void add_events(const lts::Graph&, EventSet& events);

void add_content(const Supercombinator&, const EventPlaces&, diagnostics::Hasher&);
void add_content(const lts::Graph&, const EventPlaces&, diagnostics::Hasher&);

}  // namespace robochart::machine
