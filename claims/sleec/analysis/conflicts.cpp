// SPDX-License-Identifier: Apache-2.0
// See conflicts.hpp.
#include "claims/sleec/analysis/conflicts.hpp"

#include <algorithm>
#include <set>

#include "checker/lts/graph.hpp"
#include "checker/refine/verdict/check.hpp"
#include "claims/sleec/analysis/rule_system.hpp"

namespace robochart::sleec {
namespace {

/// The events that the obligations of a rule demand and forbid.
struct Events {
    std::set<std::size_t> demanded, forbidden;
};

Events events_of(const std::vector<Obligation>& obligations) {
    Events result;
    for (const Obligation& obligation : obligations)
        for (const Demand& demand : obligation.any)
            (demand.forbids ? result.forbidden : result.demanded).insert(demand.event.begin(), demand.event.end());
    return result;
}

bool have_common(const std::set<std::size_t>& a, const std::set<std::size_t>& b) {
    return std::ranges::any_of(a, [&](std::size_t event) { return b.contains(event); });
}

/// True if one rule demands an event that each of the other rules forbids. Otherwise, there is no conflict, and no
/// search is needed.
bool may_clash(const Question& question) {
    std::vector<Events> all;
    for (std::size_t i = 0; i < question.judged; ++i) all.push_back(events_of(question.obligations[i]));
    for (std::size_t due = 0; due < all.size(); ++due) {
        bool every = true;
        for (std::size_t i = 0; i < all.size(); ++i)
            every = every && ((i == due && all.size() > 1) || have_common(all[due].demanded, all[i].forbidden));
        if (every) return true;
    }
    return false;
}

/// Returns the events that the obligations demand at the instant of their trigger.
std::set<std::size_t> demanded_at_once(const std::vector<Obligation>& obligations) {
    std::set<std::size_t> result;
    for (const Obligation& obligation : obligations)
        for (const Demand& demand : obligation.any)
            if (!demand.forbids && demand.end == 0) result.insert(demand.event.begin(), demand.event.end());
    return result;
}

/// Finds, for each rule, the rules that it triggers at once: the rule demands their trigger at the instant of its own
/// trigger.
using Answers = std::vector<std::vector<std::size_t>>;

Answers find_answers(const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers,
                     const std::vector<std::set<std::size_t>>& at_once) {
    Answers result(rule_numbers.size());
    for (std::size_t i = 0; i < rule_numbers.size(); ++i)
        for (std::size_t k = 0; k < rule_numbers.size(); ++k)
            if (std::ranges::any_of(rules.rules[rule_numbers[k]].trigger,
                                    [&](std::size_t event) { return at_once[i].contains(event); }))
                result[i].push_back(k);
    return result;
}

/// Finds simple cycles of rules that trigger each other at once, as sets of rules. The length and the number of cycles
/// are bounded.
class Cycles {
public:
    static constexpr std::size_t longest = 6;
    static constexpr std::size_t most = 500;

    explicit Cycles(const Answers& answers) : answers_(answers) {
        for (std::size_t first = 0; first < answers.size(); ++first) {
            path_ = {first};
            extend_path();
        }
    }
    [[nodiscard]] const std::set<std::vector<std::size_t>>& found() const { return found_; }

private:
    /// Extends the path only by rules after the first, so that each cycle is found from its first rule.
    void extend_path() {
        for (const std::size_t next : answers_[path_.back()]) {
            if (found_.size() >= most) return;
            if (next == path_.front()) {
                std::vector<std::size_t> cycle = path_;
                std::ranges::sort(cycle);
                found_.insert(std::move(cycle));
            } else if (next > path_.front() && path_.size() < longest &&
                       std::ranges::find(path_, next) == path_.end()) {
                path_.push_back(next);
                extend_path();
                path_.pop_back();
            }
        }
    }

    const Answers& answers_;
    std::vector<std::size_t> path_;
    std::set<std::vector<std::size_t>> found_;
};

bool may_be_endless(const CheckedRules& rules, const Question& question) {
    std::vector<std::set<std::size_t>> at_once;
    for (const auto& obligations : question.obligations) at_once.push_back(demanded_at_once(obligations));
    return !Cycles(find_answers(rules, question.rules, at_once)).found().empty();
}

/// Repeats a run and records the origin of each obligation.
class Replay {
public:
    Replay(const Question& question, const RuleSystem& system) : question_(question), system_(system) {}

