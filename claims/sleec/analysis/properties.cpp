// SPDX-License-Identifier: Apache-2.0
// See properties.hpp. A shortest history begins with the occurrences of the property, at one instant. Every other
// occurrence fulfils or ends an open duty. Further occurrences can be omitted, because they would only open duties, and
// without them no rule is broken. The history can continue forever in two cases: it reaches a state in which all open
// duties are satisfied if no further event occurs, or it reaches a part of the graph in which seconds pass repeatedly
// and every duty without limit is fulfilled or ended.
#include "claims/sleec/analysis/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "base/diagnostics/containers.hpp"
#include "checker/lts/strong_components.hpp"
#include "claims/sleec/obligations/open.hpp"
#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {
namespace {

using lts::StateIndex;

constexpr std::size_t most_states = 200'000;

/// An open duty: its rule, its obligation (by number), and its progress.
struct OpenDuty {
    std::size_t rule = 0, obligation = 0;
    Progress progress;

    friend auto operator<=>(const OpenDuty&, const OpenDuty&) = default;
};

struct State {
    bool awaited = true;  ///< true if the property's event has not occurred yet
    bool during = false;  ///< true if the event of `while` has not occurred yet
    std::optional<OpenDuty> to_break;
    std::vector<OpenDuty> open;

    friend auto operator<=>(const State&, const State&) = default;
};

struct Step {
    StateIndex target = 0;
    std::optional<Happening> happening;  ///< no value: the end of a second
};

/// Returns the rules with the property as additional rules, which open a duty at its occurrences. The rule for `exists`
/// makes no demand, but its samples show whether the condition is true.
CheckedRules with_property(const CheckedRules& rules, const CheckedProperty& property) {
    CheckedRules result = rules;
    Duty nothing;
    nothing.forbids = true;
    nothing.event = rules.events.size();
    nothing.to = 0;
    const DutyPtr duty = property.duty ? property.duty : std::make_shared<const Duty>(nothing);
    result.rules.push_back({property.trigger, property.condition, duty, false, nullptr});
    if (property.during)
        result.rules.push_back(
            {*property.during, property.during_condition, std::make_shared<const Duty>(nothing), false, nullptr});
    return result;
}

/// The outcome of the property's duty in the histories that are searched for.
enum class Fate { kept, broken };

class Histories {
public:
    Histories(const CheckedRules& rules, const CheckedProperty& property, Fate fate, const AnalysisOptions& options)
        : rules_(with_property(rules, property)),
          property_(property),
          fate_(fate),
          options_(options),
          first_(rules.rules.size()) {
        collect_events();
    }

    PropertyAnswer find_history() {
        explore_states();
        PropertyAnswer answer;
        answer.states = states_.size();
        const auto end = quiet_ ? quiet_ : endless_state();
        if (!end) return answer;
        answer.possible = Answer::yes;
        for (StateIndex at = *end; at != 0; at = from_[at].first)
            if (from_[at].second) answer.history.push_back(*from_[at].second);
        std::ranges::reverse(answer.history);
        return answer;
    }

private:
    /// Collects the relevant events, each with the possible values of the measures.
    void collect_events() {
        std::vector<std::size_t> waiting(property_.trigger.begin(), property_.trigger.end());
        if (property_.during) waiting.insert(waiting.end(), property_.during->begin(), property_.during->end());
        while (!waiting.empty()) {
            const std::size_t event = waiting.back();
            waiting.pop_back();
            if (samples_.contains(event)) continue;
            std::vector<std::size_t> triggered;
            for (std::size_t i = 0; i < rules_.rules.size(); ++i)
                if (rules_.rules[i].trigger.contains(event)) triggered.push_back(i);
            const auto& found = samples_[event] = all_samples(triggered, event);
            triggered_[event] = triggered;
            for (const Sample& sample : found)
                for (const auto& obligation : sample.obligations) {
                    if (!obligation) continue;
                    if (obligation->any.size() > most_demands)
                        throw NotDecided("a rule has too many responses behind each other");
                    for (const Demand& demand : obligation->any)
                        if (!demand.forbids || fate_ == Fate::broken)
                            waiting.insert(waiting.end(), demand.event.begin(), demand.event.end());
                    waiting.insert(waiting.end(), obligation->ended_by.begin(), obligation->ended_by.end());
                }
        }
    }

