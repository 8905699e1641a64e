// SPDX-License-Identifier: Apache-2.0
// Replays violations by the plain definitions: sets of whole states are closed under tau and advance event by event.
#include "checker/refine/verdict/replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>

#include "checker/refine/search/steps.hpp"

namespace robochart::refine {
namespace {

using lts::StateView;
using lts::Word;
using process::Event;
using process::EventSet;
using State = std::vector<Word>;

void require_claim(bool truth, const char* claim) {
    if (!truth) throw std::logic_error(fmt::format("a counterexample failed its replay: {}", claim));
}

void confirm_steps(lts::TransitionSystem& system, const Run& run, Budget& budget) {
    const State* from = &run.initial;
    for (const RunStep& step : run.steps) {
        const std::vector<RunStep> moves = steps_from(system, *from, budget);
        require_claim(std::ranges::any_of(moves,
                                          [&](const RunStep& move) {
                                              return move.event == step.event && move.revealed == step.revealed &&
                                                     move.state == step.state;
                                          }),
                      "a step of the run does not exist");
        from = &step.state;
    }
}

void confirm_run(lts::TransitionSystem& system, const Run& run, Budget& budget) {
    require_claim(run.initial == initial_of(system), "the run does not start in the initial state");
    confirm_steps(system, run, budget);
}

/// What one state can do: its taus and events.
struct Conduct {
    bool tau = false;
    std::set<Event> events;

    [[nodiscard]] bool is_stable() const { return !tau && !events.contains(process::tick); }
    /// Returns true if the state can refuse everything outside `accepted`. A stable state accepts everything that it
    /// offers. A state that can terminate accepts only tick.
    [[nodiscard]] bool can_settle_for(const EventSet& accepted) const {
        if (events.contains(process::tick)) return std::ranges::find(accepted, process::tick) != accepted.end();
        return is_stable() && std::ranges::all_of(events, [&](Event event) {
                   return std::ranges::find(accepted, event) != accepted.end();
               });
    }
    [[nodiscard]] bool can_refuse(Event event) const {
        return events.contains(process::tick) ? event != process::tick : is_stable() && !events.contains(event);
    }
};

Conduct conduct_of(lts::TransitionSystem& system, const State& state, Budget& budget) {
    Conduct conduct;
    for (const RunStep& move : steps_from(system, state, budget)) {
        if (move.event == process::tau)
            conduct.tau = true;
        else
            conduct.events.insert(move.event);
    }
    return conduct;
}

/// Contains all states in which a system can be after a trace. An external choice with taus is stored as the powersets
/// of its operands. P [] Q performs what P or Q performs, can settle for a set if both can, terminates if P or Q does,
/// and diverges if P or Q does. If taus of a choice's own operands lead to the choice, it is stored as a single state.
class Powerset {
public:
    /// Thrown if there are more states than the limit.
    struct TooLarge {};

    Powerset(lts::TransitionSystem& system, Budget& budget, std::size_t most = std::numeric_limits<std::size_t>::max())
        : system_(system), budget_(budget), most_(most) {
        add_closure({initial_of(system)});
    }

    void perform_event(Event event) {
        std::set<State> next;
        add_targets(event, next);
        states_.clear();
        choices_.clear();
        add_closure(next);
    }
    [[nodiscard]] bool has_no_states() const { return states_.empty() && choices_.empty(); }
    bool can_perform(Event event) {
        std::set<State> next;
        add_targets(event, next);
        return !next.empty();
    }
    bool can_settle_for(const EventSet& accepted) {
        EventSet visible = accepted;
        std::erase(visible, process::tick);
        const bool may_terminate = visible.size() < accepted.size() && can_perform(process::tick);
        return may_terminate || some_state(&Conduct::can_settle_for, accepted) ||
               std::ranges::any_of(choices_, [&](std::vector<Powerset>& operands) {
                   return std::ranges::all_of(operands,
                                              [&](Powerset& operand) { return operand.can_settle_for(visible); });
               });
    }
    bool diverges() {
        const auto some_operand = [](std::vector<Powerset>& operands) {
            return std::ranges::any_of(operands, [](Powerset& operand) { return operand.diverges(); });
        };
        return has_endless_taus() || std::ranges::any_of(choices_, some_operand);
    }

private:
    /// Creates the powerset of one operand of a choice. The last element of `open` is this choice.
    Powerset(lts::TransitionSystem& system, Budget& budget, std::size_t most, std::vector<State> open, State operand)
        : system_(system), budget_(budget), most_(most), open_(std::move(open)) {
        add_closure({std::move(operand)});
    }

