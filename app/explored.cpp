// See explored.hpp.
#include "app/explored.hpp"

#include "checker/refine/watch.hpp"

namespace robochart::app {

lts::Graph explored(lts::TransitionSystem& system, const refine::Limits& limits, std::size_t& known) {
    refine::Budget budget(limits);
    known = 0;
    budget.report_by([&known](refine::Progress& progress) { progress.states = known; });
    const refine::Watch watch({&system}, budget);
    lts::Exploration all = lts::explore(system, [&](std::size_t states) {
        known = states;
        budget.states(states);
        budget.charge();
    });
    return std::move(all.graph);
}

}  // namespace robochart::app
