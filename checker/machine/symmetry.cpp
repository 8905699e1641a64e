// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/symmetry.hpp"

#include <algorithm>
#include <map>

#include "base/diagnostics/splitmix64.hpp"
#include "checker/machine/exchange.hpp"
#include "checker/machine/supercombinator_system.hpp"

namespace robochart::machine {
namespace {

using diagnostics::splitmix64_mixed;

constexpr std::size_t largest_component = 20'000;  // number of states
constexpr std::size_t most_rules = 200'000;
constexpr std::size_t most_exchanges = 500;  // number of verified exchanges
/// Limits the work for proposals that turn out to be wrong: the rules and states that are examined for them.
constexpr std::size_t most_in_vain = 200'000;

/// Forwards polls to another budget and counts them.
class PollCounter final : public diagnostics::Pollable {
public:
    explicit PollCounter(diagnostics::Pollable& budget) : budget_(budget) {}
    void poll() override {
        ++polls_;
        budget_.poll();
    }
    [[nodiscard]] std::size_t polls() const { return polls_; }

private:
    diagnostics::Pollable& budget_;
    std::size_t polls_ = 0;
};

class Finder {
public:
    Finder(const Supercombinator& combined, const lts::EventTable& names, diagnostics::Pollable& budget)
        : combined_(combined),
          names_(names),
          budget_(budget),
          shapes_(combined.components.size()),
          taken_(combined.components.size(), false) {}

    std::vector<lts::ReplicaSet> run() {
        std::size_t rules = 0;
        for (const Region& region : combined_.regions) rules += region.rules.size();
        if (rules > most_rules) return {};
        for (auto& [size, ranges] : by_size()) {
            if (ranges.size() < 2) continue;
            for (auto& [hash, alike] : by_shape(ranges)) find_sets(alike);
        }
        return std::move(result_);
    }

private:
    using Ranges = std::vector<SlotRange>;

    /// Groups ranges by the sizes of their components: this saves computing shapes. Large ranges come first.
    [[nodiscard]] std::map<std::vector<std::size_t>, Ranges> by_size() const {
        std::map<std::vector<std::size_t>, Ranges> result;
        for (const SlotRange& range : combined_.operands) {
            std::vector<std::size_t> key{combined_.components.size() - (range.end - range.first)};
            bool small = true;
            bool moves = false;
            for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
                const Component& component = *combined_.components[slot];
                key.insert(key.end(), {component.size(), component.alphabet().size()});
                small = small && component.size() <= largest_component;
                moves = moves || component.size() > 1;
            }
            if (small && moves) result[key].push_back(range);
        }
        return result;
    }

    std::map<std::vector<std::uint64_t>, Ranges> by_shape(const Ranges& ranges) {
        std::map<std::vector<std::uint64_t>, Ranges> result;
        for (const SlotRange& range : ranges) {
            std::vector<std::uint64_t> key;
            for (std::uint32_t slot = range.first; slot < range.end; ++slot) key.push_back(shape(slot).hash);
            result[key].push_back(range);
        }
        return result;
    }

    const ComponentShape& shape(std::uint32_t slot) {
        if (roles_.empty()) find_roles();
        if (shapes_[slot].number.empty())
            shapes_[slot] = shape_of(*combined_.components[slot], roles_[slot], names_, budget_);
        return shapes_[slot];
    }

    /// Computes a number for each event from the rules that require it. Exchanges preserve this number.
    void find_roles() {
        for (const ComponentPtr& component : combined_.components) {
            std::vector<std::uint64_t>& role = roles_.emplace_back();
            for (const Event event : component->alphabet()) role.push_back(event < lts::first_visible ? event : 2);
        }
        for (const Region& region : combined_.regions)
            for (const Rule& rule : region.rules) {
                const std::uint64_t kind = rule.event < lts::first_visible ? rule.event : 2;
                std::uint64_t what = splitmix64_mixed(rule.level + 1);
                for (const std::uint64_t number : {kind, std::uint64_t{rule.end_requirement - rule.first_requirement},
                                                   std::uint64_t{rule.end_assignment - rule.first_assignment}})
                    what = splitmix64_mixed(what + number);
                add_role(region, rule.lead, what);
                for (std::uint32_t i = rule.first_requirement; i < rule.end_requirement; ++i)
                    add_role(region, region.requirements[i], what);
            }
    }

    void add_role(const Region& region, const Requirement& requirement, std::uint64_t what) {
        const Participant& who = region.participants[requirement.participant];
        if (!who.is_region) roles_[who.index][requirement.event] += what;
    }

    /// Finds replicas of the first range, then of the first range that remains, and so on.
    void find_sets(Ranges ranges) {
        const auto used = [&](const SlotRange& range) { return taken_[range.first]; };
        std::erase_if(ranges, used);
        while (ranges.size() > 1 && exchanges_ < most_exchanges) {
            const SlotRange first = ranges.front();
            lts::ReplicaSet set{replica(first, {})};
            Ranges others;
            Ranges members{first};
            for (auto range = ranges.begin() + 1; range != ranges.end(); ++range) {
                const auto exchange = try_exchange(first, *range);
                if (exchange) {
                    set.push_back(replica(*range, *exchange));
                    members.push_back(*range);
                } else {
                    others.push_back(*range);
                }
            }
            if (set.size() > 1) {
                result_.push_back(std::move(set));
                for (const SlotRange& range : members)
                    std::fill(taken_.begin() + range.first, taken_.begin() + range.end, true);
            }
            ranges = std::move(others);
        }
    }

    std::optional<lts::EventPermutation> try_exchange(SlotRange first, SlotRange second) {
        if (exchanges_ == most_exchanges || in_vain_ > most_in_vain || second.first < first.end) return std::nullopt;
        ++exchanges_;
        PollCounter looked(budget_);
        auto exchange = Exchange(combined_, shapes_, first, second).find_exchanged_events(looked);
        if (!exchange) in_vain_ += looked.polls();
        return exchange;
    }

    [[nodiscard]] lts::Replica replica(SlotRange range, lts::EventPermutation exchange) const {
        lts::Replica result{{}, std::move(exchange)};
        for (std::uint32_t slot = range.first; slot < range.end; ++slot) {
            const ComponentShape& shape = shapes_[slot];
            result.parts.push_back({combined_.fields[slot],
                                    std::make_shared<const std::vector<std::uint32_t>>(shape.number),
                                    std::make_shared<const std::vector<std::uint32_t>>(shape.state)});
        }
        return result;
    }

    const Supercombinator& combined_;
    const lts::EventTable& names_;
    diagnostics::Pollable& budget_;
    std::vector<std::vector<std::uint64_t>> roles_;  // by slot and index in the alphabet
    std::vector<ComponentShape> shapes_;             // by slot, computed on first use
    std::vector<bool> taken_;                        // for each slot: whether it belongs to a replica
    std::size_t exchanges_ = 0;
    std::size_t in_vain_ = 0;
    std::vector<lts::ReplicaSet> result_;
};

}  // namespace

std::vector<lts::ReplicaSet> replica_sets(const Supercombinator& combined, const lts::EventTable& names,
                                          diagnostics::Pollable& budget) {
    return Finder(combined, names, budget).run();
}

std::vector<lts::ReplicaSet> SupercombinatorSystem::replicas(diagnostics::Pollable& budget) const {
    if (!replicas_) replicas_ = replica_sets(*combined_, terms_.events(), budget);
    return *replicas_;
}

}  // namespace robochart::machine
