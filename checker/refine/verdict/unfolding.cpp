// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/unfolding.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <stdexcept>

#include "checker/refine/search/steps.hpp"

namespace robochart::refine {
namespace {

using State = std::vector<lts::Word>;

/// Constructs a run of the system in parallel with a run of its reduced form. The state of the system is always the
/// image of a state that the reduced form visits or passes through, under the current automorphism.
class Unfolding {
public:
    Unfolding(lts::TransitionSystem& system, const Reduction& reduction)
        : system_(system), reduction_(reduction), shown_(initial_of(system)), run_{shown_, {}} {
        set_shown_state(shown_);
        follow_confluent_steps();
        set_shown_state(representative(shown_));
    }

    void follow_run(const Run& shown) {
        for (const RunStep& step : shown.steps) {
            const RunStep behind = step_behind(step);
            go_to(behind.state, behind.event);
            follow_confluent_steps();
            set_shown_state(step.state);
        }
    }
    /// Returns the run and begins another one at its end.
    Run take_run() {
        Run result = std::move(run_);
        run_ = {result.last_state(), {}};
        return result;
    }
    /// Repeats the run under its automorphism until it returns to its first state.
    void close_loop() {
        const State first = run_.initial;
        const std::size_t length = run_.steps.size();
        if (reduction_.symmetry == nullptr || run_.last_state() == first) return;
        const lts::Symmetry::Permutation turn = reduction_.symmetry->find_permutation(first, run_.last_state());
        while (run_.last_state() != first) {
            const RunStep& before = run_.steps[run_.steps.size() - length];
            State next = before.state;
            reduction_.symmetry->apply(turn, next);
            run_.steps.push_back(step_to(next, before.event));
        }
    }

private:
    [[nodiscard]] std::vector<State> followed_path(const State& state) const {
        return reduction_.steps == nullptr ? std::vector<State>{} : reduction_.steps->followed_path(state);
    }
    /// Returns true if the reduced form shows steps without their events.
    [[nodiscard]] bool has_no_events() const {
        return reduction_.steps != nullptr && reduction_.steps->followed() == lts::Followed::steps;
    }
    [[nodiscard]] State representative(State state) const {
        if (reduction_.symmetry != nullptr) reduction_.symmetry->replace_by_representative(state);
        return state;
    }
    [[nodiscard]] lts::Event orbit_of(lts::Event event) const {
        return reduction_.symmetry == nullptr ? event : reduction_.symmetry->orbit_representative(event);
    }

    /// Returns the step of the system that the reduced form shows as this step.
    [[nodiscard]] RunStep step_behind(const RunStep& shown) const {
        for (RunStep& step : steps_from(system_, shown_)) {
            const bool same_event = step.event == shown.event && step.revealed == shown.revealed;
            if (!same_event && !has_no_events()) continue;
            const std::vector<State> row = followed_path(step.state);
            if (representative(row.empty() ? step.state : row.back()) == shown.state) return std::move(step);
        }
        throw std::logic_error("a step of the reduced system cannot be taken");
    }

    /// Returns the step of the system from the end of the run to `target`. If `event` has no value, the step may have
    /// any event.
    [[nodiscard]] RunStep step_to(const State& target, std::optional<lts::Event> event) const {
        for (RunStep& step : steps_from(system_, run_.last_state()))
            if (step.state == target && (!event || orbit_of(step.event) == orbit_of(*event))) return std::move(step);
        throw std::logic_error("the image of a transition is none");
    }

    void go_to(const State& next, std::optional<lts::Event> event) {
        State image = next;
        if (reduction_.symmetry != nullptr) reduction_.symmetry->apply(permutation_, image);
        run_.steps.push_back(step_to(image, event));
        shown_ = next;
    }

    void follow_confluent_steps() {
        const auto event = has_no_events() ? std::nullopt : std::optional(process::tau);
        for (const State& next : followed_path(shown_)) go_to(next, event);
    }

