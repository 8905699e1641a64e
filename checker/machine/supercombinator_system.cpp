// Successors by rules: each event of each participant's present state is looked up in the rules that it comes first in,
// and a rule fires in all the ways in which its other participants can do their part.
#include "checker/machine/supercombinator_system.hpp"

#include <algorithm>

namespace robochart::machine {

using process::tau;

SupercombinatorSystem::SupercombinatorSystem(std::shared_ptr<const Supercombinator> combined,
                                             const process::TermStore& terms)
    : combined_(std::move(combined)),
      terms_(terms),
      locals_(combined_->components.size()),
      moves_(combined_->regions.size()),
      target_(combined_->words) {}

namespace {

void put(std::span<lts::Word> state, const Field& field, Local value) {
    state[field.word] = (state[field.word] & ~(field.mask << field.shift)) | (value << field.shift);
}

}  // namespace

void SupercombinatorSystem::initial(std::span<lts::Word> state) {
    std::fill(state.begin(), state.end(), 0);
    for (std::size_t slot = 0; slot < combined_->fields.size(); ++slot)
        put(state, combined_->fields[slot], combined_->initial[slot]);
}

void SupercombinatorSystem::unpack(lts::StateView state) {
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) {
        const Field& field = combined_->fields[slot];
        locals_[slot] = (state[field.word] >> field.shift) & field.mask;
    }
}

/// Fires the rules of one region in one state.
class SupercombinatorSystem::Firing {
public:
    Firing(SupercombinatorSystem& system, const Region& region, Moves& out, lts::StateView state,
           lts::SuccessorSink* sink)
        : system_(system), region_(region), out_(out), state_(state), sink_(sink) {}

    void run() {
        for (std::uint32_t who = 0; who < region_.participants.size(); ++who) {
            const Participant& participant = region_.participants[who];
            if (participant.is_region)
                of_region(who, system_.moves_[participant.index]);
            else
                of_component(who, participant.index);
        }
    }

private:
    void of_component(std::uint32_t who, std::uint32_t slot) {
        for (const Component::Edge& edge : region_.leading[who].of(system_.locals_[slot])) {
            const std::vector<std::uint32_t>& first = region_.first_rule[who];
            for (std::uint32_t rule = first[edge.event]; rule < first[edge.event + 1U]; ++rule) {
                system_.changes_.clear();
                system_.changes_.push_back({slot, edge.target});
                others(region_.rules[rule], region_.rules[rule].first_requirement, edge.revealed);
            }
        }
    }

    void of_region(std::uint32_t who, const Moves& moves) {
        for (const Move& move : moves.list) {
            const std::vector<std::uint32_t>& first = region_.first_rule[who];
            for (std::uint32_t rule = first[move.event]; rule < first[move.event + 1U]; ++rule) {
                system_.changes_.clear();
                add_changes(moves, move);
                others(region_.rules[rule], region_.rules[rule].first_requirement, move.revealed);
            }
        }
    }

    void add_changes(const Moves& moves, const Move& move) {
        system_.changes_.insert(system_.changes_.end(), moves.changes.begin() + move.first_change,
                                moves.changes.begin() + move.end_change);
    }

    /// The participants after the first, from this requirement on, in all their ways.
    void others(const Rule& rule, std::uint32_t next, Event revealed) {
        if (next == rule.end_requirement) return perform(rule, revealed);
        const Requirement& wanted = region_.requirements[next];
        const Participant& participant = region_.participants[wanted.participant];
        const std::size_t before = system_.changes_.size();
        if (!participant.is_region) {
            const Component& component = *system_.combined_->components[participant.index];
            for (const Component::Edge& edge : component.edges(system_.locals_[participant.index], wanted.event)) {
                system_.changes_.push_back({participant.index, edge.target});
                others(rule, next + 1, revealed);
                system_.changes_.resize(before);
            }
            return;
        }
        const Moves& moves = system_.moves_[participant.index];
        const auto less = [](const Move& a, const Move& b) { return a.event < b.event; };
        const auto [from, to] =
            std::equal_range(moves.list.begin(), moves.list.end(), Move{wanted.event, 0, 0, 0, 0}, less);
        for (auto move = from; move != to; ++move) {
            add_changes(moves, *move);
            others(rule, next + 1, revealed);
            system_.changes_.resize(before);
        }
    }

