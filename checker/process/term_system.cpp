// SPDX-License-Identifier: Apache-2.0
// Process terms as transition systems.
#include "checker/process/term_system.hpp"

namespace robochart::process {

void TermSystem::initial(std::span<lts::Word> state) {
    state[0] = static_cast<lts::Word>(initial_);
}

void TermSystem::successors(lts::StateView state, lts::SuccessorSink& sink) {
    for (const Transition& step : semantics_.successors(TermId{state[0]})) {
        const auto target = static_cast<lts::Word>(step.target);
        sink.add(step.event, lts::StateView(&target, 1), step.revealed);
    }
}

const EventTable& TermSystem::events() const {
    return semantics_.terms().events();
}

std::string TermSystem::describe(lts::StateView state) const {
    return process::describe(semantics_.terms(), TermId{state[0]});
}

}  // namespace robochart::process
