// SPDX-License-Identifier: Apache-2.0
#include "checker/machine/confluence.hpp"

#include <algorithm>
#include <cassert>
#include <limits>

namespace robochart::machine {

using process::tau;

namespace {

constexpr std::size_t most_answers = 4'000'000;  // maximal number of stored answers
/// The maximal number of states that one proof examines. A state here contains only tracked components.
constexpr std::size_t most_together = 500;
/// How many components a proof may track in addition to those in the rule.
constexpr std::size_t most_beside = 4;

/// In the table, these two values are answers. Any other value is the number of another query.
constexpr std::uint32_t no = std::numeric_limits<std::uint32_t>::max();
constexpr std::uint32_t yes = no - 1;

bool shares_region(const std::vector<std::uint32_t>& some, const std::vector<Passage>& others) {
    return std::ranges::any_of(
        others, [&](const Passage& passage) { return std::ranges::find(some, passage.region) != some.end(); });
}

}  // namespace

bool is_candidate(const WholeRule& rule, lts::Followed followed) {
    return (followed == lts::Followed::steps || rule.event == tau) && rule.prevented.empty();
}

Confluence::Confluence(std::shared_ptr<const Supercombinator> combined, std::shared_ptr<const WholeRules> rules,
                       lts::Followed followed, ProofPlan plan)
    : combined_(std::move(combined)),
      rules_(std::move(rules)),
      plan_(std::move(plan)),
      first_(rules_->rules.size(), no) {
    assert(rules_->asking.size() == combined_->components.size() && !combined_->regions.empty());
    leading_.resize(combined_->components.size());
    known_.resize(combined_->components.size());
    for (std::uint32_t slot = 0; slot < known_.size(); ++slot) {
        leading_[slot].resize(component(slot).alphabet().size());
        known_[slot].resize(component(slot).size());
    }
    count_offers();
    list_candidates(followed);
}

void Confluence::count_offers() {
    for (std::uint32_t slot = 0; slot < known_.size(); ++slot) {
        auto& shares = share_.emplace_back(component(slot).alphabet().size());
        for (Local local = 0; local < component(slot).size(); ++local)
            for (const Component::Edge& edge : component(slot).edges(local)) ++shares[edge.event];
        for (double& share : shares) share /= static_cast<double>(component(slot).size());
    }
}

/// Lists each candidate once, for quick look-up. It is listed at the component that can perform its event in the
/// smallest fraction of its states.
void Confluence::list_candidates(lts::Followed followed) {
    const auto share = [&](const Part& part) { return share_[part.slot][*part.event]; };
    for (RuleNumber number = 0; number < rules_->rules.size(); ++number) {
        const WholeRule& rule = rules_->rules[number];
        if (!is_candidate(rule, followed)) continue;
        const Part* lead = nullptr;
        for (const Part& part : rule.parts)
            if (part.event && (lead == nullptr || share(part) < share(*lead))) lead = &part;
        if (lead == nullptr) continue;
        first_[number] = find_tracked_set(number, parts_of(number));
        if (first_[number] != no) leading_[lead->slot][*lead->event].push_back(number);
    }
}

bool Confluence::follow_step(std::span<Local> state) {
    assert(state.size() == known_.size());
    ++states_asked_;
    for (std::uint32_t slot = 0; slot < state.size(); ++slot) {
        if (state[slot] >= known_[slot].size()) continue;  // the component is off
        for (const RuleNumber number : candidates(slot, state[slot])) {
            if (!is_confluent(number, state)) continue;
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
    assert(slot < known_.size() && local < known_[slot].size());
    std::uint32_t& known = known_[slot][local];
    if (known == 0) {
        lists_.push_back(make_entry(slot, local));
        known = static_cast<std::uint32_t>(lists_.size());
    }
    assert(known <= lists_.size());
    return lists_[known - 1U];
}

std::vector<Confluence::RuleNumber> Confluence::make_entry(std::uint32_t slot, Local local) const {
    std::vector<RuleNumber> result;
    std::optional<std::uint32_t> before;
    for (const Component::Edge& edge : component(slot).edges(local)) {
        if (before == edge.event) continue;
        before = edge.event;
        for (const RuleNumber number : leading_[slot][edge.event])
            if (!never_commutes(number, slot, local)) result.push_back(number);
    }
    return result;
}

/// Returns true if condition 3 fails in this state of the component, for all states of the other components.
bool Confluence::never_commutes(RuleNumber number, std::uint32_t slot, Local local) const {
    const WholeRule& rule = rules_->rules[number];
    for (const Component::Edge& edge : component(slot).edges(local))
        for (const RuleNumber by : rules_->asking[slot][edge.event]) {
            const WholeRule& other = rules_->rules[by];
            if (by == number || shares_region(rule.preventing, other.prevented)) continue;
            const bool alone = other.parts.size() == 1 && !other.parts.front().assigned;
            if (alone && !commutes_with(*rule.find_part(slot), *other.find_part(slot), local)) return true;
        }
    return false;
}

std::uint64_t Confluence::state_key(const Tracked& tracked, Locals state) {
    std::uint64_t result = 0;
    assert(tracked.slots.size() == tracked.weights.size());
    for (std::size_t i = 0; i < tracked.slots.size(); ++i) result += tracked.weights[i] * state[tracked.slots[i]];
    return result;
}

/// Returns the number of the query that tracks these components for the rule. If the plan replaces this query, returns
/// the number of its replacement. Returns `no` if there is none, or if a key cannot represent all states.
std::uint32_t Confluence::find_tracked_set(RuleNumber rule, Slots slots) {
    const auto [known, fresh] = numbers_.try_emplace({rule, std::move(slots)}, no);
    if (!fresh) return known->second;
    const auto planned = plan_.find({parts_of(rule), known->first.second});
    if (planned == plan_.end())
        known->second = make_entry(rule, known->first.second);
    else if (!planned->second.empty())
        known->second = find_tracked_set(rule, planned->second);
    return known->second;
}

std::uint32_t Confluence::make_entry(RuleNumber rule, Slots slots) {
    assert(std::ranges::adjacent_find(slots, std::ranges::greater_equal()) == slots.end());
    std::vector<std::uint64_t> weights;
    std::uint64_t states = 1;
    for (const std::uint32_t slot : slots) {
        weights.push_back(states);
        const std::uint64_t more = component(slot).size() + 1;
        if (states > std::numeric_limits<std::uint64_t>::max() / more) return no;
        states *= more;
    }
    std::vector<char> has(combined_->components.size());
    for (const std::uint32_t slot : slots) has[slot] = 1;
    assert(tracked_.size() < yes);  // a query's number must differ from `yes` and `no`
    tracked_.push_back({rule, std::move(slots), std::move(weights), std::move(has), nullptr, 0, 0, 0, 0, {}});
    return static_cast<std::uint32_t>(tracked_.size() - 1);
}

namespace {

/// Returns the work of the proofs. The unit is the same as for `work_of_a_state`.
double work(const ProofRecord::Sum& sum) {
    constexpr double of_a_state = 4;  // in addition to the work for its rules
    return static_cast<double>(sum.rules) + of_a_state * static_cast<double>(sum.looked);
}

bool known_well(const ProofRecord::Sum& sum) {
    constexpr double enough = 2'000;
    return work(sum) >= enough;
}

/// Returns true if the proofs save more work than they take. A followed tau removes at most one state. This also saves
/// memory, so a proof may take twice as much work as a state.
bool worth_it(const ProofRecord::Sum& sum, double work_of_a_state) {
    constexpr double most_for_a_state = 2;
    return sum.proofs > 0 &&
           (!known_well(sum) || work(sum) <= most_for_a_state * work_of_a_state * static_cast<double>(sum.used));
}

}  // namespace

ProofPlan ProofRecord::plan(double work_of_a_state) const {
    ProofPlan result;
    for (const auto& [key, sum] : sums_) {
        if (!known_well(sum) || worth_it(sum, work_of_a_state)) continue;
        Slots& instead = result[key];
        std::uint64_t most = 0;
        for (const auto& [next, often] : sum.next) {
            if (often <= most || !leads_to_proofs({key.first, next}, work_of_a_state)) continue;
            most = often;
            instead = next;
        }
    }
    return result;
}

/// Returns true if proofs that begin with this query save work, perhaps because a later query succeeds. The recursion
/// ends, because each next query tracks more components.
bool ProofRecord::leads_to_proofs(const Key& key, double work_of_a_state) const {
    const auto known = sums_.find(key);
    if (known == sums_.end()) return false;
    const Sum& sum = known->second;
    return worth_it(sum, work_of_a_state) || std::ranges::any_of(sum.next, [&](const auto& next) {
               return leads_to_proofs({key.first, next.first}, work_of_a_state);
           });
}

void Confluence::add_to(ProofRecord& record) const {
    for (const Tracked& tracked : tracked_) {
        ProofRecord::Sum& sum = record.sum_of(parts_of(tracked.rule), tracked.slots);
        sum.proofs += tracked.proofs;
        sum.looked += tracked.looked;
        sum.rules += tracked.rules;
        sum.used += tracked.used;
        for (const auto& [next, often] : tracked.next) sum.next[tracked_[next].slots] += often;
    }
}

double Confluence::total_work() const {
    constexpr double of_an_answer = 0.7;  // cost of a cached answer
    ProofRecord::Sum all;
    for (const Tracked& tracked : tracked_) {
        all.looked += tracked.looked;
        all.rules += tracked.rules;
    }
    return static_cast<double>(states_asked_) + of_an_answer * static_cast<double>(answers_asked_) + machine::work(all);
}

Slots Confluence::parts_of(RuleNumber rule) const {
    Slots slots;
    for (const Part& part : rules_->rules[rule].parts) slots.push_back(part.slot);
    return slots;
}

/// Returns the component for which to list the rule. Of the selected components that perform an event in the rule, it
/// is the one that can perform its event in the smallest fraction of its states.
std::uint32_t Confluence::rarest_component(const WholeRule& rule, const std::vector<char>& has) const {
    const Part* rarest = nullptr;
    for (const Part& part : rule.parts) {
        if (!part.event || has[part.slot] == 0) continue;
        if (rarest == nullptr || share_[part.slot][*part.event] < share_[rarest->slot][*rarest->event]) rarest = &part;
    }
    assert(rarest != nullptr);  // a tracked component performs an event in the rule
    return rarest->slot;
}

/// Returns the rules in which the tracked component at this place performs the event. Omits a rule if another tracked
/// component can perform its event in this rule more rarely: the rule is listed there.
const std::vector<Confluence::RuleNumber>& Confluence::rules_asking(const Tracked& tracked, std::size_t place,
                                                                    std::uint32_t event) const {
    assert(tracked.asking != nullptr && tracked.asking->size() == tracked.slots.size());
    const auto [known, fresh] = (*tracked.asking)[place].try_emplace(event);
    if (!fresh) return known->second;
    const std::uint32_t slot = tracked.slots[place];
    for (const RuleNumber rule : rules_->asking[slot][event])
        if (rarest_component(rules_->rules[rule], tracked.has) == slot) known->second.push_back(rule);
    return known->second;
}

/// Returns a query that also tracks the components of another rule. This rule is the first of `others` that adds at
/// least one component, but not too many.
Confluence::Next Confluence::find_larger_tracked_set(std::uint32_t number, const std::vector<RuleNumber>& others) {
    const RuleNumber rule = tracked_[number].rule;
    const Slots& before = tracked_[number].slots;
    const std::size_t most = rules_->rules[rule].parts.size() + most_beside;
    for (std::size_t i = 0; i < others.size(); ++i) {
        Slots slots = before;
        for (const Part& part : rules_->rules[others[i]].parts)
            if (part.event && !std::ranges::binary_search(before, part.slot)) slots.push_back(part.slot);
        if (slots.size() == before.size() || slots.size() > most) continue;
        std::ranges::sort(slots);
        if (const std::uint32_t more = find_tracked_set(rule, std::move(slots)); more != no) return {more, i + 1};
    }
    return {no, 0};
}

void Confluence::store_answer(std::uint32_t number, std::uint64_t key, std::uint32_t answer) {
    assert(number < tracked_.size() && (answer >= yes || answer < tracked_.size()));
    if (answers_.size() >= most_answers) answers_.clear();
    answers_.store_answer(number, key, answer);
}

/// Computes which states of the tracked components other rules can reach while the rule can fire. These states are the
/// greatest set that condition 3 allows. The rule is confluent in all of them, or in none.
class Confluence::Closure {
public:
    explicit Closure(const Confluence& all) : all_(all) {}

    [[nodiscard]] bool prove(const Tracked& tracked, Locals from) {
        begin(tracked, from.size());
        add(from, 0, 0);
        std::optional<RuleNumber> disturbing;
        for (std::size_t i = 0; i < keys_.size(); ++i) {
            assert(led_.size() == keys_.size() && found_.size() == keys_.size() * width_);
            next_.states.clear();
            next_.by.clear();
            const Locals found = Locals(found_).subspan(i * width_, width_);
            state_.assign(found.begin(), found.end());
            if (!all_.holds_now(tracked, state_, next_, disturbing)) {
                record_blame(disturbing, i);
                return false;
            }
            for (std::size_t j = 0; j < next_.by.size(); ++j)
                add(Locals(next_.states).subspan(j * width_, width_), i, next_.by[j]);
            if (keys_.size() > most_together) return false;
        }
        return true;
    }
    [[nodiscard]] const std::vector<std::uint64_t>& state_keys() const { return keys_; }
    /// Returns the number of rules that the last proof examined.
    [[nodiscard]] std::uint64_t rules() const { return next_.rules; }
    /// After a failed proof: the rule for which a condition failed, and then the rules on the path to the state of the
    /// failure, last rule first.
    [[nodiscard]] const std::vector<RuleNumber>& blamed_rules() const { return blamed_; }
    /// After a failed proof: the keys of the states on the path, from the state of the failure back to the first state.
    /// Between the n-th of these states and the failure are the first n - 1 rules of blamed_rules().
    [[nodiscard]] const std::vector<std::uint64_t>& led_on() const { return led_on_; }

private:
    /// With at most this many keys, a linear search is used instead of a set.
    static constexpr std::size_t few = 16;

    void begin(const Tracked& tracked, std::size_t width) {
        tracked_ = &tracked;
        width_ = width;
        found_.clear();
        keys_.clear();
        led_.clear();
        known_.clear();
        blamed_.clear();
        led_on_.clear();
        next_.rules = 0;
    }
    void add(Locals state, std::size_t from, RuleNumber by) {
        const std::uint64_t here = state_key(*tracked_, state);
        if (!is_new(here)) return;
        found_.insert(found_.end(), state.begin(), state.end());
        keys_.push_back(here);
        led_.emplace_back(from, by);
    }
    [[nodiscard]] bool is_new(std::uint64_t key) {
        if (keys_.size() < few) return std::ranges::find(keys_, key) == keys_.end();
        if (known_.empty()) known_.insert(keys_.begin(), keys_.end());
        return known_.insert(key).second;
    }
    void record_blame(const std::optional<RuleNumber>& disturbing, std::size_t at) {
        led_on_.push_back(keys_[at]);
        if (disturbing) blamed_.push_back(*disturbing);
        for (; at != 0; at = led_[at].first) {
            assert(led_[at].first < at);
            led_on_.push_back(keys_[led_[at].first]);
            if (disturbing) blamed_.push_back(led_[at].second);
        }
    }

    const Confluence& all_;
    const Tracked* tracked_ = nullptr;
    std::size_t width_ = 0;
    std::vector<Local> found_;  // states of all components, one after the other
    std::vector<Local> state_;  // the state that is being examined
    Outcomes next_;
    std::vector<std::uint64_t> keys_;
    std::vector<std::pair<std::size_t, RuleNumber>> led_;  // by state: its predecessor, and the rule that leads to it
    std::unordered_set<std::uint64_t> known_;
    std::vector<RuleNumber> blamed_;
    std::vector<std::uint64_t> led_on_;
};

Confluence::~Confluence() = default;

bool Confluence::is_confluent(RuleNumber rule, Locals state) {
    std::uint32_t found = first_[rule];
    std::uint32_t query = no;
    while (found < yes) {
        query = found;
        found = find_answer(query, state);
    }
    if (found == yes) ++tracked_[query].used;
    return found == yes;
}

std::uint32_t Confluence::find_answer(std::uint32_t number, Locals state) {
    assert(number < tracked_.size());
    ++answers_asked_;
    const std::uint64_t here = state_key(tracked_[number], state);
    const std::optional<std::uint32_t> known = answers_.find(number, here);
    return known ? *known : prove_answer(number, here, state);
}

/// Proves the answer to a query, and stores it. The answer and the next query depend only on the states of the tracked
/// components. A failed proof gives the answer for every state on the path to the failure: a proof from such a state
/// would fail at the same state. (The search is breadth first, so no shorter path leads to a failure.) One rule of the
/// failed proof determines the next query. A state on the path gets no next query if this rule fires before the path
/// reaches that state.
std::uint32_t Confluence::prove_answer(std::uint32_t number, std::uint64_t here, Locals state) {
    if (tracked_[number].asking == nullptr) {
        Asking& asking = asking_[tracked_[number].slots];
        asking.resize(tracked_[number].slots.size());
        tracked_[number].asking = &asking;
    }
    if (!closure_) closure_ = std::make_unique<Closure>(*this);
    Closure& closure = *closure_;
    const bool proved = closure.prove(tracked_[number], state);
    tracked_[number].looked += closure.state_keys().size();
    tracked_[number].rules += closure.rules();
    if (proved) {
        ++tracked_[number].proofs;
        for (const std::uint64_t key : closure.state_keys()) store_answer(number, key, yes);
        return yes;
    }
    const Next next = find_larger_tracked_set(number, closure.blamed_rules());
    // Each query tracks more components than the previous one, so the sequence of queries ends.
    assert(next.number == no || tracked_[next.number].slots.size() > tracked_[number].slots.size());
    if (next.number != no) ++tracked_[number].next[next.number];
    for (std::size_t i = 0; i < closure.led_on().size(); ++i)
        store_answer(number, closure.led_on()[i], i + 1 < next.rules ? no : next.number);
    store_answer(number, here, next.number);
    return next.number;
}

/// Checks conditions 2 to 4 in `state`. Reads only the tracked components, and changes them temporarily.
/// `next` receives the states in which the conditions must hold, too. If the conditions fail because of a
/// rule, `disturbing` receives this rule. If a rule needs events of several tracked components, it is
/// examined only for one of them, and only if this component can perform its event. Otherwise the rule cannot
/// fire.
bool Confluence::holds_now(const Tracked& tracked, std::span<Local> state, Outcomes& next,
                           std::optional<RuleNumber>& disturbing) const {
    const WholeRule& rule = rules_->rules[tracked.rule];
    if (!is_deterministic(rule, state)) return false;
    const auto leave_it_possible = [&](const std::vector<RuleNumber>& others) {
        return std::ranges::all_of(others, [&](RuleNumber by) {
            ++next.rules;
            const WholeRule& other = rules_->rules[by];
            if (by == tracked.rule || cannot_fire(other, tracked, state)) return true;
            if (!commutes_with(rule, other, state)) {
                disturbing = by;
                return false;
            }
            add_outcomes(tracked, by, 0, state, next);
            return true;
        });
    };
    for (std::size_t place = 0; place < tracked.slots.size(); ++place) {
        const std::uint32_t slot = tracked.slots[place];
        const Local local = state[slot];
        const Component::Edges edges = component(slot).edges(local);
        for (auto edge = edges.begin(); edge != edges.end(); ++edge) {
            const bool first_of_event = edge == edges.begin() || std::prev(edge)->event != edge->event;
            if (first_of_event && !leave_it_possible(rules_asking(tracked, place, edge->event))) return false;
        }
        if (!leave_it_possible(rules_->assigning[slot])) return false;
        const Part* const part = rule.find_part(slot);
        if (part == nullptr || stays_unchanged(*part, local)) continue;
        for (const RuleNumber by : rules_->preventable[slot]) {
            if (cannot_fire(rules_->rules[by], tracked, state)) continue;
            disturbing = by;
            return false;
        }
    }
    return true;
}

/// Checks condition 2: every component of the rule can perform its event, with exactly one result.
bool Confluence::is_deterministic(const WholeRule& rule, Locals state) const {
    return std::ranges::all_of(rule.parts, [&](const Part& part) {
        if (!part.event) return true;
        const Component::Edges edges = component(part.slot).edges(state[part.slot], *part.event);
        const auto same = [&](const Component::Edge& edge) { return edge.target == edges.front().target; };
        return !edges.empty() && std::ranges::all_of(edges, same);
    });
}

/// Returns true if the rule `other` cannot fire: a tracked component cannot perform its event, or the tracked rule
/// prevents `other`.
bool Confluence::cannot_fire(const WholeRule& other, const Tracked& tracked, Locals state) const {
    return shares_region(rules_->rules[tracked.rule].preventing, other.prevented) ||
           std::ranges::any_of(other.parts, [&](const Part& part) {
               return part.event && tracked.has[part.slot] != 0 &&
                      component(part.slot).edges(state[part.slot], *part.event).empty();
           });
}

/// Returns true if both rules, applied in either order, lead the components that they share to the same states.
bool Confluence::commutes_with(const WholeRule& rule, const WholeRule& other, Locals state) const {
    return std::ranges::all_of(rule.parts, [&](const Part& part) {
        const Part* const theirs = other.find_part(part.slot);
        return theirs == nullptr || commutes_with(part, *theirs, state[part.slot]);
    });
}

bool Confluence::commutes_with(const Part& part, const Part& other, Local local) const {
    assert(part.slot == other.slot);
    if (part.assigned || other.assigned || !part.event || !other.event) return false;
    const Component& machine = component(part.slot);
    const Component::Edges first = machine.edges(local, *part.event);
    if (first.empty()) return false;
    const Component::Edges second = machine.edges(first.front().target, *other.event);
    const Component::Edges others = machine.edges(local, *other.event);
    return std::ranges::all_of(others, [&](const Component::Edge& theirs) {
        const Component::Edges after = machine.edges(theirs.target, *part.event);
        if (after.empty()) return false;
        const Local both = after.front().target;
        const auto leads_there = [both](const Component::Edge& edge) { return edge.target == both; };
        return std::ranges::all_of(after, leads_there) && std::ranges::any_of(second, leads_there);
    });
}

/// Adds the states of the tracked components that the rule `other` can reach from `state`. Its parts before `place`
/// have already been applied.
void Confluence::add_outcomes(const Tracked& tracked, RuleNumber other, std::size_t place, std::span<Local> state,
                              Outcomes& next) const {
    const std::vector<Part>& parts = rules_->rules[other].parts;
    for (; place < parts.size(); ++place) {
        const Part& part = parts[place];
        if (tracked.has[part.slot] == 0) continue;
        const Local before = state[part.slot];
        if (part.assigned) {
            state[part.slot] = *part.assigned;
            add_outcomes(tracked, other, place + 1, state, next);
        } else {
            for (const Component::Edge& edge : component(part.slot).edges(before, *part.event)) {
                state[part.slot] = edge.target;
                add_outcomes(tracked, other, place + 1, state, next);
            }
        }
        state[part.slot] = before;
        return;
    }
    next.states.insert(next.states.end(), state.begin(), state.end());
    next.by.push_back(other);
    assert(next.states.size() == next.by.size() * state.size());
}

/// Returns true if the part does not change this state: all edges for its event lead back to the state.
bool Confluence::stays_unchanged(const Part& part, Local local) const {
    if (part.assigned || !part.event) return false;
    const Component::Edges edges = component(part.slot).edges(local, *part.event);
    return std::ranges::all_of(edges, [&](const Component::Edge& edge) { return edge.target == local; });
}

}  // namespace robochart::machine
