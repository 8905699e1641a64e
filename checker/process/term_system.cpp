// SPDX-License-Identifier: Apache-2.0
// Implements the transition system of a process term.
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

std::vector<std::vector<lts::Word>> TermSystem::choice_operands(lts::StateView state) {
    std::vector<std::vector<lts::Word>> operands;
    for (const TermId operand : process::choice_operands(semantics_.terms(), TermId{state[0]}))
        operands.push_back({static_cast<lts::Word>(operand)});
    return operands;
}

const EventTable& TermSystem::events() const {
    return semantics_.terms().events();
}

std::string TermSystem::describe(lts::StateView state) const {
    return process::describe(semantics_.terms(), TermId{state[0]});
}

std::vector<TermId> choice_operands(TermStore& terms, TermId term) {
    constexpr int most_names = 100;
    const Term& unfolded = terms[terms.unfold_calls(term, most_names)];
    return unfolded.op == Op::external_choice ? unfolded.children : std::vector<TermId>();
}

}  // namespace robochart::process
