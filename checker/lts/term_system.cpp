// Process terms behind the narrow waist.
#include "checker/lts/term_system.hpp"

namespace robochart::lts {

void TermSystem::initial(std::span<Word> state) {
    state[0] = static_cast<Word>(initial_);
}

void TermSystem::successors(StateView state, SuccessorSink& sink) {
    for (const process::Transition& step : semantics_.successors(process::TermId{state[0]})) {
        const auto target = static_cast<Word>(step.target);
        sink.add(step.event, StateView(&target, 1), step.revealed);
    }
}

const process::EventTable& TermSystem::events() const {
    return semantics_.terms().events();
}

std::string TermSystem::describe(StateView state) const {
    return process::describe(semantics_.terms(), process::TermId{state[0]});
}

}  // namespace robochart::lts
