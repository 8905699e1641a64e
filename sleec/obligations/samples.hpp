// The values of measures that a question distinguishes. Two valuations under which all of its rules ask for the same
// are one sample; a valuation stands for each.
#pragma once

#include <vector>

#include "diagnostics/budget.hpp"
#include "sleec/obligations/obligation.hpp"

namespace robochart::sleec {

/// One way in which the measures may be when an event occurs.
struct Sample {
    Valuation values;                                    ///< that stand for it; 0 of measures that no rule asks
    std::vector<std::optional<Obligation>> obligations;  ///< of each rule of the question, in its order
};

/// The samples of an event for these rules, those that differ in what a rule asks for. Rules with another trigger ask
/// for nothing. Numbers are represented by the constants that they are compared with, their neighbours, and as many
/// values in between as there are numbers compared with each other. Throws NotDecided where measures are in arithmetic,
/// or where there are too many values.
[[nodiscard]] std::vector<Sample> samples(const CheckedRules& rules, const std::vector<std::size_t>& asked,
                                          std::size_t event, WithoutLimit, diagnostics::Budget* budget);

/// Values for each measure of the file of which every valuation can be represented, with respect to these rules.
[[nodiscard]] std::vector<std::vector<std::int64_t>> representatives(const CheckedRules& rules,
                                                                     const std::vector<std::size_t>& asked);
/// The measures that the conditions of a rule name, its defeaters included; each once, in the order of the text.
[[nodiscard]] std::vector<std::size_t> measures_of(const CheckedRule& rule);
/// The constants that a rule compares a measure with, ascending.
[[nodiscard]] std::vector<std::int64_t> constants_of(const CheckedRule& rule, std::size_t measure);
/// Whether a condition of the rule compares two measures.
[[nodiscard]] bool compares_measures(const CheckedRule& rule);

}  // namespace robochart::sleec