    std::vector<Sample> all_samples(const std::vector<std::size_t>& triggered, std::size_t event) const {
        if (!triggered.empty()) return find_samples(rules_, triggered, event, options_.without_limit, options_.budget);
        return {{Valuation(rules_.measures.size(), 0), {}}};
    }

    std::size_t number_of(const Obligation& obligation) {
        const auto found = std::ranges::find(obligations_, obligation);
        if (found != obligations_.end()) return static_cast<std::size_t>(found - obligations_.begin());
        obligations_.push_back(obligation);
        return obligations_.size() - 1;
    }

    void explore_states() {
        State start;
        start.during = property_.during.has_value();
        add(start, 0, std::nullopt);
        for (StateIndex at = 0; at < states_.size() && !quiet_; ++at) {
            if (options_.budget != nullptr) options_.budget->poll();
            if (states_.size() > most_states) throw NotDecided(fmt::format("more than {} states", most_states));
            const State state = states_[at];
            for (const auto& [event, found] : samples_)
                if (is_useful(state, event))
                    for (const Sample& sample : found) add_occurrences(at, state, event, sample);
            if (!state.awaited && !state.during) add_second(at, state);
        }
    }

    /// True for an occurrence that the property waits for, that may fulfil or end a duty, or that may break the duty of
    /// the property.
    [[nodiscard]] bool is_useful(const State& state, std::size_t event) const {
        if ((state.awaited && property_.trigger.contains(event)) || (state.during && property_.during->contains(event)))
            return true;
        if (state.to_break) {
            Progress progress = state.to_break->progress;
            const Effect effect = take_event(obligations_[state.to_break->obligation], progress, event);
            if (effect == Effect::broken || progress != state.to_break->progress) return true;
        }
        return std::ranges::any_of(state.open, [&](const OpenDuty& duty) {
            Progress progress = duty.progress;
            return take_event(obligations_[duty.obligation], progress, event) == Effect::fulfilled;
        });
    }

    /// Adds the successors for an occurrence, with all ways in which the property may take part.
    void add_occurrences(StateIndex at, const State& state, std::size_t event, const Sample& sample) {
        State next = state;
        next.open.clear();
        for (OpenDuty duty : state.open) {
            const Effect effect = take_event(obligations_[duty.obligation], duty.progress, event);
            if (effect == Effect::broken) return;
            if (effect == Effect::open) next.open.push_back(duty);
        }
        const auto by_event = [&](const Obligation& obligation, Progress& progress) {
            return take_event(obligation, progress, event);
        };
        if (!break_on(next, by_event)) return;
        const std::vector<std::size_t>& triggered = triggered_[event];
        std::optional<OpenDuty> own;
        bool takes_part = false, also_during = false;
        for (std::size_t i = 0; i < triggered.size(); ++i) {
            if (!sample.obligations[i]) continue;
            OpenDuty opened{triggered[i], number_of(*sample.obligations[i]), {}};
            if (triggered[i] < first_) {
                const Effect effect = begin(opened, event);
                if (effect == Effect::broken) return;
                if (effect == Effect::open) next.open.push_back(opened);
            } else if (triggered[i] == first_) {
                takes_part = state.awaited;
                own = opened;
            } else {
                also_during = state.during;
            }
        }
        const auto follow = [&](bool part, bool during) {
            State then = next;
            if (part) then.awaited = false;
            if (part && property_.duty && !take_part(then, *own, event)) return;
            if (during) then.during = false;
            diagnostics::sort_unique(then.open);
            add(then, at, Happening{0, event, sample.values, part || during});
        };
        if (takes_part) follow(true, false);
        if (also_during) follow(false, true);
        follow(false, false);
    }

    /// Returns the effect of the trigger on the duty that it opens. In LEGOS, the instant of the trigger belongs to the
    /// window of the duty.
    Effect begin(OpenDuty& opened, std::size_t event) const {
        if (options_.without_limit != WithoutLimit::now) return Effect::open;
        return take_event(obligations_[opened.obligation], opened.progress, event);
    }

    /// Opens the property's duty. Returns false if its outcome is already decided and is not the required one.
    bool take_part(State& state, OpenDuty own, std::size_t event) const {
        const Effect effect = begin(own, event);
        if (effect != Effect::open) return effect == (fate_ == Fate::kept ? Effect::fulfilled : Effect::broken);
        if (fate_ == Fate::kept)
            state.open.push_back(own);
        else
            state.to_break = own;
        return true;
    }

