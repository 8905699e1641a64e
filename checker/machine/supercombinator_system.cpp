// SPDX-License-Identifier: Apache-2.0
// Computes successors by rules. For each event that a participant can perform now, it looks up the rules that start
// with this event of this participant. A rule fires for every combination of transitions of its other participants. The
// moves of an inner region are computed only when an outer rule needs them, and priorities only when an event is
// possible that they may prevent.
#include "checker/machine/supercombinator_system.hpp"

#include <algorithm>
#include <cassert>

#include "checker/machine/static_proofs.hpp"

namespace robochart::machine {

using process::tau;

SupercombinatorSystem::SupercombinatorSystem(std::shared_ptr<const Supercombinator> combined,
                                             const process::TermStore& terms)
    : combined_(std::move(combined)),
      terms_(terms),
      locals_(combined_->components.size()),
      moves_(combined_->regions.size()),
      target_(combined_->words) {
    assert(!moves_.empty());
    assert(combined_->fields.size() == locals_.size() && combined_->initial.size() == locals_.size());
    for (std::size_t region = 0; region < moves_.size(); ++region)
        moves_[region].by_event.resize(combined_->regions[region].alphabet.size());
}

void SupercombinatorSystem::initial(std::span<lts::Word> state) {
    assert(state.size() == combined_->words);
    std::ranges::fill(state, 0);
    for (std::size_t slot = 0; slot < combined_->fields.size(); ++slot)
        combined_->fields[slot].put(state, combined_->initial[slot]);
}

void SupercombinatorSystem::unpack(lts::StateView state) {
    assert(state.size() == combined_->words);
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) locals_[slot] = combined_->fields[slot].get(state);
}

/// Fires rules of one region in the current state.
class SupercombinatorSystem::Firing {
public:
    Firing(SupercombinatorSystem& system, std::uint32_t region)
        : system_(system), number_(region), region_(system.combined_->regions[region]), base_(system.changes_.size()) {}

    /// Fires the rules of this region whose events start rules of an outer region. Stores the moves in the list of the
    /// region.
    void list_leading(const std::vector<std::uint32_t>& first_rule_around) {
        around_ = &first_rule_around;
        enumerate();
    }
    /// Fires the rules with one event, and stores their moves.
    void list_event(std::uint32_t event) {
        assert(event < region_.by_event.size());
        for (const std::uint32_t rule : region_.by_event[event])
            try_participant(region_.rules[rule], region_.rules[rule].lead, region_.rules[rule].first_requirement, tau);
    }
    /// Passes all results to the sink as successors of the state.
    void pass_results(lts::StateView state, lts::SuccessorSink& sink) {
        state_ = state;
        sink_ = &sink;
        enumerate();
    }
    /// Returns the first level that has a rule which can fire, or no_level.
    std::uint32_t find_best_level() {
        probing_ = true;
        enumerate();
        return best_;
    }

private:
    void enumerate() {
        for (std::uint32_t who = 0; who < region_.participants.size(); ++who) {
            const Participant& participant = region_.participants[who];
            assert(participant.is_region ? participant.index < number_ : participant.index < system_.locals_.size());
            const std::vector<std::uint32_t>& first = region_.first_rule[who];
            if (!participant.is_region) {
                for (const Component::Edge& edge : region_.leading[who].edges_of(system_.locals_[participant.index]))
                    begin(participant.index, edge, first[edge.event], first[edge.event + 1U]);
                continue;
            }
            const Range moves = system_.leading_moves(participant.index, first);
            for (std::size_t i = moves.from; i < moves.to; ++i) {
                const Move move = system_.moves_[participant.index].list[i];
                begin(participant.index, move, first[move.event], first[move.event + 1U]);
            }
        }
    }

    /// Tries the rules [rule, end). Their first participant performs this transition.
    template <typename Way>
    void begin(std::uint32_t who, const Way& way, std::uint32_t rule, std::uint32_t end) {
        assert(rule <= end && end <= region_.rules.size());
        for (; rule < end; ++rule)
            if (is_relevant(rule)) take_step(region_.rules[rule], who, way, region_.rules[rule].first_requirement, tau);
    }

    [[nodiscard]] bool is_relevant(std::uint32_t number) const {
        const Rule& rule = region_.rules[number];
        if (probing_) return rule.level < best_;
        if (around_ != nullptr) return (*around_)[rule.place] < (*around_)[rule.place + 1U];
        return system_.fired_ == nullptr || (*system_.fired_)[number];
    }