    void perform(const Rule& rule, Event revealed_by_participant) {
        const Event revealed = rule.revealed == tau ? revealed_by_participant : rule.revealed;
        if (sink_ != nullptr) return to_sink(rule, revealed);
        const auto from = static_cast<std::uint32_t>(out_.changes.size());
        out_.changes.insert(out_.changes.end(), system_.changes_.begin(), system_.changes_.end());
        out_.changes.insert(out_.changes.end(), region_.assignments.begin() + rule.first_assignment,
                            region_.assignments.begin() + rule.end_assignment);
        const auto place = static_cast<std::uint32_t>(
            std::lower_bound(region_.alphabet.begin(), region_.alphabet.end(), rule.event) - region_.alphabet.begin());
        out_.list.push_back({place, rule.event, revealed, from, static_cast<std::uint32_t>(out_.changes.size())});
    }

    void to_sink(const Rule& rule, Event revealed) {
        std::vector<lts::Word>& target = system_.target_;
        std::copy(state_.begin(), state_.end(), target.begin());
        const std::vector<Field>& fields = system_.combined_->fields;
        for (const Assignment& change : system_.changes_) put(target, fields[change.slot], change.value);
        for (std::uint32_t i = rule.first_assignment; i < rule.end_assignment; ++i)
            put(target, fields[region_.assignments[i].slot], region_.assignments[i].value);
        sink_->add(rule.event, target, revealed);
    }

    SupercombinatorSystem& system_;
    const Region& region_;
    Moves& out_;
    lts::StateView state_;
    lts::SuccessorSink* sink_;
};

/// Priority as in process/composition_rules.cpp, prioritise: an event is prevented by one of a higher level.
void SupercombinatorSystem::prefer(const Region& region, Moves& moves) const {
    const auto level_of = [&](Event event) { return event < region.level.size() ? region.level[event] : no_level; };
    std::uint32_t best = no_level;
    for (const Move& move : moves.list) best = std::min(best, level_of(move.name));
    std::erase_if(moves.list, [&](const Move& move) {
        const std::uint32_t own = level_of(move.name);
        return own != no_level && own > best;
    });
}

void SupercombinatorSystem::fire(std::size_t index, lts::StateView state, lts::SuccessorSink* sink) {
    const Region& region = combined_->regions[index];
    Moves& moves = moves_[index];
    moves.list.clear();
    moves.changes.clear();
    Firing(*this, region, moves, state, sink).run();
    if (!region.level.empty()) prefer(region, moves);
    std::stable_sort(moves.list.begin(), moves.list.end(),
                     [](const Move& a, const Move& b) { return a.event < b.event; });
}

void SupercombinatorSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    // Where one system is both sides of a refinement, the sink asks for successors while it is given some.
    if (busy_) return SupercombinatorSystem(combined_, terms_).successors(state, sink);
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
    const std::size_t whole = combined_->regions.size() - 1;
    for (std::size_t region = 0; region < whole; ++region) fire(region, state, nullptr);
    if (combined_->regions[whole].level.empty()) return fire(whole, state, &sink);
    fire(whole, state, nullptr);
    for (const Move& move : moves_[whole].list) {
        std::copy(state.begin(), state.end(), target_.begin());
        for (std::uint32_t i = move.first_change; i < move.end_change; ++i) {
            const Assignment& change = moves_[whole].changes[i];
            put(target_, combined_->fields[change.slot], change.value);
        }
        sink.add(move.name, target_, move.revealed);
    }
}

std::string SupercombinatorSystem::describe(lts::StateView state) const {
    std::string text;
    for (std::size_t slot = 0; slot < locals_.size(); ++slot) {
        const Field& field = combined_->fields[slot];
        const Local local = (state[field.word] >> field.shift) & field.mask;
        const Component& component = *combined_->components[slot];
        if (local >= component.size()) continue;
        text += (text.empty() ? "" : " ‖ ") + process::describe(terms_, component.meaning(local));
    }
    return text;
}

}  // namespace robochart::machine
