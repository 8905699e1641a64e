// See properties.hpp. A shortest history begins with the occurrences of the property, at one instant; every other one
// fulfils a duty that is open, or ends it: leaving the others out breaks no rule, since they only open duties. The
// history goes on for ever if it comes to a state in which silence keeps what is open, or to a part of the graph in
// which seconds pass again and again and every duty without limit is fulfilled or ended.
#include "sleec/analysis/properties.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "checker/lts/strong_components.hpp"
#include "sleec/obligations/open.hpp"
#include "sleec/obligations/samples.hpp"

namespace robochart::sleec {
namespace {

using lts::StateIndex;

constexpr std::size_t most_states = 200'000;

/// A duty that is open: of which rule, what it is (a number), how far it has come.
struct OpenDuty {
    std::size_t rule = 0, obligation = 0;
    Progress progress;

    friend auto operator<=>(const OpenDuty&, const OpenDuty&) = default;
};

struct State {
    bool awaited = true;  ///< the property's event is still to come
    bool during = false;  ///< so is that of `while`
    std::optional<OpenDuty> to_break;
    std::vector<OpenDuty> open;

    friend auto operator<=>(const State&, const State&) = default;
};

struct Step {
    StateIndex target = 0;
    std::optional<Happening> happening;  ///< nothing: a second
};

/// A property as rules that open a duty at its occurrences: that of `exists` asks for nothing, but its samples show
/// whether the condition is true.
CheckedRules with_property(const CheckedRules& rules, const CheckedProperty& property) {
    CheckedRules result = rules;
    Duty nothing;
    nothing.forbids = true;
    nothing.event = rules.file->events.size();
    nothing.to = 0;
    const DutyPtr asked = property.duty ? property.duty : std::make_shared<const Duty>(nothing);
    result.rules.push_back({property.trigger, property.condition, asked, false, nullptr});
    if (property.during)
        result.rules.push_back(
            {*property.during, property.during_condition, std::make_shared<const Duty>(nothing), false, nullptr});
    return result;
}

/// What becomes of the property's duty in the histories that are looked for.
enum class Fate { kept, broken };

class Histories {
public:
    Histories(const CheckedRules& rules, const CheckedProperty& property, Fate fate, const AnalysisOptions& options)
        : rules_(with_property(rules, property)),
          property_(property),
          fate_(fate),
          options_(options),
          first_(rules.rules.size()) {
        reach();
    }

    PropertyAnswer search() {
        explore();
        PropertyAnswer answer;
        answer.states = states_.size();
        const auto end = quiet_ ? quiet_ : endless_state();
        if (!end) return answer;
        answer.possible = Answer::yes;
        for (StateIndex at = *end; at != 0; at = from_[at].first)
            if (from_[at].second) answer.history.push_back(*from_[at].second);
        std::reverse(answer.history.begin(), answer.history.end());
        return answer;
    }

private:
    /// The events that can matter, with the ways in which the measures may be at each.
    void reach() {
        std::vector<std::size_t> waiting{property_.trigger};
        if (property_.during) waiting.push_back(*property_.during);
        while (!waiting.empty()) {
            const std::size_t event = waiting.back();
            waiting.pop_back();
            if (samples_.contains(event)) continue;
            std::vector<std::size_t> triggered;
            for (std::size_t i = 0; i < rules_.rules.size(); ++i)
                if (rules_.rules[i].trigger == event) triggered.push_back(i);
            const auto& found = samples_[event] = all_samples(triggered, event);
            triggered_[event] = triggered;
            for (const Sample& sample : found)
                for (const auto& obligation : sample.obligations) {
                    if (!obligation) continue;
                    if (obligation->any.size() > most_demands)
                        throw NotDecided("a rule has too many responses behind each other");
                    for (const Demand& each : obligation->any)
                        if (!each.forbids || fate_ == Fate::broken) waiting.push_back(each.event);
                    waiting.insert(waiting.end(), obligation->ended_by.begin(), obligation->ended_by.end());
                }
        }
    }

