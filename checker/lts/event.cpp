// SPDX-License-Identifier: Apache-2.0
// Implements the table of events. Its first two entries are tau and tick.
#include "checker/lts/event.hpp"

#include <cassert>

namespace robochart::lts {

EventTable::EventTable() {
    intern("τ");
    intern("✓");
}

Event EventTable::intern(std::string_view name) {
    const auto [entry, fresh] = ids_.emplace(std::string(name), static_cast<Event>(names_.size()));
    if (fresh) names_.push_back(entry->first);
    assert(entry->second < names_.size() && ids_.size() == names_.size());
    return entry->second;
}

const std::string& EventTable::name(Event event) const {
    return names_.at(event);
}

}  // namespace robochart::lts
