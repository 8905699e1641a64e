// SPDX-License-Identifier: Apache-2.0
// See suggest.hpp.
#include "claims/sleec/analysis/suggest.hpp"

#include <fmt/format.h>

#include <set>

#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {
namespace {

/// A defeater without response.
struct Candidate {
    std::string text;
    CheckedDefeater defeater;
};

Condition constant_condition(std::int64_t value) {
    return {Op::number, value, 0, {}, nullptr};
}

Condition measure_value(std::size_t measure) {
    return {Op::name, 0, measure, {}, nullptr};
}

Candidate make_candidate(std::string text, Condition condition) {
    return {fmt::format("unless {}", text), {std::move(condition), std::nullopt, nullptr, nullptr}};
}

/// Adds conditions on one measure, for the values that the rules distinguish.
void add_conditions(const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers, std::size_t index,
                    std::vector<Candidate>& result) {
    const Measure& measure = rules.measure(index);
    const std::string& name = measure.name.text;
    if (measure.type == MeasureType::boolean) {
        result.push_back(make_candidate(name, measure_value(index)));
        result.push_back(make_candidate("not " + name, {Op::negation, 0, 0, {measure_value(index)}, nullptr}));
        return;
    }
    const auto compared = [&](Op op, std::int64_t value, const std::string& shown) {
        result.push_back(make_candidate(fmt::format("{} {} {}", name, symbol_of(op), shown),
                                        {op, 0, 0, {measure_value(index), constant_condition(value)}, nullptr}));
    };
    if (measure.type == MeasureType::scale) {
        for (std::size_t i = 0; i < measure.literals.size(); ++i)
            for (const Op op : {Op::greater_equal, Op::less_equal, Op::equal})
                compared(op, static_cast<std::int64_t>(i), measure.literals[i].text);
        return;
    }
    std::set<std::int64_t> constants;
    for (const std::size_t rule : rule_numbers)
        for (const std::int64_t constant : constants_of(rules.rules[rule], index)) constants.insert(constant);
    for (const std::int64_t constant : constants)
        for (const Op op : {Op::greater, Op::greater_equal, Op::less, Op::less_equal, Op::equal})
            if (constant >= 0) compared(op, constant, std::to_string(constant));
}

Candidate on_event(const CheckedRules& rules, const EventCases& event) {
    return {fmt::format("unless {}", rules.event_name(event)), {{}, event, nullptr, nullptr}};
}

/// Returns the rules with one more defeater.
CheckedRules with_defeater(const CheckedRules& rules, std::size_t rule, const CheckedDefeater& defeater) {
    CheckedRules result = rules;
    Duty duty = *result.rules[rule].duty;
    duty.defeaters.push_back(defeater);
    result.rules[rule].duty = std::make_shared<const Duty>(std::move(duty));
    return result;
}

class Search {
public:
    Search(const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers, const AnalysisOptions& options)
        : rules_(rules), rule_numbers_(rule_numbers), options_(options) {}

    std::vector<Suggestion> suggest_one() {
        std::set<std::size_t> measures;
        std::set<EventCases> events;
        for (const std::size_t rule : rule_numbers_) {
            for (const std::size_t measure : measures_of(rules_.rules[rule])) measures.insert(measure);
            events.insert(rules_.rules[rule].trigger);
        }
        for (const std::size_t rule : rule_numbers_) {
            std::vector<Candidate> candidates;
            for (const std::size_t measure : measures) add_conditions(rules_, rule_numbers_, measure, candidates);
            for (const EventCases& event : events)
                if (event != rules_.rules[rule].trigger) candidates.push_back(on_event(rules_, event));
            for (const Candidate& candidate : candidates)
                if (resolves_conflict(with_defeater(rules_, rule, candidate.defeater))) return {{rule, candidate.text}};
        }
        return {};
    }

    std::vector<Suggestion> suggest_two() {
        for (const std::size_t first : rule_numbers_)
            for (const std::size_t second : rule_numbers_) {
                const EventCases& a = rules_.rules[first].trigger;
                const EventCases& b = rules_.rules[second].trigger;
                if (first >= second || a == b) continue;
                const Candidate to_first = on_event(rules_, b), to_second = on_event(rules_, a);
                if (resolves_conflict(
                        with_defeater(with_defeater(rules_, first, to_first.defeater), second, to_second.defeater)))
                    return {{first, to_first.text}, {second, to_second.text}};
            }
        return {};
    }

private:
    /// True if neither the rules nor a subset of them is in conflict any more.
    bool resolves_conflict(const CheckedRules& changed) {
        try {
            for (const std::size_t rule : rule_numbers_)
                if (makes_no_demand(changed, rule, options_)) return false;
        } catch (const NotDecided&) {
            return false;
        }
        return find_conflict(changed, rule_numbers_, options_).conflict == Answer::no;
    }

    const CheckedRules& rules_;
    const std::vector<std::size_t>& rule_numbers_;
    const AnalysisOptions& options_;
};

}  // namespace

std::vector<Suggestion> suggest_defeaters(const CheckedRules& rules, const std::vector<std::size_t>& in_conflict,
                                          const AnalysisOptions& options) {
    Search search(rules, in_conflict, options);
    std::vector<Suggestion> found = search.suggest_one();
    return found.empty() ? search.suggest_two() : found;
}

}  // namespace robochart::sleec
