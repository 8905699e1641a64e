#include "checker/refine/verdict/reduction.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <stdexcept>

#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/search/steps.hpp"

namespace robochart::refine {
namespace {

using State = std::vector<lts::Word>;

/// A step of the whole system to this state by a tau.
RunStep tau_to(lts::TransitionSystem& system, const State& from, const State& to) {
    for (RunStep& step : steps_from(system, from))
        if (step.event == process::tau && step.state == to) return std::move(step);
    throw std::logic_error("a followed tau cannot be taken");
}

void chase(lts::TransitionSystem& system, lts::ReducedSystem& reduced, Run& run) {
    for (const State& next : reduced.chase(run.last())) run.steps.push_back(tau_to(system, State(run.last()), next));
}

/// A step of the whole system that the reduced one shows as this step.
RunStep step_behind(lts::TransitionSystem& system, lts::ReducedSystem& reduced, const State& from,
                    const RunStep& shown) {
    for (RunStep& step : steps_from(system, from)) {
        if (step.event != shown.event || step.revealed != shown.revealed) continue;
        const std::vector<State> row = reduced.chase(step.state);
        if ((row.empty() ? step.state : row.back()) == shown.state) return std::move(step);
    }
    throw std::logic_error("a step of the reduced system cannot be taken");
}

void append(lts::TransitionSystem& system, lts::ReducedSystem& reduced, const Run& shown, Run& run) {
    for (const RunStep& step : shown.steps) {
        run.steps.push_back(step_behind(system, reduced, State(run.last()), step));
        chase(system, reduced, run);
    }
}

/// The limits of the search for a shortest run, so that time is left to report what is known.
Limits leaving_time(Limits limits) {
    const auto now = std::chrono::steady_clock::now();
    if (limits.deadline) *limits.deadline = now + (std::max(*limits.deadline, now) - now) / 2;
    return limits;
}

Violation shortest(lts::TransitionSystem& system, Violation known, Budget& budget, const ViolationSearch& search) {
    const Limits limits = leaving_time(budget.limits());
    Budget own(limits);
    Statistics ignored;
    try {
        if (std::optional<Violation> found = search(system, own, ignored, &known)) return std::move(*found);
    } catch (const process::Interrupted&) {
        if (limits.interrupted && limits.interrupted()) throw;
        known.shortest = false;
        return known;
    } catch (const std::bad_alloc&) {
        known.shortest = false;
        return known;
    }
    throw std::logic_error("the whole system does not have the violation of its reduced form");
}

}  // namespace

std::uint64_t events_until(const Violation* known) {
    const bool bounded = known != nullptr && known->kind == ViolationKind::divergence;
    return bounded ? known->run.steps.size() : std::numeric_limits<std::uint64_t>::max();
}

Run run_of_whole(lts::TransitionSystem& system, lts::ReducedSystem& reduced, const Run& run) {
    Run result{initial_of(system), {}};
    chase(system, reduced, result);
    append(system, reduced, run, result);
    return result;
}

std::optional<Violation> search_reduced(lts::TransitionSystem& system, Budget& budget, Statistics& statistics,
                                        const ViolationSearch& search) {
    const auto reduced = budget.limits().reduction ? system.reduced([&budget] { budget.charge(); }) : nullptr;
    if (!reduced) return search(system, budget, statistics, nullptr);
    const PollGuard guard({reduced.get()}, budget);
    std::optional<Violation> violation = search(*reduced, budget, statistics, nullptr);
    const bool same = statistics.chased == 0 && reduced->chased() == 0;
    if (!violation || same) return violation;
    Violation known = *violation;
    known.run = run_of_whole(system, *reduced, violation->run);
    known.loop = {violation->loop.initial, {}};
    append(system, *reduced, violation->loop, known.loop);
    return shortest(system, std::move(known), budget, search);
}

}  // namespace robochart::refine