    Conflict make_conflict(const std::vector<refine::Step>& steps) {
        for (const refine::Step& step : steps) replay_event(step.event);
        std::vector<OpenObligation> open;
        for (const Opened& opened : open_) open.push_back(opened.open);
        const Clash found = find_clash(question_, open).value();
        Conflict result;
        result.instant = now_;
        std::set<std::size_t> triggers{find(found.due).id};
        for (std::size_t i = 0; i < found.events.size(); ++i) {
            result.due.push_back(make_side(found.due, found.events[i], false));
            result.forbidding.push_back(make_side(found.by[i], found.events[i], true));
            result.for_ever = result.for_ever || result.due.back().demand.end == forever;
            triggers.insert(find(found.by[i]).id);
        }
        note_besides(triggers, result);
        return result;
    }

    /// Makes a conflict from a run that leads to an instant that never ends, because due events trigger further demands
    /// without end. The conflict contains each duty that is due.
    Conflict make_endless_conflict(const std::vector<lts::Event>& steps) {
        for (const lts::Event step : steps) replay_event(step);
        Conflict result;
        result.instant = now_;
        result.endless = true;
        std::set<std::size_t> triggers;
        for (const Opened& opened : open_)
            for (const Demand* demand : due_now(question_.find_obligation(opened.open), opened.open.progress,
                                                [](std::size_t) { return false; })) {
                result.due.push_back(make_side(opened.open, *demand->event.begin(), false));
                triggers.insert(opened.id);
            }
        note_besides(triggers, result);
        return result;
    }

private:
    struct Opened {
        OpenObligation open;
        std::int64_t began = 0;
        std::size_t occurrence = 0;
        std::size_t id = 0;  ///< id of the trigger
    };
    struct Occurred {
        std::int64_t instant = 0;
        std::size_t event = 0, id = 0;
    };

    void note_besides(const std::set<std::size_t>& triggers, Conflict& result) const {
        for (const auto& [instant, event, id] : occurred_)
            if (!triggers.contains(id)) result.besides.emplace_back(instant, event);
    }

    void replay_event(lts::Event event) {
        const auto occurrence = system_.occurrence_of(event);
        std::vector<Opened> left;
        for (Opened opened : open_) {
            const Obligation& obligation = question_.find_obligation(opened.open);
            const Effect effect =
                occurrence ? take_event(obligation, opened.open.progress, question_.occurrences[*occurrence].event)
                           : take_tock(obligation, opened.open.progress);
            if (effect == Effect::open) left.push_back(opened);
        }
        open_ = std::move(left);
        if (!occurrence) {
            ++now_;
            return;
        }
        const Occurrence& taken = question_.occurrences[*occurrence];
        occurred_.push_back({now_, taken.event, occurred_.size()});
        for (std::size_t rule = 0; rule < question_.rules.size(); ++rule)
            if (const auto opened = question_.opened_by(taken, rule))
                open_.push_back({*opened, now_, *occurrence, occurred_.size() - 1});
    }

    [[nodiscard]] const Opened& find(const OpenObligation& open) const {
        return *std::ranges::find_if(open_, [&](const Opened& opened) { return opened.open == open; });
    }

    [[nodiscard]] Side make_side(const OpenObligation& open, std::size_t event, bool forbids) const {
        const Opened& opened = find(open);
        Side result{
            question_.rules[open.rule], opened.began, question_.occurrences[opened.occurrence].sample.values, {}};
        // Takes the last demand about the event, because the windows of earlier demands are over.
        for (const Demand& demand : question_.find_obligation(open).any)
            if (demand.event.contains(event) && demand.forbids == forbids) result.demand = demand;
        return result;
    }

