// SPDX-License-Identifier: Apache-2.0
// Combines a rule that requires an event of an inner region with the rules of that region for the event. Changes have
// the same order as in SupercombinatorSystem: those of the participants, in the order of the requirements, and then the
// assignments of the rule. If several of them change one slot, the last one counts.
#include "checker/machine/whole_rules.hpp"

#include <algorithm>
#include <cassert>
#include <map>

namespace robochart::machine {
namespace {

constexpr std::size_t most_parts = 4'000'000;

struct TooMany {};

class Flattening {
public:
    Flattening(const Supercombinator& combined, diagnostics::Pollable& budget)
        : combined_(combined), budget_(budget), inside_(combined.regions.size()), slots_(combined.regions.size()) {}

    std::vector<std::vector<WholeRule>> list_by_region() {
        std::vector<std::vector<WholeRule>> result;
        for (std::uint32_t region = 0; region < combined_.regions.size(); ++region) {
            inside_[region] = flatten_region(region);
            std::vector<WholeRule>& rules = result.emplace_back();
            for (const Changes& changes : inside_[region]) rules.push_back(make_whole_rule(changes));
        }
        return result;
    }

    WholeRules run() {
        const auto whole = static_cast<std::uint32_t>(combined_.regions.size() - 1);
        for (std::uint32_t region = 0; region <= whole; ++region) list_slots(region);
        for (std::uint32_t region = 0; region < whole; ++region) inside_[region] = flatten_region(region);
        for (const Changes& changes : flatten_region(whole)) result_.rules.push_back(make_whole_rule(changes));
        index();
        return std::move(result_);
    }

private:
    /// A change of one slot: the component performs an event, or a rule sets its state.
    struct Change {
        std::uint32_t slot;
        std::optional<std::uint32_t> event;
        Local value;
    };
    /// A rule of a region in which changes of components replace the events of inner regions. The changes are in the
    /// order in which they are applied.
    struct Changes {
        Event event = process::tau;
        std::uint32_t place = 0;
        std::uint32_t rule = 0;
        std::vector<Change> list;
        std::vector<Passage> passages;
    };

    void list_slots(std::uint32_t region) {
        for (const Participant& participant : combined_.regions[region].participants) {
            if (!participant.is_region) {
                slots_[region].push_back(participant.index);
                continue;
            }
            const std::vector<std::uint32_t>& inner = slots_[participant.index];
            slots_[region].insert(slots_[region].end(), inner.begin(), inner.end());
        }
    }

    std::vector<Changes> flatten_region(std::uint32_t number) {
        const Region& region = combined_.regions[number];
        std::vector<Changes> result;
        for (std::uint32_t rule_number = 0; rule_number < region.rules.size(); ++rule_number) {
            const Rule& rule = region.rules[rule_number];
            std::vector<Changes> open{{rule.event, rule.place, rule_number, {}, {{number, rule.level}}}};
            extend(region, rule.lead, open);
            for (std::uint32_t i = rule.first_requirement; i < rule.end_requirement; ++i)
                extend(region, region.requirements[i], open);
            for (Changes& changes : open) {
                for (std::uint32_t i = rule.first_assignment; i < rule.end_assignment; ++i)
                    changes.list.push_back({region.assignments[i].slot, std::nullopt, region.assignments[i].value});
                result.push_back(std::move(changes));
            }
        }
        return result;
    }

    void extend(const Region& region, const Requirement& requirement, std::vector<Changes>& open) {
        const Participant& who = region.participants[requirement.participant];
        if (!who.is_region) {
            charge(open.size());
            for (Changes& changes : open) changes.list.push_back({who.index, requirement.event, 0});
            return;
        }
        std::vector<Changes> longer;
        for (const Changes& inner : inside_[who.index]) {
            if (inner.place != requirement.event) continue;
            for (const Changes& changes : open) {
                charge(changes.list.size() + inner.list.size());
                longer.push_back(changes);
                Changes& joint = longer.back();
                joint.list.insert(joint.list.end(), inner.list.begin(), inner.list.end());
                joint.passages.insert(joint.passages.end(), inner.passages.begin(), inner.passages.end());
            }
        }
        open = std::move(longer);
    }

    void charge(std::size_t parts) {
        budget_.poll();
        parts_ += parts;
        if (parts_ > most_parts) throw TooMany();
    }

    static WholeRule make_whole_rule(const Changes& changes) {
        std::map<std::uint32_t, Part> parts;
        for (const Change& change : changes.list) {
            Part& part = parts[change.slot];
            part.slot = change.slot;
            if (change.event) {
                part.event = change.event;
                part.assigned.reset();
            } else {
                part.assigned = change.value;
            }
        }
        WholeRule rule;
        rule.event = changes.event;
        rule.outermost = changes.rule;
        rule.level = changes.passages.front().level;
        for (const auto& [slot, part] : parts) {
            assert(part.event || part.assigned);
            rule.parts.push_back(part);
        }
        for (const Passage& passage : changes.passages) {
            if (passage.level == no_level) continue;
            if (passage.level == 0)
                rule.preventing.push_back(passage.region);
            else
                rule.prevented.push_back(passage);
        }
        return rule;
    }

    void index() {
        result_.asking.resize(combined_.components.size());
        result_.assigning.resize(combined_.components.size());
        result_.preventable.resize(combined_.components.size());
        for (std::size_t slot = 0; slot < result_.asking.size(); ++slot)
            result_.asking[slot].resize(combined_.components[slot]->alphabet().size());
        for (std::uint32_t number = 0; number < result_.rules.size(); ++number) {
            const WholeRule& rule = result_.rules[number];
            for (const Part& part : rule.parts) {
                if (part.event) result_.asking[part.slot][*part.event].push_back(number);
                if (part.assigned) result_.assigning[part.slot].push_back(number);
            }
            for (const Passage& passage : rule.prevented) {
                assert(passage.region < slots_.size());
                charge(slots_[passage.region].size());
                for (const std::uint32_t slot : slots_[passage.region]) result_.preventable[slot].push_back(number);
            }
        }
    }

    const Supercombinator& combined_;
    diagnostics::Pollable& budget_;
    std::size_t parts_ = 0;
    std::vector<std::vector<Changes>> inside_;       // by region: its rules in terms of components
    std::vector<std::vector<std::uint32_t>> slots_;  // by region: the slots below it
    WholeRules result_;
};

}  // namespace

const Part* WholeRule::find_part(std::uint32_t slot) const {
    const auto found = std::ranges::lower_bound(parts, slot, {}, &Part::slot);
    return found != parts.end() && found->slot == slot ? &*found : nullptr;
}

std::optional<WholeRules> whole_rules(const Supercombinator& combined, diagnostics::Pollable& budget) {
    try {
        return Flattening(combined, budget).run();
    } catch (const TooMany&) {
        return std::nullopt;
    }
}

std::optional<std::vector<std::vector<WholeRule>>> rules_of_regions(const Supercombinator& combined,
                                                                    diagnostics::Pollable& budget) {
    try {
        return Flattening(combined, budget).list_by_region();
    } catch (const TooMany&) {
        return std::nullopt;
    }
}

}  // namespace robochart::machine
