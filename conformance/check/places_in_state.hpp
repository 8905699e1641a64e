// The places of machines (cpp_emit/plan/options.hpp) that a printed state of the code shows.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cpp_emit/plan/options.hpp"

namespace robochart::conformance {

/// Where the machines of a controller may miss events or take them late, as the generator knows it.
using EventPlaces = std::vector<cpp_emit::EventPlace>;

class PlacesInState {
public:
    /// The places outlive it.
    explicit PlacesInState(const EventPlaces& places);

    /// In the order of the members; `state` is the text of CodeSystem::print.
    [[nodiscard]] std::vector<const cpp_emit::EventPlace*> in(std::string_view state) const;
    /// How many events the platform raises.
    [[nodiscard]] std::size_t events() const { return events_; }

private:
    std::unordered_map<std::string, const cpp_emit::EventPlace*> by_name_;  ///< never iterated
    std::set<std::string> members_;
    std::size_t events_ = 0;
};

}  // namespace robochart::conformance
