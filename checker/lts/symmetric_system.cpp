// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/symmetric_system.hpp"

#include <algorithm>
#include <cassert>

#include "checker/lts/sink_in_use.hpp"

namespace robochart::lts {

SymmetricSystem::SymmetricSystem(std::unique_ptr<TransitionSystem> system, Symmetry symmetry)
    : system_(std::move(system)), symmetry_(std::move(symmetry)), target_(system_->width()) {}

void SymmetricSystem::initial(std::span<Word> state) {
    system_->initial(state);
    symmetry_.replace_by_representative(state);
}

std::unique_ptr<TransitionSystem> SymmetricSystem::clone_for_thread() const {
    std::unique_ptr<TransitionSystem> system = system_->clone_for_thread();
    return system ? std::make_unique<SymmetricSystem>(std::move(system), symmetry_) : nullptr;
}

std::unique_ptr<TransitionSystem> SymmetricSystem::make_cycle_system(diagnostics::Pollable& budget) const {
    std::unique_ptr<TransitionSystem> system = system_->make_cycle_system(budget);
    return system ? std::make_unique<SymmetricSystem>(std::move(system), symmetry_) : nullptr;
}

void SymmetricSystem::set_budget(diagnostics::Pollable& budget) {
    budget_ = &budget;
    system_->set_budget(budget);
}

void SymmetricSystem::successors(StateView state, SuccessorSink& sink) {
    // The sink may call successors() again while it receives successors.
    if (sink_ != nullptr) {
        const auto other = clone_for_thread();
        other->set_budget(*budget_);
        return other->successors(state, sink);
    }
    const SinkInUse in_use(sink_, sink);
    system_->successors(state, *this);
}

void SymmetricSystem::add(Event event, StateView target, Event revealed) {
    assert(sink_ != nullptr && target.size() == target_.size());
    std::ranges::copy(target, target_.begin());
    symmetry_.replace_by_representative(target_);
    sink_->add(event, target_, revealed);
}

}  // namespace robochart::lts
