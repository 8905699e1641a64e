// SPDX-License-Identifier: Apache-2.0
// See samples.hpp.
#include "claims/sleec/obligations/samples.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace robochart::sleec {
namespace {

/// The largest number of valuations that are enumerated for one event.
constexpr std::uint64_t most_valuations = 1U << 22U;

using Visit = std::function<void(const Condition&)>;

void visit(const Condition& condition, const Visit& on_condition) {
    on_condition(condition);
    for (const Condition& part : condition.parts) visit(part, on_condition);
}

void visit(const DutyPtr& duty, const Visit& on_condition) {
    if (!duty) return;
    visit(duty->otherwise, on_condition);
    for (const CheckedDefeater& defeater : duty->defeaters) {
        if (!defeater.event) visit(defeater.condition, on_condition);
        visit(defeater.duty, on_condition);
    }
}

void visit(const CheckedRule& rule, const Visit& on_condition) {
    if (rule.condition) visit(*rule.condition, on_condition);
    visit(rule.duty, on_condition);
}

bool has_measure(const Condition& condition) {
    bool found = false;
    visit(condition, [&](const Condition& part) { found = found || part.op == Op::name; });
    return found;
}

/// The comparisons of numbers.
struct Comparisons {
    std::vector<std::set<std::int64_t>> constants;  ///< index: the measure
    std::set<std::size_t> together;                 ///< measures compared with other measures
};

void note_comparisons(const Condition& condition, Comparisons& result) {
    const bool arithmetic = condition.op == Op::add || condition.op == Op::subtract || condition.op == Op::multiply;
    if (arithmetic && has_measure(condition)) throw NotDecided("a condition computes with measures");
    if (!is_comparison(condition.op)) return;
    const Condition& left = condition.parts[0];
    const Condition& right = condition.parts[1];
    const auto is_measure = [](const Condition& side) { return side.op == Op::name; };
    if (is_measure(left) && is_measure(right)) {
        result.together.insert({left.measure, right.measure});
    } else if (is_measure(left)) {
        result.constants[left.measure].insert(evaluate_condition(right, {}));
    } else if (is_measure(right)) {
        result.constants[right.measure].insert(evaluate_condition(left, {}));
    }
}

/// Returns values between and around these constants: `count` values in each interval, or all values of a smaller
/// interval.
std::vector<std::int64_t> values_around(const std::set<std::int64_t>& constants, std::int64_t count) {
    if (constants.empty()) {
        std::vector<std::int64_t> any;
        for (std::int64_t i = 0; i < count; ++i) any.push_back(i);
        return any;
    }
    std::set<std::int64_t> values;
    for (const std::int64_t constant : constants)
        for (std::int64_t i = 0; i <= count; ++i) {
            // A value beyond the next constant is harmless: only the number of values matters.
            values.insert(constant + i);
            values.insert(constant - i);
        }
    return {values.begin(), values.end()};
}

/// Enumerates all valuations of some measures.
class Valuations {
public:
    Valuations(const std::vector<std::vector<std::int64_t>>& values, std::vector<std::size_t> measures)
        : values_(values), measures_(std::move(measures)), at_(measures_.size(), 0) {
        current_.assign(values.size(), 0);
        std::uint64_t count = 1;
        for (const std::size_t measure : measures_) {
            count *= values_[measure].size();
            if (count > most_valuations)
                throw NotDecided(fmt::format("the measures have more than {} combinations of values", most_valuations));
            current_[measure] = values_[measure][0];
        }
    }
    [[nodiscard]] const Valuation& current() const { return current_; }
    bool next() {
        for (std::size_t i = 0; i < measures_.size(); ++i) {
            const std::vector<std::int64_t>& values = values_[measures_[i]];
            at_[i] = (at_[i] + 1) % values.size();
            current_[measures_[i]] = values[at_[i]];
            if (at_[i] != 0) return true;
        }
        return false;
    }

private:
    const std::vector<std::vector<std::int64_t>>& values_;
    std::vector<std::size_t> measures_;
    std::vector<std::size_t> at_;
    Valuation current_;
};

}  // namespace

