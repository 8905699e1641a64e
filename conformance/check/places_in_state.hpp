// SPDX-License-Identifier: Apache-2.0
// Finds the places of machines (cpp_emit/plan/options.hpp) in a printed state of the code.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cpp_emit/plan/options.hpp"

namespace robochart::conformance {

/// The places in which machines of a controller may miss events or take them late, as the generator determined them.
using EventPlaces = std::vector<cpp_emit::EventPlace>;

class PlacesInState {
public:
    /// `places` must outlive the object.
    explicit PlacesInState(const EventPlaces& places);

    /// Returns the places of the machines in a state, in the order of the members. `state` is the text of
    /// CodeSystem::print.
    [[nodiscard]] std::vector<const cpp_emit::EventPlace*> find_places(std::string_view state) const;
    /// Returns the number of events that the platform raises.
    [[nodiscard]] std::size_t event_count() const { return events_; }

private:
    std::unordered_map<std::string, const cpp_emit::EventPlace*> by_name_;  ///< never iterated
    std::set<std::string> members_;
    std::size_t events_ = 0;
};

}  // namespace robochart::conformance