    /// Updates the duty that must be broken. Returns false if it is fulfilled.
    template <class Happens>
    bool break_on(State& state, const Happens& happens) const {
        if (!state.to_break) return true;
        const Effect effect = happens(obligations_[state.to_break->obligation], state.to_break->progress);
        if (effect == Effect::broken) state.to_break.reset();
        return effect != Effect::fulfilled;
    }

    /// True if the property needs no further event. A duty that must be broken is broken already, or it has no limit
    /// and stays unfulfilled if no further event occurs.
    [[nodiscard]] bool is_property_met(const State& state) const {
        return !state.awaited && !state.during && (!state.to_break || without_limit(*state.to_break));
    }

    void add_second(StateIndex at, const State& state) {
        State next = state;
        next.open.clear();
        if (!break_on(next, take_tock)) return;
        for (OpenDuty duty : state.open) {
            const Effect effect = take_tock(obligations_[duty.obligation], duty.progress);
            if (effect == Effect::broken) return;
            if (effect == Effect::open) next.open.push_back(duty);
        }
        diagnostics::sort_unique(next.open);
        add(next, at, std::nullopt);
    }

    /// Adds a step. Seconds are counted along the path by which a state was found first.
    void add(const State& state, StateIndex before, std::optional<Happening> happening) {
        const auto [known, fresh] = numbers_.emplace(state, static_cast<StateIndex>(states_.size()));
        if (fresh) {
            const bool start = states_.empty();
            states_.push_back(state);
            const std::int64_t passed = happening ? 0 : 1;
            seconds_.push_back(start ? 0 : seconds_[before] + passed);
            if (happening) happening->second = seconds_[before];
            from_.emplace_back(before, happening);
            steps_.emplace_back();
            if (!quiet_ && is_quiet(state)) quiet_ = known->second;
            if (start) return;
        }
        steps_[before].push_back({known->second, std::move(happening)});
    }

    /// True if no further event is needed, because every open duty has a prohibition that is not broken yet. The duty
    /// is then fulfilled if no further event occurs.
    [[nodiscard]] bool is_quiet(const State& state) const {
        return is_property_met(state) && std::ranges::all_of(state.open, [&](const OpenDuty& duty) {
                   const Obligation& obligation = obligations_[duty.obligation];
                   for (std::size_t i = 0; i < obligation.any.size(); ++i)
                       if (obligation.any[i].forbids && (duty.progress.broken >> i & 1U) == 0) return true;
                   return false;
               });
    }

    /// Returns a state from which seconds can pass forever while every duty without limit is fulfilled repeatedly; no
    /// value if there is none.
    std::optional<StateIndex> endless_state() {
        const lts::GraphView view{states_.size(), [&](StateIndex state, std::vector<StateIndex>& targets) {
                                      for (const Step& step : steps_[state]) targets.push_back(step.target);
                                  }};
        const std::vector<StateIndex> roots{0};
        std::optional<StateIndex> found;
        lts::strong_components(view, roots, [&](std::span<const StateIndex> members, bool) {
            const StateIndex least = *std::ranges::min_element(members);
            if ((!found || least < *found) && is_valid_loop(members)) found = least;
        });
        return found;
    }

    /// True if a run that repeats all steps between these states forever is valid: seconds pass, and no duty stays open
    /// forever. A duty stays open forever iff every step leaves it unchanged, because then no run in this part ends it.
    /// A step may also end a duty and open the same duty again. Then the duty is in every state, although it is
    /// fulfilled.
    [[nodiscard]] bool is_valid_loop(std::span<const StateIndex> members) const {
        if (!is_property_met(states_[members.front()])) return false;
        const std::set<StateIndex> inside(members.begin(), members.end());
        bool time = false;
        std::vector<OpenDuty> left;  // duties that no step so far has ended or changed
        for (const OpenDuty& duty : states_[members.front()].open)
            if (without_limit(duty)) left.push_back(duty);
        for (const StateIndex state : members)
            for (const Step& step : steps_[state]) {
                if (!inside.contains(step.target)) continue;
                time = time || !step.happening;
                std::erase_if(left, [&](const OpenDuty& duty) { return !leaves_unchanged(step, duty); });
            }
        return time && left.empty();
    }

