// SPDX-License-Identifier: Apache-2.0
#include "driver/rules/endless_counterexample.hpp"

#include <cstddef>
#include <utility>

#include "checker/refine/search/budget.hpp"
#include "checker/refine/verdict/counterexample.hpp"
#include "checker/refine/verdict/reference.hpp"

namespace robochart::driver {

std::optional<refine::Counterexample> endless_counterexample(lts::TransitionSystem& system,
                                                             const sleec::EndlessRun& run,
                                                             const refine::Limits& bounds) {
    if (system.reference() == nullptr || !system.reference()->states_are_terms()) return std::nullopt;
    refine::Violation violation{refine::ViolationKind::trace, {}, {}, std::nullopt, true};
    for (const auto* steps : {&run.steps, &run.loop})
        for (const sleec::EndlessStep& step : *steps) violation.run.steps.push_back({step.event, step.revealed, {}});
    refine::Budget budget(bounds);
    refine::Violation again = refine::found_again(system, *system.reference(), violation, budget);
    if (again.run.steps.size() != violation.run.steps.size()) return std::nullopt;
    refine::Counterexample drawn = refine::make_counterexample({std::move(again), system.reference(), true});
    const auto stem = static_cast<std::ptrdiff_t>(run.steps.size());
    drawn.loop.assign(drawn.steps.begin() + stem, drawn.steps.end());
    drawn.steps.resize(run.steps.size());
    drawn.loop_terms.assign(drawn.terms.begin() + stem, drawn.terms.end());
    drawn.terms.resize(run.steps.size() + 1);
    drawn.kind = refine::ViolationKind::divergence;
    return drawn;
}

}  // namespace robochart::driver
