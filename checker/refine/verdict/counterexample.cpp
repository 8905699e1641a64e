// States as people read them, and what the last one offers.
#include "checker/refine/verdict/counterexample.hpp"

#include "checker/refine/search/steps.hpp"

namespace robochart::refine {
namespace {

std::vector<Step> steps_of(lts::TransitionSystem& system, const Run& run) {
    std::vector<Step> steps;
    for (const RunStep& step : run.steps) steps.push_back({step.event, step.revealed, system.describe(step.state)});
    return steps;
}

std::vector<process::TermId> terms_of(const Run& run) {
    std::vector<process::TermId> terms;
    if (!run.initial.empty()) terms.push_back(process::TermId{run.initial.front()});
    for (const RunStep& step : run.steps) terms.push_back(process::TermId{step.state.front()});
    return terms;
}

}  // namespace

Counterexample tell(const Confirmed& confirmed) {
    lts::TransitionSystem& system = *confirmed.system;
    const Violation& violation = confirmed.violation;
    Counterexample told;
    told.kind = violation.kind;
    told.initial = system.describe(violation.run.initial);
    told.steps = steps_of(system, violation.run);
    told.loop = steps_of(system, violation.loop);
    told.event = violation.event;
    told.replayed_by_terms = confirmed.by_terms;
    if (system.states_are_terms()) {
        told.terms = terms_of(violation.run);
        told.loop_terms = terms_of(violation.loop);
    }
    const bool stops = violation.kind == ViolationKind::refusal || violation.kind == ViolationKind::deadlock ||
                       violation.kind == ViolationKind::nondeterminism;
    if (stops) told.offered = offer_of(steps_from(system, violation.run.last())).events;
    return told;
}

}  // namespace robochart::refine
