#include "checker/machine/confluence.hpp"

#include <algorithm>
#include <limits>

namespace robochart::machine {

using process::tau;

namespace {

constexpr std::size_t most_answers = 4'000'000;  // kept
/// States of a rule's parts that one proof may take together.
constexpr std::size_t most_together = 500;

bool shared(const std::vector<std::uint32_t>& some, const std::vector<Passage>& others) {
    return std::any_of(others.begin(), others.end(), [&](const Passage& passage) {
        return std::find(some.begin(), some.end(), passage.region) != some.end();
    });
}

}  // namespace

Confluence::Confluence(std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules)
    : combined_(std::move(combined)), rules_(std::move(rules)), proved_(rules_->rules.size()) {
    leading_.resize(combined_->components.size());
    known_.resize(combined_->components.size());
    for (std::uint32_t slot = 0; slot < known_.size(); ++slot) {
        leading_[slot].resize(component(slot).alphabet().size());
        known_[slot].resize(component(slot).size());
    }
    list_tau_rules();
}

/// Condition 1. A rule is looked for where the component is that can do its part in the fewest of its states.
void Confluence::list_tau_rules() {
    std::vector<std::vector<std::size_t>> offered;
    for (std::uint32_t slot = 0; slot < known_.size(); ++slot) {
        auto& counts = offered.emplace_back(component(slot).alphabet().size());
        for (Local local = 0; local < component(slot).size(); ++local)
            for (const Component::Edge& edge : component(slot).edges(local)) ++counts[edge.event];
    }
    const auto share = [&](const Part& part) {
        return static_cast<double>(offered[part.slot][*part.event]) / static_cast<double>(component(part.slot).size());
    };
    for (RuleNumber number = 0; number < rules_->rules.size(); ++number) {
        const WholeRule& rule = rules_->rules[number];
        if (rule.event != tau || !rule.prevented.empty()) continue;
        const Part* lead = nullptr;
        std::uint64_t states = 1;
        bool fits = true;
        for (const Part& part : rule.parts) {
            if (part.event && (lead == nullptr || share(part) < share(*lead))) lead = &part;
            proved_[number].weights.push_back(states);
            const std::uint64_t more = component(part.slot).size() + 1;
            fits = fits && states <= std::numeric_limits<std::uint64_t>::max() / more;
            states *= more;
        }
        if (lead != nullptr && fits) leading_[lead->slot][*lead->event].push_back(number);
    }
}

bool Confluence::follow(std::span<Local> state) {
    for (std::uint32_t slot = 0; slot < state.size(); ++slot) {
        if (state[slot] >= known_[slot].size()) continue;  // off
        for (const RuleNumber number : candidates(slot, state[slot])) {
            if (!confluent(number, state)) continue;
            for (const Part& part : rules_->rules[number].parts)
                state[part.slot] = part.assigned
                                       ? *part.assigned
                                       : component(part.slot).edges(state[part.slot], *part.event).front().target;
            return true;
        }
    }
    return false;
}

const std::vector<Confluence::RuleNumber>& Confluence::candidates(std::uint32_t slot, Local local) {
    std::uint32_t& known = known_[slot][local];
    if (known == 0) {
        lists_.push_back(made(slot, local));
        known = static_cast<std::uint32_t>(lists_.size());
    }
    return lists_[known - 1U];
}

std::vector<Confluence::RuleNumber> Confluence::made(std::uint32_t slot, Local local) const {
    std::vector<RuleNumber> result;
    std::optional<std::uint32_t> before;
    for (const Component::Edge& edge : component(slot).edges(local)) {
        if (before == edge.event) continue;
        before = edge.event;
        for (const RuleNumber number : leading_[slot][edge.event])
            if (!hopeless(number, slot, local)) result.push_back(number);
    }
    return result;
}

/// Whether condition 3 fails whatever states the other parts are in.
bool Confluence::hopeless(RuleNumber number, std::uint32_t slot, Local local) const {
    const WholeRule& rule = rules_->rules[number];
    for (const Component::Edge& edge : component(slot).edges(local))
        for (const RuleNumber by : rules_->asking[slot][edge.event]) {
            const WholeRule& other = rules_->rules[by];
            if (by == number || shared(rule.preventing, other.prevented)) continue;
            const auto common = std::count_if(other.parts.begin(), other.parts.end(),
                                              [&](const Part& part) { return rule.part(part.slot) != nullptr; });
            if (common == 1 && !commutes(*rule.part(slot), *other.part(slot), local)) return true;
        }
    return false;
}

std::uint64_t Confluence::key(RuleNumber rule, std::span<const Local> state) const {
    const std::vector<Part>& parts = rules_->rules[rule].parts;
    std::uint64_t result = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) result += proved_[rule].weights[i] * state[parts[i].slot];
    return result;
}

void Confluence::keep(RuleNumber rule, std::uint64_t key, bool answer) {
    if (++answers_ > most_answers) {
        for (Proved& each : proved_) each.answers.clear();
        answers_ = 1;
    }
    proved_[rule].answers.insert_or_assign(key, answer);
}

/// The states of a rule's parts that other rules lead to while it can fire: for all of them, or for none, the answer is
/// that it is confluent (the greatest set that condition 3 allows).
class Confluence::Closure {
public:
    Closure(const Confluence& all, RuleNumber rule) : all_(all), rule_(rule) {}

    [[nodiscard]] bool prove(const Locals& from) {
        add(from);
        std::vector<Locals> next;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            next.clear();
            if (!all_.holds_now(rule_, Locals(found_[i]), next) || found_.size() > most_together) return false;
            for (const Locals& each : next) add(each);
        }
        return true;
    }
    [[nodiscard]] const std::unordered_map<std::uint64_t, bool>& keys() const { return known_; }