std::vector<std::size_t> measures_of(const CheckedRule& rule) {
    std::vector<std::size_t> result;
    visit(rule, [&](const Condition& condition) {
        if (condition.op == Op::name && std::ranges::find(result, condition.measure) == result.end())
            result.push_back(condition.measure);
    });
    return result;
}

bool reads_states(const CheckedRules& rules, std::size_t rule) {
    return std::ranges::any_of(measures_of(rules.rules[rule]),
                               [&](std::size_t measure) { return rules.is_state(measure); });
}

std::vector<std::int64_t> constants_of(const CheckedRule& rule, std::size_t measure) {
    Comparisons found;
    found.constants.resize(measure + 1);
    visit(rule, [&](const Condition& condition) {
        for (const Condition& part : condition.parts)
            if (part.op == Op::name && part.measure >= found.constants.size()) found.constants.resize(part.measure + 1);
        note_comparisons(condition, found);
    });
    return {found.constants[measure].begin(), found.constants[measure].end()};
}

bool compares_measures(const CheckedRule& rule) {
    bool found = false;
    visit(rule, [&](const Condition& condition) {
        found = found ||
                (is_comparison(condition.op) && condition.parts[0].op == Op::name && condition.parts[1].op == Op::name);
    });
    return found;
}

/// Returns representative values of each measure. A valuation of integers is characterised by the position of each
/// number relative to the constants, and by the order of numbers that are compared with each other. Between two
/// constants, n numbers have at most n different values, so n values are sufficient.
std::vector<std::vector<std::int64_t>> representative_values(const CheckedRules& rules,
                                                             const std::vector<std::size_t>& rule_numbers) {
    const std::vector<Measure>& measures = rules.measures;
    Comparisons found;
    found.constants.resize(measures.size());
    for (const std::size_t rule : rule_numbers)
        visit(rules.rules[rule], [&](const Condition& condition) { note_comparisons(condition, found); });
    std::set<std::int64_t> shared;
    for (const std::size_t measure : found.together)
        shared.insert(found.constants[measure].begin(), found.constants[measure].end());
    std::vector<std::vector<std::int64_t>> result(measures.size());
    for (std::size_t i = 0; i < measures.size(); ++i) {
        if (measures[i].type == MeasureType::boolean) {
            result[i] = {0, 1};
        } else if (measures[i].type == MeasureType::scale) {
            for (std::size_t place = 0; place < measures[i].literals.size(); ++place)
                result[i].push_back(static_cast<std::int64_t>(place));
        } else if (found.together.contains(i)) {
            result[i] = values_around(shared, static_cast<std::int64_t>(found.together.size()));
        } else {
            result[i] = values_around(found.constants[i], 1);
        }
    }
    return result;
}

std::vector<Sample> find_samples(const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers,
                                 std::size_t event, WithoutLimit without, diagnostics::Budget* budget) {
    std::vector<std::size_t> triggered, measures;
    for (const std::size_t rule : rule_numbers) {
        if (!rules.rules[rule].trigger.contains(event)) continue;
        triggered.push_back(rule);
        for (const std::size_t measure : measures_of(rules.rules[rule]))
            if (std::ranges::find(measures, measure) == measures.end()) measures.push_back(measure);
    }
    const auto values = representative_values(rules, triggered);
    Valuations valuations(values, measures);
    std::vector<Sample> result;
    do {
        if (budget != nullptr) budget->poll();
        Sample sample{valuations.current(), {}};
        for (const std::size_t rule : rule_numbers)
            sample.obligations.push_back(rules.rules[rule].trigger.contains(event)
                                             ? obligation_of(rules.rules[rule], sample.values, without)
                                             : std::nullopt);
        const bool known =
            std::ranges::any_of(result, [&](const Sample& other) { return other.obligations == sample.obligations; });
        if (!known) result.push_back(std::move(sample));
    } while (valuations.next());
    return result;
}

}  // namespace robochart::sleec
