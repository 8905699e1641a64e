// SPDX-License-Identifier: Apache-2.0
// Describes the states of a run for readers, and the events that the last state offers.
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

void tell_accepting(const Confirmed& accepting, Counterexample& counterexample) {
    counterexample.accepting_initial = accepting.system->describe(accepting.violation.run.initial);
    counterexample.accepting = steps_of(*accepting.system, accepting.violation.run);
    if (accepting.system->states_are_terms()) counterexample.accepting_terms = terms_of(accepting.violation.run);
}

Counterexample make_counterexample(const Confirmed& confirmed) {
    lts::TransitionSystem& system = *confirmed.system;
    const Violation& violation = confirmed.violation;
    Counterexample result;
    result.kind = violation.kind;
    result.initial = system.describe(violation.run.initial);
    result.steps = steps_of(system, violation.run);
    result.loop = steps_of(system, violation.loop);
    result.event = violation.event;
    result.replayed_by_terms = confirmed.by_terms;
    result.shortest = violation.shortest;
    if (system.states_are_terms()) {
        result.terms = terms_of(violation.run);
        result.loop_terms = terms_of(violation.loop);
    }
    const bool stops = violation.kind == ViolationKind::refusal || violation.kind == ViolationKind::deadlock ||
                       violation.kind == ViolationKind::nondeterminism;
    if (stops) {
        const Offer offer = offer_of(steps_from(system, violation.run.last_state()));
        result.offered = acceptance(offer).value_or(offer.events);
    }
    return result;
}

}  // namespace robochart::refine