    /// True if the step does not change the duty.
    [[nodiscard]] bool leaves_unchanged(const Step& step, const OpenDuty& duty) const {
        const Obligation& obligation = obligations_[duty.obligation];
        Progress progress = duty.progress;
        const Effect effect =
            step.happening ? take_event(obligation, progress, step.happening->event) : take_tock(obligation, progress);
        return effect == Effect::open && progress == duty.progress;
    }

    /// True if the remaining part of the duty is only a demand without limit.
    [[nodiscard]] bool without_limit(const OpenDuty& duty) const {
        const Obligation& obligation = obligations_[duty.obligation];
        for (std::size_t i = 0; i < obligation.any.size(); ++i) {
            const Demand& demand = obligation.any[i];
            if (demand.forbids && (duty.progress.broken >> i & 1U) == 0) return false;
        }
        return std::ranges::any_of(obligation.any,
                                   [](const Demand& demand) { return !demand.forbids && demand.end == forever; });
    }

    CheckedRules rules_;  ///< followed by the property
    const CheckedProperty& property_;
    Fate fate_;
    const AnalysisOptions& options_;
    std::size_t first_;  ///< index of the property
    std::map<std::size_t, std::vector<Sample>> samples_;
    std::map<std::size_t, std::vector<std::size_t>> triggered_;  ///< the rules that the samples are about
    std::vector<Obligation> obligations_;
    std::map<State, StateIndex> numbers_;
    std::vector<State> states_;
    std::vector<std::int64_t> seconds_;
    std::vector<std::pair<StateIndex, std::optional<Happening>>> from_;
    std::vector<std::vector<Step>> steps_;
    std::optional<StateIndex> quiet_;  ///< the first quiet state found
};

PropertyAnswer search_histories(const CheckedRules& rules, const CheckedProperty& property, Fate fate,
                                const AnalysisOptions& options) {
    try {
        return Histories(rules, property, fate, options).find_history();
    } catch (const NotDecided& error) {
        return {Answer::not_decided, {}, error.what(), 0};
    }
}

/// Returns the rules without the given one.
CheckedRules without_rule(const CheckedRules& rules, std::size_t rule) {
    CheckedRules result = rules;
    result.rules.erase(result.rules.begin() + static_cast<std::ptrdiff_t>(rule));
    return result;
}

}  // namespace

PropertyAnswer check_possible(const CheckedRules& rules, const CheckedProperty& property,
                              const AnalysisOptions& options) {
    return search_histories(rules, property, Fate::kept, options);
}

Implication check_implied(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options) {
    const CheckedRule& subject = rules.rules[rule];
    CheckedProperty broken;
    broken.trigger = subject.trigger;
    broken.condition = subject.condition;
    broken.duty = subject.duty;
    CheckedProperty comes = broken;
    comes.duty = nullptr;
    comes.exists = true;

    Implication result;
    CheckedRules others = without_rule(rules, rule);
    const PropertyAnswer breaks = search_histories(others, broken, Fate::broken, options);
    const PropertyAnswer triggered = check_possible(others, comes, options);
    if (breaks.possible == Answer::not_decided || triggered.possible == Answer::not_decided) {
        result.implied = Answer::not_decided;
        result.reason = breaks.reason.empty() ? triggered.reason : breaks.reason;
        return result;
    }
    if (breaks.possible == Answer::yes || triggered.possible == Answer::no) return result;
    result.implied = Answer::yes;
    std::vector<std::size_t> left;  // for each remaining rule, its number in the file
    for (std::size_t i = 0; i < rules.rules.size(); ++i)
        if (i != rule) left.push_back(i);
    for (std::size_t i = left.size(); i-- > 0;) {
        CheckedRules fewer = without_rule(others, i);
        if (search_histories(fewer, broken, Fate::broken, options).possible != Answer::no) continue;
        others = std::move(fewer);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    result.by = std::move(left);
    return result;
}

std::vector<std::size_t> excluding_rules(const CheckedRules& rules, const CheckedProperty& property,
                                         const AnalysisOptions& options) {
    std::vector<std::size_t> needed;
    for (std::size_t i = 0; i < rules.rules.size(); ++i) needed.push_back(i);
    for (std::size_t i = 0; i < rules.rules.size(); ++i) {
        CheckedRules fewer = rules;
        fewer.rules.clear();
        for (const std::size_t other : needed)
            if (other != i) fewer.rules.push_back(rules.rules[other]);
        if (check_possible(fewer, property, options).possible == Answer::no) std::erase(needed, i);
    }
    return needed;
}

}  // namespace robochart::sleec
