// SPDX-License-Identifier: Apache-2.0
// Applies events and seconds to open obligations.
#pragma once

#include <algorithm>

#include "claims/sleec/obligations/obligation.hpp"

namespace robochart::sleec {

/// The effect of an event or a second on an open obligation.
enum class Effect : std::uint8_t { open, fulfilled, broken };

/// The progress of an open obligation.
struct Progress {
    std::int64_t elapsed = 0;  ///< seconds since its trigger; not counted beyond the last relevant second
    std::uint32_t broken = 0;  ///< bit set of its broken prohibitions, by index

    friend auto operator<=>(const Progress&, const Progress&) = default;
};

/// The largest number of demands of one obligation, so that `Progress` can store a bit for each.
inline constexpr std::size_t most_demands = 15;

/// Applies an event after the trigger, at the current instant.
[[nodiscard]] Effect take_event(const Obligation& obligation, Progress& progress, std::size_t event);
/// Applies the end of a second.
[[nodiscard]] Effect take_tock(const Obligation& obligation, Progress& progress);

/// Returns the demands of which one must be fulfilled at this instant to keep the obligation from being broken. The
/// result is empty if the obligation cannot be broken now. A demand without limit is included if `never_again` returns
/// true, which means that its event is forbidden forever.
template <class NeverAgain>
std::vector<const Demand*> due_now(const Obligation& obligation, const Progress& progress,
                                   const NeverAgain& never_again);
/// True if the obligation forbids the event forever.
[[nodiscard]] bool forbids_forever(const Obligation& obligation, const Progress& progress, std::size_t event);

template <class NeverAgain>
std::vector<const Demand*> due_now(const Obligation& obligation, const Progress& progress,
                                   const NeverAgain& never_again) {
    std::vector<const Demand*> due;
    for (std::size_t i = 0; i < obligation.any.size(); ++i) {
        const Demand& demand = obligation.any[i];
        if (demand.forbids) {
            if ((progress.broken >> i & 1U) == 0) return {};
            continue;
        }
        if (demand.end < progress.elapsed) continue;
        const bool last =
            demand.end == progress.elapsed || (demand.end == forever && std::ranges::all_of(demand.event, never_again));
        if (!last) return {};
        if (demand.begin <= progress.elapsed || demand.end == forever) due.push_back(&demand);
    }
    return due;
}

}  // namespace robochart::sleec
