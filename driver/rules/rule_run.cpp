// SPDX-License-Identifier: Apache-2.0
// See rule_run.hpp.
#include "driver/rules/rule_run.hpp"

#include <fmt/format.h>

#include <charconv>

#include "claims/sleec/analysis/explain.hpp"

namespace robochart::driver {
namespace {

std::vector<std::size_t> all_of(const std::multimap<std::string, std::size_t>& names, std::string_view word) {
    std::vector<std::size_t> result;
    const auto [from, to] = names.equal_range(std::string(word.substr(0, word.find_first_of("?!"))));
    for (auto at = from; at != to; ++at) result.push_back(at->second);
    return result;
}

/// Returns the values in an event of a log: a and b for "o!a!b". A number such as "3.0" becomes the whole number 3.
std::vector<std::string> values_in(std::string_view word) {
    std::vector<std::string> result;
    for (std::size_t mark = word.find_first_of("?!"); mark != std::string_view::npos;) {
        const std::size_t next = word.find('!', mark + 1);
        std::string_view value = word.substr(mark + 1, next == std::string_view::npos ? next : next - mark - 1);
        mark = next;
        if (const std::size_t point = value.find('.');
            point != std::string_view::npos && point + 1 < value.size() &&
            value.find_first_not_of('0', point + 1) == std::string_view::npos)
            value = value.substr(0, point);
        if (!value.empty()) result.emplace_back(value);
    }
    return result;
}

}  // namespace

RuleWords::RuleWords(const sleec::CheckedRules& rules) : rules_(rules) {
    for (std::size_t i = 0; i < rules.file->events.size(); ++i)
        events_.emplace(model_name(rules.file->events[i].name.text), i);
    for (std::size_t i = 0; i < rules.measures.size(); ++i)
        measures_.emplace(model_name(rules.measure(i).name.text), i);
}

std::vector<std::size_t> RuleWords::declared_by_word(std::string_view word) const {
    return all_of(events_, word);
}

std::vector<std::size_t> RuleWords::events_of_word(std::string_view word) const {
    std::vector<std::size_t> result;
    for (const std::size_t declared : declared_by_word(word)) {
        const bool plain = rules_.arguments[declared].empty();
        if (const auto event = rules_.case_of(declared, plain ? std::vector<std::string>() : values_in(word)))
            result.push_back(*event);
    }
    return result;
}

std::vector<std::size_t> RuleWords::measures_of_word(std::string_view word) const {
    return all_of(measures_, word);
}

std::optional<std::int64_t> RuleWords::value_in(std::size_t measure, std::string_view word) const {
    const std::size_t mark = word.find_first_of("?!");
    const std::string_view text = mark == std::string_view::npos ? std::string_view() : word.substr(mark + 1);
    const sleec::Measure& of = rules_.measure(measure);
    if (of.type == sleec::MeasureType::boolean) {
        if (text == "true") return 1;
        if (text == "false") return 0;
        return std::nullopt;
    }
    if (of.type == sleec::MeasureType::scale) {
        for (std::size_t i = 0; i < of.literals.size(); ++i)
            if (of.literals[i].text == text) return static_cast<std::int64_t>(i);
        return std::nullopt;
    }
    std::int64_t number = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool whole = code == std::errc() && end == text.data() + text.size() && !text.empty();
    return whole ? std::optional(number) : std::nullopt;
}

std::string RuleWords::model_name(const std::string& name) const {
    for (const sleec::Mapping& mapping : rules_.file->mappings)
        if (mapping.name.text == name) return mapping.element.text.substr(mapping.element.text.rfind(':') + 1);
    return name;
}

RuleRun::RuleRun(RulesOf of, sleec::WithoutLimit without)
    : of_(of),
      monitor_(of.rules, without),
      readings_(of.rules.measures.size()),
      read_(of.rules.measures.size(), false) {}

void RuleRun::read(std::size_t measure, std::optional<std::int64_t> value) {
    readings_[measure] = read_[measure] && readings_[measure] != value ? std::nullopt : value;
    read_[measure] = true;
}

void RuleRun::add_event(std::size_t event, std::uint64_t line) {
    instant_.push_back({event, line});
}

void RuleRun::end_second(std::uint64_t line) {
    end_instant();
    monitor_.end_second();
    note_violations(line);
}

void RuleRun::drop_obligations() {
    instant_.clear();
    monitor_.drop_obligations();
    readings_.assign(readings_.size(), std::nullopt);
    read_.assign(read_.size(), false);
}

void RuleRun::end_instant() {
    for (const Happened& happened : instant_) {
        monitor_.observe_event(happened.event, readings_);
        note_violations(happened.line);
    }
    instant_.clear();
    readings_.assign(readings_.size(), std::nullopt);
    read_.assign(read_.size(), false);
}

/// Records only the first violation of the run.
void RuleRun::note_violations(std::uint64_t line) {
    for (const sleec::Violation& violation : monitor_.take_violations()) {
        if (is_broken()) return;
        line_ = line;
        place_ = of_.rules.rules[violation.rule].written->span;
        for (const sleec::Demand& demand : violation.obligation.any)
            text_.push_back(
                sleec::side_text({violation.rule, violation.began, violation.values, demand}, of_.rules, of_.sources));
        const std::string instant = sleec::instant_text(of_.rules, violation.second);
        text_.push_back(violation.event ? fmt::format("{} comes at {}", of_.rules.event_name(*violation.event), instant)
                                        : fmt::format("{} ends without it", instant));
    }
}

}  // namespace robochart::driver
