// SPDX-License-Identifier: Apache-2.0
// Checks whether a compiled process stays the same if two groups of components are exchanged (an automorphism).
// docs/search.md, "Symmetry", states the conditions.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "base/diagnostics/pollable.hpp"
#include "checker/lts/symmetry.hpp"
#include "checker/machine/component_shape.hpp"
#include "checker/machine/supercombinator.hpp"

namespace robochart::machine {

/// Exchanges the components of two ranges of slots: the first with the first, the second with the second, and so on.
/// Other components do not change. Each shape numbers the states and events of a component. The exchange maps states or
/// events with equal numbers to each other.
class Exchange {
public:
    /// `shapes` contains the shape of each component in the two ranges, by slot. The ranges must be disjoint and
    /// equally long.
    Exchange(const Supercombinator& combined, const std::vector<ComponentShape>& shapes, SlotRange first,
             SlotRange second);

    /// Returns the events that the exchange maps to other events, or no value if the exchange is not an automorphism.
    /// Polls the budget for each state and each rule that it examines.
    [[nodiscard]] std::optional<lts::EventPermutation> find_exchanged_events(diagnostics::Pollable& budget);

private:
    using Places = std::vector<std::uint32_t>;  ///< by index in an alphabet: index of the event's image
    /// A rule without its event: its requirements and its assignments, both ascending.
    using Body = std::vector<std::uint32_t>;
    using EventsByBody = std::map<Body, std::vector<std::uint32_t>>;

    [[nodiscard]] std::uint32_t image_of_slot(std::uint32_t slot) const;
    [[nodiscard]] Local state(std::uint32_t slot, Local state) const;
    [[nodiscard]] bool moves_slot(std::uint32_t slot) const { return this->image_of_slot(slot) != slot; }

    [[nodiscard]] bool maps_component(std::uint32_t slot, diagnostics::Pollable& budget);
    bool map_regions();
    [[nodiscard]] bool map_participants(std::uint32_t region);
    [[nodiscard]] bool maps_rules(std::uint32_t region, diagnostics::Pollable& budget);
    [[nodiscard]] EventsByBody bodies(const Region& region, diagnostics::Pollable& budget) const;
    [[nodiscard]] EventsByBody map_requirements(std::uint32_t region, diagnostics::Pollable& budget) const;
    [[nodiscard]] std::optional<Places> event_images(const Region& from, const Region& to, const EventsByBody& bodies,
                                                     const EventsByBody& to_bodies) const;

    const Supercombinator& combined_;
    const std::vector<ComponentShape>& shapes_;
    SlotRange first_, second_;
    std::vector<Places> component_events_;                 // by slot; empty if every index is its own image
    std::vector<std::uint32_t> region_;                    // by region: the number of its image
    std::vector<std::vector<std::uint32_t>> participant_;  // by region and participant: its image's number there
    std::vector<Places> region_events_;                    // by region
};

}  // namespace robochart::machine
