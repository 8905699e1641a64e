// What `rules` found, as data, and its output: text, JSON (robochart-verify/rules/1).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/command/options.hpp"

namespace robochart::app {

/// A rule of the file.
struct RuleName {
    std::string name;
    std::string place;  ///< file:line
};

/// Rules in conflict, or of which it is not decided.
struct RuleConflict {
    std::vector<std::size_t> rules;
    bool decided = true;
    std::string reason;                  ///< not decided: why
    std::vector<std::string> lines;      ///< decided: the situation
    std::vector<std::string> suggested;  ///< "R1 ... unless near": what removes it, all of them together
    std::uint64_t states = 0;
};

/// A rule that says nothing that these do not, together; or of which it is not decided.
struct RedundantRule {
    std::size_t rule = 0;
    std::vector<std::size_t> by;
    std::string reason = {};  ///< not decided: why
};

/// A concern that the rules allow, a purpose that they exclude, or one that is not decided.
struct RuleProperty {
    bool concern = false;
    std::string name, place;
    bool decided = true;
    std::string reason;                 ///< not decided: why
    std::vector<std::string> lines;     ///< of a concern: a history that keeps the rules
    std::vector<std::size_t> excluded;  ///< of a purpose: rules that exclude it together
};

/// A pair as SLEEC-TK sees it: four answers; nothing where one is not decided.
struct ComparedPair {
    std::size_t first = 0, second = 0;
    std::optional<bool> deadline_missed, only_time_passes, first_redundant, second_redundant;
};

/// A rule and a component of a model.
struct RuleVerdict {
    enum class Kind { obeyed, broken, never_asked, not_applicable, not_decided, error };
    std::string component;
    std::size_t rule = 0;
    Kind kind = Kind::not_decided;
    std::string reason;              ///< not applicable, not decided, error: why
    std::vector<std::string> lines;  ///< broken: how
    std::uint64_t states = 0;
};

struct RulesReport {
    std::string file, dialect;
    std::string model;                    ///< "": rules alone
    std::vector<RuleVerdict> verdicts;    ///< of a model
    std::vector<std::string> time_stops;  ///< components in which time can stop
    std::vector<std::string> time_open;   ///< "whether time can stop in C: why it is not decided"
    bool as_sleec_tk = false;
    std::string without_limit;
    std::vector<RuleName> rules;
    std::uint64_t questions = 0;  ///< decided or not
    std::vector<RuleConflict> conflicts;
    std::vector<RedundantRule> redundant;
    std::vector<std::size_t> asking_nothing;  ///< rules that never ask for anything
    std::size_t concerns = 0, purposes = 0;   ///< asked about
    std::vector<RuleProperty> properties;     ///< those that are raised, blocked, or not decided
    std::vector<std::string> ranges;          ///< as SLEEC-TK: the values of numeric measures
    std::vector<ComparedPair> pairs;          ///< as SLEEC-TK
    std::vector<std::string> not_read;        ///< as SLEEC-TK: rules that it would not read, with the reason
    std::vector<std::string> errors;          ///< of the files, and where a component cannot be evaluated
    std::string limit;                        ///< what ended the run; "" if nothing did
};

/// 2 where a file is wrong or a component cannot be evaluated, 1 where there is a conflict, a rule is broken, a concern
/// raised or a purpose blocked, 3 where something is not decided.
[[nodiscard]] Exit exit_of(const RulesReport& report);
[[nodiscard]] std::string rules_text(const RulesReport& report, const Options& options);
[[nodiscard]] std::string rules_json(const RulesReport& report);

}  // namespace robochart::app
