// SPDX-License-Identifier: Apache-2.0
#include "checker/lts/symmetric_system.hpp"

#include <algorithm>

#include "checker/lts/sink_in_use.hpp"

namespace robochart::lts {

SymmetricSystem::SymmetricSystem(std::unique_ptr<TransitionSystem> system, Symmetry symmetry)
    : system_(std::move(system)), symmetry_(std::move(symmetry)), target_(system_->width()) {}

void SymmetricSystem::initial(std::span<Word> state) {
    system_->initial(state);
    symmetry_.fold(state);
}

std::unique_ptr<TransitionSystem> SymmetricSystem::another() const {
    std::unique_ptr<TransitionSystem> system = system_->another();
    return system ? std::make_unique<SymmetricSystem>(std::move(system), symmetry_) : nullptr;
}

void SymmetricSystem::watch(const std::function<void()>& poll) {
    poll_ = poll;
    system_->watch(poll);
}

void SymmetricSystem::successors(StateView state, SuccessorSink& sink) {
    // The sink may ask for successors while it receives some.
    if (sink_ != nullptr) {
        const auto other = another();
        other->watch(poll_);
        return other->successors(state, sink);
    }
    const SinkInUse in_use(sink_, sink);
    system_->successors(state, *this);
}

void SymmetricSystem::add(Event event, StateView target, Event revealed) {
    std::ranges::copy(target, target_.begin());
    symmetry_.fold(target_);
    sink_->add(event, target_, revealed);
}

}  // namespace robochart::lts