    const Question& question_;
    const RuleSystem& system_;
    std::vector<Opened> open_;
    std::vector<Occurred> occurred_;
    std::int64_t now_ = 0;
};

/// Finds the steps to a state from which time can no longer pass and no clash of some of the rules is reachable.
/// Returns no value if there is no such state.
std::optional<std::vector<lts::Event>> endless_instant(RuleSystem& system, const AnalysisOptions& options) {
    const auto explored = lts::explore(system, [&](std::size_t states) {
        if (options.budget != nullptr) options.budget->poll();
        if (states > options.limits.max_states) throw NotDecided("more states than --max-states");
    });
    const lts::Graph& graph = explored.graph;
    std::vector<std::vector<lts::StateIndex>> before(graph.size());
    std::vector<std::pair<lts::StateIndex, lts::Event>> reached(graph.size(), {0, 0});
    std::vector<bool> passes(graph.size(), false), known(graph.size(), false);
    std::vector<lts::StateIndex> waiting;
    known[0] = true;
    for (lts::StateIndex state = 0; state < graph.size(); ++state) {  // in breadth-first order, so the state already
                                                                      // known
        if (system.some_clash(explored.states[state])) {
            passes[state] = true;
            waiting.push_back(state);
        }
        for (const lts::Edge& edge : graph.edges(state)) {
            if (!known[edge.target]) reached[edge.target] = {state, edge.event};
            known[edge.target] = true;
            before[edge.target].push_back(state);
            if (!system.is_tock(edge.event) || passes[state]) continue;
            passes[state] = true;
            waiting.push_back(state);
        }
    }
    while (!waiting.empty()) {
        const lts::StateIndex state = waiting.back();
        waiting.pop_back();
        for (const lts::StateIndex predecessor : before[state]) {
            if (passes[predecessor]) continue;
            passes[predecessor] = true;
            waiting.push_back(predecessor);
        }
    }
    const auto found = std::ranges::find(passes, false);
    if (found == passes.end()) return std::nullopt;
    std::vector<lts::Event> steps;
    for (auto at = static_cast<lts::StateIndex>(found - passes.begin()); at != 0; at = reached[at].first)
        steps.push_back(reached[at].second);
    std::ranges::reverse(steps);
    return steps;
}

void search_clash(const Question& question, const AnalysisOptions& options, ConflictAnswer& answer) {
    RuleSystem system(question);
    const refine::Verdict verdict = refine::deadlock_free(system, refine::Model::failures, options.limits);
    answer.states = verdict.statistics.states;
    if (verdict.outcome == refine::Outcome::fails && verdict.counterexample) {
        answer.conflict = Answer::yes;
        answer.example = Replay(question, system).make_conflict(verdict.counterexample->steps);
    } else if (verdict.outcome == refine::Outcome::inconclusive) {
        answer.conflict = Answer::not_decided;
        answer.reason = verdict.reason;
    } else if (system.left_out()) {
        answer.conflict = Answer::not_decided;
        answer.reason = "too many obligations can be open at once";
    }
}

void search_endless(const Question& question, const AnalysisOptions& options, ConflictAnswer& answer) {
    RuleSystem system(question);
    const auto steps = endless_instant(system, options);
    if (system.left_out()) {
        answer.conflict = Answer::not_decided;
        answer.reason = "too many obligations can be open at once";
    } else if (steps) {
        answer.conflict = Answer::yes;
        answer.example = Replay(question, system).make_endless_conflict(*steps);
    }
}

/// Asks all questions about a file, smaller sets of rules first.
class Questions {
public:
    Questions(const CheckedRules& rules, const AnalysisOptions& options,
              const std::function<void(const ConflictAnswer&)>& take)
        : rules_(rules), options_(options), take_(take) {}

    void ask_all() {
        for (std::size_t rule = 0; rule < rules_.rules.size(); ++rule)
            if (!rules_.rules[rule].assumed) prepare_rule(rule);
        std::size_t most = 2;
        for (const Known& known : known_) {
            ask_conflict({known.rule});
            most = std::max(most, known.alternatives + 1);
        }
        const std::set<std::vector<std::size_t>> cycles = at_once();
        for (std::size_t size = 2; size <= std::max(most, Cycles::longest + 1); ++size) {
            for (std::size_t due = 0; due < known_.size(); ++due)
                if (size == 2 || known_[due].alternatives + 1 >= size) with_forbidding(due, size);
            for (const auto& cycle : cycles)
                if (cycle.size() == size) ask_conflict(cycle);
        }
    }

private:
    struct Known {
        std::size_t rule = 0;
        std::size_t alternatives = 1;
        Events events;
        std::set<std::size_t> at_once;
    };

    void prepare_rule(std::size_t rule) {
        try {
            const Question alone = make_question(rules_, {rule}, options_.without_limit, options_.budget);
            known_.push_back({rule, last_alternatives(alone.obligations[0]), events_of(alone.obligations[0]),
                              demanded_at_once(alone.obligations[0])});
        } catch (const NotDecided& error) {
            ConflictAnswer answer;
            answer.rules = {rule};
            answer.conflict = Answer::not_decided;
            answer.reason = std::string(error.what()) + "; no other rule is compared with it";
            take_(answer);
        }
    }

    /// Returns the cycles of rules that trigger each other at once. Also returns each of these cycles with one more
    /// rule that forbids an event demanded in the cycle.
    std::set<std::vector<std::size_t>> at_once() {
        std::vector<std::size_t> rules;
        std::vector<std::set<std::size_t>> events;
        for (const Known& known : known_) {
            rules.push_back(known.rule);
            events.push_back(known.at_once);
        }
        const Answers all = find_answers(rules_, rules, events);
        const Cycles cycles(all);
        std::set<std::vector<std::size_t>> result;
        for (const std::vector<std::size_t>& places : cycles.found()) {
            std::vector<std::size_t> cycle;
            std::set<std::size_t> demanded;
            for (const std::size_t place : places) {
                cycle.push_back(rules[place]);
                demanded.insert(known_[place].at_once.begin(), known_[place].at_once.end());
            }
            result.insert(cycle);
            for (const Known& known : known_) {
                if (!have_common(demanded, known.events.forbidden)) continue;
                std::vector<std::size_t> more = cycle;
                if (std::ranges::find(more, known.rule) != more.end()) continue;
                more.push_back(known.rule);
                std::ranges::sort(more);
                result.insert(std::move(more));
            }
        }
        return result;
    }