private:
    void add(const Locals& state) {
        if (known_.emplace(all_.key(rule_, state), true).second) found_.push_back(state);
    }
    const Confluence& all_;
    RuleNumber rule_;
    std::vector<Locals> found_;
    std::unordered_map<std::uint64_t, bool> known_;
};

bool Confluence::confluent(RuleNumber rule, std::span<const Local> state) {
    const std::uint64_t here = key(rule, state);
    const auto known = proved_[rule].answers.find(here);
    if (known != proved_[rule].answers.end()) return known->second;
    Closure closure(*this, rule);
    const bool answer = closure.prove(Locals(state.begin(), state.end()));
    if (!answer) return keep(rule, here, false), false;
    for (const auto& [each, proved] : closure.keys()) keep(rule, each, proved);
    return true;
}

/// Conditions 2 to 4 in these states of the parts; nothing else of the state is looked at. `next`: the states of the
/// parts in which they have to hold too.
bool Confluence::holds_now(RuleNumber number, const Locals& state, std::vector<Locals>& next) const {
    const WholeRule& rule = rules_->rules[number];
    if (!determined(rule, state)) return false;
    Locals outcome = state;
    const auto leave_it_possible = [&](const std::vector<RuleNumber>& others) {
        return std::all_of(others.begin(), others.end(), [&](RuleNumber by) {
            const WholeRule& other = rules_->rules[by];
            if (by == number || cannot_fire_beside(other, rule, state)) return true;
            if (!commutes(rule, other, state)) return false;
            add_outcomes(rule, other, 0, outcome, next);
            return true;
        });
    };
    for (const Part& part : rule.parts) {
        const Local local = state[part.slot];
        std::optional<std::uint32_t> before;
        for (const Component::Edge& edge : component(part.slot).edges(local)) {
            if (before == edge.event) continue;
            before = edge.event;
            if (!leave_it_possible(rules_->asking[part.slot][edge.event])) return false;
        }
        if (!leave_it_possible(rules_->assigning[part.slot])) return false;
        if (unchanged(part, local)) continue;
        for (const RuleNumber by : rules_->preventable[part.slot])
            if (!cannot_fire_beside(rules_->rules[by], rule, state)) return false;
    }
    return true;
}

/// Condition 2: every part can be done, with one result.
bool Confluence::determined(const WholeRule& rule, const Locals& state) const {
    return std::all_of(rule.parts.begin(), rule.parts.end(), [&](const Part& part) {
        if (!part.event) return true;
        const Component::Edges edges = component(part.slot).edges(state[part.slot], *part.event);
        const auto same = [&](const Component::Edge& edge) { return edge.target == edges.front().target; };
        return !edges.empty() && std::all_of(edges.begin(), edges.end(), same);
    });
}

/// Whether some part of the rule cannot do what the other one asks of it, or the rule prevents the other.
bool Confluence::cannot_fire_beside(const WholeRule& other, const WholeRule& rule, const Locals& state) const {
    return shared(rule.preventing, other.prevented) ||
           std::any_of(rule.parts.begin(), rule.parts.end(), [&](const Part& part) {
               const Part* const asked = other.part(part.slot);
               return asked != nullptr && asked->event &&
                      component(part.slot).edges(state[part.slot], *asked->event).empty();
           });
}

/// Whether the components that have a part in both rules get to the same states in either order.
bool Confluence::commutes(const WholeRule& rule, const WholeRule& other, const Locals& state) const {
    return std::all_of(rule.parts.begin(), rule.parts.end(), [&](const Part& part) {
        const Part* const theirs = other.part(part.slot);
        return theirs == nullptr || commutes(part, *theirs, state[part.slot]);
    });
}

bool Confluence::commutes(const Part& part, const Part& other, Local local) const {
    if (part.assigned || other.assigned || !part.event || !other.event) return false;
    const Component& machine = component(part.slot);
    const Component::Edges first = machine.edges(local, *part.event);
    if (first.empty()) return false;
    const Component::Edges second = machine.edges(first.front().target, *other.event);
    const Component::Edges others = machine.edges(local, *other.event);
    return std::all_of(others.begin(), others.end(), [&](const Component::Edge& theirs) {
        const Component::Edges after = machine.edges(theirs.target, *part.event);
        if (after.empty()) return false;
        const Local both = after.front().target;
        const auto leads_there = [both](const Component::Edge& edge) { return edge.target == both; };
        return std::all_of(after.begin(), after.end(), leads_there) &&
               std::any_of(second.begin(), second.end(), leads_there);
    });
}

/// The states of the rule's parts, from that number on, that the other rule can lead to.
void Confluence::add_outcomes(const WholeRule& rule, const WholeRule& other, std::size_t part, Locals& state,
                              std::vector<Locals>& next) const {
    for (; part < rule.parts.size(); ++part) {
        const std::uint32_t slot = rule.parts[part].slot;
        const Part* const theirs = other.part(slot);
        if (theirs == nullptr) continue;
        const Local before = state[slot];
        for (const Component::Edge& edge : component(slot).edges(before, *theirs->event)) {
            state[slot] = edge.target;
            add_outcomes(rule, other, part + 1, state, next);
        }
        state[slot] = before;
        return;
    }
    next.push_back(state);
}

/// Whether the component stays in this state, whichever way it does its part.
bool Confluence::unchanged(const Part& part, Local local) const {
    if (part.assigned || !part.event) return false;
    const Component::Edges edges = component(part.slot).edges(local, *part.event);
    return std::all_of(edges.begin(), edges.end(), [&](const Component::Edge& edge) { return edge.target == local; });
}

}  // namespace robochart::machine
