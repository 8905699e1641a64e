// SPDX-License-Identifier: Apache-2.0
#include "checker/process/priority_order.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace robochart::process {
namespace {

using Below = std::map<Event, std::set<Event>>;

bool contains(const EventSet& set, Event event) {
    return std::ranges::binary_search(set, event);
}

/// Returns the events that are below `from`, directly or through other events.
std::set<Event> events_below(const Below& direct, Event from) {
    std::set<Event> found;
    std::vector<Event> work{from};
    while (!work.empty()) {
        const auto next = direct.find(work.back());
        work.pop_back();
        if (next == direct.end()) continue;
        for (Event lower : next->second)
            if (found.insert(lower).second) work.push_back(lower);
    }
    return found;
}

}  // namespace

std::vector<std::uint32_t> levels_of(const PriorityOrder& order) {
    std::vector<std::uint32_t> level(first_visible, 0);
    for (std::uint32_t i = 0; i < order.size(); ++i)
        for (Event event : order[i]) {
            if (event >= level.size()) level.resize(event + 1U, no_level);
            level[event] = std::min(level[event], i);
        }
    return level;
}

std::variant<Renaming, OrderFault> priority_order(const EventSet& prioritised, const std::vector<EventPair>& pairs,
                                                  const EventSet& maximal) {
    using Kind = OrderFault::Kind;
    Below direct;
    for (const auto& [higher, lower] : pairs) {
        for (Event event : {higher, lower})
            if (!contains(prioritised, event)) return OrderFault{Kind::missing, event};
        direct[higher].insert(lower);
    }
    for (Event event : maximal)
        if (!contains(prioritised, event)) return OrderFault{Kind::missing, event};
    Renaming result;
    for (Event event : prioritised)
        if (!contains(maximal, event)) {
            result.emplace_back(tau, event);
            result.emplace_back(tick, event);
        }
    for (const auto& [higher, lower] : direct)
        for (Event event : events_below(direct, higher)) {
            if (event == higher) return OrderFault{Kind::cyclic, event};
            if (contains(maximal, event)) return OrderFault{Kind::not_maximal, event};
            result.emplace_back(higher, event);
        }
    std::ranges::sort(result);
    return result;
}

}  // namespace robochart::process
