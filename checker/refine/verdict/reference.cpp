// SPDX-License-Identifier: Apache-2.0
// Searches for the run in the reference, breadth first, in four stages. The first stage matches the actions and the
// hidden events of taus exactly. The second does the same with the run as it was before the components were minimised.
// The third matches only the actions, which suffices for strongly bisimilar components. The fourth matches only the
// trace, because compressed components may perform other taus.
#include "checker/refine/verdict/reference.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "checker/refine/search/poll_guard.hpp"
#include "checker/refine/search/steps.hpp"
#include "checker/refine/verdict/unfolding.hpp"

namespace robochart::refine {
namespace {

using process::Event;
using State = std::vector<lts::Word>;

/// The time limit for the search in the reference. Reaching it does not affect the verdict.
constexpr std::chrono::seconds longest_replay{20};
/// After the reference has reached its limit: the time for finding the names of hidden events.
constexpr std::chrono::seconds longest_naming{2};

struct Moves {
    std::vector<RunStep> list;
    Offer offer;
};

Moves moves_of(lts::TransitionSystem& system, const State& state, Budget& budget) {
    Moves moves{steps_from(system, state, budget), {}};
    moves.offer = offer_of(moves.list);
    return moves;
}

/// One action of a run. `revealed` has no value if it may be any hidden event.
struct Action {
    Event event;
    std::optional<Event> revealed = std::nullopt;
    [[nodiscard]] bool matches_step(const RunStep& step) const {
        return step.event == event && (!revealed || step.revealed == *revealed);
    }
};

/// Searches for paths through a system. The nodes are states, each with an index into a sequence of actions.
class Paths {
public:
    Paths(lts::TransitionSystem& system, Budget& budget) : system_(system), budget_(budget) {}

    /// Returns the shortest run from `from` along the actions to a state that `ends` accepts. With `free_taus`, the
    /// actions contain no taus, and taus are allowed anywhere.
    std::optional<Run> find(const State& from, const std::vector<Action>& actions, bool free_taus,
                            const std::function<bool(const State&, const Moves&)>& ends) {
        nodes_.clear();
        known_.clear();
        add_node({0, from, 0, {}});
        for (std::size_t at = 0; at < nodes_.size(); ++at) {
            const std::size_t place = nodes_[at].place;
            const Moves moves = moves_of(system_, nodes_[at].state, budget_);
            if (place == actions.size() && ends(nodes_[at].state, moves)) return run_to(at);
            for (const RunStep& step : moves.list) {
                if (place < actions.size() && actions[place].matches_step(step))
                    add_node({place + 1, step.state, at, step});
                if (free_taus && step.event == process::tau) add_node({place, step.state, at, step});
            }
        }
        return std::nullopt;
    }

private:
    struct Node {
        std::size_t place;
        State state;
        std::size_t from;
        RunStep step;
    };

    void add_node(Node node) {
        if (known_.emplace(std::pair(node.place, node.state), nodes_.size()).second) nodes_.push_back(std::move(node));
    }
    Run run_to(std::size_t at) const {
        Run run;
        for (; at != 0; at = nodes_[at].from) run.steps.push_back(nodes_[at].step);
        std::ranges::reverse(run.steps);
        run.initial = nodes_.front().state;
        return run;
    }

