// SPDX-License-Identifier: Apache-2.0
#include "tests/checker/machine/random_rules.hpp"

#include <algorithm>
#include <numeric>

#include "tests/checker/machine/rules_by_hand.hpp"

namespace robochart::machine {

using process::first_visible;
using process::tau;

Event RandomRules::event(std::uint32_t taus) {
    return chance(taus) ? tau : first_visible + below(visible);
}

ComponentPtr RandomRules::component(TermId meaning) {
    const std::uint32_t size = 2 + below(4);
    std::vector<std::vector<Component::RawEdge>> rows(size);
    for (auto& row : rows) {
        for (std::uint32_t edges = below(3) + below(2); edges > 0; --edges) {
            const Event by = event(30);
            row.push_back({by, by, below(size)});
        }
        std::ranges::sort(row, [](const auto& a, const auto& b) { return a.event < b.event; });
    }
    return std::make_shared<const Component>(rows, std::vector<TermId>(size, meaning));
}

/// Returns the level of each event, or an empty list if the region has no priorities.
std::vector<std::uint32_t> RandomRules::levels() {
    if (chance(40)) return {};
    std::vector<std::uint32_t> result(first_visible, 0);
    for (Event i = 0; i < visible; ++i) result.push_back(chance(40) ? no_level : below(3));
    return result;
}

Region RandomRules::region(const std::vector<Participant>& participants, const std::vector<std::uint32_t>& slots) {
    std::vector<EventSet> alphabets;
    for (const Participant& participant : participants)
        alphabets.push_back(participant.is_region ? made_.regions[participant.index].alphabet
                                                  : made_.components[participant.index]->alphabet());
    std::vector<DraftRule> drafts;
    for (std::uint32_t count = 4 + below(14); count > 0; --count) {
        DraftRule draft{event(50), {}, {}};
        for (std::uint32_t who = 0; who < participants.size(); ++who)
            if (!alphabets[who].empty() && chance(35))
                draft.parts.push_back({who, below(static_cast<std::uint32_t>(alphabets[who].size()))});
        if (draft.parts.empty()) continue;
        if (chance(10)) {
            const std::uint32_t slot = slots[below(static_cast<std::uint32_t>(slots.size()))];
            draft.assignments.push_back({slot, below(static_cast<std::uint32_t>(made_.components[slot]->size()) + 1)});
        }
        std::swap(draft.parts.front(), draft.parts[below(static_cast<std::uint32_t>(draft.parts.size()))]);
        drafts.push_back(std::move(draft));
    }
    const std::vector<std::uint32_t> level = levels();
    return region_of(participants, std::move(alphabets), std::move(drafts), level);
}

std::shared_ptr<const Supercombinator> RandomRules::next(const process::TermId& meaning) {
    made_ = {};
    const std::uint32_t count = 2 + below(4);
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        made_.components.push_back(component(meaning));
        made_.initial.push_back(0);
        made_.fields.push_back({slot, 0, 0xffU});
    }
    made_.words = count;
    // Inner regions take over some of the remaining participants.
    std::vector<Participant> open;
    std::vector<std::vector<std::uint32_t>> below_them;
    for (std::uint32_t slot = 0; slot < count; ++slot) {
        open.push_back({false, slot});
        below_them.push_back({slot});
    }
    for (std::uint32_t inner = below(3); inner > 0; --inner) {
        const std::size_t taken = 1 + below(static_cast<std::uint32_t>(open.size()));
        const std::size_t from = open.size() - taken;
        std::vector<std::uint32_t> slots;
        for (std::size_t i = from; i < open.size(); ++i)
            slots.insert(slots.end(), below_them[i].begin(), below_them[i].end());
        const auto first = open.begin() + static_cast<std::ptrdiff_t>(from);
        made_.regions.push_back(region({first, open.end()}, slots));
        open.resize(from);
        below_them.resize(from);
        open.insert(open.begin(), {true, static_cast<std::uint32_t>(made_.regions.size() - 1)});
        below_them.insert(below_them.begin(), slots);
    }
    std::vector<std::uint32_t> slots(count);
    std::iota(slots.begin(), slots.end(), 0U);
    made_.regions.push_back(region(open, slots));
    list_leading(made_, diagnostics::unlimited);
    return std::make_shared<const Supercombinator>(made_);
}

}  // namespace robochart::machine