    /// Sets the state of the reduced form. The current state of the run is an image of it.
    void set_shown_state(State state) {
        shown_ = std::move(state);
        if (reduction_.symmetry != nullptr)
            permutation_ = reduction_.symmetry->find_permutation(shown_, run_.last_state());
    }

    lts::TransitionSystem& system_;
    Reduction reduction_;
    State shown_;
    Run run_;
    lts::Symmetry::Permutation permutation_;
};

/// Constructs a run of the finer system along a run of the minimised system. After each step both systems are in
/// bisimilar states, so the finer system can take the next step. If it can take several steps, prefers the one with the
/// displayed name.
class FinerRun {
public:
    FinerRun(lts::FinerSystem& finer, Budget& budget)
        : finer_(finer), budget_(budget), run_{initial_of(finer), {}}, minimised_(finer.minimised_width()) {}

    /// Returns true if such a run exists.
    bool follow_run(const Run& shown) {
        return std::ranges::all_of(shown.steps, [&](const RunStep& step) { return follow_step(step); });
    }
    [[nodiscard]] bool is_at(const State& minimised) { return represents(run_.last_state(), minimised); }
    /// Returns the run and begins another one at its end.
    Run take_run() {
        Run result = std::move(run_);
        run_ = {result.last_state(), {}};
        return result;
    }

private:
    bool follow_step(const RunStep& shown) {
        std::vector<RunStep> steps = steps_from(finer_, run_.last_state(), budget_);
        std::erase_if(steps, [&](const RunStep& step) {
            return step.event != shown.event || !represents(step.state, shown.state);
        });
        if (steps.empty()) return false;
        const auto named = std::ranges::find(steps, shown.revealed, &RunStep::revealed);
        run_.steps.push_back(std::move(named == steps.end() ? steps.front() : *named));
        return true;
    }
    bool represents(const State& state, const State& minimised) {
        finer_.minimised_state(state, minimised_);
        return minimised_ == minimised;
    }

    lts::FinerSystem& finer_;
    Budget& budget_;
    Run run_;
    State minimised_;
};

/// Repeats the loop until a round begins in the first state of an earlier round. Adds the rounds before that earlier
/// round to `run`. A state of the minimised system represents several states, so the loop may close only after several
/// rounds.
std::optional<Run> finer_loop(FinerRun& finer, const Run& shown, Run& run) {
    std::vector<Run> rounds;
    for (;;) {
        if (!finer.follow_run(shown)) return std::nullopt;
        rounds.push_back(finer.take_run());
        const auto first = std::ranges::find(rounds, rounds.back().last_state(), &Run::initial);
        if (first == rounds.end()) continue;
        Run loop{first->initial, {}};
        for (auto round = rounds.begin(); round != rounds.end(); ++round)
            std::ranges::copy(round->steps, std::back_inserter(round < first ? run.steps : loop.steps));
        return loop;
    }
}

}  // namespace

std::optional<Violation> refine_violation(lts::FinerSystem& finer, const Violation& shown, Budget& budget) {
    FinerRun following(finer, budget);
    if (!following.is_at(shown.run.initial) || !following.follow_run(shown.run)) return std::nullopt;
    Violation result = shown;
    result.run = following.take_run();
    if (shown.loop.steps.empty()) return result;
    std::optional<Run> loop = finer_loop(following, shown.loop, result.run);
    if (!loop) return std::nullopt;
    result.loop = std::move(*loop);
    return result;
}

Violation unfold_violation(lts::TransitionSystem& system, const Reduction& reduction, const Violation& shown) {
    Violation result = shown;
    Unfolding unfolding(system, reduction);
    unfolding.follow_run(shown.run);
    result.run = unfolding.take_run();
    if (shown.loop.steps.empty()) return result;
    unfolding.follow_run(shown.loop);
    unfolding.close_loop();
    result.loop = unfolding.take_run();
    return result;
}

}  // namespace robochart::refine
