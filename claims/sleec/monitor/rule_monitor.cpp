// SPDX-License-Identifier: Apache-2.0
// See rule_monitor.hpp.
#include "claims/sleec/monitor/rule_monitor.hpp"

#include <algorithm>
#include <utility>

#include "claims/sleec/obligations/samples.hpp"

namespace robochart::sleec {

RuleMonitor::RuleMonitor(const CheckedRules& rules, WithoutLimit without) : rules_(rules), without_(without) {}

namespace {

/// Returns the possible obligations of the rule for these values, each with a valuation. An unknown measure takes each
/// of the values that the rule distinguishes.
std::vector<std::pair<Valuation, std::optional<Obligation>>> possible(const CheckedRules& rules, std::size_t rule,
                                                                      const MeasureReadings& readings,
                                                                      WithoutLimit without) {
    constexpr std::size_t most = 4096;
    std::vector<Valuation> all{Valuation(readings.size(), 0)};
    for (std::size_t i = 0; i < readings.size(); ++i)
        if (readings[i]) all.front()[i] = *readings[i];
    std::vector<std::vector<std::int64_t>> values;
    for (const std::size_t measure : measures_of(rules.rules[rule])) {
        if (readings[measure]) continue;
        if (values.empty()) values = representative_values(rules, {rule});
        std::vector<Valuation> more;
        for (const Valuation& valuation : all)
            for (const std::int64_t value : values[measure]) {
                more.push_back(valuation);
                more.back()[measure] = value;
                if (more.size() > most) throw NotDecided("a rule distinguishes too many values of measures");
            }
        all = std::move(more);
    }
    std::vector<std::pair<Valuation, std::optional<Obligation>>> result;
    for (Valuation& valuation : all) {
        auto obligation = obligation_of(rules.rules[rule], valuation, without);
        const bool known = std::ranges::any_of(result, [&](const auto& other) { return other.second == obligation; });
        if (!known) result.emplace_back(std::move(valuation), std::move(obligation));
    }
    return result;
}

}  // namespace

void RuleMonitor::observe_event(std::size_t event, const MeasureReadings& values) {
    std::vector<Open> left;
    for (Open& open : open_) {
        const Effect effect = take_event(open.obligation, open.progress, event);
        update_open(std::move(open), effect, event, left);
    }
    open_ = std::move(left);
    for (std::size_t i = 0; i < rules_.rules.size(); ++i)
        if (!rules_.rules[i].assumed && rules_.rules[i].trigger.contains(event)) start_rule(i, values);
}

void RuleMonitor::start_rule(std::size_t rule, const MeasureReadings& values) {
    auto all = possible(rules_, rule, values, without_);
    if (all.size() > 1) {
        if (std::ranges::find(open_triggers_, rule) == open_triggers_.end()) open_triggers_.push_back(rule);
        return;
    }
    auto& [valuation, obligation] = all.front();
    if (!obligation) return;
    if (obligation->any.size() > most_demands) throw NotDecided("a rule has too many responses behind each other");
    keep_distinct({rule, std::move(*obligation), {}, now_, std::move(valuation)}, open_);
}

void RuleMonitor::end_second() {
    std::vector<Open> left;
    for (Open& open : open_) {
        const Effect effect = take_tock(open.obligation, open.progress);
        update_open(std::move(open), effect, std::nullopt, left);
    }
    open_ = std::move(left);
    ++now_;
}

void RuleMonitor::update_open(Open open, Effect effect, std::optional<std::size_t> event, std::vector<Open>& left) {
    if (effect == Effect::open) keep_distinct(std::move(open), left);
    if (effect == Effect::broken)
        violations_.push_back({open.rule, open.began, std::move(open.values), std::move(open.obligation), event, now_});
}

/// Adds a duty. If several duties of a rule are equal from now on, stores only the oldest.
void RuleMonitor::keep_distinct(Open open, std::vector<Open>& open_now) const {
    const bool known = std::ranges::any_of(open_now, [&](const Open& other) {
        return other.rule == open.rule && other.progress == open.progress && other.obligation == open.obligation;
    });
    if (!known) open_now.push_back(std::move(open));
}

std::vector<std::pair<Obligation, Progress>> RuleMonitor::open_duties() const {
    std::vector<std::pair<Obligation, Progress>> result;
    for (const Open& open : open_) result.emplace_back(open.obligation, open.progress);
    return result;
}

std::vector<Violation> RuleMonitor::take_violations() {
    return std::exchange(violations_, {});
}

}  // namespace robochart::sleec
