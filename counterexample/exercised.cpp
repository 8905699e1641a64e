// SPDX-License-Identifier: Apache-2.0
// Searches the states of a process and records the elements that cause its steps.
#include "counterexample/exercised.hpp"

#include <deque>
#include <tuple>
#include <utility>

namespace robochart::runs {
namespace {

using process::TermId;
using process::Transition;

class Search {
public:
    explicit Search(StepReader& reader) : reader_(reader) {}

    Exercised run(TermId process, std::uint64_t most, diagnostics::Pollable& budget);

private:
    void meet_term(TermId term) {
        if (seen_.insert(term).second) waiting_.push_back(term);
    }
    void note_step(TermId term, const Transition& step);
    void note_step(const ComponentStep& step);

    StepReader& reader_;
    Exercised result_;
    std::set<TermId> seen_;
    std::deque<TermId> waiting_;
    /// The steps of components that have been seen. A component performs the same step in many states of the whole
    /// process.
    std::set<std::tuple<TermId, process::Event, TermId>> noted_;
};

void Search::note_step(const ComponentStep& step) {
    const std::set<std::string> elements = reader_.elements_of(step);
    if (elements.size() == 1) result_.certain.insert(*elements.begin());
    result_.possible.insert(elements.begin(), elements.end());
}

void Search::note_step(TermId term, const Transition& step) {
    for (const process::Move& move : reader_.context().session.split_transition(term, step)) {
        const process::Event event = move.step.event == process::tau ? move.step.revealed : move.step.event;
        if (noted_.insert({move.part, event, move.step.target}).second) note_step(reader_.component_step(move));
    }
}

Exercised Search::run(TermId process, std::uint64_t most, diagnostics::Pollable& budget) {
    for (meet_term(process); !waiting_.empty(); waiting_.pop_front()) {
        if (result_.states == most) {
            result_.all = false;
            break;
        }
        ++result_.states;
        budget.poll();
        const TermId term = waiting_.front();
        for (const Transition& step : reader_.context().session.transitions(term)) {
            note_step(term, step);
            meet_term(step.target);
        }
    }
    return std::move(result_);
}

}  // namespace

Exercised find_exercised(StepReader& reader, TermId process, std::uint64_t most, diagnostics::Pollable& budget) {
    return Search(reader).run(process, most, budget);
}

}  // namespace robochart::runs