    bool some_state(bool (Conduct::*can)(const EventSet&) const, const EventSet& events) {
        return std::ranges::any_of(
            states_, [&](const State& state) { return (conduct_of(system_, state, budget_).*can)(events); });
    }
    void add_targets(Event event, std::set<State>& targets) {
        for (const State& state : states_)
            for (RunStep& move : steps_from(system_, state, budget_))
                if (move.event == event) targets.insert(std::move(move.state));
        for (std::vector<Powerset>& operands : choices_)
            for (Powerset& operand : operands) operand.add_targets(event, targets);
    }
    /// Returns true if the states can perform taus forever. Removes states without a tau, and then states whose taus
    /// all lead to removed states. At the end, either no state remains, or every remaining state has a tau to a
    /// remaining state.
    bool has_endless_taus() {
        std::map<State, std::size_t> taus_left;
        std::map<State, std::vector<State>> sources;
        std::vector<State> finite;
        for (const State& state : states_) {
            std::set<State> targets;
            for (RunStep& move : steps_from(system_, state, budget_))
                if (move.event == process::tau && states_.contains(move.state)) targets.insert(std::move(move.state));
            for (const State& target : targets) sources[target].push_back(state);
            taus_left[state] = targets.size();
            if (targets.empty()) finite.push_back(state);
        }
        std::size_t removed = 0;
        for (; removed < finite.size(); ++removed) {
            const std::vector<State> before = sources[finite[removed]];
            for (const State& source : before)
                if (--taus_left[source] == 0) finite.push_back(source);
        }
        return removed < states_.size();
    }
    /// Adds these states and all states that taus reach from them.
    void add_closure(const std::set<State>& seeds) {
        std::set<State> known = seeds;
        std::vector<State> work(seeds.begin(), seeds.end());
        while (!work.empty()) {
            const State state = std::move(work.back());
            work.pop_back();
            if (known.size() > most_) throw TooLarge();
            const std::vector<RunStep> moves = steps_from(system_, state, budget_);
            if (splits_choice(state, moves)) continue;
            states_.insert(state);
            for (const RunStep& move : moves)
                if (move.event == process::tau && known.insert(move.state).second) work.push_back(move.state);
        }
    }
    bool splits_choice(const State& state, const std::vector<RunStep>& moves) {
        constexpr std::size_t most_open = 100;
        const auto is_tau = [](const RunStep& move) { return move.event == process::tau; };
        if (std::ranges::none_of(moves, is_tau) || open_.size() == most_open) return false;
        if (std::ranges::find(open_, state) != open_.end()) return false;
        const std::vector<State> operands = system_.choice_operands(state);
        if (operands.empty()) return false;
        std::vector<State> open = open_;
        open.push_back(state);
        std::vector<Powerset>& choice = choices_.emplace_back();
        for (const State& operand : operands) choice.push_back(Powerset(system_, budget_, most_, open, operand));
        return true;
    }

