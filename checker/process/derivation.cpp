// SPDX-License-Identifier: Apache-2.0
// Finds derivations by the rules in firing_rules.cpp and composition_rules.cpp. If two operands can both perform a step
// without a change of their states, the step has several derivations. The result is then the one by the first of these
// operands.
#include "checker/process/derivation.hpp"

#include <algorithm>

#include "checker/process/operators.hpp"

namespace robochart::process {
namespace {

class Deriver {
public:
    Deriver(OperationalSemantics& semantics, TermId id, const Transition& step)
        : semantics_(semantics),
          terms_(semantics.terms()),
          term_(terms_[id]),
          target_(terms_[step.target]),
          step_(step) {}

    std::optional<Derivation> derive();

private:
    using Found = std::optional<Derivation>;

    [[nodiscard]] bool frame_stays() const {
        return target_.op == term_.op && target_.payload == term_.payload && target_.sets == term_.sets &&
               target_.children.size() == term_.children.size();
    }
    [[nodiscard]] bool in_set(Event event) const {
        return event != tau && event != tick && terms_.contains(SetId{term_.payload}, event);
    }
    /// Returns a transition of the operand with this event, and to `target` if that is given. If several match, prefers
    /// one with the same hidden event.
    std::optional<Transition> find_move(std::size_t operand, Event event, std::optional<TermId> target) {
        std::optional<Transition> found;
        for (const Transition& transition : semantics_.successors(term_.children[operand])) {
            if (transition.event != event || (target && transition.target != *target)) continue;
            if (transition.revealed == step_.revealed) return transition;
            if (!found) found = transition;
        }
        return found;
    }
    [[nodiscard]] bool others_stay(const std::vector<std::size_t>& movers) const {
        for (std::size_t i = 0; i < term_.children.size(); ++i)
            if (std::ranges::find(movers, i) == movers.end() && target_.children[i] != term_.children[i]) return false;
        return true;
    }
    /// Derives the step if all these operands move with its event, and the operator stays.
    Found move_together(const std::vector<std::size_t>& movers) {
        if (!frame_stays() || !others_stay(movers)) return std::nullopt;
        Derivation result;
        for (std::size_t mover : movers) {
            const std::optional<Transition> own = find_move(mover, step_.event, target_.children[mover]);
            if (!own) return std::nullopt;
            result.moves.emplace_back(mover, *own);
        }
        return result;
    }
    /// Derives the step if only this operand moves, with this event, and the operator stays.
    Found move_alone(std::size_t operand, Event event) {
        if (!frame_stays() || !others_stay({operand})) return std::nullopt;
        const std::optional<Transition> own = find_move(operand, event, target_.children[operand]);
        if (!own) return std::nullopt;
        return Derivation{{{operand, *own}}, {}, false};
    }
    Found move_any() {
        for (std::size_t i = 0; i < term_.children.size(); ++i)
            if (Found found = move_alone(i, step_.event)) return found;
        return std::nullopt;
    }
    /// Derives the step if this operand moves and its successor replaces the operator.
    Found resolve_by(std::size_t operand) {
        const std::optional<Transition> own = find_move(operand, step_.event, step_.target);
        if (!own) return std::nullopt;
        return Derivation{{{operand, *own}}, operand, false};
    }
    Found resolve_by_any() {
        for (std::size_t i = 0; i < term_.children.size(); ++i)
            if (Found found = resolve_by(i)) return found;
        return std::nullopt;
    }
    /// Derives the step if operand 0 moves with `event` and operand 1 replaces the operator.
    Found hand_over(Event event) {
        if (step_.target != term_.children[1]) return std::nullopt;
        const std::optional<Transition> own = find_move(0, event, std::nullopt);
        if (!own) return std::nullopt;
        return Derivation{{{0, *own}}, 1, true};
    }
    /// Derives the step if all these operands terminate and the result is Ω.
    Found terminate_operands(const std::vector<std::size_t>& movers) {
        Derivation result;
        for (std::size_t mover : movers) {
            const std::optional<Transition> own = find_move(mover, tick, std::nullopt);
            if (!own) return std::nullopt;
            result.moves.emplace_back(mover, *own);
        }
        return result;
    }
    [[nodiscard]] std::vector<std::size_t> all_operands() const {
        std::vector<std::size_t> all(term_.children.size());
        for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
        return all;
    }
    [[nodiscard]] std::vector<std::size_t> with_event_in_alphabet() const {
        std::vector<std::size_t> result;
        for (std::size_t i = 0; i < term_.children.size(); ++i)
            if (terms_.contains(term_.sets[i], step_.event)) result.push_back(i);
        return result;
    }

