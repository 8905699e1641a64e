// SPDX-License-Identifier: Apache-2.0
#include "conformance/check/places_in_state.hpp"

namespace robochart::conformance {

namespace {

/// Returns the value of a member in the text of a state. Members of operations follow those of their machines.
std::string_view value_in(std::string_view state, const std::string& member) {
    const std::string prefix = member + "=";
    for (std::size_t at = state.find(prefix); at != std::string_view::npos; at = state.find(prefix, at + 1)) {
        if (at != 0 && state[at - 1] != ' ') continue;
        const std::string_view rest = state.substr(at + prefix.size());
        return rest.substr(0, rest.find(' '));
    }
    return {};
}

}  // namespace

PlacesInState::PlacesInState(const EventPlaces& places) {
    for (const cpp_emit::EventPlace& place : places) {
        by_name_[place.member + "=" + place.place] = &place;
        members_.insert(place.member);
    }
    if (!places.empty()) events_ = places.front().events.size();
}

std::vector<const cpp_emit::EventPlace*> PlacesInState::find_places(std::string_view state) const {
    std::vector<const cpp_emit::EventPlace*> result;
    for (const std::string& member : members_) {
        const auto found = by_name_.find(member + "=" + std::string(value_in(state, member)));
        if (found != by_name_.end()) result.push_back(found->second);
    }
    return result;
}

}  // namespace robochart::conformance
