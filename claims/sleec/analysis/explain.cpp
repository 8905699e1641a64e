// SPDX-License-Identifier: Apache-2.0
// See explain.hpp.
#include "claims/sleec/analysis/explain.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {
namespace {

/// Lists the first of the other events: "Alarm at second 3, Help at second 4".
std::string besides_text(const Conflict& conflict, const CheckedRules& rules) {
    constexpr std::size_t most = 4;
    std::string text;
    for (std::size_t i = 0; i < std::min(most, conflict.besides.size()); ++i)
        text += fmt::format("{}{} at {}", i == 0 ? "" : ", ", rules.event_name(conflict.besides[i].second),
                            instant_text(rules, conflict.besides[i].first));
    return text + (conflict.besides.size() > most ? ", ..." : "");
}

std::string end_text(const Conflict& conflict, const CheckedRules& rules) {
    std::vector<std::string> due;  // without duplicates, because several alternatives may be cases of one event
    for (const Side& side : conflict.due)
        if (const std::string event = rules.event_name(side.demand.event); std::ranges::find(due, event) == due.end())
            due.push_back(event);
    const std::string events = fmt::format("{}", fmt::join(due, " or "));
    if (conflict.endless)
        return fmt::format("{} never ends: {} has to come, and calls for the next, whatever is done",
                           instant_text(rules, conflict.instant), events);
    if (conflict.for_ever) return fmt::format("{} has to come some time, and never may", events);
    return fmt::format("at {} {} has to come, and {}", instant_text(rules, conflict.instant), events,
                       due.size() > 1 ? "none of them may" : "may not");
}

}  // namespace

std::string side_text(const Side& side, const CheckedRules& rules, const diagnostics::SourceManager& sources) {
    const std::string values = values_text(rules, side.rule, side.values);
    return fmt::format("{} begins at {} with {}{}: it {} ({})", rules.name(side.rule), instant_text(rules, side.began),
                       rules.event_name(rules.rules[side.rule].trigger), values.empty() ? "" : ", " + values,
                       demand_text(rules, side.demand, side.began), sources.path_and_line(side.demand.written->span));
}

std::string values_text(const CheckedRules& rules, std::size_t rule, const Valuation& values) {
    std::string text;
    for (const std::size_t measure : measures_of(rules.rules[rule]))
        text += (text.empty() ? "" : ", ") + value_text(rules.measure(measure), values[measure]);
    return text;
}

std::string demand_text(const CheckedRules& rules, const Demand& demand, std::int64_t began) {
    std::string text = fmt::format("{} {}", demand.forbids ? "forbids" : "asks for", rules.event_name(demand.event));
    if (demand.begin > 0) text += fmt::format(" from {}", instant_text(rules, began + demand.begin));
    if (demand.end == forever) return text + (demand.forbids ? " for ever" : ", without limit");
    return text + fmt::format("{} {}", demand.begin > 0 ? " to" : " up to", instant_text(rules, began + demand.end));
}

std::vector<std::string> history_lines(const std::vector<Happening>& history, const CheckedProperty& property,
                                       const CheckedRules& rules) {
    constexpr std::size_t most = 7;
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < std::min(most, history.size()); ++i) {
        const Happening& happening = history[i];
        const bool during = property.during && property.during->contains(happening.event) &&
                            !property.trigger.contains(happening.event);
        const auto& condition = during ? property.during_condition : property.condition;
        std::string values;
        if (happening.named && condition)
            for (const std::size_t measure : measures_of({0, condition, nullptr, false, nullptr}))
                values +=
                    (values.empty() ? " with " : ", ") + value_text(rules.measure(measure), happening.values[measure]);
        lines.push_back(fmt::format("{} at {}{}", rules.event_name(happening.event),
                                    instant_text(rules, happening.second), values));
    }
    if (history.size() > most) lines.push_back(fmt::format("and {} more events", history.size() - most));
    return lines;
}

std::vector<std::string> explain_conflict(const Conflict& conflict, const CheckedRules& rules,
                                          const diagnostics::SourceManager& sources) {
    std::vector<const Side*> sides;
    for (const auto* group : {&conflict.due, &conflict.forbidding})
        for (const Side& side : *group) sides.push_back(&side);
    std::ranges::stable_sort(sides, [](const Side* a, const Side* b) { return a->began < b->began; });
    std::vector<std::string> lines;
    for (const Side* side : sides)
        if (std::string line = side_text(*side, rules, sources); std::ranges::find(lines, line) == lines.end())
            lines.push_back(std::move(line));
    if (!conflict.besides.empty())
        lines.push_back(fmt::format("to keep the rules before, {}", besides_text(conflict, rules)));
    lines.push_back(end_text(conflict, rules));
    return lines;
}

}  // namespace robochart::sleec
