// SPDX-License-Identifier: Apache-2.0
// Implements the firing rules of every operator, each with its published statement. Private to checker/process.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

/// Gives the firing rules the transitions that have been computed so far.
class KnownTransitions {
public:
    virtual ~KnownTransitions() = default;
    [[nodiscard]] virtual bool is_known(TermId) const = 0;
    [[nodiscard]] virtual std::span<const Transition> list_transitions(TermId) const = 0;
};

/// Throws SemanticsError for `deter` and the watchdogs, because they do not preserve the value of their operands.
void refuse_unsupported(const Term& compressed);

/// Derives the transitions of a term from the transitions of its operands.
class FiringRules {
public:
    FiringRules(TermStore& terms, const KnownTransitions& known);

    /// Returns an operand whose transitions must be computed before those of this term. Returns no value if all of them
    /// are known; `transitions` can then be called.
    std::optional<TermId> missing_operand(TermId);
    /// Returns the term's transitions, sorted by event and without duplicates.
    std::vector<Transition> transitions(TermId);
    /// Sets the budget that the computation of transitions polls. The budget must outlive this object.
    void set_budget(diagnostics::Pollable& budget) { budget_ = &budget; }

private:
    using List = std::vector<Transition>;

    diagnostics::Pollable* budget_ = &diagnostics::unlimited;

    void fire(const Term&, List&);
    void copy_transitions(TermId, List&) const;

    void fire_call(const Term&, List&);
    void fire_compressed(const Term&, List&);
    void fire_run(const Term&, List&);
    void fire_chaos(const Term&, List&);
    void fire_prefix(const Term&, List&);
    void fire_external_choice(const Term&, List&);
    void fire_internal_choice(const Term&, List&);
    void fire_sliding(const Term&, List&);
    void fire_sequential(const Term&, List&);
    void fire_interrupt(const Term&, List&);
    void fire_exception(const Term&, List&);
    void fire_sync_choice(const Term&, List&);
    void fire_sync_interrupt(const Term&, List&);
    void fire_parallel(const Term&, List&);
    void fire_alphabetised(const Term&, List&);
    void fire_hide(const Term&, List&);
    void fire_rename(const Term&, List&);
    void fire_prioritise(const Term&, List&);
    void fire_prioritise_order(const Term&, List&);
    void fire_chase(const Term&, List&);

    [[nodiscard]] bool can_perform(TermId, Event) const;
    [[nodiscard]] std::span<const Transition> by_event(TermId, Event) const;
    /// Returns the term that determines the behaviour of chase. The function follows the first tau of the operand, and
    /// of each term after it, until a term has no tau or is on a loop of taus.
    [[nodiscard]] TermId end_of_chase(TermId operand) const;
    TermId with_operand(const Term&, std::size_t position, TermId operand);
    void synchronise_all(const Term&, const std::vector<std::size_t>& participants, List&);
    void synchronise(const Term&, const std::vector<std::size_t>& participants, Event, List&);
    void tick_together(const Term&, List&);
    const std::vector<std::uint32_t>& priority_levels(OrderId);

    TermStore& terms_;
    const KnownTransitions& known_;
    Term scratch_;
    TermId omega_;
    TermId stop_;
    std::vector<std::vector<std::uint32_t>> levels_;  // by order: the level of each event
};

}  // namespace robochart::process
