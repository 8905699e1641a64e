// SPDX-License-Identifier: Apache-2.0
// Implements the firing rules after Roscoe, "Understanding Concurrent Systems" (UCS), chapters 9 and 20, and the FDR
// 4.2 manual, "Defining Processes" and "Built-In Definitions". In the comments x is any action, and a is a visible
// event or tick unless stated otherwise. FDR's rule for termination always holds: P --✓--> always ends in Ω, which has
// no transitions.
#include "checker/process/firing_rules.hpp"

#include <algorithm>
#include <cassert>
#include <unordered_set>

#include "checker/process/operators.hpp"

namespace robochart::process {
namespace {

constexpr std::size_t short_list = 24;

/// Does the same as drop_repeated_targets for a few transitions, without a table.
void drop_repeated_targets_of_few(std::vector<Transition>& list) {
    std::size_t distinct = 0;
    for (const Transition& step : list) {
        const auto same = [&](const Transition& other) {
            return other.event == step.event && other.target == step.target;
        };
        const auto end = list.begin() + static_cast<std::ptrdiff_t>(distinct);
        if (std::find_if(list.begin(), end, same) == end) list[distinct++] = step;
    }
    assert(distinct > 0 && distinct <= list.size());
    list.resize(distinct, Transition{tau, tau, TermId{0}});
}

/// Removes repeated transitions: of those with the same event and target, only the first stays.
void drop_repeated_targets(std::vector<Transition>& list) {
    std::unordered_set<std::uint32_t> seen;
    Event event = 0;
    std::erase_if(list, [&](const Transition& step) {
        if (step.event != event) seen.clear();
        event = step.event;
        return !seen.insert(static_cast<std::uint32_t>(step.target)).second;
    });
}

void put_in_order(std::vector<Transition>& list) {
    if (list.size() < 2) return;
    const auto earlier = [](const Transition& a, const Transition& b) { return a.event < b.event; };
    if (!std::ranges::is_sorted(list, earlier)) std::ranges::stable_sort(list, earlier);
    const auto same = [](const Transition& a, const Transition& b) { return a.event == b.event; };
    if (std::ranges::adjacent_find(list, same) == list.end()) return;
    if (list.size() <= short_list)
        drop_repeated_targets_of_few(list);
    else
        drop_repeated_targets(list);
}

}  // namespace

void refuse_unsupported(const Term& compressed) {
    const auto refuse = [](const char* name) {
        throw SemanticsError(std::string(name) + " is not supported: FDR's manual does not say what it does");
    };
    switch (Compression{compressed.payload}) {
        case Compression::deter:
            return refuse("deter");
        case Compression::trace_watchdog:
            return refuse("trace_watchdog");
        case Compression::failure_watchdog:
            return refuse("failure_watchdog");
        case Compression::normal:
        case Compression::sbisim:
        case Compression::dbisim:
        case Compression::wbisim:
        case Compression::diamond:
        case Compression::tau_loop_factor:
        case Compression::model_compress:
        case Compression::explicate:
        case Compression::lazyenumerate:
            return;
    }
}

FiringRules::FiringRules(TermStore& terms, const KnownTransitions& known)
    : terms_(terms),
      known_(known),
      omega_(terms.intern_term(Term{Op::omega, 0, {}, {}})),
      stop_(terms.intern_term(Term{Op::stop, 0, {}, {}})) {}

std::optional<TermId> FiringRules::missing_operand(TermId id) {
    const auto unless_known = [this](TermId operand) {
        return known_.is_known(operand) ? std::nullopt : std::optional(operand);
    };
    const Term& term = terms_[id];
    if (term.op == Op::call) return unless_known(terms_.unfold(term.payload));
    if (term.op == Op::chase) return unless_known(end_of_chase(term.children.front()));
    const std::span<const TermId> children(term.children);
    for (const TermId child : children.first(running_operands(term.op, children.size())))
        if (!known_.is_known(child)) return child;
    return std::nullopt;
}

std::vector<Transition> FiringRules::transitions(TermId id) {
    List list;
    fire(terms_[id], list);
    put_in_order(list);
    assert(std::ranges::is_sorted(list, {}, &Transition::event));
    return list;
}

void FiringRules::fire(const Term& term, List& list) {
    switch (term.op) {
        case Op::stop:
        case Op::omega:
            return;  // STOP and Ω have no transitions
        // UCS 9.2: SKIP --✓--> Ω.
        case Op::skip:
            return list.push_back({tick, tick, omega_});
        // FDR manual: DIV performs taus forever. DIV --τ--> DIV.
        case Op::div:
            return list.push_back({tau, tau, terms_.intern_term(term)});
        case Op::run:
        case Op::chaos_offer:
            return fire_run(term, list);
        case Op::chaos:
            return fire_chaos(term, list);
        case Op::prefix:
            return fire_prefix(term, list);
        case Op::external_choice:
            return fire_external_choice(term, list);
        case Op::internal_choice:
            return fire_internal_choice(term, list);
        case Op::sliding:
            return fire_sliding(term, list);
        case Op::sync_choice:
            return fire_sync_choice(term, list);
        case Op::sequential:
            return fire_sequential(term, list);
        case Op::interrupt:
            return fire_interrupt(term, list);
        case Op::sync_interrupt:
            return fire_sync_interrupt(term, list);
        case Op::exception:
            return fire_exception(term, list);
        case Op::parallel:
            return fire_parallel(term, list);
        case Op::alphabetised:
            return fire_alphabetised(term, list);
        case Op::call:
            return fire_call(term, list);
        case Op::hide:
            return fire_hide(term, list);
        case Op::rename:
            return fire_rename(term, list);
        case Op::prioritise:
            return fire_prioritise(term, list);
        case Op::prioritise_order:
            return fire_prioritise_order(term, list);
        case Op::chase:
            return fire_chase(term, list);
        case Op::compress:
            return fire_compressed(term, list);
        case Op::machine:
            throw std::logic_error("a state of a machine that another semantics has made");
    }
}

void FiringRules::copy_transitions(TermId operand, List& list) const {
    const std::span<const Transition> steps = known_.list_transitions(operand);
    list.assign(steps.begin(), steps.end());
}

// A name has the transitions of its body. UCS 9.2 unfolds recursion by a tau; FDR does not, and no model distinguishes
// the two rules if every recursion reaches an event.
void FiringRules::fire_call(const Term& term, List& list) {
    copy_transitions(terms_.unfold(term.payload), list);
}

// FDR manual, "Compression": a compression preserves the value of its operand in the models that it supports. The
// implementation here returns the operand's transitions unchanged, which preserves all models.
void FiringRules::fire_compressed(const Term& term, List& list) {
    refuse_unsupported(term);
    copy_transitions(term.children.front(), list);
}

// FDR manual: RUN(A) offers all of A forever. RUN(A) --a--> RUN(A), a ∈ A.
// CHAOS(A) after its choice to offer: --a--> CHAOS(A), a ∈ A.
void FiringRules::fire_run(const Term& term, List& list) {
    const Op next = term.op == Op::run ? Op::run : Op::chaos;
    const SetId set{term.payload};
    const TermId target = terms_.intern_term(Term{next, term.payload, {}, {}});
    for (Event event : terms_[set]) list.push_back({event, event, event == tick ? omega_ : target});
}

// UCS 1.3.3, FDR manual: CHAOS(A) = STOP |~| (?x:A -> CHAOS(A)).
// CHAOS(A) --τ--> STOP;  CHAOS(A) --τ--> (?x:A -> CHAOS(A)).
void FiringRules::fire_chaos(const Term& term, List& list) {
    list.push_back({tau, tau, stop_});
    list.push_back({tau, tau, terms_.intern_term(Term{Op::chaos_offer, term.payload, {}, {}})});
}

// UCS 9.2: (e -> P) --a--> P(a) for each a that e allows.
void FiringRules::fire_prefix(const Term& term, List& list) {
    const std::uint32_t payload = term.payload;
    for (const Branch& branch : terms_.branches(payload)) list.push_back({branch.event, branch.event, branch.target});
}

// UCS 9.2:  P --τ--> P'            P --a--> P'   (a ≠ τ)
//        ----------------------    ----------------------   and the same for Q.
//        P [] Q --τ--> P' [] Q     P [] Q --a--> P'
// ✓ resolves the choice like any a; the models let an option terminate by itself
// (checker/refine/search/stability.hpp).
void FiringRules::fire_external_choice(const Term& term, List& list) {
    for (std::size_t i = 0; i < term.children.size(); ++i)
        for (const Transition& step : known_.list_transitions(term.children[i]))
            list.push_back(
                {step.event, step.revealed, step.event == tau ? with_operand(term, i, step.target) : step.target});
}

// UCS 9.2: P |~| Q --τ--> P;  P |~| Q --τ--> Q.
void FiringRules::fire_internal_choice(const Term& term, List& list) {
    for (TermId child : term.children) list.push_back({tau, tau, child});
}

// UCS 9.2, sliding choice (timeout): P [> Q --τ--> Q; a tau of P keeps the choice, any other action of P resolves it to
// P'.
void FiringRules::fire_sliding(const Term& term, List& list) {
    for (const Transition& step : known_.list_transitions(term.children[0]))
        list.push_back(
            {step.event, step.revealed, step.event == tau ? with_operand(term, 0, step.target) : step.target});
    list.push_back({tau, tau, term.children[1]});
}

// FDR manual, synchronising external choice P [+A+] Q: as [], but an event of A happens in all operands together and
// leaves the choice open.
//   P --τ--> P'                   P --a--> P'  (a ∉ A)      P --a--> P', Q --a--> Q'  (a ∈ A)
//   P [+A+] Q --τ--> P' [+A+] Q   P [+A+] Q --a--> P'       P [+A+] Q --a--> P' [+A+] Q'
void FiringRules::fire_sync_choice(const Term& term, List& list) {
    const SetId set{term.payload};
    std::vector<std::size_t> everyone(term.children.size());
    for (std::size_t i = 0; i < everyone.size(); ++i) {
        everyone[i] = i;
        for (const Transition& step : known_.list_transitions(term.children[i])) {
            if (step.event == tau)
                list.push_back({tau, step.revealed, with_operand(term, i, step.target)});
            else if (!terms_.contains(set, step.event))
                list.push_back(step);
        }
    }
    synchronise_all(term, everyone, list);
}

// UCS 9.2:  P --x--> P'  (x ≠ ✓)      P --✓--> P'
//           P;Q --x--> P';Q           P;Q --τ--> Q
void FiringRules::fire_sequential(const Term& term, List& list) {
    for (const Transition& step : known_.list_transitions(term.children[0])) {
        if (step.event == tick)
            list.push_back({tau, tau, term.children[1]});
        else
            list.push_back({step.event, step.revealed, with_operand(term, 0, step.target)});
    }
}

// UCS 9.2:  P --x--> P'  (x ≠ ✓)      P --✓--> P'        Q --τ--> Q'              Q --a--> Q'  (a ≠ τ)
//           P /\ Q --x--> P' /\ Q     P /\ Q --✓--> Ω    P /\ Q --τ--> P /\ Q'    P /\ Q --a--> Q'
void FiringRules::fire_interrupt(const Term& term, List& list) {
    for (const Transition& step : known_.list_transitions(term.children[0]))
        list.push_back({step.event, step.revealed, step.event == tick ? omega_ : with_operand(term, 0, step.target)});
    for (const Transition& step : known_.list_transitions(term.children[1]))
        list.push_back(
            {step.event, step.revealed, step.event == tau ? with_operand(term, 1, step.target) : step.target});
}

// FDR manual, synchronising interrupt P /+A+\ Q: as /\, but P and Q perform an event of A together, and it interrupts
// nothing.
void FiringRules::fire_sync_interrupt(const Term& term, List& list) {
    const SetId set{term.payload};
    for (const Transition& step : known_.list_transitions(term.children[0])) {
        if (step.event == tick)
            list.push_back(step);
        else if (!terms_.contains(set, step.event))
            list.push_back({step.event, step.revealed, with_operand(term, 0, step.target)});
    }
    for (const Transition& step : known_.list_transitions(term.children[1])) {
        if (step.event == tau)
            list.push_back({tau, step.revealed, with_operand(term, 1, step.target)});
        else if (step.event == tick || !terms_.contains(set, step.event))
            list.push_back(step);
    }
    synchronise_all(term, {0, 1}, list);
}

// UCS 7.2 (throw):  P --x--> P'  (x ∉ A, x ≠ ✓)           P --a--> P'  (a ∈ A)        P --✓--> P'
//                   P [|A|> Q --x--> P' [|A|> Q           P [|A|> Q --a--> Q          P [|A|> Q --✓--> Ω
void FiringRules::fire_exception(const Term& term, List& list) {
    const SetId set{term.payload};
    for (const Transition& step : known_.list_transitions(term.children[0])) {
        if (step.event == tick)
            list.push_back(step);
        else if (step.event != tau && terms_.contains(set, step.event))
            list.push_back({step.event, step.revealed, term.children[1]});
        else
            list.push_back({step.event, step.revealed, with_operand(term, 0, step.target)});
    }
}

bool FiringRules::can_perform(TermId term, Event event) const {
    return !by_event(term, event).empty();
}

std::span<const Transition> FiringRules::by_event(TermId term, Event event) const {
    const std::span<const Transition> steps = known_.list_transitions(term);
    const auto first = std::ranges::lower_bound(steps, event, {}, &Transition::event);
    auto last = first;
    while (last != steps.end() && last->event == event) ++last;
    return {first, last};
}

TermId FiringRules::with_operand(const Term& term, std::size_t position, TermId operand) {
    scratch_ = term;
    scratch_.children[position] = operand;
    return terms_.intern_term(scratch_);
}

}  // namespace robochart::process