    /// Applies the step of one participant. Then processes the requirements from index `next` on. If the event is a
    /// tau, its name is that of the first participant's tau.
    template <typename Way>
    void take_step(const Rule& rule, std::uint32_t who, const Way& way, std::uint32_t next, Event revealed) {
        const std::size_t before = system_.changes_.size();
        ++system_.work_;
        assert(next <= rule.end_requirement);
        add_changes(who, way);
        const Event name = next == rule.first_requirement ? way.revealed : revealed;
        if (next == rule.end_requirement)
            perform_rule(rule, name);
        else
            try_participant(rule, region_.requirements[next], next + 1, name);
        system_.changes_.resize(before);
    }

    void add_changes(std::uint32_t slot, const Component::Edge& edge) {
        system_.changes_.push_back({slot, edge.target});
    }
    void add_changes(std::uint32_t region, const Move& move) {
        const std::vector<Assignment>& inside = system_.moves_[region].changes;
        assert(move.first_change <= move.end_change && move.end_change <= inside.size());
        system_.changes_.insert(system_.changes_.end(), inside.begin() + move.first_change,
                                inside.begin() + move.end_change);
    }

    /// Tries all transitions of one participant.
    void try_participant(const Rule& rule, const Requirement& requirement, std::uint32_t next, Event revealed) {
        const Participant& participant = region_.participants[requirement.participant];
        if (!participant.is_region) {
            const Component& component = *system_.combined_->components[participant.index];
            for (const Component::Edge& edge : component.edges(system_.locals_[participant.index], requirement.event))
                take_step(rule, participant.index, edge, next, revealed);
            return;
        }
        const Range moves = system_.moves_by(participant.index, requirement.event);
        for (std::size_t i = moves.from; i < moves.to; ++i) {
            const Move move = system_.moves_[participant.index].list[i];
            take_step(rule, participant.index, move, next, revealed);
        }
    }

    /// Applies priority as in process/composition_rules.cpp: a possible event of a higher level prevents an event.
    void perform_rule(const Rule& rule, Event revealed_by_participant) {
        constexpr std::uint32_t between_polls = 64;
        if (++system_.performed_ % between_polls == 0) system_.budget_->poll();
        if (probing_) {
            assert(rule.level <= best_);  // is_relevant has excluded the others
            best_ = std::min(best_, rule.level);
            return;
        }
        if (rule.level != 0 && rule.level != no_level && system_.best_level(number_) < rule.level) return;
        Event revealed = rule.revealed == tau ? revealed_by_participant : rule.revealed;
        if (rule.event == tau && revealed == process::tick) revealed = tau;  // the tick of P in P ; Q
        if (sink_ != nullptr)
            to_sink(rule, revealed);
        else
            to_list(rule, revealed);
    }

    void to_list(const Rule& rule, Event revealed) {
        Moves& out = system_.moves_[number_];
        assert(base_ <= system_.changes_.size());
        const auto from = static_cast<std::uint32_t>(out.changes.size());
        out.changes.insert(out.changes.end(), system_.changes_.begin() + static_cast<std::ptrdiff_t>(base_),
                           system_.changes_.end());
        out.changes.insert(out.changes.end(), region_.assignments.begin() + rule.first_assignment,
                           region_.assignments.begin() + rule.end_assignment);
        out.list.push_back({rule.place, revealed, from, static_cast<std::uint32_t>(out.changes.size())});
    }

    void to_sink(const Rule& rule, Event revealed) {
        std::vector<lts::Word>& target = system_.target_;
        assert(state_.size() == target.size());
        std::ranges::copy(state_, target.begin());
        const std::vector<Field>& fields = system_.combined_->fields;
        for (const Assignment& change : system_.changes_) fields[change.slot].put(target, change.value);
        for (std::uint32_t i = rule.first_assignment; i < rule.end_assignment; ++i)
            fields[region_.assignments[i].slot].put(target, region_.assignments[i].value);
        sink_->add(rule.event, target, revealed);
    }

    SupercombinatorSystem& system_;
    std::uint32_t number_;
    const Region& region_;
    std::size_t base_;  // where the changes of this rule start; those before belong to rules of outer regions
    const std::vector<std::uint32_t>* around_ = nullptr;
    bool probing_ = false;
    std::uint32_t best_ = no_level;
    lts::StateView state_;
    lts::SuccessorSink* sink_ = nullptr;
};

SupercombinatorSystem::Range SupercombinatorSystem::leading_moves(std::uint32_t region,
                                                                  const std::vector<std::uint32_t>& first_rule_around) {
    Moves& moves = moves_[region];
    if (moves.leading.state != state_number_) {
        const std::size_t from = moves.list.size();
        Firing(*this, region).list_leading(first_rule_around);
        moves.leading = {state_number_, from, moves.list.size()};
    }
    return moves.leading;
}

