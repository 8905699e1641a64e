// SPDX-License-Identifier: Apache-2.0
#include "tests/checker/machine/rules_by_hand.hpp"

#include <algorithm>
#include <set>

namespace robochart::machine {

Region region_of(std::vector<Participant> participants, std::vector<EventSet> alphabets, std::vector<DraftRule> drafts,
                 const std::vector<std::uint32_t>& levels) {
    Region made;
    made.participants = std::move(participants);
    made.alphabets = std::move(alphabets);
    const auto lead = [](const DraftRule& draft) {
        return std::pair(draft.parts.front().participant, draft.parts.front().event);
    };
    std::ranges::stable_sort(drafts, [&](const DraftRule& a, const DraftRule& b) { return lead(a) < lead(b); });
    std::set<Event> events;
    for (const DraftRule& draft : drafts) events.insert(draft.event);
    made.alphabet.assign(events.begin(), events.end());
    made.by_event.resize(events.size());
    made.first_rule.resize(made.participants.size());
    auto next = drafts.begin();
    for (std::uint32_t who = 0; who < made.participants.size(); ++who)
        for (std::uint32_t by = 0; by <= made.alphabets[who].size(); ++by) {
            made.first_rule[who].push_back(static_cast<std::uint32_t>(made.rules.size()));
            for (; next != drafts.end() && lead(*next) == std::pair(who, by); ++next) {
                Rule rule{};
                rule.event = rule.revealed = next->event;
                rule.place = static_cast<std::uint32_t>(std::ranges::lower_bound(made.alphabet, next->event) -
                                                        made.alphabet.begin());
                rule.level = next->event < levels.size() ? levels[next->event] : no_level;
                rule.lead = next->parts.front();
                rule.first_requirement = static_cast<std::uint32_t>(made.requirements.size());
                made.requirements.insert(made.requirements.end(), next->parts.begin() + 1, next->parts.end());
                rule.end_requirement = static_cast<std::uint32_t>(made.requirements.size());
                rule.first_assignment = static_cast<std::uint32_t>(made.assignments.size());
                made.assignments.insert(made.assignments.end(), next->assignments.begin(), next->assignments.end());
                rule.end_assignment = static_cast<std::uint32_t>(made.assignments.size());
                made.by_event[rule.place].push_back(static_cast<std::uint32_t>(made.rules.size()));
                made.rules.push_back(rule);
            }
        }
    return made;
}

ComponentPtr component_of(const Rows& rows, TermId meaning) {
    std::vector<std::vector<Component::RawEdge>> edges(rows.size());
    for (std::size_t state = 0; state < rows.size(); ++state) {
        for (const auto& [event, target] : rows[state]) edges[state].push_back({event, event, target});
        std::ranges::stable_sort(edges[state], [](const auto& a, const auto& b) { return a.event < b.event; });
    }
    return std::make_shared<const Component>(edges, std::vector<TermId>(rows.size(), meaning));
}

}  // namespace robochart::machine
