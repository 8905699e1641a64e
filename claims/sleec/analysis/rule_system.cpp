// SPDX-License-Identifier: Apache-2.0
// See rule_system.hpp.
#include "claims/sleec/analysis/rule_system.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "base/diagnostics/containers.hpp"

namespace robochart::sleec {
namespace {

/// The maximal number of obligations that are open at the same time in one question, and the number of words for each.
constexpr std::size_t most_open_duties = 8;
constexpr std::size_t words = 2;
constexpr std::uint32_t kind_bits = 12;

void check_sizes(const Obligation& obligation) {
    if (obligation.any.size() > most_demands)
        throw NotDecided(fmt::format("a rule has more than {} responses behind each other", most_demands));
    for (const Demand& demand : obligation.any)
        if (demand.begin > 0x7fffffff || (demand.end != forever && demand.end > 0x7fffffff))
            throw NotDecided("a limit is longer than 68 years");
}

/// Returns every event in a demand, a trigger, or `unless EVENT`.
std::set<std::size_t> named_events(const CheckedRules& rules, const Question& question) {
    std::set<std::size_t> events;
    for (std::size_t i = 0; i < question.rules.size(); ++i) {
        const EventCases& trigger = rules.rules[question.rules[i]].trigger;
        events.insert(trigger.begin(), trigger.end());
        for (const Obligation& obligation : question.obligations[i]) {
            for (const Demand& demand : obligation.any) events.insert(demand.event.begin(), demand.event.end());
            events.insert(obligation.ended_by.begin(), obligation.ended_by.end());
        }
    }
    return events;
}

std::size_t intern_obligation(std::vector<Obligation>& known, const Obligation& obligation) {
    const auto found = std::ranges::find(known, obligation);
    if (found != known.end()) return static_cast<std::size_t>(found - known.begin());
    check_sizes(obligation);
    if (known.size() + 1 >= 1U << kind_bits) throw NotDecided("a rule can require too many different responses");
    known.push_back(obligation);
    return known.size() - 1;
}

}  // namespace

std::optional<OpenObligation> Question::opened_by(const Occurrence& occurrence, std::size_t rule) const {
    const auto& obligation = occurrence.sample.obligations[rule];
    if (!obligation) return std::nullopt;
    const auto& known = obligations[rule];
    const auto found = std::ranges::find(known, *obligation);
    return OpenObligation{rule, static_cast<std::size_t>(found - known.begin()), {}};
}

Question make_question(const CheckedRules& rules, std::vector<std::size_t> judged, WithoutLimit without,
                       diagnostics::Budget* budget) {
    Question question;
    question.rules = std::move(judged);
    question.judged = question.rules.size();
    for (std::size_t i = 0; i < rules.rules.size(); ++i)
        if (rules.rules[i].assumed) question.rules.push_back(i);
    constexpr std::size_t most_rules = 15;
    if (question.rules.size() > most_rules)
        throw NotDecided(fmt::format("there are more than {} assumptions", most_rules - 2));
    question.obligations.resize(question.rules.size());
    std::set<std::size_t> triggers;
    for (const std::size_t rule : question.rules)
        triggers.insert(rules.rules[rule].trigger.begin(), rules.rules[rule].trigger.end());
    for (const std::size_t event : triggers)
        for (Sample& sample : find_samples(rules, question.rules, event, without, budget)) {
            for (std::size_t i = 0; i < question.rules.size(); ++i)
                if (sample.obligations[i]) (void)intern_obligation(question.obligations[i], *sample.obligations[i]);
            question.occurrences.push_back({event, std::move(sample)});
        }
    for (const std::size_t event : named_events(rules, question)) {
        if (triggers.contains(event)) continue;
        Sample plain{Valuation(rules.measures.size(), 0), {}};
        plain.obligations.resize(question.rules.size());
        question.occurrences.push_back({event, std::move(plain)});
    }
    return question;
}

namespace {

/// True if the event would break the obligation at this instant.
bool forbids_event(const Question& question, const OpenObligation& open, std::size_t event) {
    Progress progress = open.progress;
    return take_event(question.find_obligation(open), progress, event) == Effect::broken;
}

/// Returns, for each judged rule, one obligation that forbids the event now, or forever for a demand without limit.
std::vector<OpenObligation> forbidding_obligations(const Question& question, const std::vector<OpenObligation>& open,
                                                   std::size_t event, bool for_ever) {
    std::vector<OpenObligation> result;
    for (const OpenObligation& obligation : open) {
        if (obligation.rule >= question.judged || (!result.empty() && result.back().rule == obligation.rule)) continue;
        if (forbids_event(question, obligation, event) &&
            (!for_ever || forbids_forever(question.find_obligation(obligation), obligation.progress, event)))
            result.push_back(obligation);
    }
    return result;
}

/// Selects one obligation for each demand, such that all rules in the bit set `required` take part in the clash.
bool choose_obligations(std::uint32_t required, const std::vector<std::vector<OpenObligation>>& choices, Clash& clash,
                        std::uint32_t involved) {
    const std::size_t at = clash.by.size();
    if (at == choices.size()) return (involved & required) == required;
    for (const OpenObligation& obligation : choices[at]) {
        clash.by.push_back(obligation);
        if (choose_obligations(required, choices, clash, involved | 1U << obligation.rule)) return true;
        clash.by.pop_back();
    }
    return false;
}

std::optional<Clash> clash_of(const Question& question, const std::vector<OpenObligation>& open,
                              const OpenObligation& due, std::uint32_t required) {
    const auto never_again = [&](std::size_t event) {
        return !forbidding_obligations(question, open, event, true).empty();
    };
    Clash result{due, {}, {}};
    std::vector<std::vector<OpenObligation>> choices;
    for (const Demand* demand : due_now(question.find_obligation(due), due.progress, never_again))
        for (const std::size_t event : demand->event) {
            choices.push_back(forbidding_obligations(question, open, event, demand->end == forever));
            result.events.push_back(event);
        }
    if (choices.empty() || !choose_obligations(required, choices, result, 1U << due.rule)) return std::nullopt;
    return result;
}

}  // namespace

std::optional<Clash> clash(const Question& question, const std::vector<OpenObligation>& open, std::uint32_t required) {
    for (const OpenObligation& due : open)
        if (due.rule < question.judged)
            if (auto found = clash_of(question, open, due, required)) return found;
    return std::nullopt;
}

std::optional<Clash> find_clash(const Question& question, const std::vector<OpenObligation>& open) {
    return clash(question, open, (1U << question.judged) - 1);
}

std::size_t last_alternatives(const std::vector<Obligation>& obligations) {
    std::size_t most = 1;
    for (const Obligation& obligation : obligations)
        for (const Demand& last : obligation.any) {
            std::set<std::size_t> events;
            for (const Demand& demand : obligation.any)
                if (!demand.forbids && demand.end == last.end) events.insert(demand.event.begin(), demand.event.end());
            most = std::max(most, events.size());
        }
    return most;
}

std::size_t unasked_occurrences(const Question& question) {
    std::size_t breakable = 0, alternatives = 1;
    for (std::size_t rule = 0; rule < question.obligations.size(); ++rule) {
        alternatives = std::max(alternatives, last_alternatives(question.obligations[rule]));
        for (const Obligation& obligation : question.obligations[rule]) {
            const auto forbidding =
                std::ranges::count_if(obligation.any, [](const Demand& demand) { return demand.forbids; });
            if (obligation.any.size() > 1) breakable = std::max(breakable, static_cast<std::size_t>(forbidding));
        }
    }
    return (1 + alternatives) * (1 + breakable);
}

RuleSystem::RuleSystem(const Question& question) : question_(question) {
    tock_ = events_.intern("tock");
    aside_ = events_.intern("aside");
    for (std::size_t i = 0; i < question.occurrences.size(); ++i)
        names_.push_back(events_.intern(fmt::format("occurrence {}", i)));
}

std::size_t RuleSystem::width() const {
    return 1 + most_open_duties * words;
}

void RuleSystem::initial(std::span<lts::Word> state) {
    std::ranges::fill(state, 0U);
    state[0] = static_cast<lts::Word>(unasked_occurrences(question_));
}

RuleSystem::State RuleSystem::unpack_state(lts::StateView state) const {
    State result;
    result.unasked = state[0];
    for (std::size_t i = 1; i < state.size() && state[i + 1] != 0; i += words) {
        const std::uint32_t rest = state[i + 1] - 1;
        OpenObligation open;
        open.progress.elapsed = state[i];
        open.progress.broken = rest & ((1U << most_demands) - 1);
        open.kind = rest >> most_demands & ((1U << kind_bits) - 1);
        open.rule = rest >> (most_demands + kind_bits);
        result.open.push_back(open);
    }
    return result;
}

void RuleSystem::add(const State& state, lts::Event event, lts::SuccessorSink& sink) {
    if (state.open.size() > most_open_duties) {
        left_out_ = true;
        return;
    }
    std::vector<lts::Word> packed(width(), 0);
    packed[0] = state.unasked;
    std::size_t at = 1;
    for (const OpenObligation& open : state.open) {
        packed[at] = static_cast<lts::Word>(open.progress.elapsed);
        packed[at + 1] = 1 + (open.progress.broken | static_cast<lts::Word>(open.kind) << most_demands |
                              static_cast<lts::Word>(open.rule) << (most_demands + kind_bits));
        at += words;
    }
    sink.add(event, packed, event);
}

std::optional<std::size_t> RuleSystem::occurrence_of(lts::Event event) const {
    const auto found = std::ranges::find(names_, event);
    if (found == names_.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names_.begin());
}

bool RuleSystem::some_clash(lts::StateView packed) const {
    return clash(question_, unpack_state(packed).open, 0).has_value();
}

void RuleSystem::successors(lts::StateView packed, lts::SuccessorSink& sink) {
    const State state = unpack_state(packed);
    if (find_clash(question_, state.open)) return;
    // The self-loop ensures that only clashes are deadlocks. A state in which a single rule cannot be obeyed is not a
    // conflict between rules.
    sink.add(aside_, packed, aside_);
    for (std::size_t i = 0; i < question_.occurrences.size(); ++i) add_event_successor(state, i, sink);
    add_tock_successor(state, sink);
}

/// Adds the successor after an occurrence. The occurrence first fulfils or breaks open obligations, and then opens new
/// ones. It does not affect the obligations that it opens.
void RuleSystem::add_event_successor(const State& state, std::size_t occurrence, lts::SuccessorSink& sink) {
    const Occurrence& taken = question_.occurrences[occurrence];
    State next;
    bool fulfilled = false;
    for (OpenObligation open : state.open) {
        const Effect effect = take_event(question_.find_obligation(open), open.progress, taken.event);
        if (effect == Effect::broken) return;
        if (effect == Effect::fulfilled)
            fulfilled = true;
        else
            next.open.push_back(open);
    }
    if (!fulfilled && state.unasked == 0) return;
    next.unasked = state.unasked - (fulfilled ? 0 : 1);
    for (std::size_t rule = 0; rule < question_.rules.size(); ++rule)
        if (const auto opened = question_.opened_by(taken, rule)) next.open.push_back(*opened);
    remove_dominated(next.open);
    add(next, names_[occurrence], sink);
}

void RuleSystem::add_tock_successor(const State& state, lts::SuccessorSink& sink) {
    State next;
    next.unasked = state.unasked;
    for (OpenObligation open : state.open) {
        const Effect effect = take_tock(question_.find_obligation(open), open.progress);
        if (effect == Effect::broken) return;
        if (effect == Effect::open) next.open.push_back(open);
    }
    remove_dominated(next.open);
    add(next, tock_, sink);
}

/// True if the obligation `a` need not be stored because of `b`. If the same obligation is open twice, one of the two
/// is sufficient: the older for a demand, the younger for a prohibition.
bool RuleSystem::is_dominated(const OpenObligation& a, const OpenObligation& b) const {
    if (a.rule != b.rule || a.kind != b.kind) return false;
    const Obligation& obligation = question_.find_obligation(a);
    if (obligation.any.size() != 1 || obligation.any[0].begin != 0) return a == b;
    return obligation.any[0].forbids ? a.progress.elapsed > b.progress.elapsed
                                     : a.progress.elapsed < b.progress.elapsed;
}

void RuleSystem::remove_dominated(std::vector<OpenObligation>& open) const {
    diagnostics::sort_unique(open);
    std::vector<OpenObligation> left;
    for (const OpenObligation& obligation : open)
        if (std::ranges::none_of(open, [&](const OpenObligation& other) {
                return !(other == obligation) && is_dominated(obligation, other);
            }))
            left.push_back(obligation);
    open = std::move(left);
}

}  // namespace robochart::sleec
