// SPDX-License-Identifier: Apache-2.0
// See decision_process.hpp.
#include "prism/assertions/process/decision_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "prism/assertions/experiments/encoding.hpp"
#include "prism/explore/real.hpp"

namespace robochart::probability {
namespace {

using csp_emit::EventMeaning;
using csp_emit::MeaningKind;

using Distribution = std::vector<std::pair<lts::StateIndex, Rational>>;

/// The properties of a step that do not depend on its states.
struct Kind {
    const EventMeaning* meaning = nullptr;  ///< the meaning of the event or of the hidden event
    bool tock = false;
    bool waits = false;  ///< true for an input: the platform decides whether it occurs
};

/// A choice of a state.
struct Choice {
    std::uint32_t action = 0;
    bool tock = false;
    bool waits = false;
    Distribution branches;
    friend bool operator==(const Choice&, const Choice&) = default;
};

/// Returns the states in which only time can pass. They are the largest set of states that have only tock steps into
/// the set.
markov::StateSet deadlocked_states(const Exploration& explored, const std::function<bool(const Step&)>& tock,
                                   diagnostics::Pollable& budget) {
    markov::StateSet result(explored.size(), true);
    std::vector<std::vector<lts::StateIndex>> before(explored.size());
    std::vector<lts::StateIndex> work;
    for (lts::StateIndex state = 0; state < explored.size(); ++state) {
        budget.poll();
        bool only = true;
        for (const Step& step : explored.steps_from(state)) {
            only = only && tock(step);
            before[step.target].push_back(state);
        }
        if (only) continue;
        result[state] = false;
        work.push_back(state);
    }
    while (!work.empty()) {
        const lts::StateIndex state = work.back();
        work.pop_back();
        for (const lts::StateIndex predecessor : before[state]) {
            if (!result[predecessor]) continue;
            result[predecessor] = false;
            work.push_back(predecessor);
        }
    }
    return result;
}

class Builder {
public:
    Builder(const Exploration& explored, StateReader& reader, const Sources& sources, Scheduler scheduler,
            diagnostics::Pollable& budget)
        : explored_(explored),
          reader_(reader),
          sources_(sources),
          scheduler_(scheduler),
          budget_(budget),
          weights_(sources.system, sources.instantiation),
          number_(explored.size(), none) {
        markov::Model& model = result_.model;
        model.kind = markov::Kind::mdp;
        model.first_choice = {0};
        model.first_branch = {0};
        model.actions = {"", tock_action, "loop"};
        result_.happening = {0};
    }

    DecisionProcess operator()() {
        const auto tock = [&](const Step& step) { return kind_of_step(step).tock; };
        const markov::StateSet dead = deadlocked_states(explored_, tock, budget_);
        number_state(0);
        result_.model.initial = {0};
        // Scheduler::uniform adds intermediate states, one for each choice, while the loop runs.
        for (markov::State state = 0; state < result_.origins.size(); ++state) {
            budget_.poll();
            const auto only = single_.find(state);
            const std::vector<Choice> choices =
                only != single_.end() ? std::vector{only->second} : this->choices_in(result_.origins[state]);
            if (choices.size() > 1 && scheduler_ == Scheduler::uniform)
                add_uniform_choice(state, choices);
            else
                for (const Choice& choice : choices) add_choice(choice);
            if (choices.empty()) push_loop(state);
            result_.model.first_choice.push_back(static_cast<std::uint32_t>(result_.model.choices()));
        }
        for (const lts::StateIndex origin : result_.origins) result_.deadlocks.push_back(dead[origin]);
        return std::move(result_);
    }

private:
    static constexpr markov::State none = ~markov::State{0};

    /// The observers' parities in a state.
    struct Parities {
        EventSet known = 0, odd = 0;
        bool read = false;
    };

    /// Returns the kind of a step, by its event or its hidden event.
    const Kind& kind_of_step(const Step& step) {
        const bool hidden = step.event == lts::tau;
        const auto [known, added] = kinds_.try_emplace({step.event, step.revealed});
        if (!added) return known->second;
        Kind& result = known->second;
        const std::string& name = sources_.events.name(hidden ? step.revealed : step.event);
        result.meaning = meaning_of(name);
        const bool named = result.meaning != nullptr && !hidden;
        result.tock = named && result.meaning->kind == MeaningKind::tock;
        result.waits =
            named &&
            (result.meaning->kind == MeaningKind::trigger || result.meaning->kind == MeaningKind::external_write ||
             result.meaning->kind == MeaningKind::event_read || result.meaning->kind == MeaningKind::variable_read);
        return result;
    }