    Found derive_sliding() {
        if (Found found = step_.event == tau ? move_alone(0, tau) : resolve_by(0)) return found;
        if (step_.event == tau && step_.target == term_.children[1]) return Derivation{{}, 1, true};
        return std::nullopt;
    }
    Found derive_sequential() {
        if (Found found = move_alone(0, step_.event)) return found;
        return step_.event == tau ? hand_over(tick) : std::nullopt;
    }
    Found derive_interrupt() {
        if (step_.event == tick)
            if (Found found = terminate_operands({0})) return found;
        if (Found found = move_alone(0, step_.event)) return found;
        return step_.event == tau ? move_alone(1, tau) : resolve_by(1);
    }
    Found derive_sync_interrupt() {
        if (in_set(step_.event)) return move_together({0, 1});
        return derive_interrupt();
    }
    Found derive_hide() {
        if (step_.event == tick) return terminate_operands({0});
        if (step_.event != tau) return move_alone(0, step_.event);
        if (in_set(step_.revealed))
            if (Found found = move_alone(0, step_.revealed)) return found;
        if (Found found = move_alone(0, tau)) return found;
        for (const Event event : terms_[SetId{term_.payload}])
            if (Found found = move_alone(0, event)) return found;
        return std::nullopt;
    }
    Found derive_rename() {
        if (step_.event == tick) return terminate_operands({0});
        if (Found found = move_alone(0, step_.event); found && !is_renamed(step_.event)) return found;
        for (const auto& [from, to] : terms_[RenamingId{term_.payload}])
            if (to == step_.event)
                if (Found found = move_alone(0, from)) return found;
        return std::nullopt;
    }
    [[nodiscard]] bool is_renamed(Event event) const {
        const Renaming& pairs = terms_[RenamingId{term_.payload}];
        const auto at = std::ranges::lower_bound(pairs, EventPair{event, 0});
        return event != tau && at != pairs.end() && at->first == event;
    }

    OperationalSemantics& semantics_;
    TermStore& terms_;
    Term term_;  // a copy, because computing successors may create terms
    Term target_;
    Transition step_;
};

std::optional<Derivation> Deriver::derive() {
    const Event event = step_.event;
    switch (term_.op) {
        case Op::parallel:
            if (event == tick) return terminate_operands(all_operands());
            return in_set(event) ? move_together(all_operands()) : move_any();
        case Op::alphabetised:
            if (event == tick) return terminate_operands(all_operands());
            return event == tau ? move_any() : move_together(with_event_in_alphabet());
        case Op::sync_choice:
            if (in_set(event)) return move_together(all_operands());
            return event == tau ? move_any() : resolve_by_any();
        case Op::external_choice:
            return event == tau ? move_any() : resolve_by_any();
        case Op::sync_interrupt:
            return derive_sync_interrupt();
        case Op::interrupt:
            return derive_interrupt();
        case Op::sliding:
            return derive_sliding();
        case Op::sequential:
            return derive_sequential();
        case Op::exception:
            if (event == tick) return terminate_operands({0});
            return in_set(event) ? hand_over(event) : move_alone(0, event);
        case Op::hide:
            return derive_hide();
        case Op::rename:
            return derive_rename();
        case Op::prioritise:
        case Op::prioritise_order:
            return event == tick ? terminate_operands({0}) : move_alone(0, event);
        case Op::stop:
        case Op::skip:
        case Op::div:
        case Op::omega:
        case Op::run:
        case Op::chaos:
        case Op::call:
        case Op::prefix:
        case Op::internal_choice:
        case Op::chase:
        case Op::compress:
        case Op::machine:
        case Op::chaos_offer:
            break;
    }
    return std::nullopt;
}

}  // namespace

bool is_operator(Op op) {
    switch (properties_of(op).group) {
        case OpGroup::parallel:
        case OpGroup::unary:
        case OpGroup::resolving:
        case OpGroup::synchronising:
            return true;
        case OpGroup::leaf:
        case OpGroup::prefix:
        case OpGroup::internal_choice:
        case OpGroup::compression:
            break;
    }
    return false;
}

std::optional<Derivation> derivation(OperationalSemantics& semantics, TermId term, const Transition& step) {
    return Deriver(semantics, term, step).derive();
}

}  // namespace robochart::process
