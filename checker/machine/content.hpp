// SPDX-License-Identifier: Apache-2.0
// Computes the content of a compiled process: the data that determine its transitions, independent of the session that
// compiled the process. Compiled processes with equal content have equal packed states, and searches of them are equal.
// The content does not include the terms of states.
#pragma once

#include "base/cache/digest.hpp"
#include "checker/lts/graph.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Numbers events by their indices in an ascending list. If two sessions give the events different numbers in the same
/// order, they still compute the same content.
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
