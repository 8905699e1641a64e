// SPDX-License-Identifier: Apache-2.0
#include "tests/claims/sleec/random/naive_rules.hpp"

#include <algorithm>
#include <limits>
#include <map>

namespace robochart::sleec::testing {
namespace {

constexpr int endless = std::numeric_limits<int>::max();
constexpr std::size_t most_states = 6'000;
constexpr int events = 4;

/// An action with its window, relative to the trigger.
struct Part {
    bool negated = false;
    int event = 0, first = 0, last = 0;
    friend auto operator<=>(const Part&, const Part&) = default;
};
using Parts = std::vector<Part>;

/// A duty, which holds if at least one of the parts holds.
struct Duty {
    Parts parts;
    int age = 0;
    unsigned failed = 0;
    friend auto operator<=>(const Duty&, const Duty&) = default;
};

enum class Fate { open, kept, violated };

bool failed(const Duty& duty, std::size_t part) {
    return (duty.failed >> part & 1U) != 0;
}

Fate fate(const Duty& duty) {
    for (std::size_t i = 0; i < duty.parts.size(); ++i)
        if (!failed(duty, i)) return Fate::open;
    return Fate::violated;
}

Fate on_event(Duty& duty, int event) {
    for (std::size_t i = 0; i < duty.parts.size(); ++i) {
        const Part& part = duty.parts[i];
        if (part.event != event || duty.age < part.first || duty.age > part.last) continue;
        if (!part.negated) return Fate::kept;
        duty.failed |= 1U << i;
    }
    return fate(duty);
}

Fate on_second(Duty& duty) {
    int settled = 0;  // the age after which only events change the duty
    for (const Part& part : duty.parts) settled = std::max(settled, part.last == endless ? part.first : part.last + 1);
    ++duty.age;
    for (std::size_t i = 0; i < duty.parts.size(); ++i) {
        if (duty.parts[i].last >= duty.age || failed(duty, i)) continue;
        if (duty.parts[i].negated) return Fate::kept;
        duty.failed |= 1U << i;
    }
    duty.age = std::min(duty.age, settled);
    return fate(duty);
}

/// Returns the parts that the response requires with these values, or nullopt if there is no duty.
std::optional<Parts> required_parts(const NaiveResponse& response, unsigned values) {
    const NaiveResponse::Defeater* deciding = nullptr;
    for (const auto& defeater : response.defeaters)
        if (defeater.condition.holds(values)) deciding = &defeater;
    if (deciding != nullptr) return deciding->response ? required_parts(*deciding->response, values) : std::nullopt;
    Parts parts;
    int begin = 0;
    for (const NaiveAction& action : response.chain) {
        parts.push_back({action.negated, action.event, begin + action.from, action.to ? begin + *action.to : endless});
        if (!action.to) break;
        begin += *action.to;
    }
    return parts;
}

using State = std::set<Duty>;

/// Returns true if every remaining part requires an event that is forbidden. The event must be forbidden forever, or
/// must occur now at the latest.
bool is_dead(const Duty& due, const State& open) {
    bool any = false;
    for (std::size_t i = 0; i < due.parts.size(); ++i) {
        const Part& part = due.parts[i];
        if (failed(due, i)) continue;
        if (part.negated || part.last < due.age) return false;
        const bool for_ever = part.last == endless;
        if (!for_ever && (part.last != due.age || part.first > due.age)) return false;
        const bool forbidden = std::ranges::any_of(open, [&](Duty other) {
            const bool always = std::ranges::all_of(other.parts, [&](const Part& of) {
                const auto place = static_cast<std::size_t>(&of - other.parts.data());
                return failed(other, place) || (of.negated && of.event == part.event && of.last == endless);
            });
            return on_event(other, part.event) == Fate::violated && (!for_ever || always);
        });
        if (!forbidden) return false;
        any = true;
    }
    return any;
}

std::optional<State> after_event(const std::vector<NaiveRule>& rules, const State& state, int event, unsigned values) {
    State next;
    for (Duty duty : state) {
        const Fate fate = on_event(duty, event);
        if (fate == Fate::violated) return std::nullopt;
        if (fate == Fate::open) next.insert(duty);
    }
    for (const NaiveRule& rule : rules) {
        if (rule.trigger != event || (rule.condition && !rule.condition->holds(values))) continue;
        if (auto parts = required_parts(rule.response, values)) next.insert({std::move(*parts), 0, 0});
    }
    return next;
}

std::optional<State> after_second(const State& state) {
    State next;
    for (Duty duty : state) {
        const Fate fate = on_second(duty);
        if (fate == Fate::violated) return std::nullopt;
        if (fate == Fate::open) next.insert(duty);
    }
    return next;
}

int number(std::mt19937_64& random, int below) {
    return static_cast<int>(random() % static_cast<unsigned>(below));
}

NaiveCondition random_condition(std::mt19937_64& random) {
    return {number(random, 2), number(random, 2) == 0};
}

/// Returns the number of actions of a response.
int random_length(std::mt19937_64& random) {
    if (number(random, 3) != 0) return 1;
    return number(random, 3) == 0 ? 3 : 2;
}

NaiveResponse random_response(std::mt19937_64& random, int depth) {
    NaiveResponse result;
    const int length = random_length(random);
    for (int i = 0; i < length; ++i) {
        NaiveAction action{number(random, 5) < 2, number(random, events), 0, number(random, 3)};
        if (i > 0 && number(random, 3) != 0) action.to = 0;
        if (*action.to > 0 && !action.negated && number(random, 6) == 0) action.from = 1;
        if (i + 1 == length && number(random, 8) == 0) action.to.reset();
        if (!action.to) action.from = 0;
        result.chain.push_back(action);
    }
    while (depth < 2 && number(random, 4) == 0) {
        NaiveResponse::Defeater defeater{random_condition(random), std::nullopt};
        if (number(random, 3) != 0) defeater.response = random_response(random, depth + 1);
        result.defeaters.push_back(std::move(defeater));
    }
    return result;
}

/// Returns `A within 1 seconds otherwise B within 0 seconds ...`, or `not A within 2 seconds`.
NaiveResponse alternative_response(std::mt19937_64& random, bool demands) {
    NaiveResponse result;
    if (!demands) {
        result.chain.push_back({true, number(random, events), 0, number(random, 3)});
        return result;
    }
    const int first = number(random, events), count = 2 + number(random, 2);
    for (int i = 0; i < count; ++i)
        result.chain.push_back({false, (first + i) % events, 0, i == 0 ? number(random, 3) : 0});
    return result;
}

}  // namespace

std::string NaiveCondition::text() const {
    return std::string(positive ? "" : "not ") + (measure == 0 ? "near" : "safe");
}

std::string NaiveResponse::text() const {
    std::string result;
    for (const NaiveAction& action : chain) {
        if (&action != chain.data()) result += " otherwise ";
        result += (action.negated ? "not " : "") + event_text(action.event);
        if (action.to && action.from > 0)
            result += " within [" + std::to_string(action.from) + ", " + std::to_string(*action.to) + "] seconds";
        else if (action.to)
            result += " within " + std::to_string(*action.to) + " seconds";
    }
    for (const Defeater& defeater : defeaters) {
        result += " unless " + defeater.condition.text();
        if (defeater.response) result += " then {" + defeater.response->text() + "}";
    }
    return result;
}

std::string event_text(int event) {
    return {static_cast<char>('A' + event)};
}

std::string text_of(const std::vector<NaiveRule>& rules) {
    std::string text = "def_start\n";
    for (int i = 0; i < events; ++i) text += "event " + event_text(i) + " ";
    text += "measure near : boolean measure safe : boolean\ndef_end\nrule_start\n";
    for (std::size_t i = 0; i < rules.size(); ++i) {
        text += "R" + std::to_string(i) + " when " + event_text(rules[i].trigger);
        if (rules[i].condition) text += " and " + rules[i].condition->text();
        text += " then " + rules[i].response.text() + "\n";
    }
    return text + "rule_end\n";
}

std::vector<NaiveRule> random_rules(std::mt19937_64& random) {
    std::vector<NaiveRule> result(static_cast<std::size_t>(2 + number(random, 3)));
    const bool alternatives = number(random, 4) == 0;  // the first rule has alternatives, the others forbid
    for (NaiveRule& rule : result) {
        rule.trigger = number(random, events);
        if (number(random, 3) == 0) rule.condition = random_condition(random);
        rule.response = random_response(random, 0);
        if (alternatives) rule.response = alternative_response(random, &rule == result.data());
    }
    return result;
}

std::optional<NaiveAnswer> in_conflict(const std::vector<NaiveRule>& rules) {
    std::map<State, std::size_t> known{{State{}, 0}};
    std::vector<State> states{State{}};
    std::vector<std::vector<std::size_t>> before(1);
    std::vector<std::size_t> passing;
    for (std::size_t at = 0; at < states.size(); ++at) {
        if (states.size() > most_states) return std::nullopt;
        const State state = states[at];
        for (const Duty& duty : state)
            if (is_dead(duty, state)) return NaiveAnswer::forbidden;
        const auto meet = [&](std::optional<State> next) {
            if (!next) return;
            const auto [place, fresh] = known.emplace(*next, states.size());
            if (fresh) {
                states.push_back(std::move(*next));
                before.emplace_back();
            }
            before[place->second].push_back(at);
        };
        auto second = after_second(state);
        if (second) passing.push_back(at);
        meet(std::move(second));
        for (int event = 0; event < events; ++event)
            for (unsigned values = 0; values < 4; ++values) meet(after_event(rules, state, event, values));
    }
    std::vector<bool> passes(states.size(), false);
    for (const std::size_t index : passing) passes[index] = true;
    while (!passing.empty()) {
        const std::size_t at = passing.back();
        passing.pop_back();
        for (const std::size_t previous : before[at]) {
            if (!passes[previous]) passing.push_back(previous);
            passes[previous] = true;
        }
    }
    const bool all = std::ranges::find(passes, false) == passes.end();
    return all ? NaiveAnswer::none : NaiveAnswer::endless;
}

std::optional<std::set<std::vector<std::size_t>>> smallest_conflicts(const std::vector<NaiveRule>& rules) {
    std::set<std::vector<std::size_t>> result;
    for (std::size_t size = 1; size <= rules.size(); ++size)
        for (unsigned chosen = 1; chosen < 1U << rules.size(); ++chosen) {
            std::vector<std::size_t> subset;
            std::vector<NaiveRule> of;
            for (std::size_t i = 0; i < rules.size(); ++i)
                if ((chosen >> i & 1U) != 0) {
                    subset.push_back(i);
                    of.push_back(rules[i]);
                }
            const bool known = std::ranges::any_of(
                result, [&](const auto& smaller) { return std::ranges::includes(subset, smaller); });
            if (subset.size() != size || known) continue;
            const std::optional<NaiveAnswer> found = in_conflict(of);
            if (!found) return std::nullopt;
            if (*found == NaiveAnswer::forbidden) result.insert(subset);
        }
    return result;
}

}  // namespace robochart::sleec::testing
