// SPDX-License-Identifier: Apache-2.0
// Represents events by numbers. Stores the name of each event.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace robochart::lts {

using Event = std::uint32_t;
inline constexpr Event tau = 0;   ///< the invisible action
inline constexpr Event tick = 1;  ///< successful termination, printed as ✓
inline constexpr Event first_visible = 2;

/// Assigns consecutive numbers to the names of events. A visible event gets the next number when its name is first
/// interned.
class EventTable {
public:
    EventTable();
    Event intern(std::string_view name);
    [[nodiscard]] const std::string& name(Event) const;
    [[nodiscard]] std::size_t size() const { return names_.size(); }

private:
    std::vector<std::string> names_;
    std::unordered_map<std::string, Event> ids_;
};

using EventSet = std::vector<Event>;  ///< ascending; never contains tau; contains tick only where a comment says so

}  // namespace robochart::lts
