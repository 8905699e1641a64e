// SPDX-License-Identifier: Apache-2.0
// The firing rules of every operator, each with its published statement. Private to checker/process.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

/// The transitions computed so far.
class KnownTransitions {
public:
    virtual ~KnownTransitions() = default;
    [[nodiscard]] virtual bool knows(TermId) const = 0;
    [[nodiscard]] virtual std::span<const Transition> of(TermId) const = 0;
};

/// Throws SemanticsError for `deter` and the watchdogs, which are not compressions in this sense.
void refuse_unsupported(const Term& compressed);

/// Derives a term's transitions from those of its operands.
class FiringRules {
public:
    FiringRules(TermStore& terms, const KnownTransitions& known);

    /// Returns an operand whose transitions are needed next and are not known. No value if `transitions` can be called.
    std::optional<TermId> missing_operand(TermId);
    /// Returns the transitions, sorted by event and without duplicates.
    std::vector<Transition> transitions(TermId);
    /// `poll` is called regularly if a term has many transitions; it may throw to stop. Empty: none.
    void watch(std::function<void()> poll) { poll_ = std::move(poll); }

private:
    using List = std::vector<Transition>;

    std::function<void()> poll_;

    void fire(const Term&, List&);
    void stop_family(const Term&, List&);
    void choice_family(const Term&, List&);
    void parallel_family(const Term&, List&);
    void unary_family(const Term&, List&);

    void run(const Term&, List&);
    void chaos(const Term&, List&);
    void prefix(const Term&, List&);
    void external_choice(const Term&, List&);
    void internal_choice(const Term&, List&);
    void sliding(const Term&, List&);
    void sequential(const Term&, List&);
    void interrupt(const Term&, List&);
    void exception(const Term&, List&);
    void sync_choice(const Term&, List&);
    void sync_interrupt(const Term&, List&);
    void parallel(const Term&, List&);
    void alphabetised(const Term&, List&);
    void hide(const Term&, List&);
    void rename(const Term&, List&);
    void prioritise(const Term&, List&);
    void prioritise_order(const Term&, List&);
    void chase(const Term&, List&);

    [[nodiscard]] bool performs(TermId, Event) const;
    [[nodiscard]] std::span<const Transition> by_event(TermId, Event) const;
    /// Returns the operand that determines the behaviour of chase: the end of its first taus, or a state on a tau loop.
    [[nodiscard]] TermId end_of_chase(TermId operand) const;
    TermId with_operand(const Term&, std::size_t position, TermId operand);
    void synchronise_all(const Term&, const std::vector<std::size_t>& participants, List&);
    void synchronise(const Term&, const std::vector<std::size_t>& participants, Event, List&);
    void tick_together(const Term&, List&);
    const std::vector<std::uint32_t>& levels(OrderId);

    TermStore& terms_;
    const KnownTransitions& known_;
    Term scratch_;
    TermId omega_;
    TermId stop_;
    std::vector<std::vector<std::uint32_t>> levels_;  // by order: the level of each event
};

}  // namespace robochart::process
