// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/exchange.hpp"

#include <algorithm>
#include <cassert>
#include <utility>

#include "base/diagnostics/containers.hpp"

namespace robochart::machine {
namespace {

constexpr std::uint32_t nowhere = static_cast<std::uint32_t>(-1);

using Edges = std::vector<std::pair<std::uint32_t, Local>>;  // event and target of each edge

/// Returns, for each region, the components below it, ascending.
std::vector<std::vector<std::uint32_t>> slots_below(const Supercombinator& combined) {
    std::vector<std::vector<std::uint32_t>> below;
    for (const Region& region : combined.regions) {
        std::vector<std::uint32_t> slots;
        for (const Participant& participant : region.participants)
            if (participant.is_region)
                slots.insert(slots.end(), below[participant.index].begin(), below[participant.index].end());
            else
                slots.push_back(participant.index);
        std::ranges::sort(slots);
        below.push_back(std::move(slots));
    }
    return below;
}

}  // namespace

Exchange::Exchange(const Supercombinator& combined, const std::vector<ComponentShape>& shapes, SlotRange first,
                   SlotRange second)
    : combined_(combined),
      shapes_(shapes),
      first_(first),
      second_(second),
      component_events_(combined.components.size()) {
    assert(first_.end <= second_.first && first_.end - first_.first == second_.end - second_.first);
}

std::uint32_t Exchange::image_of_slot(std::uint32_t slot) const {
    if (slot >= first_.first && slot < first_.end) return slot - first_.first + second_.first;
    if (slot >= second_.first && slot < second_.end) return slot - second_.first + first_.first;
    return slot;
}

Local Exchange::state(std::uint32_t slot, Local state) const {
    return moves_slot(slot) ? shapes_[this->image_of_slot(slot)].state[shapes_[slot].number[state]] : state;
}

std::optional<lts::EventPermutation> Exchange::find_exchanged_events(diagnostics::Pollable& budget) {
    for (const SlotRange& range : {first_, second_})
        for (std::uint32_t slot = range.first; slot < range.end; ++slot)
            if (!maps_component(slot, budget)) return std::nullopt;
    if (!map_regions()) return std::nullopt;
    for (std::uint32_t region = 0; region < combined_.regions.size(); ++region)
        if (!map_participants(region) || !maps_rules(region, budget)) return std::nullopt;
    const EventSet& whole = combined_.regions.back().alphabet;
    lts::EventPermutation events;
    for (std::uint32_t place = 0; place < whole.size(); ++place)
        if (region_events_.back()[place] != place)
            events.emplace_back(whole[place], whole[region_events_.back()[place]]);
    return events;
}

/// Checks condition 1: mapping states and events with equal numbers to each other is an isomorphism of the two
/// components. Their fields must have the same width, because each of them must hold the states of the other. For a
/// component that is never turned off, "off" is not a state.
bool Exchange::maps_component(std::uint32_t slot, diagnostics::Pollable& budget) {
    const std::uint32_t image = this->image_of_slot(slot);
    const Component& from = *combined_.components[slot];
    const Component& to = *combined_.components[image];
    if (combined_.fields[slot].mask != combined_.fields[image].mask) return false;
    if (from.size() != to.size() || from.alphabet().size() != to.alphabet().size()) return false;
    if (shapes_[slot].state.empty() || shapes_[image].state.empty()) return false;
    Places& events = component_events_[slot];
    events.resize(from.alphabet().size());
    for (std::uint32_t rank = 0; rank < events.size(); ++rank)
        events[shapes_[slot].event[rank]] = shapes_[image].event[rank];
    for (std::uint32_t place = 0; place < events.size(); ++place)
        for (const Event fixed : {process::tau, process::tick})
            if ((from.alphabet()[place] == fixed) != (to.alphabet()[events[place]] == fixed)) return false;
    Edges mapped;
    Edges expected;
    for (Local at = 0; at < from.size(); ++at) {
        budget.poll();
        mapped.clear();
        expected.clear();
        for (const Component::Edge& edge : from.edges(at))
            mapped.emplace_back(events[edge.event], state(slot, edge.target));
        for (const Component::Edge& edge : to.edges(state(slot, at))) expected.emplace_back(edge.event, edge.target);
        std::ranges::sort(mapped);
        std::ranges::sort(expected);
        if (mapped != expected) return false;
    }
    return true;
}

/// Checks condition 2: the image of each region is a region, over the images of its components. If several regions have
/// the same components, an inner region is mapped to an inner one.
bool Exchange::map_regions() {
    const std::vector<std::vector<std::uint32_t>> below = slots_below(combined_);
    std::vector<bool> taken(below.size(), false);
    for (const std::vector<std::uint32_t>& slots : below) {
        std::vector<std::uint32_t> images;
        for (const std::uint32_t slot : slots) images.push_back(image_of_slot(slot));
        std::ranges::sort(images);
        std::uint32_t image = 0;
        while (image < below.size() && (taken[image] || below[image] != images)) ++image;
        if (image == below.size()) return false;
        taken[image] = true;
        region_.push_back(image);
    }
    region_events_.resize(region_.size());
    participant_.resize(region_.size());
    return region_.back() + 1 == region_.size();
}

/// Checks the rest of condition 2: the images of the participants of a region are the participants of its image.
bool Exchange::map_participants(std::uint32_t region) {
    const auto key = [](bool is_region, std::uint32_t index) { return std::pair(is_region, index); };
    std::map<std::pair<bool, std::uint32_t>, std::uint32_t> numbers;
    for (const Participant& participant : combined_.regions[region_[region]].participants)
        numbers.emplace(key(participant.is_region, participant.index), static_cast<std::uint32_t>(numbers.size()));
    const std::vector<Participant>& participants = combined_.regions[region].participants;
    if (numbers.size() != participants.size()) return false;
    for (const Participant& participant : participants) {
        const auto image =
            numbers.find(key(participant.is_region,
                             participant.is_region ? region_[participant.index] : image_of_slot(participant.index)));
        if (image == numbers.end()) return false;
        participant_[region].push_back(image->second);
    }
    return true;
}

/// Checks condition 3: a permutation of events maps the region's rules to those of its image.
bool Exchange::maps_rules(std::uint32_t region, diagnostics::Pollable& budget) {
    const Region& from = combined_.regions[region];
    const Region& to = combined_.regions[region_[region]];
    if (from.rules.size() != to.rules.size() || from.alphabet.size() != to.alphabet.size()) return false;
    std::optional<Places> events = event_images(from, to, map_requirements(region, budget), bodies(to, budget));
    if (!events) return false;
    region_events_[region] = std::move(*events);
    return true;
}

Exchange::EventsByBody Exchange::bodies(const Region& region, diagnostics::Pollable& budget) const {
    EventsByBody result;
    using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;
    const auto as_set = [](Pairs& pairs) { diagnostics::sort_unique(pairs); };
    Pairs required, assigned;
    for (const Rule& rule : region.rules) {
        budget.poll();
        required.assign(1, {rule.lead.participant, rule.lead.event});
        for (std::uint32_t i = rule.first_requirement; i < rule.end_requirement; ++i)
            required.emplace_back(region.requirements[i].participant, region.requirements[i].event);
        assigned.clear();
        for (std::uint32_t i = rule.first_assignment; i < rule.end_assignment; ++i)
            assigned.emplace_back(region.assignments[i].slot, region.assignments[i].value);
        as_set(required);
        as_set(assigned);
        Body body{rule.level, static_cast<std::uint32_t>(required.size())};
        for (const Pairs* const pairs : {&required, &assigned})
            for (const auto& [who, what] : *pairs) body.insert(body.end(), {who, what});
        result[body].push_back(rule.place);
    }
    return result;
}

Exchange::EventsByBody Exchange::map_requirements(std::uint32_t region, diagnostics::Pollable& budget) const {
    Region mapped;
    const Region& from = combined_.regions[region];
    const auto image = [&](const Requirement& requirement) {
        const Participant& who = from.participants[requirement.participant];
        const Places& events = who.is_region ? region_events_[who.index] : component_events_[who.index];
        return Requirement{participant_[region][requirement.participant],
                           events.empty() ? requirement.event : events[requirement.event]};
    };
    mapped.rules = from.rules;
    for (Rule& rule : mapped.rules) rule.lead = image(rule.lead);
    for (const Requirement& requirement : from.requirements) mapped.requirements.push_back(image(requirement));
    for (const Assignment& assignment : from.assignments)
        mapped.assignments.push_back({image_of_slot(assignment.slot), state(assignment.slot, assignment.value)});
    return bodies(mapped, budget);
}

/// Returns the images of the events of rules that have these bodies. These images must be the expected events. If a
/// body occurs with several events, events with equal names are mapped to each other, and the others in their order.
std::optional<Exchange::Places> Exchange::event_images(const Region& from, const Region& to, const EventsByBody& bodies,
                                                       const EventsByBody& to_bodies) const {
    Places image(from.alphabet.size(), nowhere);
    std::vector<bool> taken(to.alphabet.size(), false);
    const auto map = [&](std::uint32_t place, std::uint32_t to_place) {
        if (image[place] != nowhere || taken[to_place]) return;
        image[place] = to_place;
        taken[to_place] = true;
    };
    if (bodies.size() != to_bodies.size()) return std::nullopt;
    for (const auto& [body, places] : bodies) {
        const auto found = to_bodies.find(body);
        if (found == to_bodies.end() || found->second.size() != places.size()) return std::nullopt;
        if (places.size() == 1) map(places.front(), found->second.front());
    }
    for (const auto& [body, places] : bodies) {
        const std::vector<std::uint32_t>& to_places = to_bodies.at(body);
        for (const std::uint32_t place : places)
            for (const std::uint32_t to_place : to_places)
                if (from.alphabet[place] == to.alphabet[to_place]) map(place, to_place);
        for (const std::uint32_t place : places)
            for (const std::uint32_t to_place : to_places) map(place, to_place);
    }
    for (const auto& [body, places] : bodies) {
        std::vector<std::uint32_t> mapped;
        for (const std::uint32_t place : places) mapped.push_back(image[place]);
        std::vector<std::uint32_t> expected = to_bodies.at(body);
        std::ranges::sort(mapped);
        std::ranges::sort(expected);
        if (mapped != expected) return std::nullopt;
    }
    for (std::uint32_t place = 0; place < image.size(); ++place) {
        assert(image[place] != nowhere);  // each event occurs in a rule, and each rule has a body
        for (const Event fixed : {process::tau, process::tick})
            if ((from.alphabet[place] == fixed) != (to.alphabet[image[place]] == fixed)) return std::nullopt;
    }
    return image;
}

}  // namespace robochart::machine
