// SPDX-License-Identifier: Apache-2.0
// Defines the results of `rules` as data, and writes them as text and JSON (robochart-verify/rules/1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"
#include "base/durations/time_unit.hpp"
#include "driver/results/rule_verdict.hpp"

namespace robochart::app {

/// A rule of the file.
struct RuleName {
    std::string name;
    std::string place;  ///< file:line
};

/// Rules that are in conflict, or rules for which a conflict is not decided.
struct RuleConflict {
    std::vector<std::size_t> rules;
    bool decided = true;
    std::string reason;                  ///< if not decided, the reason
    std::vector<std::string> lines;      ///< decided: describes the situation
    std::vector<std::string> suggested;  ///< "R1 ... unless near": changes that together remove the conflict
    std::uint64_t states = 0;
};

/// A rule that other rules together imply, or a rule for which this is not decided.
struct RedundantRule {
    std::size_t rule = 0;
    std::vector<std::size_t> by;
    std::string reason = {};  ///< if not decided, the reason
};

/// A concern that the rules allow, a purpose that they exclude, or a property that is not decided.
struct RuleProperty {
    bool concern = false;
    std::string name, place;
    bool decided = true;
    std::string reason;                 ///< if not decided, the reason
    std::vector<std::string> lines;     ///< for a concern: a history that satisfies the rules
    std::vector<std::size_t> excluded;  ///< for a purpose: the rules that exclude it together
};

/// SLEEC-TK's four answers about a pair of rules; no value if one is not decided.
struct ComparedPair {
    std::size_t first = 0, second = 0;
    std::optional<bool> deadline_missed, only_time_passes, first_redundant, second_redundant;
};

struct RulesReport {
    std::string file, dialect;
    std::string model;                          ///< the model; "" if only rules were analysed
    std::vector<driver::RuleVerdict> verdicts;  ///< the verdicts about a model
    std::vector<std::string> time_stops;        ///< components in which time can stop
    std::vector<std::string> time_open;         ///< "whether time can stop in C: why it is not decided"
    durations::Unit unit;                       ///< with a model: its time unit, if one is declared
    bool as_sleec_tk = false;
    std::string without_limit;
    std::vector<RuleName> rules;
    std::uint64_t questions = 0;  ///< number of questions, decided or not
    std::vector<RuleConflict> conflicts;
    std::vector<RedundantRule> redundant;
    std::vector<std::size_t> asking_nothing;  ///< rules that never require anything
    std::size_t concerns = 0, purposes = 0;   ///< how many concerns and purposes were checked
    std::vector<RuleProperty> properties;     ///< raised concerns, blocked purposes, and properties that are not
                                              ///< decided
    std::vector<std::string> ranges;          ///< for SLEEC-TK: the values of numeric measures
    std::vector<ComparedPair> pairs;          ///< for SLEEC-TK
    std::vector<std::string> not_read;        ///< for SLEEC-TK: rules that it would reject, with the reason
    std::vector<std::string> errors;          ///< errors of the files, and components that cannot be evaluated
    std::string limit;                        ///< the limit that ended the run; "" if none did
};

/// Returns 2 if a file is wrong or a component cannot be evaluated. Otherwise, returns 1 if there is a conflict, a
/// broken rule, a raised concern or a blocked purpose. Otherwise, returns 3 if something is not decided.
[[nodiscard]] Exit exit_of(const RulesReport& report);
[[nodiscard]] std::string rules_text(const RulesReport& report, const Options& options);
[[nodiscard]] std::string rules_json(const RulesReport& report);

}  // namespace robochart::app
