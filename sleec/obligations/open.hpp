// An obligation while it is open: what an event, or a second, does to it.
#pragma once

#include "sleec/obligations/obligation.hpp"

namespace robochart::sleec {

/// What became of it.
enum class Effect : std::uint8_t { open, fulfilled, broken };

/// Where an open obligation has come to.
struct Progress {
    std::int64_t elapsed = 0;  ///< seconds since its trigger; no further than matters
    std::uint32_t broken = 0;  ///< prohibitions of it that are broken, by their place

    friend auto operator<=>(const Progress&, const Progress&) = default;
};

/// Most demands that one obligation may have, so that `Progress` can hold a bit for each.
inline constexpr std::size_t most_demands = 15;

/// An event behind the trigger, at the instant reached.
[[nodiscard]] Effect take_event(const Obligation& obligation, Progress& progress, std::size_t event);
/// A second passes.
[[nodiscard]] Effect take_tock(const Obligation& obligation, Progress& progress);

/// The demands of an obligation that it cannot outlive this instant without, where that is so: else nothing. A demand
/// without limit is one where `never_again` says that its event is forbidden for ever.
template <class NeverAgain>
std::vector<const Demand*> due_now(const Obligation& obligation, const Progress& progress,
                                   const NeverAgain& never_again);
/// Whether the event is forbidden by it for ever.
[[nodiscard]] bool forbids_for_ever(const Obligation& obligation, const Progress& progress, std::size_t event);

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
        const bool last = demand.end == progress.elapsed || (demand.end == forever && never_again(demand.event));
        if (!last) return {};
        if (demand.begin <= progress.elapsed || demand.end == forever) due.push_back(&demand);
    }
    return due;
}

}  // namespace robochart::sleec