    void with_forbidding(std::size_t due, std::size_t size) {
        std::vector<std::size_t> others;
        for (std::size_t i = 0; i < known_.size(); ++i)
            if (i != due && have_common(known_[due].events.demanded, known_[i].events.forbidden))
                others.push_back(known_[i].rule);
        std::vector<std::size_t> chosen{known_[due].rule};
        ask_combinations(others, 0, size, chosen);
    }

    void ask_combinations(const std::vector<std::size_t>& others, std::size_t from, std::size_t size,
                          std::vector<std::size_t>& chosen) {
        if (chosen.size() == size) {
            std::vector<std::size_t> sorted = chosen;
            std::ranges::sort(sorted);
            return ask_conflict(std::move(sorted));
        }
        for (std::size_t i = from; i < others.size(); ++i) {
            chosen.push_back(others[i]);
            ask_combinations(others, i + 1, size, chosen);
            chosen.pop_back();
        }
    }

    void ask_conflict(std::vector<std::size_t> rule_numbers) {
        const bool smaller = std::ranges::any_of(
            conflicts_, [&](const auto& conflict) { return std::ranges::includes(rule_numbers, conflict); });
        if ((smaller && rule_numbers.size() > 2) || !asked_.insert(rule_numbers).second) return;
        ConflictAnswer answer = find_conflict(rules_, rule_numbers, options_);
        if (answer.conflict == Answer::yes && answer.example->endless && smaller)
            answer = {rule_numbers, Answer::no, {}, {}, 0};
        if (answer.conflict == Answer::yes) conflicts_.push_back(std::move(rule_numbers));
        take_(answer);
    }

    const CheckedRules& rules_;
    const AnalysisOptions& options_;
    const std::function<void(const ConflictAnswer&)>& take_;
    std::vector<Known> known_;
    std::set<std::vector<std::size_t>> asked_;
    std::vector<std::vector<std::size_t>> conflicts_;
};

}  // namespace

ConflictAnswer find_conflict(const CheckedRules& rules, std::vector<std::size_t> judged,
                             const AnalysisOptions& options) {
    ConflictAnswer answer;
    answer.rules = judged;
    try {
        const Question question = make_question(rules, std::move(judged), options.without_limit, options.budget);
        if (may_clash(question)) search_clash(question, options, answer);
        if (answer.conflict == Answer::no && may_be_endless(rules, question)) search_endless(question, options, answer);
    } catch (const NotDecided& error) {
        answer.conflict = Answer::not_decided;
        answer.reason = error.what();
    }
    return answer;
}

void for_each_question(const CheckedRules& rules, const AnalysisOptions& options,
                       const std::function<void(const ConflictAnswer&)>& take) {
    Questions(rules, options, take).ask_all();
}

namespace {

/// Returns the samples of all cases of the first rule's trigger.
std::vector<Sample> samples_of_trigger(const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers,
                                       const AnalysisOptions& options) {
    std::vector<Sample> result;
    for (const std::size_t event : rules.rules[rule_numbers.front()].trigger)
        for (Sample& sample : find_samples(rules, rule_numbers, event, options.without_limit, options.budget))
            result.push_back(std::move(sample));
    return result;
}

}  // namespace

/// True if, for each sample of its trigger, the rule makes no demand or the other rule's demand implies its demand.
/// Measures are unconstrained, and other triggers may or may not occur, so only a demand for the same occurrence can
/// imply the rule's demand.
bool is_redundant(const CheckedRules& rules, std::size_t rule, std::size_t by, const AnalysisOptions& options) {
    return std::ranges::all_of(samples_of_trigger(rules, {rule, by}, options), [](const Sample& sample) {
        if (!sample.obligations[0] || always_fulfilled(*sample.obligations[0])) return true;
        return sample.obligations[1] && implies(*sample.obligations[1], *sample.obligations[0]);
    });
}

bool makes_no_demand(const CheckedRules& rules, std::size_t rule, const AnalysisOptions& options) {
    return std::ranges::none_of(samples_of_trigger(rules, {rule}, options), [](const Sample& sample) {
        return sample.obligations[0] && !always_fulfilled(*sample.obligations[0]);
    });
}

}  // namespace robochart::sleec
