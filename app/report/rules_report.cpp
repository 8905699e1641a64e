// SPDX-License-Identifier: Apache-2.0
#include "app/report/rules_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/json_values.hpp"

namespace robochart::app {
namespace {

using diagnostics::Json;
using diagnostics::json_array;
using diagnostics::json_or_null;

std::string rule_names(const RulesReport& report, const std::vector<std::size_t>& rules) {
    std::string text;
    for (std::size_t i = 0; i < rules.size(); ++i) {
        if (i > 0) text += i + 1 == rules.size() ? " and " : ", ";
        text += report.rules[rules[i]].name;
    }
    return text;
}

bool is_open(const ComparedPair& pair) {
    return !pair.deadline_missed || !pair.only_time_passes || !pair.first_redundant || !pair.second_redundant;
}

bool in_conflict(const ComparedPair& pair) {
    return pair.deadline_missed.value_or(false) || pair.only_time_passes.value_or(false);
}

std::string conflict_text(const RulesReport& report, const RuleConflict& conflict) {
    const std::string rules = rule_names(report, conflict.rules) + (conflict.rules.size() == 1 ? " with itself" : "");
    if (!conflict.decided) return fmt::format("not decided: conflict of {}: {}\n", rules, conflict.reason);
    std::string text = fmt::format("conflict: {}\n", rules);
    for (const std::string& line : conflict.lines) text += fmt::format("  {}\n", line);
    for (const std::string& suggestion : conflict.suggested)
        text += fmt::format("  {}: {}\n", &suggestion == conflict.suggested.data() ? "no conflict with" : "and",
                            suggestion);
    return text;
}

std::string redundant_text(const RulesReport& report, const RedundantRule& found) {
    const RuleName& rule = report.rules[found.rule];
    if (!found.reason.empty())
        return fmt::format("not decided: redundancy of {}: {} ({})\n", rule.name, found.reason, rule.place);
    std::string places = rule.place;
    for (const std::size_t implying_rule : found.by) places += ", " + report.rules[implying_rule].place;
    return fmt::format("redundant: {}, which {} {} ({})\n", rule.name, rule_names(report, found.by),
                       found.by.size() == 1 ? "implies" : "together imply", places);
}

std::string property_text(const RulesReport& report, const RuleProperty& property) {
    const char* const what = property.concern ? "concern" : "purpose";
    if (!property.decided)
        return fmt::format("not decided: {} {}: {} ({})\n", what, property.name, property.reason, property.place);
    if (!property.concern) {
        std::string by = "nothing can bring it about";
        if (!property.excluded.empty())
            by = rule_names(report, property.excluded) +
                 (property.excluded.size() == 1 ? " excludes it" : " together exclude it");
        return fmt::format("purpose blocked: {}: {} ({})\n", property.name, by, property.place);
    }
    std::string text = fmt::format("concern raised: {}: the rules allow it ({})\n", property.name, property.place);
    for (const std::string& line : property.lines) text += fmt::format("  {}\n", line);
    return text;
}

std::string pair_text(const RulesReport& report, const ComparedPair& pair) {
    std::string text;
    const std::string both = rule_names(report, {pair.first, pair.second});
    if (pair.deadline_missed.value_or(false))
        text += fmt::format("conflict: {}: a deadline is missed\n", both);
    else if (pair.only_time_passes.value_or(false))
        text += fmt::format("conflict: {}: only time can pass\n", both);
    if (pair.first_redundant.value_or(false)) text += redundant_text(report, {pair.first, {pair.second}});
    if (pair.second_redundant.value_or(false)) text += redundant_text(report, {pair.second, {pair.first}});
    if (is_open(pair)) text += fmt::format("not decided: {}\n", both);
    return text;
}

std::string number_of(std::size_t count, const char* noun) {
    return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

/// The numbers of answers of each kind.
struct AnswerCounts {
    std::size_t broken = 0, conflicts = 0, redundancies = 0, raised = 0, blocked = 0, undecided = 0, errors = 0;
};

void count_verdict(driver::RuleVerdict::Kind kind, AnswerCounts& counts) {
    switch (kind) {
        case driver::RuleVerdict::Kind::broken:
            ++counts.broken;
            break;
        case driver::RuleVerdict::Kind::not_decided:
            ++counts.undecided;
            break;
        case driver::RuleVerdict::Kind::error:
            ++counts.errors;
            break;
        case driver::RuleVerdict::Kind::obeyed:
        case driver::RuleVerdict::Kind::never_asked:
        case driver::RuleVerdict::Kind::not_applicable:
            break;
    }
}

AnswerCounts count_answers(const RulesReport& report) {
    AnswerCounts counts;
    counts.errors = report.errors.size();
    for (const driver::RuleVerdict& verdict : report.verdicts) count_verdict(verdict.kind, counts);
    for (const RuleConflict& conflict : report.conflicts) ++(conflict.decided ? counts.conflicts : counts.undecided);
    for (const RedundantRule& rule : report.redundant) ++(rule.reason.empty() ? counts.redundancies : counts.undecided);
    for (const ComparedPair& pair : report.pairs) {
        if (in_conflict(pair)) ++counts.conflicts;
        if (is_open(pair)) ++counts.undecided;
        for (const auto& implied : {pair.first_redundant, pair.second_redundant})
            if (implied.value_or(false)) ++counts.redundancies;
    }
    for (const RuleProperty& property : report.properties) {
        if (!property.decided)
            ++counts.undecided;
        else
            ++(property.concern ? counts.raised : counts.blocked);
    }
    return counts;
}

std::string closing_text(const RulesReport& report) {
    const AnswerCounts counts = count_answers(report);
    std::string text =
        fmt::format("{}: {}, {}", number_of(report.rules.size(), "rule"), number_of(counts.conflicts, "conflict"),
                    counts.redundancies == 1 ? "1 redundancy" : fmt::format("{} redundancies", counts.redundancies));
    if (report.concerns > 0)
        text += fmt::format(", {} of {} raised", counts.raised, number_of(report.concerns, "concern"));
    if (report.purposes > 0)
        text += fmt::format(", {} of {} blocked", counts.blocked, number_of(report.purposes, "purpose"));
    if (counts.undecided > 0) text += fmt::format(", {} not decided", counts.undecided);
    return text + "\n";
}

const char* verdict_word(driver::RuleVerdict::Kind kind) {
    switch (kind) {
        case driver::RuleVerdict::Kind::obeyed:
            return "obeyed";
        case driver::RuleVerdict::Kind::broken:
            return "broken";
        case driver::RuleVerdict::Kind::never_asked:
            return "never asked";
        case driver::RuleVerdict::Kind::not_applicable:
            return "not applicable";
        case driver::RuleVerdict::Kind::not_decided:
            return "not decided";
        case driver::RuleVerdict::Kind::error:
            break;
    }
    return "error";
}

std::string verdict_text(const RulesReport& report, const driver::RuleVerdict& verdict) {
    std::string text = fmt::format("{} by {}: {}{}{}\n", report.rules[verdict.rule].name, verdict.component,
                                   verdict_word(verdict.kind), verdict.reason.empty() ? "" : ": ", verdict.reason);
    for (const std::string& line : verdict.lines) text += fmt::format("  {}\n", line);
    return text;
}

bool is_wrong(const driver::RuleVerdict& verdict) {
    using Kind = driver::RuleVerdict::Kind;
    return verdict.kind == Kind::broken || verdict.kind == Kind::not_decided || verdict.kind == Kind::error;
}

std::string verdicts_text(const RulesReport& report, bool quiet) {
    std::string text;
    for (const driver::RuleVerdict& verdict : report.verdicts)
        if (!quiet || is_wrong(verdict)) text += verdict_text(report, verdict);
    for (const std::string& error : report.errors) text += fmt::format("error: {}\n", error);
    for (const std::string& component : report.time_stops) text += fmt::format("time can stop in {}\n", component);
    for (const std::string& reason : report.time_open) text += fmt::format("not decided: {}\n", reason);
    if (!quiet || std::ranges::any_of(report.verdicts, is_wrong)) text += durations::second_text(report.unit) + "\n";
    if (!quiet) text += "an input counts as an event of the rules when the component takes it\n";
    if (!report.limit.empty()) text += fmt::format("not finished: {}\n", report.limit);
    const AnswerCounts counts = count_answers(report);
    return text + fmt::format("{}: {} broken, {} not decided{}\n", number_of(report.verdicts.size(), "verdict"),
                              counts.broken, counts.undecided,
                              counts.errors == 0 ? "" : ", " + number_of(counts.errors, "error"));
}

Json verdict_json(const RulesReport& report, const driver::RuleVerdict& verdict) {
    Json json{{"rule", report.rules[verdict.rule].name},
              {"component", verdict.component},
              {"verdict", verdict_word(verdict.kind)}};
    if (!verdict.reason.empty()) json["reason"] = verdict.reason;
    if (!verdict.lines.empty()) json["run"] = verdict.lines;
    json["states"] = verdict.states;
    return json;
}

/// Returns the names of the rules with these numbers.
Json names_json(const RulesReport& report, const std::vector<std::size_t>& rules) {
    return json_array(rules, [&](std::size_t rule) { return report.rules[rule].name; });
}

Json pair_json(const RulesReport& report, const ComparedPair& pair) {
    return {{"rules", names_json(report, {pair.first, pair.second})},
            {"deadlineMissed", json_or_null(pair.deadline_missed)},
            {"onlyTimePasses", json_or_null(pair.only_time_passes)},
            {"firstRedundant", json_or_null(pair.first_redundant)},
            {"secondRedundant", json_or_null(pair.second_redundant)}};
}

Json conflict_json(const RulesReport& report, const RuleConflict& conflict) {
    Json json{{"rules", names_json(report, conflict.rules)}, {"decided", conflict.decided}};
    if (!conflict.decided) json["reason"] = conflict.reason;
    if (conflict.decided) json["situation"] = conflict.lines;
    if (!conflict.suggested.empty()) json["suggested"] = conflict.suggested;
    json["states"] = conflict.states;
    return json;
}

const char* verdict_word(const RuleProperty& property) {
    if (!property.decided) return "not decided";
    return property.concern ? "raised" : "blocked";
}

Json property_json(const RulesReport& report, const RuleProperty& property) {
    Json json{{"kind", property.concern ? "concern" : "purpose"},
              {"name", property.name},
              {"place", property.place},
              {"verdict", verdict_word(property)}};
    if (!property.decided) json["reason"] = property.reason;
    if (!property.lines.empty()) json["history"] = property.lines;
    if (property.decided && !property.concern) json["excludedBy"] = names_json(report, property.excluded);
    return json;
}

}  // namespace

Exit exit_of(const RulesReport& report) {
    const AnswerCounts counts = count_answers(report);
    if (counts.errors > 0) return Exit::bad_input;
    const std::size_t failures = counts.broken + counts.conflicts + counts.raised + counts.blocked;
    if (failures > 0 || !report.time_stops.empty()) return Exit::failed;
    const bool finished = report.limit.empty() && report.not_read.empty() && report.time_open.empty();
    return finished && counts.undecided == 0 ? Exit::success : Exit::inconclusive;
}

std::string rules_text(const RulesReport& report, const Options& options) {
    if (!report.model.empty()) return verdicts_text(report, options.output.quiet);
    std::string text;
    if (!options.output.quiet && report.as_sleec_tk) {
        text += fmt::format("{}: as SLEEC-TK has it\n", report.file);
        for (const std::string& range : report.ranges) text += fmt::format("  numeric values: {}\n", range);
    }
    for (const std::string& unread : report.not_read) text += fmt::format("not decided: {}\n", unread);
    for (const RuleConflict& conflict : report.conflicts) text += conflict_text(report, conflict);
    for (const ComparedPair& pair : report.pairs) text += pair_text(report, pair);
    for (const RedundantRule& redundant_rule : report.redundant) text += redundant_text(report, redundant_rule);
    for (const std::size_t rule : report.asking_nothing)
        text += fmt::format("asks for nothing: {}, whatever the measures are ({})\n", report.rules[rule].name,
                            report.rules[rule].place);
    for (const RuleProperty& property : report.properties) text += property_text(report, property);
    if (!report.limit.empty()) text += fmt::format("not finished: {}\n", report.limit);
    return text + closing_text(report);
}

Json redundant_json(const RulesReport& report, const RedundantRule& found) {
    Json json{{"rule", report.rules[found.rule].name},
              {"decided", found.reason.empty()},
              {"by", names_json(report, found.by)}};
    if (!found.reason.empty()) json["reason"] = found.reason;
    return json;
}

std::string rules_json(const RulesReport& report) {
    Json json{{"schema", "robochart-verify/rules/1"}, {"file", report.file}, {"dialect", report.dialect}};
    json["semantics"] = report.as_sleec_tk ? "SLEEC-TK" : "default";
    if (!report.as_sleec_tk) json["withoutLimit"] = report.without_limit;
    json["rules"] = json_array(report.rules, [](const RuleName& rule) {
        return Json{{"name", rule.name}, {"place", rule.place}};
    });
    // Passes the report to the functions, because they also need the names of the rules.
    const auto listed = [&](const auto& entries, const auto& entry_json) {
        return json_array(entries, [&](const auto& entry) { return entry_json(report, entry); });
    };
    if (!report.model.empty()) {
        json["model"] = report.model;
        json["verdicts"] = listed(report.verdicts, verdict_json);
        json["timeStops"] = report.time_stops;
        if (!report.time_open.empty()) json["timeNotDecided"] = report.time_open;
        json["inputsCount"] = "taken";
        json["unitNanoseconds"] = json_or_null(report.unit);
        json["second"] = durations::second_text(report.unit);
    } else if (report.as_sleec_tk) {
        json["numericValues"] = report.ranges;
        json["pairs"] = listed(report.pairs, pair_json);
        if (!report.not_read.empty()) json["notRead"] = report.not_read;
    } else {
        json["questions"] = report.questions;
        json["conflicts"] = listed(report.conflicts, conflict_json);
        json["redundant"] = listed(report.redundant, redundant_json);
        json["askingNothing"] = names_json(report, report.asking_nothing);
        json["concerns"] = report.concerns;
        json["purposes"] = report.purposes;
        json["properties"] = listed(report.properties, property_json);
    }
    if (!report.errors.empty()) json["errors"] = report.errors;
    if (!report.limit.empty()) json["limit"] = report.limit;
    return diagnostics::json_text(json) + "\n";
}

}  // namespace robochart::app
