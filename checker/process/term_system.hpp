// SPDX-License-Identifier: Apache-2.0
// A process term as a transition system. Its states are terms; each takes one word.
#pragma once

#include "checker/lts/transition_system.hpp"
#include "checker/process/operational_semantics.hpp"

namespace robochart::process {

/// The transition system of one term in the operational semantics. Several systems may share the store of terms and the
/// cache of the semantics.
class TermSystem final : public lts::TransitionSystem {
public:
    TermSystem(OperationalSemantics& semantics, TermId initial) : semantics_(semantics), initial_(initial) {}

    [[nodiscard]] std::size_t width() const override { return 1; }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] std::vector<std::vector<lts::Word>> choice_operands(lts::StateView state) override;
    [[nodiscard]] const EventTable& events() const override;
    void set_budget(diagnostics::Pollable& budget) override { semantics_.set_budget(budget); }
    [[nodiscard]] bool states_are_terms() const override { return true; }
    [[nodiscard]] std::string describe(lts::StateView state) const override;

private:
    OperationalSemantics& semantics_;
    TermId initial_;
};

/// Returns the operands of a term that is an external choice, or the name of one. Returns an empty list for all other
/// terms.
[[nodiscard]] std::vector<TermId> choice_operands(TermStore& terms, TermId term);

}  // namespace robochart::process
