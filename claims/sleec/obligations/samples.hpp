// SPDX-License-Identifier: Apache-2.0
// Enumerates the values of measures that a question distinguishes. All valuations for which the rules make the same
// demands form one sample, represented by one valuation.
#pragma once

#include <vector>

#include "base/diagnostics/budget.hpp"
#include "claims/sleec/obligations/obligation.hpp"

namespace robochart::sleec {

/// One case of the values of measures when an event occurs.
struct Sample {
    Valuation values;  ///< a representative valuation; 0 for measures that no rule uses
    std::vector<std::optional<Obligation>> obligations;  ///< for each rule of the question, in order
};

/// Returns the samples of an event that differ in the demands of some of these rules. Rules with another trigger make
/// no demand. A number is represented by the constants with which it is compared, by their neighbours, and by further
/// values in between. There are as many values in between as there are numbers compared with each other. Throws
/// NotDecided if measures occur in arithmetic, or if there are too many values.
[[nodiscard]] std::vector<Sample> find_samples(const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers,
                                               std::size_t event, WithoutLimit, diagnostics::Budget* budget);

/// Returns values for each measure of the file that represent every valuation with respect to these rules.
[[nodiscard]] std::vector<std::vector<std::int64_t>> representative_values(
    const CheckedRules& rules, const std::vector<std::size_t>& rule_numbers);
/// Returns the measures in the conditions of a rule and its defeaters, without duplicates, in textual order.
[[nodiscard]] std::vector<std::size_t> measures_of(const CheckedRule& rule);
/// True if a condition of the rule reads a state of the model.
[[nodiscard]] bool reads_states(const CheckedRules& rules, std::size_t rule);
/// Returns the constants with which a rule compares a measure, in ascending order.
[[nodiscard]] std::vector<std::int64_t> constants_of(const CheckedRule& rule, std::size_t measure);
/// True if a condition of the rule compares two measures.
[[nodiscard]] bool compares_measures(const CheckedRule& rule);

}  // namespace robochart::sleec