    lts::TransitionSystem& system_;
    Budget& budget_;
    std::size_t most_;
    std::set<State> states_;                      ///< closed under taus, except those to choices
    std::vector<std::vector<Powerset>> choices_;  ///< by choice: its operands
    std::vector<State> open_;                     ///< the choices that contain these states as operands
};

void confirm_loop(lts::TransitionSystem& system, const Violation& violation, Budget& budget) {
    const Run& loop = violation.loop;
    require_claim(
        !loop.steps.empty() && loop.initial == violation.run.last_state() && loop.last_state() == loop.initial,
        "the loop does not return to the end of the run");
    require_claim(loop.trace().empty(), "the loop performs an event");
    confirm_steps(system, loop, budget);
}

void confirm_refusal(lts::TransitionSystem& implementation, Powerset& specification, const Run& run, Budget& budget) {
    const Conduct conduct = conduct_of(implementation, run.last_state(), budget);
    const bool ticks = conduct.events.contains(process::tick);
    require_claim(ticks || conduct.is_stable(), "the state that refuses is not stable");
    const EventSet accepted = ticks ? EventSet{process::tick} : EventSet(conduct.events.begin(), conduct.events.end());
    require_claim(!specification.can_settle_for(accepted), "the specification refuses as much");
}

}  // namespace

void confirm_refinement_violation(lts::TransitionSystem& specification, lts::TransitionSystem& implementation,
                                  Model model, const Violation& violation, Budget& budget) {
    confirm_run(implementation, violation.run, budget);
    const bool with_divergence = model == Model::failures_divergences;
    std::vector<Event> trace = violation.run.trace();
    std::optional<Event> forbidden;
    if (violation.kind == ViolationKind::trace) {
        require_claim(!trace.empty(), "no event is forbidden");
        forbidden = trace.back();
        trace.pop_back();
    }
    Powerset allowed(specification, budget);
    require_claim(!with_divergence || !allowed.diverges(), "the specification diverges");
    for (Event event : trace) {
        allowed.perform_event(event);
        require_claim(!allowed.has_no_states(), "the trace is impossible before its last event");
        require_claim(!with_divergence || !allowed.diverges(), "the specification diverges");
    }
    switch (violation.kind) {
        case ViolationKind::trace:
            return require_claim(!allowed.can_perform(*forbidden), "the specification allows the event");
        case ViolationKind::refusal:
            require_claim(model != Model::traces, "refusals do not matter to traces");
            return confirm_refusal(implementation, allowed, violation.run, budget);
        case ViolationKind::divergence:
            require_claim(with_divergence, "divergence does not matter to this model");
            return confirm_loop(implementation, violation, budget);
        case ViolationKind::deadlock:
        case ViolationKind::nondeterminism:
        case ViolationKind::no_return:
        case ViolationKind::no_trace:
            require_claim(false, "a kind that refinement does not have");
    }
}

void confirm_property_violation(lts::TransitionSystem& system, const Violation& violation, Budget& budget) {
    confirm_run(system, violation.run, budget);
    if (violation.kind == ViolationKind::divergence) return confirm_loop(system, violation, budget);
    if (violation.kind == ViolationKind::deadlock)
        return require_claim(steps_from(system, violation.run.last_state(), budget).empty(),
                             "the state is not deadlocked");
    require_claim(violation.kind == ViolationKind::nondeterminism && violation.event,
                  "a kind that properties do not have");
    require_claim(conduct_of(system, violation.run.last_state(), budget).can_refuse(*violation.event),
                  "the event is not refused");
    Powerset states(system, budget);
    for (Event event : violation.run.trace()) states.perform_event(event);
    require_claim(states.can_perform(*violation.event), "the event is not accepted");
}

void confirm_missing_trace(lts::TransitionSystem& system, const std::vector<Event>& trace, const Run& run,
                           Budget& budget) {
    confirm_run(system, run, budget);
    const std::vector<Event> prefix = run.trace();
    require_claim(prefix.size() < trace.size() && std::equal(prefix.begin(), prefix.end(), trace.begin()),
                  "the run is not a beginning of the trace");
    // One run does not show that no other run performs the next event, so all runs are followed. If there are too many,
    // the result of the search is not confirmed, as for a refinement that holds.
    constexpr std::size_t most_states = 2'000;
    try {
        Powerset states(system, budget, most_states);
        for (Event event : prefix) states.perform_event(event);
        require_claim(!states.can_perform(trace[prefix.size()]), "the trace goes on");
    } catch (const Powerset::TooLarge&) {
    }
}

void confirm_trace(lts::TransitionSystem& system, const std::vector<Event>& trace, const Run& run, Budget& budget) {
    confirm_run(system, run, budget);
    require_claim(run.trace() == trace, "the run performs another trace");
}

}  // namespace robochart::refine