    [[nodiscard]] const EventMeaning* meaning_of(const std::string& name) const {
        for (std::string prefix = name;; prefix.resize(prefix.rfind('.'))) {
            const auto found = sources_.provenance.events.find(prefix);
            if (found != sources_.provenance.events.end()) return &found->second;
            if (prefix.rfind('.') == std::string::npos) return nullptr;
        }
    }

    /// Returns the observers whose parity changes in the step. Before its first event, an observer is still its initial
    /// term and not a call of a known definition; its parity is then 0. A terminated observer has no parity.
    [[nodiscard]] EventSet changed_observers(lts::StateIndex from, lts::StateIndex to) {
        if (sources_.observed.empty()) return 0;
        const Parities before = parities_of(from);
        const Parities behind = parities_of(to);
        return behind.known & (before.odd ^ behind.odd);
    }

    [[nodiscard]] Parities parities_of(lts::StateIndex state) {
        if (parities_.empty()) parities_.resize(explored_.size());
        Parities& result = parities_[state];
        if (result.read) return result;
        result.read = true;
        const std::vector<std::size_t>& parts = reader_.parts_of_state(explored_.state(state));
        for (std::size_t i = 0; i < sources_.observed.size(); ++i)
            for (const std::size_t part : parts) {
                const auto held = reader_.part(part).find_variable(sources_.observed[i].name(), observed_parity);
                if (!held) continue;
                result.known |= EventSet{1} << i;
                if (held->text != "0") result.odd |= EventSet{1} << i;
            }
        return result;
    }

    [[nodiscard]] std::uint32_t action_number(EventSet events) {
        if (events == 0) return 0;
        const auto [known, added] =
            actions_.try_emplace(events, static_cast<std::uint32_t>(result_.model.actions.size()));
        if (added) {
            result_.model.actions.push_back(observed_action(events));
            result_.happening.push_back(events);
        }
        return known->second;
    }

    /// Returns the choices that the scheduler allows.
    std::vector<Choice> choices_in(lts::StateIndex state) {
        std::vector<Choice> result;
        std::map<std::pair<std::string, std::string>, std::vector<const Step*>> draws;  // by machine and junction
        for (const Step& step : explored_.steps_from(state)) {
            const Kind& what = kind_of_step(step);
            if (what.meaning != nullptr && what.meaning->draw) {
                draws[{what.meaning->component, what.meaning->draw->junction}].push_back(&step);
                continue;
            }
            const std::uint32_t action = what.tock ? 1 : this->action_number(changed_observers(state, step.target));
            Choice one{action, what.tock, what.waits, {{step.target, 1}}};
            if (std::ranges::find(result, one) == result.end()) result.push_back(std::move(one));
        }
        for (const auto& [junction, steps] : draws)
            result.push_back(probabilistic_choice(state, junction.first, steps));
        if (scheduler_ != Scheduler::urgent) return result;
        const auto free = [](const Choice& choice) { return !choice.tock && !choice.waits; };
        if (std::ranges::any_of(result, free))
            std::erase_if(result, [&](const Choice& choice) { return !free(choice); });
        return result;
    }

