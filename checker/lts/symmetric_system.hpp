// SPDX-License-Identifier: Apache-2.0
// A system that keeps only one of the states that symmetries map to each other (docs/search.md, "Symmetry").
#pragma once

#include <memory>
#include <vector>

#include "checker/lts/symmetry.hpp"
#include "checker/lts/transition_system.hpp"

namespace robochart::lts {

/// The states of this system are states of the original system. A transition leads to the representative of the state
/// to which the original transition leads, and has the same event as the original transition.
class SymmetricSystem final : public TransitionSystem, private SuccessorSink {
public:
    /// `symmetry` must be a symmetry of `system`, or of the system that `system` reduces.
    SymmetricSystem(std::unique_ptr<TransitionSystem> system, Symmetry symmetry);

    [[nodiscard]] std::size_t width() const override { return system_->width(); }
    void initial(std::span<Word> state) override;
    void successors(StateView state, SuccessorSink& sink) override;
    /// Returns null if the original system cannot be copied.
    [[nodiscard]] std::unique_ptr<TransitionSystem> clone_for_thread() const override;
    [[nodiscard]] const EventTable& events() const override { return system_->events(); }
    [[nodiscard]] std::string describe(StateView state) const override { return system_->describe(state); }
    void set_budget(diagnostics::Pollable& budget) override;
    [[nodiscard]] std::unique_ptr<TransitionSystem> make_cycle_system(diagnostics::Pollable& budget) const override;
    [[nodiscard]] std::uint64_t chased_state_count() const override { return system_->chased_state_count(); }
    /// Returns the original system.
    [[nodiscard]] const TransitionSystem& original_system() const { return *system_; }
    [[nodiscard]] const Symmetry& symmetry() const { return symmetry_; }

private:
    void add(Event event, StateView target, Event revealed) override;

    std::unique_ptr<TransitionSystem> system_;
    Symmetry symmetry_;
    std::vector<Word> target_;
    SuccessorSink* sink_ = nullptr;
    diagnostics::Pollable* budget_ = &diagnostics::unlimited;
};

}  // namespace robochart::lts
