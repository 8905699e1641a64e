// SPDX-License-Identifier: Apache-2.0
#include "checker/refine/verdict/unfolding.hpp"

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "checker/refine/search/steps.hpp"

namespace robochart::refine {
namespace {

using State = std::vector<lts::Word>;

/// A run of the system in parallel with a run of its reduced form. At each moment the state of the system is the image,
/// under the current automorphism, of a state that the reduced form visits or passes through.
class Unfolding {
public:
    Unfolding(lts::TransitionSystem& system, const Reduction& reduction)
        : system_(system), reduction_(reduction), shown_(initial_of(system)), run_{shown_, {}} {
        arrive(shown_);
        settle();
        arrive(representative(shown_));
    }

    void follow(const Run& shown) {
        for (const RunStep& step : shown.steps) {
            const RunStep behind = step_behind(step);
            go_to(behind.state, behind.event);
            settle();
            arrive(step.state);
        }
    }
    /// Returns the run and starts another one at its end.
    Run take() {
        Run result = std::move(run_);
        run_ = {result.last(), {}};
        return result;
    }
    /// Repeats the run, each time with its next image, until it returns to its first state.
    void close() {
        const State first = run_.initial;
        const std::size_t length = run_.steps.size();
        if (reduction_.symmetry == nullptr || run_.last() == first) return;
        const lts::Symmetry::Permutation turn = reduction_.symmetry->between(first, run_.last());
        while (run_.last() != first) {
            const RunStep& before = run_.steps[run_.steps.size() - length];
            State next = before.state;
            reduction_.symmetry->apply(turn, next);
            run_.steps.push_back(step_to(next, before.event));
        }
    }

private:
    [[nodiscard]] std::vector<State> chased(const State& state) const {
        return reduction_.taus == nullptr ? std::vector<State>{} : reduction_.taus->chase(state);
    }
    [[nodiscard]] State representative(State state) const {
        if (reduction_.symmetry != nullptr) reduction_.symmetry->fold(state);
        return state;
    }
    [[nodiscard]] lts::Event orbit(lts::Event event) const {
        return reduction_.symmetry == nullptr ? event : reduction_.symmetry->orbit(event);
    }

    /// Returns the step of the system from the current state that the reduced form shows as this step.
    [[nodiscard]] RunStep step_behind(const RunStep& shown) const {
        for (RunStep& step : steps_from(system_, shown_)) {
            if (step.event != shown.event || step.revealed != shown.revealed) continue;
            const std::vector<State> row = chased(step.state);
            if (representative(row.empty() ? step.state : row.back()) == shown.state) return std::move(step);
        }
        throw std::logic_error("a step of the reduced system cannot be taken");
    }

    /// Returns the step of the system from the end of the run.
    [[nodiscard]] RunStep step_to(const State& target, lts::Event event) const {
        for (RunStep& step : steps_from(system_, run_.last()))
            if (step.state == target && orbit(step.event) == orbit(event)) return std::move(step);
        throw std::logic_error("the image of a transition is none");
    }

    void go_to(const State& next, lts::Event event) {
        State image = next;
        if (reduction_.symmetry != nullptr) reduction_.symmetry->apply(permutation_, image);
        run_.steps.push_back(step_to(image, event));
        shown_ = next;
    }

    /// Follows confluent taus.
    void settle() {
        for (const State& next : chased(shown_)) go_to(next, process::tau);
    }

    /// Sets the state of the reduced form. The current state of the run is an image of it.
    void arrive(State state) {
        shown_ = std::move(state);
        if (reduction_.symmetry != nullptr) permutation_ = reduction_.symmetry->between(shown_, run_.last());
    }

    lts::TransitionSystem& system_;
    Reduction reduction_;
    State shown_;
    Run run_;
    lts::Symmetry::Permutation permutation_;
};

}  // namespace

Violation unfolded(lts::TransitionSystem& system, const Reduction& reduction, const Violation& shown) {
    Violation result = shown;
    Unfolding unfolding(system, reduction);
    unfolding.follow(shown.run);
    result.run = unfolding.take();
    if (shown.loop.steps.empty()) return result;
    unfolding.follow(shown.loop);
    unfolding.close();
    result.loop = unfolding.take();
    return result;
}

}  // namespace robochart::refine