    /// Returns the probabilistic choice at a junction.
    Choice probabilistic_choice(lts::StateIndex state, const std::string& component,
                                const std::vector<const Step*>& ways) {
        const auto seat = std::ranges::find_if(sources_.seats,
                                               [&](const Seat& candidate) { return candidate.component == component; });
        if (seat == sources_.seats.end()) throw Wrong(fmt::format("no machine is known at {}", component));
        const std::vector<std::size_t> parts = reader_.parts_of_state(explored_.state(state));
        const ValueOf value_of = [&](const std::string& name) {
            for (const std::size_t part : parts)
                if (const auto held = reader_.part(part).find_variable(component, name))
                    if (const auto number = number_of(sources_.system, sources_.instantiation, *held)) return *number;
            throw NotExpressed(fmt::format(
                "a probability at {} reads {}, which the process does not hold there: nothing else reads it", component,
                name));
        };
        Choice result;
        Rational sum;
        std::set<std::uint32_t> counted;
        for (const Step* way : ways) {
            const csp_emit::Draw& draw = *kind_of_step(*way).meaning->draw;
            if (counted.contains(draw.transition.index)) continue;
            for (const std::uint32_t branch : equivalent_branches(sources_.system, draw)) counted.insert(branch);
            const Rational weight = weights_.branch_probability(draw, *seat, value_of);
            sum += weight;
            if (weight == 0) continue;
            const auto same =
                std::ranges::find_if(result.branches, [&](const auto& branch) { return branch.first == way->target; });
            if (same != result.branches.end())
                same->second += weight;
            else
                result.branches.emplace_back(way->target, weight);
        }
        if (sum != 1)
            throw Wrong(fmt::format("the probabilities at {} sum to {}",
                                    kind_of_step(*ways.front()).meaning->draw->junction, sum.str()));
        std::ranges::sort(result.branches);
        return result;
    }

    markov::State number_state(lts::StateIndex origin) {
        if (number_[origin] == none) {
            number_[origin] = static_cast<markov::State>(result_.origins.size());
            result_.origins.push_back(origin);
        }
        return number_[origin];
    }

    std::uint32_t number_value(const Rational& value) {
        const auto [known, added] =
            numbers_.try_emplace(value, static_cast<std::uint32_t>(result_.model.numbers.size()));
        if (added) {
            const markov::Enclosure bounds = prism::enclose(value);
            result_.model.numbers.push_back({bounds.low, bounds.high});
            result_.model.exact.push_back(value);
        }
        return known->second;
    }

    void add_choice(const Choice& choice) {
        std::vector<std::pair<markov::State, std::uint32_t>> branches;
        for (const auto& [target, weight] : choice.branches)
            branches.emplace_back(number_state(target), number_value(weight));
        finish_choice(choice.action, choice.tock, std::move(branches));
    }

    void push_loop(markov::State state) { finish_choice(2, false, {{state, number_value(1)}}); }

    /// Adds one step, which takes no time. It leads to an intermediate state for each choice, with equal probabilities.
    void add_uniform_choice(markov::State state, const std::vector<Choice>& choices) {
        std::vector<std::pair<markov::State, std::uint32_t>> branches;
        const std::uint32_t share = number_value(Rational(1) / choices.size());
        for (const Choice& choice : choices) {
            const auto between = static_cast<markov::State>(result_.origins.size());
            result_.origins.push_back(result_.origins[state]);
            single_.emplace(between, choice);
            branches.emplace_back(between, share);
        }
        finish_choice(2, false, std::move(branches));
    }

    void finish_choice(std::uint32_t action, bool tock, std::vector<std::pair<markov::State, std::uint32_t>> branches) {
        markov::Model& model = result_.model;
        std::ranges::sort(branches);
        for (const auto& [target, number] : branches) {
            model.target.push_back(target);
            model.number.push_back(number);
        }
        model.first_branch.push_back(model.target.size());
        model.action.push_back(action);
        model.counted.push_back(tock);
    }

    const Exploration& explored_;
    StateReader& reader_;
    const Sources& sources_;
    Scheduler scheduler_;
    diagnostics::Pollable& budget_;
    Weights weights_;
    DecisionProcess result_;
    std::vector<markov::State> number_;  ///< the number of each state of the exploration
    std::map<std::pair<lts::Event, lts::Event>, Kind> kinds_;
    std::map<Rational, std::uint32_t> numbers_;
    std::vector<Parities> parities_;  ///< the parities in each state of the exploration; empty: not needed
    std::map<EventSet, std::uint32_t> actions_;
    std::map<markov::State, Choice> single_;  ///< states with a single choice, which has been added
};

}  // namespace

std::string observed_action(EventSet events) {
    return events == 0 ? "" : fmt::format("events {}", events);
}

DecisionProcess decision_process(const Exploration& explored, StateReader& reader, const Sources& sources,
                                 Scheduler scheduler, diagnostics::Pollable& budget) {
    return Builder(explored, reader, sources, scheduler, budget)();
}

}  // namespace robochart::probability
