// SPDX-License-Identifier: Apache-2.0
// Explores all states of one process, within the limits of the run.
#include "driver/claims/state_space.hpp"

#include "checker/refine/search/poll_guard.hpp"

namespace robochart::driver {

lts::Graph explore_graph(lts::TransitionSystem& system, const refine::Limits& limits, std::size_t& known) {
    refine::Budget budget(limits);
    known = 0;
    budget.report_by([&known](refine::Progress& progress) { progress.states = known; });
    const refine::PollGuard guard({&system}, budget);
    lts::Exploration all = lts::explore(system, [&](std::size_t states) {
        known = states;
        budget.states(states);
        budget.charge();
    });
    return std::move(all.graph);
}

}  // namespace robochart::driver
