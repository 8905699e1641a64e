// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/search/steps.hpp"

#include <algorithm>

namespace robochart::refine {
namespace {

class StepList final : public lts::SuccessorSink {
public:
    void add(process::Event event, lts::StateView target, process::Event revealed) override {
        steps.push_back({event, revealed, {target.begin(), target.end()}});
    }
    std::vector<RunStep> steps;
};

}  // namespace

std::vector<lts::Word> initial_of(lts::TransitionSystem& system) {
    std::vector<lts::Word> state(system.width());
    system.initial(state);
    return state;
}

std::vector<RunStep> steps_from(lts::TransitionSystem& system, lts::StateView state) {
    StepList list;
    system.successors(state, list);
    return std::move(list.steps);
}

std::vector<RunStep> steps_from(lts::TransitionSystem& system, lts::StateView state, Budget& budget) {
    budget.charge();
    return steps_from(system, state);
}

Offer offer_of(const std::vector<RunStep>& steps) {
    Offer offer;
    for (const RunStep& step : steps) {
        if (step.event == process::tau)
            offer.tau = true;
        else
            offer.events.push_back(step.event);
    }
    std::ranges::sort(offer.events);
    const auto end = std::unique(offer.events.begin(), offer.events.end());
    offer.branches = end != offer.events.end();
    offer.events.erase(end, offer.events.end());
    return offer;
}

}  // namespace robochart::refine