    std::vector<Sample> all_samples(const std::vector<std::size_t>& triggered, std::size_t event) const {
        if (!triggered.empty()) return samples(rules_, triggered, event, options_.without_limit, options_.budget);
        return {{Valuation(rules_.file->measures.size(), 0), {}}};
    }

    std::size_t number_of(const Obligation& obligation) {
        const auto found = std::find(obligations_.begin(), obligations_.end(), obligation);
        if (found != obligations_.end()) return static_cast<std::size_t>(found - obligations_.begin());
        obligations_.push_back(obligation);
        return obligations_.size() - 1;
    }

    void explore() {
        State start;
        start.during = property_.during.has_value();
        add(start, 0, std::nullopt);
        for (StateIndex at = 0; at < states_.size() && !quiet_; ++at) {
            if (options_.budget != nullptr) options_.budget->poll();
            if (states_.size() > most_states) throw NotDecided(fmt::format("more than {} states", most_states));
            const State state = states_[at];
            for (const auto& [event, found] : samples_)
                if (useful(state, event))
                    for (const Sample& sample : found) occur(at, state, event, sample);
            if (!state.awaited && !state.during) second(at, state);
        }
    }

    /// An occurrence that the property waits for, or that may fulfil or end a duty, or break that of the property.
    [[nodiscard]] bool useful(const State& state, std::size_t event) const {
        if ((state.awaited && event == property_.trigger) || (state.during && event == *property_.during)) return true;
        if (state.to_break) {
            Progress progress = state.to_break->progress;
            const Effect effect = take_event(obligations_[state.to_break->obligation], progress, event);
            if (effect == Effect::broken || progress != state.to_break->progress) return true;
        }
        return std::any_of(state.open.begin(), state.open.end(), [&](const OpenDuty& each) {
            Progress progress = each.progress;
            return take_event(obligations_[each.obligation], progress, event) == Effect::fulfilled;
        });
    }

    /// With all ways in which the property may take part.
    void occur(StateIndex at, const State& state, std::size_t event, const Sample& sample) {
        State next = state;
        next.open.clear();
        for (OpenDuty each : state.open) {
            const Effect effect = take_event(obligations_[each.obligation], each.progress, event);
            if (effect == Effect::broken) return;
            if (effect == Effect::open) next.open.push_back(each);
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
            std::sort(then.open.begin(), then.open.end());
            then.open.erase(std::unique(then.open.begin(), then.open.end()), then.open.end());
            add(then, at, Happening{0, event, sample.values, part || during});
        };
        if (takes_part) follow(true, false);
        if (also_during) follow(false, true);
        follow(false, false);
    }

    /// What the trigger itself does to the duty that it opens. As LEGOS reads rules, its own instant counts.
    Effect begin(OpenDuty& opened, std::size_t event) const {
        if (options_.without_limit != WithoutLimit::now) return Effect::open;
        return take_event(obligations_[opened.obligation], opened.progress, event);
    }

    /// The property's duty is opened. False where its fate is decided against what is looked for.
    bool take_part(State& state, OpenDuty own, std::size_t event) const {
        const Effect effect = begin(own, event);
        if (effect != Effect::open) return effect == (fate_ == Fate::kept ? Effect::fulfilled : Effect::broken);
        if (fate_ == Fate::kept)
            state.open.push_back(own);
        else
            state.to_break = own;
        return true;
    }

    /// What happens to the duty that is to be broken. False where it is fulfilled.
    template <class Happens>
    bool break_on(State& state, const Happens& happens) const {
        if (!state.to_break) return true;
        const Effect effect = happens(obligations_[state.to_break->obligation], state.to_break->progress);
        if (effect == Effect::broken) state.to_break.reset();
        return effect != Effect::fulfilled;
    }

    /// Nothing of the property is still to come: a duty that is to be broken is, or it has no limit and is not
    /// fulfilled if nothing comes.
    [[nodiscard]] bool has_come(const State& state) const {
        return !state.awaited && !state.during && (!state.to_break || without_limit(*state.to_break));
    }

