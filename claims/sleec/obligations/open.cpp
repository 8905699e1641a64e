// SPDX-License-Identifier: Apache-2.0
// See open.hpp.
#include "claims/sleec/obligations/open.hpp"

#include <algorithm>

namespace robochart::sleec {
namespace {

/// Returns the second after which only windows without end can still change.
std::int64_t horizon(const Obligation& obligation) {
    std::int64_t last = 0;
    for (const Demand& demand : obligation.any)
        last = std::max(last, demand.end == forever ? demand.begin : demand.end + 1);
    return last;
}

bool can_still_hold(const Demand& demand, std::size_t place, const Progress& progress) {
    if (demand.forbids) return (progress.broken >> place & 1U) == 0;
    return demand.end >= progress.elapsed;
}

bool some_can_hold(const Obligation& obligation, const Progress& progress) {
    for (std::size_t i = 0; i < obligation.any.size(); ++i)
        if (can_still_hold(obligation.any[i], i, progress)) return true;
    return false;
}

}  // namespace

Effect take_event(const Obligation& obligation, Progress& progress, std::size_t event) {
    if (std::ranges::find(obligation.ended_by, event) != obligation.ended_by.end()) return Effect::fulfilled;
    for (std::size_t i = 0; i < obligation.any.size(); ++i) {
        const Demand& demand = obligation.any[i];
        if (!demand.event.contains(event) || progress.elapsed < demand.begin || progress.elapsed > demand.end) continue;
        if (!demand.forbids) return Effect::fulfilled;
        progress.broken |= 1U << i;
    }
    return some_can_hold(obligation, progress) ? Effect::open : Effect::broken;
}

Effect take_tock(const Obligation& obligation, Progress& progress) {
    progress.elapsed = std::min(progress.elapsed + 1, horizon(obligation));
    for (std::size_t i = 0; i < obligation.any.size(); ++i) {
        const Demand& demand = obligation.any[i];
        const bool respected = demand.forbids && (progress.broken >> i & 1U) == 0;
        if (respected && demand.end < progress.elapsed) return Effect::fulfilled;
    }
    return some_can_hold(obligation, progress) ? Effect::open : Effect::broken;
}

bool forbids_forever(const Obligation& obligation, const Progress& progress, std::size_t event) {
    for (std::size_t i = 0; i < obligation.any.size(); ++i) {
        const Demand& demand = obligation.any[i];
        if (!can_still_hold(demand, i, progress)) continue;
        if (!demand.forbids || !demand.event.contains(event) || demand.end != forever ||
            demand.begin > progress.elapsed)
            return false;
    }
    return true;
}

}  // namespace robochart::sleec
