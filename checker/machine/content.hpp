// SPDX-License-Identifier: Apache-2.0
// Computes the content of a compiled process: all data that determine its transitions. The content does not depend on
// the session that compiled the process, and contains no terms of states. Processes with equal content have equal
// packed states, and searches of them give equal results.
#pragma once

#include "base/cache/digest.hpp"
#include "checker/lts/graph.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Numbers events by their index in an ascending list. An event may have different numbers in two sessions. If both
/// sessions order the events in the same way, they compute the same content.
class EventPlaces {
public:
    /// `named` must be ascending.
    explicit EventPlaces(EventSet named);
    [[nodiscard]] const EventSet& named_events() const { return named_; }
    /// Returns the index of an event in the list.
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