SupercombinatorSystem::Range SupercombinatorSystem::moves_by(std::uint32_t region, std::uint32_t event) {
    Moves& moves = moves_[region];
    Range& known = moves.by_event[event];
    if (known.state != state_number_) {
        const std::size_t from = moves.list.size();
        Firing(*this, region).list_event(event);
        known = {state_number_, from, moves.list.size()};
    }
    return known;
}

std::uint32_t SupercombinatorSystem::best_level(std::uint32_t region) {
    Moves& moves = moves_[region];
    if (moves.state != state_number_) {
        moves.best = Firing(*this, region).find_best_level();
        moves.state = state_number_;
    }
    return moves.best;
}

void SupercombinatorSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    // If both sides of a refinement are the same object, the sink calls this function again before it
    // returns.
    if (busy_) {
        const std::unique_ptr<SupercombinatorSystem> another = make_copy();
        another->budget_ = budget_;
        return another->successors(state, sink);
    }
    busy_ = true;
    try {
        pass_successors(state, sink);
    } catch (...) {
        busy_ = false;
        throw;
    }
    busy_ = false;
}

void SupercombinatorSystem::pass_successors(lts::StateView state, lts::SuccessorSink& sink) {
    unpack(state);
    ++state_number_;
    changes_.clear();  // a sink may have thrown an exception in the previous call
    for (Moves& moves : moves_) {
        moves.list.clear();
        moves.changes.clear();
    }
    Firing(*this, static_cast<std::uint32_t>(moves_.size() - 1)).pass_results(state, sink);
    assert(changes_.empty());
}

std::unique_ptr<SupercombinatorSystem> SupercombinatorSystem::make_copy() const {
    auto copy = std::make_unique<SupercombinatorSystem>(combined_, terms_);
    copy->facts_ = facts_;
    copy->fired_ = fired_;
    return copy;
}

/// Returns the rules of the whole process, or null if there are too many.
const WholeRules* SupercombinatorSystem::find_whole_rules(diagnostics::Pollable& budget) const {
    if (facts_.whole == nullptr && !facts_.too_many) {
        std::optional<WholeRules> rules = whole_rules(*combined_, budget);
        facts_.too_many = !rules;
        if (rules) facts_.whole = std::make_shared<const WholeRules>(std::move(*rules));
    }
    return facts_.whole.get();
}

const std::vector<bool>& SupercombinatorSystem::find_cycle_rules(const WholeRules& rules,
                                                                 diagnostics::Pollable& budget) const {
    if (facts_.on_cycles == nullptr)
        facts_.on_cycles = std::make_shared<const std::vector<bool>>(rules_on_tau_cycles(*combined_, rules, budget));
    return *facts_.on_cycles;
}

bool SupercombinatorSystem::excludes_tau_cycles(diagnostics::Pollable& budget) const {
    const WholeRules* const rules = find_whole_rules(budget);
    if (rules == nullptr) return false;
    const std::vector<bool>& on_cycles = find_cycle_rules(*rules, budget);
    return std::ranges::find(on_cycles, true) == on_cycles.end();
}

bool SupercombinatorSystem::excludes_choices(diagnostics::Pollable& budget) const {
    const WholeRules* const rules = find_whole_rules(budget);
    return rules != nullptr && exclude_choices(*combined_, *rules);
}

/// Returns a system without rules that are on no cycle. A rule of the outermost region fires only if a rule of the
/// whole process that passes through it may be on a cycle.
std::unique_ptr<lts::TransitionSystem> SupercombinatorSystem::make_cycle_system(diagnostics::Pollable& budget) const {
    const WholeRules* const rules = find_whole_rules(budget);
    if (rules == nullptr) return nullptr;
    const std::vector<bool>& on_cycles = find_cycle_rules(*rules, budget);
    std::vector<bool> fired(combined_->regions.back().rules.size());
    for (std::size_t rule = 0; rule < on_cycles.size(); ++rule)
        if (on_cycles[rule]) fired[rules->rules[rule].outermost] = true;
    std::unique_ptr<SupercombinatorSystem> copy = make_copy();
    copy->fired_ = std::make_shared<const std::vector<bool>>(std::move(fired));
    return copy;
}

std::string SupercombinatorSystem::describe(lts::StateView state) const {
    std::string text;
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) {
        const Local local = combined_->fields[slot].get(state);
        const Component& component = *combined_->components[slot];
        if (local >= component.size()) continue;
        text += (text.empty() ? "" : " ‖ ") + process::describe(terms_, component.term_of(local));
    }
    return text;
}

}  // namespace robochart::machine
