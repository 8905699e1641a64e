// SPDX-License-Identifier: Apache-2.0
// Reduces a compiled process by omitting states from which a confluent step can be followed (docs/search.md, "Confluent
// taus", "Deadlocks").
#pragma once

#include <memory>
#include <vector>

#include "checker/lts/state_store.hpp"
#include "checker/lts/transition_system.hpp"
#include "checker/machine/confluence.hpp"
#include "checker/machine/supercombinator_system.hpp"

namespace robochart::machine {

/// The states of this system are states of the process. A transition leads to the representative of its original
/// target. If visible steps are followed too, a state with such a step has only this transition, with the event
/// tau.
class ReducedSystem final : public lts::ReducedSystem, private lts::SuccessorSink {
public:
    /// `plan` determines which proofs are tried (Confluence).
    ReducedSystem(std::unique_ptr<lts::TransitionSystem> whole, std::shared_ptr<const Supercombinator> combined,
                  std::shared_ptr<const WholeRules> rules, lts::Followed followed, ProofPlan plan);

    [[nodiscard]] std::size_t width() const override { return whole_->width(); }
    void initial(std::span<lts::Word> state) override;
    void successors(lts::StateView state, lts::SuccessorSink& sink) override;
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> clone_for_thread() const override {
        return std::make_unique<ReducedSystem>(whole_->clone_for_thread(), combined_, rules_, followed_, plan_);
    }
    [[nodiscard]] std::unique_ptr<lts::TransitionSystem> make_cycle_system(
        diagnostics::Pollable& budget) const override;
    [[nodiscard]] const process::EventTable& events() const override { return whole_->events(); }
    [[nodiscard]] std::string describe(lts::StateView state) const override { return whole_->describe(state); }
    void set_budget(diagnostics::Pollable& budget) override;
    [[nodiscard]] std::uint64_t chased_state_count() const override { return chased_; }
    [[nodiscard]] lts::Followed followed() const override { return followed_; }
    [[nodiscard]] std::vector<std::vector<lts::Word>> followed_path(lts::StateView state) override;
    /// Adds the work and the results of all proofs so far to the record (Confluence).
    void add_to(ProofRecord& record) const { confluence_.add_to(record); }
    /// Returns the work of the proofs so far (Confluence).
    [[nodiscard]] double work_of_proofs() const { return confluence_.total_work(); }
    /// After this call, each state from which a step is followed is added to `states`. This takes time, so the function
    /// is only used to estimate what the reduction saves.
    void store_followed_states(lts::StateStore& states) { followed_states_ = &states; }
    /// Returns the compiled process that this system reduces.
    [[nodiscard]] const Supercombinator& combined() const { return *combined_; }

private:
    void add(Event event, lts::StateView target, Event revealed) override;
    void unpack_locals(lts::StateView state);
    void pack_locals(std::span<lts::Word> state) const;
    bool pass_followed_step(lts::StateView state);
    std::size_t follow_all_steps();
    std::size_t enter_cycle(std::size_t length);
    bool follow_step();

    std::unique_ptr<lts::TransitionSystem> whole_;
    std::shared_ptr<const Supercombinator> combined_;
    std::shared_ptr<const WholeRules> rules_;
    lts::Followed followed_;
    ProofPlan plan_;
    std::size_t most_steps_;  // maximal length of a sequence of followed steps
    Confluence confluence_;
    std::vector<Local> locals_, seen_, least_, begin_;
    std::vector<lts::Word> target_;
    lts::SuccessorSink* sink_ = nullptr;
    std::uint64_t chased_ = 0;
    lts::StateStore* followed_states_ = nullptr;
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
};

}  // namespace robochart::machine