    void second(StateIndex at, const State& state) {
        State next = state;
        next.open.clear();
        if (!break_on(next, take_tock)) return;
        for (OpenDuty each : state.open) {
            const Effect effect = take_tock(obligations_[each.obligation], each.progress);
            if (effect == Effect::broken) return;
            if (effect == Effect::open) next.open.push_back(each);
        }
        std::sort(next.open.begin(), next.open.end());
        next.open.erase(std::unique(next.open.begin(), next.open.end()), next.open.end());
        add(next, at, std::nullopt);
    }

    /// Counts seconds along the way by which a state was found first.
    void add(const State& state, StateIndex before, std::optional<Happening> happening) {
        const auto [known, fresh] = numbers_.emplace(state, static_cast<StateIndex>(states_.size()));
        if (fresh) {
            const bool start = states_.empty();
            states_.push_back(state);
            seconds_.push_back(start ? 0 : seconds_[before] + (happening ? 0 : 1));
            if (happening) happening->second = seconds_[before];
            from_.emplace_back(before, happening);
            steps_.emplace_back();
            if (!quiet_ && is_quiet(state)) quiet_ = known->second;
            if (start) return;
        }
        steps_[before].push_back({known->second, std::move(happening)});
    }

    /// Nothing more need come: of every duty that is open a prohibition can still hold.
    [[nodiscard]] bool is_quiet(const State& state) const {
        return has_come(state) && std::all_of(state.open.begin(), state.open.end(), [&](const OpenDuty& duty) {
                   const Obligation& obligation = obligations_[duty.obligation];
                   for (std::size_t i = 0; i < obligation.any.size(); ++i)
                       if (obligation.any[i].forbids && (duty.progress.broken >> i & 1U) == 0) return true;
                   return false;
               });
    }

    /// A state from which seconds can pass without end, every duty without limit being fulfilled now and then.
    std::optional<StateIndex> endless_state() {
        const lts::GraphView view{states_.size(), [&](StateIndex state, std::vector<StateIndex>& targets) {
                                      for (const Step& each : steps_[state]) targets.push_back(each.target);
                                  }};
        const std::vector<StateIndex> roots{0};
        std::optional<StateIndex> found;
        lts::strong_components(view, roots, [&](std::span<const StateIndex> members, bool) {
            const StateIndex least = *std::min_element(members.begin(), members.end());
            if ((!found || least < *found) && passes(members)) found = least;
        });
        return found;
    }

    /// Whether a run through all of these states and all steps between them, again and again, is one: seconds pass, and
    /// no duty stays open for ever. One does iff each of the steps leaves it as it is: then no run in here ends it.
    /// Another step may open the same duty anew where it ends one: it is in every state then, and yet fulfilled.
    [[nodiscard]] bool passes(std::span<const StateIndex> members) const {
        if (!has_come(states_[members.front()])) return false;
        const std::set<StateIndex> inside(members.begin(), members.end());
        bool time = false;
        std::vector<OpenDuty> left;  // that no step yet has ended or changed
        for (const OpenDuty& each : states_[members.front()].open)
            if (without_limit(each)) left.push_back(each);
        for (const StateIndex state : members)
            for (const Step& step : steps_[state]) {
                if (!inside.contains(step.target)) continue;
                time = time || !step.happening;
                std::erase_if(left, [&](const OpenDuty& each) { return !leaves(step, each); });
            }
        return time && left.empty();
    }

    /// Whether the duty is behind the step what it is before it.
    [[nodiscard]] bool leaves(const Step& step, const OpenDuty& duty) const {
        const Obligation& obligation = obligations_[duty.obligation];
        Progress progress = duty.progress;
        const Effect effect =
            step.happening ? take_event(obligation, progress, step.happening->event) : take_tock(obligation, progress);
        return effect == Effect::open && progress == duty.progress;
    }

