// SPDX-License-Identifier: Apache-2.0
// Converts the operators of a skeleton to rules over its components. A vector describes one possible event: the
// components that take part in it, their events, and the resulting event. Each operator has a function that converts
// the vectors of its operands. process/firing_rules.cpp and composition_rules.cpp state the firing rules.
#include <algorithm>
#include <bit>
#include <cassert>
#include <map>
#include <tuple>

#include "base/diagnostics/containers.hpp"
#include "checker/machine/supercombinator.hpp"
#include "checker/process/operators.hpp"

namespace robochart::machine {
namespace {

using process::tau;
using process::Term;
using process::tick;

/// Starts the components below a node in their first states, or turns them off.
struct Action {
    NodeId node;
    bool start;
    auto operator<=>(const Action&) const = default;
};
using Actions = std::vector<Action>;

struct Vector {
    Event event = tau;
    Event revealed = tau;
    std::vector<Requirement> parts;
    Actions actions;
};
using Vectors = std::vector<Vector>;

/// Compares the contents of actions, so that rules with equal actions share their assignments.
struct LessActions {
    bool operator()(const Actions* a, const Actions* b) const { return *a < *b; }
};
using AssignmentRanges = std::map<const Actions*, std::pair<std::uint32_t, std::uint32_t>, LessActions>;

class Combiner {
public:
    Combiner(const process::TermStore& terms, const Skeleton& skeleton, std::vector<ComponentPtr> components,
             std::size_t most_rules, diagnostics::Pollable& budget)
        : terms_(terms), skeleton_(skeleton), most_rules_(most_rules), budget_(budget) {
        result_.components = std::move(components);
    }

    Supercombinator combine() {
        assert(result_.components.size() == skeleton_.slots.size());
        const Node& root = skeleton_.nodes.front();
        const bool priorities = root.op == Op::prioritise;
        region(priorities ? root.children.front() : 0,
               priorities ? priority_levels(root) : std::vector<std::uint32_t>());
        result_.initial.assign(skeleton_.slots.size(), 0);
        for (const Assignment& assignment : assignments_of({{0, true}}))
            result_.initial[assignment.slot] = assignment.value;
        list_operands();
        pack_components();
        return std::move(result_);
    }

private:
    std::uint32_t region(NodeId top, const std::vector<std::uint32_t>& level);
    Vectors make_vectors(NodeId id, Region& region);
    Vectors operator_vectors(const Node& node, Region& region);
    Vectors add_participant(Region& region, Participant who, const EventSet& alphabet);
    Vectors combine_parallel(const Node& node, std::vector<Vectors> operands);
    Vectors combine_alphabetised(const Node& node, std::vector<Vectors> operands);
    Vectors apply_hiding(const Node& node, Vectors operand);
    Vectors apply_renaming(const Node& node, const Vectors& operand);
    Vectors combine_interruptible(const Node& node, std::vector<Vectors> operands);
    Vectors combine_gated(const Node& node, std::vector<Vectors> operands);
    Vectors combine_sequence(const Node& node, std::vector<Vectors> operands);
    void synchronise_vectors(std::vector<const Vectors*> who, Event event, Vectors& out);
    void charge(std::size_t vectors);
    void charge_work(std::size_t steps) const;
    static void prepend_actions(Vector& vector, const Actions& first);

    [[nodiscard]] std::vector<std::uint32_t> priority_levels(const Node& prioritise) const;
    [[nodiscard]] std::vector<Assignment> assignments_of(const Actions& actions) const;
    void start_operands(NodeId id, std::vector<Assignment>& made) const;
    void turn_off(NodeId id, std::vector<Assignment>& made) const;
    [[nodiscard]] std::vector<std::vector<double>> estimate_chances(const Region& region) const;
    void finish_region(Region& region, Vectors vectors, const std::vector<std::uint32_t>& level) const;
    void add_rule(Region& region, const Vector& vector, const std::vector<std::uint32_t>& level,
                  AssignmentRanges& ranges) const;
    void list_operands();
    void pack_components();

