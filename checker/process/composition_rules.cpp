// SPDX-License-Identifier: Apache-2.0
// Implements the firing rules of the operators that compose a system: parallel, hiding, renaming, priority, chase. The
// notation and the sources are those of firing_rules.cpp.
#include <algorithm>
#include <unordered_set>

#include "checker/process/firing_rules.hpp"
#include "checker/process/priority_order.hpp"

namespace robochart::process {
namespace {}  // namespace

// UCS 9.2:  P --x--> P'  (x ∉ A, x ≠ ✓)          P --a--> P', Q --a--> Q'  (a ∈ A)
//           P [|A|] Q --x--> P' [|A|] Q          P [|A|] Q --a--> P' [|A|] Q'
// FDR: P --✓-->, Q --✓--> gives P [|A|] Q --✓--> Ω (A behaves as A ∪ {✓}), so neither side terminates alone.
void FiringRules::fire_parallel(const Term& term, List& list) {
    const SetId set{term.payload};
    std::vector<std::size_t> everyone(term.children.size());
    for (std::size_t i = 0; i < everyone.size(); ++i) {
        everyone[i] = i;
        for (const Transition& step : known_.list_transitions(term.children[i]))
            if (step.event != tick && (step.event == tau || !terms_.contains(set, step.event)))
                list.push_back({step.event, step.revealed, with_operand(term, i, step.target)});
    }
    tick_together(term, list);
    synchronise_all(term, everyone, list);
}

// UCS 9.2, alphabetised parallel: an event of some alphabet happens if every operand whose alphabet contains the event
// performs it. Each operand performs its taus alone. Tick is as in [|A|].
void FiringRules::fire_alphabetised(const Term& term, List& list) {
    tick_together(term, list);
    std::vector<std::size_t> participants;
    for (std::size_t i = 0; i < term.children.size(); ++i) {
        Event last = tau;
        for (const Transition& step : known_.list_transitions(term.children[i])) {
            if (step.event == tau) list.push_back({tau, step.revealed, with_operand(term, i, step.target)});
            if (step.event == last || step.event == tick || !terms_.contains(term.sets[i], step.event)) continue;
            last = step.event;
            participants.clear();
            for (std::size_t j = 0; j < term.children.size(); ++j)
                if (terms_.contains(term.sets[j], last)) participants.push_back(j);
            if (participants.front() == i) synchronise(term, participants, last, list);
        }
    }
}

void FiringRules::tick_together(const Term& term, List& list) {
    const bool all = std::ranges::all_of(term.children, [this](TermId child) { return can_perform(child, tick); });
    if (all) list.push_back({tick, tick, omega_});
}

/// For every event of the term's set except tick, adds the synchronised steps if all participants can perform the
/// event. Only events of the first participant need to be examined.
void FiringRules::synchronise_all(const Term& term, const std::vector<std::size_t>& participants, List& list) {
    if (participants.empty()) return;
    Event last = tau;
    for (const Transition& step : known_.list_transitions(term.children[participants.front()])) {
        if (step.event == last || step.event == tick || !terms_.contains(SetId{term.payload}, step.event)) continue;
        last = step.event;
        synchronise(term, participants, step.event, list);
    }
}

/// Adds all combinations of the participants' steps with this event. The last participant varies fastest.
void FiringRules::synchronise(const Term& term, const std::vector<std::size_t>& participants, Event event, List& list) {
    std::vector<std::span<const Transition>> steps;
    for (std::size_t participant : participants) {
        steps.push_back(by_event(term.children[participant], event));
        if (steps.back().empty()) return;
    }
    std::vector<std::size_t> choice(participants.size(), 0);
    for (bool more = true; more;) {
        budget_->poll();
        scratch_ = term;
        for (std::size_t i = 0; i < participants.size(); ++i)
            scratch_.children[participants[i]] = steps[i][choice[i]].target;
        list.push_back({event, event, terms_.intern_term(scratch_)});
        more = false;
        for (std::size_t i = participants.size(); i-- > 0 && !more;) {
            more = ++choice[i] < steps[i].size();
            if (!more) choice[i] = 0;
        }
    }
}

// UCS 9.2:  P --x--> P'  (x ∉ A)          P --a--> P'  (a ∈ A)
//           P \ A --x--> P' \ A           P \ A --τ--> P' \ A
// Tick cannot be hidden.
void FiringRules::fire_hide(const Term& term, List& list) {
    const SetId set{term.payload};
    for (const Transition& step : known_.list_transitions(term.children[0])) {
        if (step.event == tick)
            list.push_back(step);
        else {
            const bool hidden = step.event != tau && terms_.contains(set, step.event);
            list.push_back({hidden ? tau : step.event, step.revealed, with_operand(term, 0, step.target)});
        }
    }
}

// UCS 9.2:  P --a--> P', (a,b) ∈ R  gives  P[[R]] --b--> P'[[R]]; τ and ✓ keep their names. CSPM: an event that R does
// not mention keeps its name; one mentioned several times is offered with each of its names.
void FiringRules::fire_rename(const Term& term, List& list) {
    const Renaming& pairs = terms_[RenamingId{term.payload}];
    for (const Transition& step : known_.list_transitions(term.children[0])) {
        if (step.event == tick) {
            list.push_back(step);
            continue;
        }
        const TermId target = with_operand(term, 0, step.target);
        auto pair = std::ranges::lower_bound(pairs, EventPair{step.event, 0});
        const bool named = step.event != tau && pair != pairs.end() && pair->first == step.event;
        if (!named) list.push_back({step.event, step.revealed, target});
        for (; named && pair != pairs.end() && pair->first == step.event; ++pair)
            list.push_back({pair->second, pair->second, target});
    }
}

// FDR manual, prioritise(P, <A0, ..., An>), and UCS 20.2: the sets are in order of descending priority; an event of A_i
// is prevented if P can also perform an event of A_j with j < i. τ and ✓ count as members of A0: they are never
// prevented, prevent A_1 ... A_n, and do not prevent A0. An event in none of the sets prevents no event, and no event
// prevents it.
//   P --x--> P',  no y of higher level than x with P --y-->
//   prioritise(P,O) --x--> prioritise(P',O)
void FiringRules::fire_prioritise(const Term& term, List& list) {
    const std::vector<std::uint32_t>& level = priority_levels(OrderId{term.payload});
    const auto level_of = [&](Event event) { return event < level.size() ? level[event] : no_level; };
    const std::span<const Transition> steps = known_.list_transitions(term.children[0]);
    std::uint32_t best = no_level;
    for (const Transition& step : steps) best = std::min(best, level_of(step.event));
    for (const Transition& step : steps) {
        const std::uint32_t own = level_of(step.event);
        if (own != no_level && own > best) continue;
        list.push_back({step.event, step.revealed, step.event == tick ? omega_ : with_operand(term, 0, step.target)});
    }
}

// FDR manual, prioritisepo(P, E, O, M), and UCS 20.2: as prioritise, by the partial order on the events of E that the
// pairs of O generate; τ and ✓ are above all events of E except the maximal ones, M.
//   P --x--> P',  no y with (y,x) in the order and P --y-->
//   prioritisepo(P,E,O,M) --x--> prioritisepo(P',E,O,M)
void FiringRules::fire_prioritise_order(const Term& term, List& list) {
    const Renaming& order = terms_[RenamingId{term.payload}];
    const std::span<const Transition> steps = known_.list_transitions(term.children[0]);
    const auto prevented = [&](Event event) {
        return std::ranges::any_of(steps, [&](const Transition& other) {
            return std::ranges::binary_search(order, EventPair{other.event, event});
        });
    };
    for (const Transition& step : steps)
        if (!prevented(step.event))
            list.push_back(
                {step.event, step.revealed, step.event == tick ? omega_ : with_operand(term, 0, step.target)});
}

const std::vector<std::uint32_t>& FiringRules::priority_levels(OrderId id) {
    const auto index = static_cast<std::uint32_t>(id);
    if (index >= levels_.size()) levels_.resize(index + 1U);
    std::vector<std::uint32_t>& level = levels_[index];
    if (level.empty()) level = levels_of(terms_[id]);
    return level;
}

// FDR manual, chase(P): if P has taus, one of them is followed at once and the other actions of that state are dropped,
// until no tau is left. This implementation follows the first tau. If the sequence of taus is infinite, the result
// diverges.
void FiringRules::fire_chase(const Term& term, List& list) {
    const TermId end = end_of_chase(term.children[0]);
    if (can_perform(end, tau)) {
        list.push_back({tau, tau, with_operand(term, 0, end)});
        return;
    }
    for (const Transition& step : known_.list_transitions(end))
        list.push_back({step.event, step.revealed, step.event == tick ? omega_ : with_operand(term, 0, step.target)});
}

TermId FiringRules::end_of_chase(TermId operand) const {
    std::unordered_set<std::uint32_t> passed;
    while (known_.is_known(operand) && can_perform(operand, tau) &&
           passed.insert(static_cast<std::uint32_t>(operand)).second)
        operand = known_.list_transitions(operand).front().target;
    return operand;
}

}  // namespace robochart::process