    /// Only a demand without limit is left of it.
    [[nodiscard]] bool without_limit(const OpenDuty& duty) const {
        const Obligation& obligation = obligations_[duty.obligation];
        for (std::size_t i = 0; i < obligation.any.size(); ++i) {
            const Demand& each = obligation.any[i];
            if (each.forbids && (duty.progress.broken >> i & 1U) == 0) return false;
        }
        return std::any_of(obligation.any.begin(), obligation.any.end(),
                           [](const Demand& each) { return !each.forbids && each.end == forever; });
    }

    CheckedRules rules_;  ///< with the property behind them
    const CheckedProperty& property_;
    Fate fate_;
    const AnalysisOptions& options_;
    std::size_t first_;  ///< the property's place
    std::map<std::size_t, std::vector<Sample>> samples_;
    std::map<std::size_t, std::vector<std::size_t>> triggered_;  ///< what the samples are of
    std::vector<Obligation> obligations_;
    std::map<State, StateIndex> numbers_;
    std::vector<State> states_;
    std::vector<std::int64_t> seconds_;
    std::vector<std::pair<StateIndex, std::optional<Happening>>> from_;
    std::vector<std::vector<Step>> steps_;
    std::optional<StateIndex> quiet_;  ///< the first state found that is
};

PropertyAnswer search(const CheckedRules& rules, const CheckedProperty& property, Fate fate,
                      const AnalysisOptions& options) {
    try {
        return Histories(rules, property, fate, options).search();
    } catch (const NotDecided& error) {
        return {Answer::not_decided, {}, error.what(), 0};
    }
}

/// The rules without one of them.
CheckedRules without(const CheckedRules& rules, std::size_t rule) {
    CheckedRules result = rules;
    result.rules.erase(result.rules.begin() + static_cast<std::ptrdiff_t>(rule));
    return result;
}

}  // namespace

PropertyAnswer possible(const CheckedRules& rules, const CheckedProperty& property, const AnalysisOptions& options) {
    return search(rules, property, Fate::kept, options);
}

Implication implied(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options) {
    const CheckedRule& asked = rules.rules[rule];
    CheckedProperty broken;
    broken.trigger = asked.trigger;
    broken.condition = asked.condition;
    broken.duty = asked.duty;
    CheckedProperty comes = broken;
    comes.duty = nullptr;
    comes.exists = true;

    Implication result;
    CheckedRules others = without(rules, rule);
    const PropertyAnswer breaks = search(others, broken, Fate::broken, options);
    const PropertyAnswer triggered = possible(others, comes, options);
    if (breaks.possible == Answer::not_decided || triggered.possible == Answer::not_decided) {
        result.implied = Answer::not_decided;
        result.reason = breaks.reason.empty() ? triggered.reason : breaks.reason;
        return result;
    }
    if (breaks.possible == Answer::yes || triggered.possible == Answer::no) return result;
    result.implied = Answer::yes;
    std::vector<std::size_t> left;  // of each of the others its number in the file
    for (std::size_t i = 0; i < rules.rules.size(); ++i)
        if (i != rule) left.push_back(i);
    for (std::size_t i = left.size(); i-- > 0;) {
        CheckedRules fewer = without(others, i);
        if (search(fewer, broken, Fate::broken, options).possible != Answer::no) continue;
        others = std::move(fewer);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    }
    result.by = std::move(left);
    return result;
}

std::vector<std::size_t> excluding(const CheckedRules& rules, const CheckedProperty& property,
                                   const AnalysisOptions& options) {
    std::vector<std::size_t> needed;
    for (std::size_t i = 0; i < rules.rules.size(); ++i) needed.push_back(i);
    for (std::size_t i = 0; i < rules.rules.size(); ++i) {
        CheckedRules fewer = rules;
        fewer.rules.clear();
        for (const std::size_t each : needed)
            if (each != i) fewer.rules.push_back(rules.rules[each]);
        if (possible(fewer, property, options).possible == Answer::no) std::erase(needed, i);
    }
    return needed;
}

}  // namespace robochart::sleec