    lts::TransitionSystem& system_;
    Budget& budget_;
    std::vector<Node> nodes_;
    std::map<std::pair<std::size_t, State>, std::size_t> known_;
};

std::vector<Action> actions_of(const Run& run) {
    std::vector<Action> actions;
    for (const RunStep& step : run.steps) actions.push_back({step.event});
    return actions;
}

/// Adds the names of hidden events. Without them, all taus would be equal, so a long sequence of taus would match runs
/// to most of the states.
std::vector<Action> revealed_actions_of(const Run& run) {
    std::vector<Action> actions;
    for (const RunStep& step : run.steps) actions.push_back({step.event, step.revealed});
    return actions;
}

std::vector<Action> trace_of(const Run& run) {
    std::vector<Action> actions;
    for (const Event event : run.trace()) actions.push_back({event});
    return actions;
}

void append(Run& run, const Run& more) {
    run.steps.insert(run.steps.end(), more.steps.begin(), more.steps.end());
}

/// A sequence of taus that leads into a loop of taus.
struct Lasso {
    Run stem;
    Run loop;
};

/// Repeats the actions and hidden events of the loop until a round begins in the same state as an earlier round. A
/// state of a machine represents several terms, so one round of the loop may correspond to several rounds of terms.
std::optional<Lasso> rounds_of(lts::TransitionSystem& system, const State& state, const Run& loop, Budget& budget) {
    constexpr std::size_t most_rounds = 100;
    const std::vector<Action> actions = revealed_actions_of(loop);
    Paths paths(system, budget);
    std::vector<Run> rounds;
    for (State at = state; rounds.size() < most_rounds; at = rounds.back().last_state()) {
        const auto begins_here = [&](const Run& round) { return round.initial == at; };
        const auto first = std::ranges::find_if(rounds, begins_here);
        if (first != rounds.end()) {
            Lasso lasso{{state, {}}, {at, {}}};
            for (auto round = rounds.begin(); round != rounds.end(); ++round)
                append(round < first ? lasso.stem : lasso.loop, *round);
            return lasso;
        }
        auto round = paths.find(at, actions, false, [](const State&, const Moves&) { return true; });
        if (!round) return std::nullopt;
        rounds.push_back(std::move(*round));
    }
    return std::nullopt;
}

/// Returns a loop of taus from the state, with the hidden events of `like` if they are known.
std::optional<Lasso> tau_loop(lts::TransitionSystem& system, const State& state, const Run& like, Budget& budget) {
    if (!like.steps.empty())
        if (auto found = rounds_of(system, state, like, budget)) return found;
    Paths paths(system, budget);
    for (const RunStep& first : moves_of(system, state, budget).list) {
        if (first.event != process::tau) continue;
        const std::optional<Run> rest =
            paths.find(first.state, {}, true, [&](const State& at, const Moves&) { return at == state; });
        if (!rest) continue;
        Lasso lasso{{state, {}}, {state, {first}}};
        append(lasso.loop, *rest);
        return lasso;
    }
    return std::nullopt;
}

/// Returns a predicate that is true for states of the reference with the same fault as the last state of the violation.
std::function<bool(const State&, const Moves&)> as_bad_as(lts::TransitionSystem& system,
                                                          lts::TransitionSystem& reference, const Violation& violation,
                                                          Budget& budget) {
    switch (violation.kind) {
        case ViolationKind::refusal: {
            const auto accepted = acceptance(moves_of(system, violation.run.last_state(), budget).offer);
            return [accepted](const State&, const Moves& moves) {
                const auto own = acceptance(moves.offer);
                return own && accepted && std::ranges::includes(*accepted, *own);
            };
        }
        case ViolationKind::deadlock:
            return [](const State&, const Moves& moves) { return moves.list.empty(); };
        case ViolationKind::divergence:
            return [&](const State& state, const Moves& moves) {
                return moves.offer.tau && tau_loop(reference, state, violation.loop, budget).has_value();
            };
        case ViolationKind::nondeterminism:
            return [event = violation.event](const State&, const Moves& moves) {
                const auto own = acceptance(moves.offer);
                return own && event && !std::ranges::binary_search(*own, *event);
            };
        case ViolationKind::trace:
        case ViolationKind::no_return:
        case ViolationKind::no_trace:
            break;
    }
    return [](const State&, const Moves&) { return true; };
}

Limits until(Limits limits, std::chrono::steady_clock::time_point end) {
    limits.deadline = end;
    return limits;
}

Limits share_of(const Limits& limits) {
    const auto end = std::chrono::steady_clock::now() + longest_replay;
    return until(limits, limits.deadline ? std::min(*limits.deadline, end) : end);
}

/// Searches the reference for a violation that was found in the system.
class Comparison {
public:
    Comparison(lts::TransitionSystem& system, lts::TransitionSystem& reference, const Violation& violation,
               Budget& budget)
        : reference_(reference),
          violation_(violation),
          budget_(budget),
          ends_(as_bad_as(system, reference, violation, budget)),
          paths_(reference, budget) {}