    const process::TermStore& terms_;
    const Skeleton& skeleton_;
    std::size_t most_rules_;
    diagnostics::Pollable& budget_;
    std::size_t made_ = 0;
    mutable std::size_t work_ = 0;
    Supercombinator result_;
};

void Combiner::charge(std::size_t vectors) {
    made_ += vectors;
    if (made_ > most_rules_) throw NotCompiled("too many rules");
    charge_work(vectors);
}

/// Adds to the work of this compilation, and stops it if it is too much work. Counting rules is not enough: a rule of
/// deeply nested operators may contain a part or an action for each operator.
void Combiner::charge_work(std::size_t steps) const {
    constexpr std::size_t worth = 20;  // allowed work for each of `most_rules_`
    constexpr std::size_t between_polls = 1024;
    const std::size_t before = work_;
    work_ += steps;
    if (before / between_polls != work_ / between_polls) budget_.poll();
    if (work_ > worth * most_rules_) throw NotCompiled("the rules are too large");
}

/// Puts `first` before the actions of the vector. `first` turns components off; later actions may start the same
/// components again.
void Combiner::prepend_actions(Vector& vector, const Actions& first) {
    vector.actions.insert(vector.actions.begin(), first.begin(), first.end());
}

std::uint32_t Combiner::region(NodeId top, const std::vector<std::uint32_t>& level) {
    Region made;
    finish_region(made, make_vectors(top, made), level);
    result_.regions.push_back(std::move(made));
    return static_cast<std::uint32_t>(result_.regions.size() - 1);
}

Vectors Combiner::add_participant(Region& region, Participant who, const EventSet& alphabet) {
    assert(region.participants.size() == region.alphabets.size());
    const auto number = static_cast<std::uint32_t>(region.participants.size());
    region.participants.push_back(who);
    region.alphabets.push_back(alphabet);
    Vectors result;
    for (std::uint32_t i = 0; i < alphabet.size(); ++i) result.push_back({alphabet[i], alphabet[i], {{number, i}}, {}});
    charge(result.size());
    return result;
}

Vectors Combiner::make_vectors(NodeId id, Region& region) {
    const Node& node = skeleton_.nodes[id];
    switch (node.kind) {
        case Node::Kind::again:
            return {};
        case Node::Kind::leaf:
        case Node::Kind::gate:
            return add_participant(region, {false, node.first_slot}, result_.components[node.first_slot]->alphabet());
        case Node::Kind::operation:
            break;
    }
    if (node.op != Op::prioritise) return operator_vectors(node, region);
    const std::uint32_t inner = this->region(node.children.front(), priority_levels(node));
    return add_participant(region, {true, inner}, result_.regions[inner].alphabet);
}

Vectors Combiner::operator_vectors(const Node& node, Region& region) {
    std::vector<Vectors> operands;
    for (NodeId child : node.children) operands.push_back(make_vectors(child, region));
    switch (node.op) {
        case Op::parallel:
            return combine_parallel(node, std::move(operands));
        case Op::alphabetised:
            return combine_alphabetised(node, std::move(operands));
        case Op::hide:
            return apply_hiding(node, std::move(operands.front()));
        case Op::rename:
            return apply_renaming(node, operands.front());
        case Op::sequential:
        case Op::exception:
            return combine_sequence(node, std::move(operands));
        case Op::interrupt:
        case Op::external_choice:
            return combine_interruptible(node, std::move(operands));
        case Op::sliding:
        case Op::internal_choice:
        case Op::prefix:
            return combine_gated(node, std::move(operands));
        case Op::stop:
        case Op::skip:
        case Op::div:
        case Op::omega:
        case Op::run:
        case Op::chaos:
        case Op::call:
        case Op::sync_choice:
        case Op::sync_interrupt:
        case Op::prioritise:
        case Op::prioritise_order:
        case Op::chase:
        case Op::compress:
        case Op::machine:
        case Op::chaos_offer:
            break;
    }
    throw std::logic_error("an operator that is no part of a skeleton");
}

/// Adds every combination of vectors with this event that takes one vector from each operand.
void Combiner::synchronise_vectors(std::vector<const Vectors*> who, Event event, Vectors& out) {
    assert(!who.empty());
    Vectors open{Vector{event, event, {}, {}}};
    for (const Vectors* operand : who) {
        Vectors longer;
        for (const Vector& one : *operand) {
            if (one.event != event) continue;
            for (const Vector& prefix : open) {
                charge_work(prefix.parts.size() + prefix.actions.size() + one.parts.size() + one.actions.size());
                Vector joint = prefix;
                joint.parts.insert(joint.parts.end(), one.parts.begin(), one.parts.end());
                joint.actions.insert(joint.actions.end(), one.actions.begin(), one.actions.end());
                longer.push_back(std::move(joint));
            }
            charge(open.size());
        }
        open = std::move(longer);
    }
    std::move(open.begin(), open.end(), std::back_inserter(out));
}

/// Returns the events of vectors; ascending, without duplicates.
EventSet events_of(const Vectors& vectors) {
    EventSet events;
    for (const Vector& vector : vectors) events.push_back(vector.event);
    diagnostics::sort_unique(events);
    return events;
}

// Combines P [|A|] Q: all operands together perform an event of A or tick. One operand performs any other event.
Vectors Combiner::combine_parallel(const Node& node, std::vector<Vectors> operands) {
    const process::SetId set{terms_[node.term].payload};
    const auto joint = [&](Event event) { return event == tick || (event != tau && terms_.contains(set, event)); };
    Vectors result;
    std::vector<Vectors> shared;
    for (Vectors& operand : operands) {
        Vectors& own = shared.emplace_back();
        charge_work(operand.size());
        for (Vector& vector : operand) (joint(vector.event) ? own : result).push_back(std::move(vector));
    }
    std::vector<std::map<Event, Vectors>> tables(shared.size());
    for (std::size_t i = 0; i < shared.size(); ++i)
        for (Vector& vector : shared[i]) tables[i][vector.event].push_back(std::move(vector));
    for (const auto& entry : tables.front()) {
        std::vector<const Vectors*> who;
        for (const auto& table : tables) {
            const auto found = table.find(entry.first);
            if (found != table.end()) who.push_back(&found->second);
        }
        if (who.size() == tables.size()) synchronise_vectors(std::move(who), entry.first, result);
    }
    return result;
}

// Combines an alphabetised parallel: all operands whose alphabet contains an event perform it together. One operand
// performs a tau, and all operands perform tick.
Vectors Combiner::combine_alphabetised(const Node& node, std::vector<Vectors> operands) {
    const Term& term = terms_[node.term];
    Vectors result;
    std::map<Event, std::vector<Vectors>> shared;  // by event, for each operand
    for (std::size_t i = 0; i < operands.size(); ++i)
        for (Vector& vector : operands[i]) {
            if (vector.event == tau) {
                result.push_back(std::move(vector));
            } else if (vector.event == tick || terms_.contains(term.sets[i], vector.event)) {
                auto& row = shared[vector.event];
                row.resize(operands.size());
                row[i].push_back(std::move(vector));
            }
        }
    for (const auto& [event, row] : shared) {
        std::vector<const Vectors*> who;
        for (std::size_t i = 0; i < row.size(); ++i)
            if (event == tick || terms_.contains(term.sets[i], event)) who.push_back(&row[i]);
        synchronise_vectors(std::move(who), event, result);
    }
    return result;
}

// Applies P \ A: an event of A becomes tau.
Vectors Combiner::apply_hiding(const Node& node, Vectors operand) {
    const process::SetId set{terms_[node.term].payload};
    for (Vector& vector : operand)
        if (vector.event != tau && vector.event != tick && terms_.contains(set, vector.event)) vector.event = tau;
    return operand;
}

// Applies P[[R]]: an event becomes each of its images under R, or stays unchanged if it has no image.
Vectors Combiner::apply_renaming(const Node& node, const Vectors& operand) {
    const process::Renaming& pairs = terms_[process::RenamingId{terms_[node.term].payload}];
    Vectors result;
    for (const Vector& vector : operand) {
        charge_work(1 + vector.parts.size() + vector.actions.size());
        auto pair = std::ranges::lower_bound(pairs, process::EventPair{vector.event, 0});
        const bool named =
            vector.event != tau && vector.event != tick && pair != pairs.end() && pair->first == vector.event;
        if (!named) result.push_back(vector);
        for (; named && pair != pairs.end() && pair->first == vector.event; ++pair) {
            result.push_back(vector);
            result.back().event = result.back().revealed = pair->second;
        }
    }
    charge(result.size());
    return result;
}

// P ; Q: P's tick becomes a tau that starts Q.   P [|A|> Q: an event of A starts Q.
Vectors Combiner::combine_sequence(const Node& node, std::vector<Vectors> operands) {
    assert(operands.size() == 2);
    const bool sequence = node.op == Op::sequential;
    const process::SetId set{terms_[node.term].payload};
    for (Vector& vector : operands[0]) {
        const bool passes_on = sequence
                                   ? vector.event == tick
                                   : vector.event != tau && vector.event != tick && terms_.contains(set, vector.event);
        if (!passes_on) continue;
        if (sequence) vector.event = vector.revealed = tau;
        vector.actions.push_back({node.children[0], false});
        vector.actions.push_back({node.children[1], true});
    }
    std::move(operands[1].begin(), operands[1].end(), std::back_inserter(operands[0]));
    return std::move(operands[0]);
}

// P /\ Q: a visible event of Q ends P, and a tick of P ends Q.   P [] Q: a visible event or tick ends the others.
Vectors Combiner::combine_interruptible(const Node& node, std::vector<Vectors> operands) {
    Vectors result;
    for (std::size_t i = 0; i < operands.size(); ++i)
        for (Vector& vector : operands[i]) {
            const bool first_of_interrupt = node.op == Op::interrupt && i == 0;
            const bool resolves = first_of_interrupt ? vector.event == tick : vector.event != tau;
            Actions others;
            for (std::size_t other = 0; resolves && other < operands.size(); ++other)
                if (other != i) others.push_back({node.children[other], false});
            charge_work(1 + others.size() + (others.empty() ? 0 : vector.actions.size()));
            prepend_actions(vector, others);
            result.push_back(std::move(vector));
        }
    return result;
}

// The gate, child 0, offers the operator's own events until one of them happens or an operand resolves the choice.
//   P [> Q: a tau that ends P and starts Q; a visible event or tick of P ends the gate.
//   P |~| Q: one tau for each operand, which starts it.      e -> P: each event starts its continuation.
Vectors Combiner::combine_gated(const Node& node, std::vector<Vectors> operands) {
    Vectors result;
    // A gate has one state. The gate of a choice has only the event tau. In a prefix, each branch has an operand.
    assert(operands.size() == node.children.size() && (node.op == Op::prefix || operands.front().size() == 1));
    const NodeId gate = node.children.front();
    const auto open = [&](Vector by, NodeId starts) {
        by.actions.push_back({gate, false});
        if (node.op == Op::sliding) by.actions.push_back({node.children[1], false});
        by.actions.push_back({starts, true});
        result.push_back(std::move(by));
    };
    if (node.op == Op::sliding) {
        for (Vector& vector : operands[1])
            if (vector.event != tau) prepend_actions(vector, {{gate, false}});
        open(operands[0].front(), node.children[2]);
    } else if (node.op == Op::internal_choice) {
        for (std::size_t i = 1; i < node.children.size(); ++i) open(operands[0].front(), node.children[i]);
    } else {
        const std::vector<process::Branch>& branches = *terms_.known_branches(terms_[node.term].payload);
        assert(operands.size() == branches.size() + 1);
        for (std::size_t i = 0; i < branches.size(); ++i)
            for (const Vector& vector : operands[0])
                if (vector.event == branches[i].event) open(vector, node.children[i + 1]);
    }
    for (std::size_t i = 1; i < operands.size(); ++i)
        std::move(operands[i].begin(), operands[i].end(), std::back_inserter(result));
    return result;
}

std::vector<std::uint32_t> Combiner::priority_levels(const Node& prioritise) const {
    return process::levels_of(terms_[process::OrderId{terms_[prioritise.term].payload}]);
}

void Combiner::turn_off(NodeId id, std::vector<Assignment>& made) const {
    const Node& node = skeleton_.nodes[id];
    charge_work(node.end_slot - node.first_slot);
    for (std::uint32_t slot = node.first_slot; slot < node.end_slot; ++slot)
        made.push_back({slot, static_cast<Local>(result_.components[slot]->size())});
}

/// Starts the components below a node in their first states. Operands that run later are turned off.
void Combiner::start_operands(NodeId id, std::vector<Assignment>& made) const {
    const Node& node = skeleton_.nodes[id];
    charge_work(1);
    if (node.kind == Node::Kind::again) return start_operands(node.again, made);
    if (node.kind != Node::Kind::operation) {
        made.push_back({node.first_slot, 0});
        return;
    }
    const std::size_t gates = skeleton_.nodes[node.children.front()].kind == Node::Kind::gate ? 1 : 0;
    const std::size_t running = gates + process::running_operands(node.op, node.children.size() - gates);
    assert(running <= node.children.size());
    for (std::size_t i = 0; i < node.children.size(); ++i) {
        if (i < running)
            start_operands(node.children[i], made);
        else
            turn_off(node.children[i], made);
    }
}

/// Returns the assignments, sorted by slot. If several actions assign a value to one slot, the last of them counts.
std::vector<Assignment> Combiner::assignments_of(const Actions& actions) const {
    std::vector<Assignment> made;
    for (const Action& action : actions) {
        if (action.start)
            start_operands(action.node, made);
        else
            turn_off(action.node, made);
    }
    std::ranges::reverse(made);
    std::ranges::stable_sort(made, [](const Assignment& a, const Assignment& b) { return a.slot < b.slot; });
    const auto same = [](const Assignment& a, const Assignment& b) { return a.slot == b.slot; };
    diagnostics::erase_repeated(made, same);
    assert(std::ranges::adjacent_find(made, std::ranges::greater_equal(), &Assignment::slot) == made.end());
    return made;
}

/// Returns, for each participant and event, in which fraction of the participant's states it can perform the event. The
/// fraction of an inner region is an estimate.
std::vector<std::vector<double>> Combiner::estimate_chances(const Region& region) const {
    std::vector<std::vector<double>> result;
    for (std::size_t who = 0; who < region.participants.size(); ++who) {
        const Participant& participant = region.participants[who];
        if (participant.is_region) {
            result.push_back(result_.regions[participant.index].chance);
            continue;
        }
        result.emplace_back(region.alphabets[who].size(), 0.0);
        const Component& component = *result_.components[participant.index];
        const double share = 1.0 / static_cast<double>(component.size());
        for (Local state = 0; state < component.size(); ++state) {
            budget_.poll();
            for (const Component::Edge& edge : component.edges(state)) result.back()[edge.event] += share;
        }
    }
    return result;
}

void Combiner::add_rule(Region& region, const Vector& vector, const std::vector<std::uint32_t>& level,
                        AssignmentRanges& ranges) const {
    charge_work(1 + vector.parts.size() + vector.actions.size());
    Rule rule{};
    rule.event = vector.event;
    rule.revealed = vector.revealed;
    rule.place =
        static_cast<std::uint32_t>(std::ranges::lower_bound(region.alphabet, vector.event) - region.alphabet.begin());
    assert(rule.place < region.alphabet.size() && region.alphabet[rule.place] == vector.event);
    rule.level = vector.event < level.size() ? level[vector.event] : no_level;
    assert(!vector.parts.empty());
    rule.lead = vector.parts.front();
    rule.first_requirement = static_cast<std::uint32_t>(region.requirements.size());
    region.requirements.insert(region.requirements.end(), vector.parts.begin() + 1, vector.parts.end());
    rule.end_requirement = static_cast<std::uint32_t>(region.requirements.size());
    const auto [range, added] = ranges.try_emplace(&vector.actions);
    if (added) {
        const std::vector<Assignment> made = assignments_of(vector.actions);
        const std::size_t first = region.assignments.size();
        region.assignments.insert(region.assignments.end(), made.begin(), made.end());
        range->second = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(first + made.size())};
    }
    std::tie(rule.first_assignment, rule.end_assignment) = range->second;
    region.by_event[rule.place].push_back(static_cast<std::uint32_t>(region.rules.size()));
    region.rules.push_back(rule);
}

void Combiner::finish_region(Region& region, Vectors vectors, const std::vector<std::uint32_t>& level) const {
    const std::vector<std::vector<double>> chance = estimate_chances(region);
    const auto chance_of = [&](const Requirement& part) { return chance[part.participant][part.event]; };
    for (Vector& vector : vectors)
        std::ranges::sort(vector.parts, [&](const Requirement& a, const Requirement& b) {
            return std::pair(chance_of(a), a.participant) < std::pair(chance_of(b), b.participant);
        });
    region.alphabet = events_of(vectors);
    region.by_event.resize(region.alphabet.size());
    region.chance.resize(region.alphabet.size());
    const auto lead = [](const Vector& v) { return std::pair(v.parts.front().participant, v.parts.front().event); };
    std::ranges::stable_sort(vectors, [&](const Vector& a, const Vector& b) { return lead(a) < lead(b); });
    region.first_rule.resize(region.participants.size());
    AssignmentRanges ranges;
    auto next = vectors.begin();
    for (std::uint32_t who = 0; who < region.participants.size(); ++who)
        for (std::uint32_t event = 0; event <= region.alphabets[who].size(); ++event) {
            region.first_rule[who].push_back(static_cast<std::uint32_t>(region.rules.size()));
            for (; next != vectors.end() && lead(*next) == std::pair(who, event); ++next) {
                add_rule(region, *next, level, ranges);
                double together = 1;
                for (const Requirement& part : next->parts) together *= chance_of(part);
                region.chance[region.rules.back().place] += together;
            }
        }
    assert(next == vectors.end());  // each vector has become a rule
}

/// Sorts the ranges, large ones first.
void Combiner::list_operands() {
    std::vector<SlotRange>& operands = result_.operands;
    for (const Node& node : skeleton_.nodes)
        if (node.first_slot < node.end_slot) operands.push_back({node.first_slot, node.end_slot});
    const auto rank = [](const SlotRange& range) { return std::pair(range.first - range.end, range.first); };
    const auto less = [&](const SlotRange& a, const SlotRange& b) { return rank(a) < rank(b); };
    const auto same = [&](const SlotRange& a, const SlotRange& b) { return rank(a) == rank(b); };
    std::ranges::sort(operands, less);
    diagnostics::erase_repeated(operands, same);
}

/// Places components in words of 32 bits, one next to the other. Each component fits into one word.
void Combiner::pack_components() {
    std::vector<bool> may_be_off(result_.components.size(), false);
    const auto note = [&](std::uint32_t slot, Local value) {
        assert(value <= result_.components[slot]->size());
        if (value == result_.components[slot]->size()) may_be_off[slot] = true;
    };
    for (std::uint32_t slot = 0; slot < result_.initial.size(); ++slot) note(slot, result_.initial[slot]);
    for (const Region& region : result_.regions)
        for (const Assignment& assignment : region.assignments) note(assignment.slot, assignment.value);
    std::uint32_t word = 0;
    std::uint32_t used = 0;
    for (std::uint32_t slot = 0; slot < result_.components.size(); ++slot) {
        const std::size_t values = result_.components[slot]->size() + (may_be_off[slot] ? 1U : 0U);
        assert(values > 0);
        const auto bits = static_cast<std::uint32_t>(std::bit_width(values - 1));
        if (used + bits > 32) {
            ++word;
            used = 0;
        }
        const std::uint32_t mask = bits == 32 ? 0xffffffffU : (1U << bits) - 1U;
        result_.fields.push_back({word, used % 32U, mask});
        used += bits;
        assert(bits <= 32 && used <= 32);
    }
    result_.words = word + 1;
}

Leading leading_edges(const Supercombinator& combined, const Region& region, std::uint32_t participant,
                      diagnostics::Pollable& budget) {
    Leading result;
    if (region.participants[participant].is_region) return result;
    const Component& component = *combined.components[region.participants[participant].index];
    const std::vector<std::uint32_t>& rule = region.first_rule[participant];
    result.first.push_back(0);
    for (Local state = 0; state < component.size(); ++state) {
        budget.poll();
        for (const Component::Edge& edge : component.edges(state))
            if (rule[edge.event] < rule[edge.event + 1U]) result.edges.push_back(edge);
        result.first.push_back(static_cast<std::uint32_t>(result.edges.size()));
    }
    return result;
}

}  // namespace

void list_leading(Supercombinator& combined, diagnostics::Pollable& budget) {
    for (Region& region : combined.regions)
        for (std::uint32_t who = 0; who < region.participants.size(); ++who)
            region.leading.push_back(leading_edges(combined, region, who, budget));
}

Supercombinator combine(const process::TermStore& terms, const Skeleton& skeleton, std::vector<ComponentPtr> components,
                        std::size_t most_rules, diagnostics::Pollable& budget) {
    return Combiner(terms, skeleton, std::move(components), most_rules, budget).combine();
}

}  // namespace robochart::machine