    /// Matches the actions and the hidden events of taus.
    std::optional<Violation> with_names() { return found(find(revealed_actions_of(violation_.run), false)); }
    /// Matches the actions; if this fails, matches only the trace.
    std::optional<Violation> without_names() {
        std::optional<Run> run = find(actions_of(violation_.run), false);
        if (!run) run = find(trace_of(violation_.run), true);
        return found(std::move(run));
    }

private:
    std::optional<Run> find(const std::vector<Action>& actions, bool free_taus) {
        return paths_.find(initial_of(reference_), actions, free_taus, ends_);
    }
    std::optional<Violation> found(std::optional<Run> run) {
        if (!run) return std::nullopt;
        Violation again{violation_.kind, std::move(*run), {}, violation_.event, violation_.shortest};
        if (violation_.kind == ViolationKind::divergence) {
            Lasso lasso = tau_loop(reference_, again.run.last_state(), violation_.loop, budget_).value();
            append(again.run, lasso.stem);
            again.loop = std::move(lasso.loop);
        }
        return again;
    }

    lts::TransitionSystem& reference_;
    const Violation& violation_;
    Budget& budget_;
    std::function<bool(const State&, const Moves&)> ends_;
    Paths paths_;
};

/// The violation in the system before minimisation, where hidden steps have the names from before the minimisation.
/// Both members are null if there is no such system, or if the run was not found in it.
struct FinerForm {
    std::shared_ptr<lts::FinerSystem> system;
    std::optional<Violation> violation;
};

FinerForm finer_form(lts::TransitionSystem& system, const Violation& violation, Budget& budget) {
    FinerForm form{system.make_finer_system(budget), std::nullopt};
    if (form.system) form.violation = refine_violation(*form.system, violation, budget);
    if (!form.violation) form.system = nullptr;
    return form;
}

/// Finds the violation in the reference. The names of hidden events in minimised components may be wrong, and a search
/// that ignores the names may find another run. So such a search is only made after a search with corrected names.
Violation found_in_reference(lts::TransitionSystem& system, lts::TransitionSystem& reference,
                             const Violation& violation, FinerForm& finer, Budget& budget) {
    Comparison comparison(system, reference, violation, budget);
    std::optional<Violation> again = comparison.with_names();
    if (!again) finer = finer_form(system, violation, budget);
    if (!again && finer.violation) again = Comparison(*finer.system, reference, *finer.violation, budget).with_names();
    if (!again) again = comparison.without_names();
    if (!again) throw std::logic_error("a counterexample failed its replay: the terms have no such run");
    return std::move(*again);
}

/// Returns the violation that is reported if the search in the reference takes too long.
Confirmed confirmed_by_system(lts::TransitionSystem& system, const Violation& violation, FinerForm finer,
                              const Limits& limits, const Judge& judge) {
    Budget own(limits);
    try {
        if (!finer.system) finer = finer_form(system, violation, own);
        if (!finer.system) return {violation, &system};
        judge(*finer.system, *finer.violation, own);
        lts::TransitionSystem* const shown = finer.system.get();
        return {std::move(*finer.violation), shown, false, std::move(finer.system)};
    } catch (const process::Interrupted&) {
        if (limits.interrupted && limits.interrupted()) throw;
        return {violation, &system};
    }
}

}  // namespace

Violation found_again(lts::TransitionSystem& system, lts::TransitionSystem& reference, const Violation& violation,
                      Budget& budget) {
    FinerForm finer;
    return found_in_reference(system, reference, violation, finer, budget);
}

Confirmed confirm_violation(lts::TransitionSystem& system, const Violation& violation, Budget& budget,
                            const Judge& judge) {
    judge(system, violation, budget);
    if (system.reference() == nullptr) return {violation, &system, system.states_are_terms()};
    lts::TransitionSystem& reference = *system.reference();
    const Limits share = share_of(budget.limits());
    Budget own(share);
    const PollGuard guard({&reference}, own);
    FinerForm finer;
    try {
        Violation again = found_in_reference(system, reference, violation, finer, own);
        judge(reference, again, own);
        return {std::move(again), &reference, true};
    } catch (const process::Interrupted&) {
        if (share.interrupted && share.interrupted()) throw;
    }
    return confirmed_by_system(system, violation, std::move(finer),
                               until(share, std::chrono::steady_clock::now() + longest_naming), judge);
}

}  // namespace robochart::refine
